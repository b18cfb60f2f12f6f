# Finds Arb: target Arb::Arb. From FLINT 3 on Arb is part of FLINT with the header flint/arb.h; before, it is a library
# of its own (flint-arb in Debian, arb elsewhere) with the header arb.h.
find_package(GMP QUIET)
find_package(MPFR QUIET)
find_path(FLINT_INCLUDE_DIR flint/flint.h)
find_library(FLINT_LIBRARY flint)
set(arb_required FLINT_LIBRARY FLINT_INCLUDE_DIR GMP_FOUND MPFR_FOUND)
if(NOT EXISTS "${FLINT_INCLUDE_DIR}/flint/arb.h")
  find_path(ARB_INCLUDE_DIR arb.h)
  find_library(ARB_LIBRARY NAMES flint-arb arb)
  list(PREPEND arb_required ARB_LIBRARY ARB_INCLUDE_DIR)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Arb REQUIRED_VARS ${arb_required}
  REASON_FAILURE_MESSAGE "install libflint-dev and, before FLINT 3, libflint-arb-dev")
mark_as_advanced(FLINT_INCLUDE_DIR FLINT_LIBRARY ARB_INCLUDE_DIR ARB_LIBRARY)
if(Arb_FOUND AND NOT TARGET Arb::Arb)
  add_library(Arb::Arb UNKNOWN IMPORTED)
  if("ARB_LIBRARY" IN_LIST arb_required)
    set_target_properties(Arb::Arb PROPERTIES IMPORTED_LOCATION ${ARB_LIBRARY}
      INTERFACE_INCLUDE_DIRECTORIES "${ARB_INCLUDE_DIR};${FLINT_INCLUDE_DIR}"
      INTERFACE_LINK_LIBRARIES "${FLINT_LIBRARY};MPFR::MPFR;GMP::GMP")
  else()
    set_target_properties(Arb::Arb PROPERTIES IMPORTED_LOCATION ${FLINT_LIBRARY}
      INTERFACE_INCLUDE_DIRECTORIES ${FLINT_INCLUDE_DIR} INTERFACE_LINK_LIBRARIES "MPFR::MPFR;GMP::GMP")
  endif()
endif()
