"""The site: `make docs` builds it with Sphinx from the pages of this folder into site/."""

import sys
from pathlib import Path

_HERE = Path(__file__).parent
sys.path[:0] = [str(_HERE.parent / "src"), str(_HERE / "_sphinx")]

project = "wrinklestudy"
author = "The wrinklestudy developers"
copyright = author
html_title = "wrinklestudy"

extensions = [
    "sphinx.ext.autodoc",
    "sphinx_copybutton",
    "numpydoc",
    "myst_nb",
    "mathml",  # _sphinx/mathml.py
    "generated_pages",  # _sphinx/generated_pages.py
]
exclude_patterns = ["_sphinx"]

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
html_math_renderer = "mathml"
nb_execution_mode = "off"  # the notebook is kept with its outputs, and a test runs it

autodoc_member_order = "bysource"
autodoc_typehints = "none"  # the numpydoc sections say the types
numpydoc_show_class_members = False
copybutton_exclude = ".linenos, .gp, .go"

html_theme = "furo"
html_theme_options = {"navigation_with_keys": True}
html_static_path = ["_sphinx/static"]
html_css_files = ["site.css"]
html_show_sphinx = False
html_copy_source = False
