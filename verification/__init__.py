"""Evidence that the numbers are right, beside the library and outside its wheel.

`groups` has the groups of checks, `tools` what they compute with, `checks` what a group writes.
`mutations` puts faults into copies of the library to see that the checks catch them, `machine`
notes where all of it ran, `page` writes docs/verification.md, `gate` fails if a check did. The
library never imports this package.
"""
