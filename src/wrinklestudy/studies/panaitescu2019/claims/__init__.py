"""The claims of the paper that a simulation can test, in one module per topic.

The decorator `claim` above a rule makes it a claim; nothing else registers it. ``order`` is the
section of the paper, the subsection (0 for none) and a number within it.
"""
