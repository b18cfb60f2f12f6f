# Finds cairo, which draws PNG and PDF: variables CAIRO_LIBRARY and CAIRO_INCLUDE_DIR.
find_path(CAIRO_INCLUDE_DIR cairo.h PATH_SUFFIXES cairo)
find_library(CAIRO_LIBRARY cairo)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Cairo REQUIRED_VARS CAIRO_LIBRARY CAIRO_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "install libcairo2-dev")
mark_as_advanced(CAIRO_INCLUDE_DIR CAIRO_LIBRARY)
