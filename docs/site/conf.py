# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx's settings; docs/site/build.py runs it on the pages that it puts together."""

project = "Gestalt"
author = "The Gestalt authors"
copyright = "2026, The Gestalt authors"
language = "en"

extensions = ["myst_parser", "breathe", "sphinx_copybutton"]
source_suffix = {".md": "markdown"}
exclude_patterns = ["doxygen"]
nitpicky = True
# Types of the standard library and of the libraries under it have no page here.
nitpick_ignore_regex = [("cpp:identifier", ".*"), ("c:identifier", ".*"), ("cpp:var", ".*")]

myst_heading_anchors = 3
myst_enable_extensions = ["colon_fence", "deflist"]
suppress_warnings = ["myst.header"]

breathe_projects = {"gestalt": "doxygen/xml"}
breathe_default_project = "gestalt"
breathe_domain_by_extension = {"h": "cpp"}
breathe_show_include = False

html_theme = "furo"
html_title = "Gestalt"
html_static_path = ["static"]
html_css_files = ["dark.css", "gestalt.css"]
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#1f5f8b", "color-brand-content": "#1f5f8b"},
    "dark_css_variables": {"color-brand-primary": "#7cc0ee", "color-brand-content": "#7cc0ee"},
}
copybutton_exclude = ".linenos, .gp, .go"
pygments_style = "friendly"
pygments_dark_style = "monokai"
highlight_language = "none"
