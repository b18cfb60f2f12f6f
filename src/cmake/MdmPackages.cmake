# Finds the packages that the project needs and names all that are missing at once, as Debian calls them.

# mdm_find_package(<name> [<arguments of find_package>...] DEBIAN <Debian packages>...)
# A macro: what find_package defines is for the caller.
macro(mdm_find_package)
  cmake_parse_arguments(mdm_wanted "" "" DEBIAN ${ARGN})
  find_package(${mdm_wanted_UNPARSED_ARGUMENTS} QUIET)
  if(NOT ${ARGV0}_FOUND)
    list(APPEND mdm_missing ${mdm_wanted_UNPARSED_ARGUMENTS})
    list(APPEND mdm_missing_debian ${mdm_wanted_DEBIAN})
  endif()
endmacro()

function(mdm_stop_if_packages_are_missing)
  if(mdm_missing)
    list(JOIN mdm_missing " " missing)
    list(JOIN mdm_missing_debian " " debian)
    message(FATAL_ERROR "Not found: ${missing}\nOn Debian and Ubuntu: apt-get install ${debian}\n"
      "(FLINT 3 contains Arb: there is no libflint-arb-dev beside it.)")
  endif()
endfunction()
