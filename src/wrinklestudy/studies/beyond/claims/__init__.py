"""What is expected beyond the paper and whether it holds, in one module per item.

``order`` is the number of the section on the page, 0, and a number within it. An expectation that
fails is a result like one that holds.
"""
