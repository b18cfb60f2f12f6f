# `cpack -G DEB` in the build folder makes Debian packages: exactmdm with the programs, libexactmdm-dev with the library
# and, with MDM_PYTHON, python3-exactmdm. Needs dpkg-shlibdeps (Debian: dpkg-dev), which finds out what the programs depend on.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME exactmdm)
set(CPACK_PACKAGE_VENDOR "The exactmdm authors")
set(CPACK_PACKAGE_CONTACT "The exactmdm authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_COMPONENTS_ALL programs development)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_COMPONENT_PROGRAMS_DESCRIPTION
  "mdm solves sieve analyses for the smallest set of particles that matches,\nmdm-check checks its proofs.")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME exactmdm)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)

set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "The libraries behind mdm and mdm-check with their headers, for find_package(mdm).")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libexactmdm-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# FLINT 3 contains Arb.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libboost-dev, libflint-arb-dev | libflint-dev (>= 3), libflint-dev, \
libfmt-dev, libgmp-dev, libmpfr-dev")
if(Pugixml_FOUND)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libpugixml-dev")
  if(Libzip_FOUND)
    string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libzip-dev")
  endif()
endif()

if(Cairo_FOUND)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libcairo2-dev")
endif()

if(MDM_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
    "The Python module exactmdm: the smallest sets of particles that match sieve analyses, exactly, with proofs.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-exactmdm)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_minor}), exactmdm (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-numpy, python3-pandas, python3-matplotlib")
endif()

include(CPack)
