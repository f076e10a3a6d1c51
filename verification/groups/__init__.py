"""The groups of checks, a module each: ``run(output)`` computes all, ``quick()`` the cheap ones.

A group computes its checks, tables and plots and writes them as one JSON file with its plots beside
it; `page` puts the groups together. A failed check makes `gate` fail, never the group itself.
"""
