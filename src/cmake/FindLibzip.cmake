# Finds libzip, which unpacks workbooks: variable LIBZIP_LIBRARY.
find_path(LIBZIP_INCLUDE_DIR zip.h)
find_library(LIBZIP_LIBRARY zip)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Libzip REQUIRED_VARS LIBZIP_LIBRARY LIBZIP_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "install libzip-dev")
mark_as_advanced(LIBZIP_INCLUDE_DIR LIBZIP_LIBRARY)
