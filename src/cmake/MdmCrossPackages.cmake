# The packages of a build for another machine, as WebAssembly is one: this machine's header-only libraries, seen through a folder of
# their own, because the rest of its headers is for this machine; and those in CMAKE_FIND_ROOT_PATH, for WebAssembly what
# src/web/libraries has built.
set(headers ${PROJECT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})

# mdm_header_package(<target> <header> <folder of headers> <Debian package>)
macro(mdm_header_package target header folder debian)
  find_path(mdm_${folder}_headers ${header} PATHS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH)
  if(mdm_${folder}_headers)
    file(CREATE_LINK ${mdm_${folder}_headers}/${folder} ${headers}/${folder} SYMBOLIC)
    add_library(${target} INTERFACE IMPORTED)
    target_include_directories(${target} SYSTEM INTERFACE ${headers})
  else()
    list(APPEND mdm_missing ${header})
    list(APPEND mdm_missing_debian ${debian})
  endif()
endmacro()

mdm_header_package(Boost::headers boost/version.hpp boost libboost-dev)
mdm_header_package(fmt::fmt fmt/core.h fmt libfmt-dev)
mdm_header_package(nlohmann_json::nlohmann_json nlohmann/json.hpp nlohmann nlohmann-json3-dev)
mdm_header_package(CLI11::CLI11 CLI/CLI.hpp CLI libcli11-dev)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
add_library(Threads::Threads INTERFACE IMPORTED)
mdm_find_package(GMP DEBIAN libgmp-dev)
mdm_find_package(MPFR DEBIAN libmpfr-dev)
find_package(Pugixml QUIET)
