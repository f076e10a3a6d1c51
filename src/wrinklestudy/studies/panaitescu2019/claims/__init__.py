"""Claims stage: every statement of the paper that a simulation can test, with a verdict.

`registry.CLAIMS` holds the statements in the order of the paper, each with its words, the
reading that is tested, a tolerance and a rule from the tables of the study to a `Finding`; the
rules are in one module per topic. Nothing but the tables and the material files is read. Importing
this package loads nothing else.
"""
