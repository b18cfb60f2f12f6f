# Finds Arb: target Arb::Arb. Before FLINT 3 Arb is a library of its own (flint-arb in Debian, arb elsewhere) with
# the header arb.h; from FLINT 3 on it is part of FLINT with the header flint/arb.h.
find_path(FLINT_INCLUDE_DIR flint/flint.h)
find_library(FLINT_LIBRARY flint)
find_path(ARB_INCLUDE_DIR arb.h PATH_SUFFIXES flint)
find_library(ARB_LIBRARY NAMES flint-arb arb)
if(NOT ARB_LIBRARY AND EXISTS "${FLINT_INCLUDE_DIR}/flint/arb.h")
  set(ARB_LIBRARY ${FLINT_LIBRARY})
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Arb REQUIRED_VARS ARB_LIBRARY ARB_INCLUDE_DIR FLINT_LIBRARY FLINT_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "install libflint-dev and libflint-arb-dev")
mark_as_advanced(FLINT_INCLUDE_DIR FLINT_LIBRARY ARB_INCLUDE_DIR ARB_LIBRARY)
if(Arb_FOUND AND NOT TARGET Arb::Arb)
  find_package(GMP REQUIRED)
  find_package(MPFR REQUIRED)
  add_library(Arb::Arb UNKNOWN IMPORTED)
  set_target_properties(Arb::Arb PROPERTIES IMPORTED_LOCATION ${ARB_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES "${ARB_INCLUDE_DIR};${FLINT_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${FLINT_LIBRARY};MPFR::MPFR;GMP::GMP")
endif()
