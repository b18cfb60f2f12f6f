# Makes the Debian packages of the build, unpacks both, and runs the programs in them.
set(sand ${source}/examples/gradations/athabasca-sand.csv)
set(root ${work}/root)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work} ${root})

# run(<command>...): standard output in `output`; stops if the command fails.
macro(run)
  execute_process(COMMAND ${ARGV} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
endmacro()

run(${cpack} --config ${build}/CPackConfig.cmake -G DEB -B ${work} -C ${config})
foreach(package exactmdm libexactmdm-dev)
  file(GLOB deb ${work}/${package}_*.deb)
  run(dpkg-deb --extract ${deb} ${root})
  run(dpkg-deb --field ${deb} Depends)
  message("${package} depends on ${output}")
  if(NOT output MATCHES "libgmp")
    message(FATAL_ERROR "${package} does not depend on GMP")
  endif()
endforeach()
foreach(file bin/mdm bin/mdm-check share/man/man1/mdm.1 share/man/man1/mdm-solve.1
    share/exactmdm/schemas/mdm-answer-1.schema.json share/doc/exactmdm/copyright include/mdm/match/solve.hpp
    include/mdm/checker.hpp lib/libmdm_checker.a lib/cmake/mdm/mdmConfig.cmake)
  if(NOT EXISTS ${root}/usr/${file})
    message(FATAL_ERROR "no package has /usr/${file}")
  endif()
endforeach()
file(GLOB python_package ${work}/python3-exactmdm_*.deb)
if(python_package)
  run(dpkg-deb --extract ${python_package} ${root})
  run(${CMAKE_COMMAND} -E env PYTHONPATH=${root}/usr/lib/python3/dist-packages /usr/bin/python3 -c
    "import exactmdm; assert exactmdm.solve('${sand}').check()")
endif()
run(${root}/usr/bin/mdm solve ${sand} --proof ${work}/sand.proof)
run(${root}/usr/bin/mdm-check ${sand} ${work}/sand.proof)
message("${output}")
