# How the programs become those of Windows: each runs alone, reads words and names of files as UTF-8, and has the same bytes
# whenever it is built.
enable_language(RC)
foreach(target mdm mdm_checker mdm-program mdm-check)
  target_compile_definitions(${target} PRIVATE _FILE_OFFSET_BITS=64 _WIN32_WINNT=0x0A00 NOMINMAX WIN32_LEAN_AND_MEAN)
endforeach()
foreach(target mdm-program mdm-check)
  target_sources(${target} PRIVATE windows/program.rc windows/words.cpp)
  target_link_options(${target} PRIVATE -static -s -Wl,--no-insert-timestamp)
endforeach()
