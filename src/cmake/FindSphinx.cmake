# Finds what makes the site and what its test needs: the programs SPHINX_PROGRAM, PANDOC_PROGRAM and CODESPELL_PROGRAM.
find_program(SPHINX_PROGRAM sphinx-build)
find_program(PANDOC_PROGRAM pandoc)
find_program(CODESPELL_PROGRAM codespell)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Sphinx REQUIRED_VARS SPHINX_PROGRAM PANDOC_PROGRAM CODESPELL_PROGRAM
  REASON_FAILURE_MESSAGE "install python3-sphinx, python3-myst-parser, pandoc and codespell")
mark_as_advanced(SPHINX_PROGRAM PANDOC_PROGRAM CODESPELL_PROGRAM)
