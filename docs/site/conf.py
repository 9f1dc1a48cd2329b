"""Sphinx: the site that tools/docs builds from README.md, docs and examples."""
project = "Gapflow"
extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
exclude_patterns = ["docs/contents.md", "docs/site"]
html_theme = "furo"
html_title = "Gapflow"
html_static_path = ["static", "/usr/share/javascript/katex"]
html_css_files = ["katex.min.css"]
html_js_files = ["katex.min.js", "render_maths.js"]
mathjax_path = "render_maths.js"  # formulas are marked as for MathJax and set by KaTeX, from files of the site itself
html_copy_source = False
html_show_sphinx = False
highlight_language = "none"
smartquotes = False  # "wall" in a table is what to type
