"""The figures of the paper, one module each; the catalogue says what they show of a study.

A module has one function ``draw(inputs)`` that returns a matplotlib figure of whatever sheets and
states it is given. No point is drawn that was not computed or measured; a state that did
not converge leaves a gap.
"""
