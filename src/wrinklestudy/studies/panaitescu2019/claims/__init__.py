"""The claims of the paper that a simulation can test, in one module per topic.

The decorator `claim` turns a rule into a claim; no other registration is needed. ``order`` is the
section of the paper, the subsection (0 for none) and a number within it.
"""
