# The tests of the rooms that compute, as WebAssembly for Node, which shows them the machine's files: there a word has 32
# bits. Programs are not run, and threads cannot be.
if(NOT EXISTS /usr/include/catch2/catch.hpp)
  message(FATAL_ERROR "The tests as WebAssembly need Catch2's header: on Debian, apt-get install catch2")
endif()
file(CREATE_LINK /usr/include/catch2 ${PROJECT_BINARY_DIR}/headers/catch2 SYMBOLIC)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/main.cpp "#define CATCH_CONFIG_MAIN\n#include <catch2/catch.hpp>\n")
add_library(catch_main OBJECT ${CMAKE_CURRENT_BINARY_DIR}/main.cpp)
target_include_directories(catch_main SYSTEM PUBLIC ${PROJECT_BINARY_DIR}/headers)
target_compile_definitions(catch_main PUBLIC CATCH_CONFIG_NO_POSIX_SIGNALS)
target_compile_options(catch_main PUBLIC -fwasm-exceptions)

# mdm_add_wasm_tests(<folder> <libraries>...)
function(mdm_add_wasm_tests folder)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*_test.cpp)
  add_executable(${folder}_tests ${sources})
  target_include_directories(${folder}_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src)
  target_compile_definitions(${folder}_tests PRIVATE
    MDM_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    MDM_DATA_DIR="${CMAKE_CURRENT_SOURCE_DIR}/data"
    MDM_SUITE="${PROJECT_SOURCE_DIR}/examples/reference/average/suite-2750.jsonl")
  target_link_libraries(${folder}_tests PRIVATE ${ARGN} catch_main)
  target_precompile_headers(${folder}_tests PRIVATE precompiled.hpp)
  target_link_options(${folder}_tests PRIVATE -fwasm-exceptions -sNODERAWFS -sEXIT_RUNTIME -sALLOW_MEMORY_GROWTH
    -sMAXIMUM_MEMORY=2GB -sTOTAL_STACK=8MB)
endfunction()

mdm_add_wasm_tests(number mdm MPFR::MPFR)
mdm_add_wasm_tests(match mdm)
