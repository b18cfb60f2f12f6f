# Makes the Debian packages of the build, unpacks them, and runs the programs in them.
set(sand ${source}/examples/gradations/athabasca-sand.csv)
set(root ${work}/root)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work} ${root})

# run(<command>...): standard output in `output`; stops if the command fails.
macro(run)
  execute_process(COMMAND ${ARGV} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
endmacro()

run(${source}/src/cmake/debs ${build} ${work})
foreach(package exactmdm libexactmdm-dev python3-exactmdm)
  file(GLOB deb ${work}/${package}_*.deb)
  run(dpkg-deb --extract ${deb} ${root})
  run(dpkg-deb --field ${deb} Depends)
  message("${package} depends on ${output}")
  if(NOT output MATCHES "libgmp")
    message(FATAL_ERROR "${package} does not depend on GMP")
  endif()
endforeach()
# Libraries are in a folder for this processor where the build was configured for /usr.
file(GLOB folder ${root}/usr/lib/cmake ${root}/usr/lib/*/cmake)
get_filename_component(folder ${folder} DIRECTORY)
file(RELATIVE_PATH libraries ${root}/usr ${folder})
foreach(file bin/mdm bin/mdm-check share/man/man1/mdm.1.gz share/man/man1/mdm-solve.1.gz
    share/exactmdm/schemas/mdm-answer-1.schema.json share/doc/exactmdm/copyright include/mdm/match/solve.hpp
    include/mdm/checker.hpp ${libraries}/libmdm_checker.a ${libraries}/cmake/mdm/mdmConfig.cmake
    ${libraries}/pkgconfig/exactmdm.pc ${libraries}/pkgconfig/exactmdm-checker.pc)
  if(NOT EXISTS ${root}/usr/${file})
    message(FATAL_ERROR "no package has /usr/${file}")
  endif()
endforeach()
if(EXISTS ${build}/web/exactmdm.html)
  file(SHA256 ${build}/web/exactmdm.html page)
  file(SHA256 ${root}/usr/share/exactmdm/exactmdm.html packaged)
  if(NOT page STREQUAL packaged)
    message(FATAL_ERROR "exactmdm has not the page of the build")
  endif()
endif()
run(${CMAKE_COMMAND} -E env PYTHONPATH=${root}/usr/lib/python3/dist-packages PATH=${root}/usr/bin:$ENV{PATH}
  PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c "import exactmdm; assert exactmdm.solve('${sand}').check()")
run(${root}/usr/bin/mdm solve ${sand} --proof ${work}/sand.proof)
run(${root}/usr/bin/mdm-check ${sand} ${work}/sand.proof)
message("${output}")
