import sys

sys.path.insert(0, ".")

project = "Two kinds of eyes"
extensions = ["mo_copp"]
html_theme = "sphinx_rtd_theme"
html_static_path = ["_static"]
exclude_patterns = ["_build", "README.md"]
