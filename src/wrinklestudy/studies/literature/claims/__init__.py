"""Statements that were read somewhere, each with the rule that judges it, in one module per topic.

``order`` is the number of the section on the page, 0, and a number within it. What is known from
memory alone has no rule and no verdict: `studies.literature.unread`.
"""
