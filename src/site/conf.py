"""What Sphinx is told about the site. make_site, beside this file, gathers its pages and calls Sphinx."""
import pathlib
import re
import sys
from unittest.mock import MagicMock

from sphinx.ext.napoleon import GoogleDocstring

# The Python module is read as it stands here, without its compiled part.
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "python"))
sys.dont_write_bytecode = True
sys.modules["exactmdm._core"] = MagicMock(option_table=lambda: "{}")
autodoc_typehints = "none"
autodoc_default_options = {"members": True, "imported-members": True, "member-order": "groupwise"}
default_role = "literal"

project = "exactmdm"
author = "The exactmdm authors"
extensions = ["myst_parser", "sphinx.ext.autodoc"]
# The pages are plain Markdown: what MyST adds to it would change what they say.
myst_disable_syntax = ["myst_line_comment", "myst_block_break", "myst_role", "myst_target"]
# Options begin with two hyphens, and quotes belong to commands.
smartquotes = False
highlight_language = "none"

html_theme = "alabaster"
html_theme_options = {"description": "Exact minimal discrete matches of grain size distributions",
                      "page_width": "1280px", "sidebar_width": "240px", "body_min_width": 0, "body_max_width": "100%",
                      "code_font_size": "0.8em", "show_powered_by": False}
html_sidebars = {"**": ["about.html", "searchbox.html", "navigation.html"]}
templates_path = ["templates"]
html_static_path = ["static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_copyright = False


def read_docstring(_app, _what, _name, _of, _options, lines):
    """Docstrings have parts as `Args:`, and programs indented below an empty line. Sphinx's own reading of them takes
    `a: b` of an attribute for a type."""
    text = re.sub(r"\n\n(?=    )", "\n\n::\n\n", "\n".join(lines))
    lines[:] = GoogleDocstring(text).lines()


def setup(app):
    app.connect("autodoc-process-docstring", read_docstring)
