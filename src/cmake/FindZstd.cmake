# Finds libzstd, which compresses and unpacks: variable ZSTD_LIBRARY.
find_path(ZSTD_INCLUDE_DIR zstd.h)
find_library(ZSTD_LIBRARY zstd)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Zstd REQUIRED_VARS ZSTD_LIBRARY ZSTD_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "install libzstd-dev")
mark_as_advanced(ZSTD_INCLUDE_DIR ZSTD_LIBRARY)
