# Finds pugixml, which reads XML: variable PUGIXML_LIBRARY.
find_path(PUGIXML_INCLUDE_DIR pugixml.hpp)
find_library(PUGIXML_LIBRARY pugixml)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Pugixml REQUIRED_VARS PUGIXML_LIBRARY PUGIXML_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "install libpugixml-dev")
mark_as_advanced(PUGIXML_INCLUDE_DIR PUGIXML_LIBRARY)
