"""Evidence that the numbers are right: groups of checks, each a module with ``run(output)``.

A group computes its checks, tables and plots and writes them as one JSON file with its plots beside
it; `page` puts the groups together. A check that fails makes `gate` fail, never the group.
"""
