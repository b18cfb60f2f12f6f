# Installs the build, builds the small project of this folder against what was installed and runs it and both programs.
set(prefix ${work}/prefix)
set(sand ${source}/examples/gradations/athabasca-sand.csv)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})

# run(<command>...): standard output in `output`; stops if the command fails.
macro(run)
  execute_process(COMMAND ${ARGV} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
endmacro()

run(${CMAKE_COMMAND} --install ${build} --prefix ${prefix} --config ${config})
file(GLOB package_files ${prefix}/${libdir}/cmake/mdm/*.cmake)
foreach(file IN LISTS package_files)
  file(READ ${file} content)
  foreach(private ${source} ${build} -Wall -fsanitize nlohmann CLI11)
    string(FIND "${content}" ${private} found)
    if(NOT found EQUAL -1)
      message(FATAL_ERROR "the installed ${file} has ${private} in it")
    endif()
  endforeach()
endforeach()

run(${CMAKE_COMMAND} -S ${source}/tests/install -B ${work}/build -G ${generator} -D CMAKE_BUILD_TYPE=${config}
  -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${work}/build)
run(${work}/build/particles ${sand})
if(NOT output STREQUAL "1485\n")
  message(FATAL_ERROR "the program printed '${output}' instead of 1485")
endif()

run(${prefix}/bin/mdm solve ${sand} --proof ${work}/sand.proof)
run(${prefix}/bin/mdm-check ${sand} ${work}/sand.proof)
message("${output}")
