# How the programs become WebAssembly: for a worker of a page and for Node, with files in memory.
foreach(target mdm mdm_checker mdm-program mdm-check)
  target_compile_options(${target} PRIVATE -fwasm-exceptions)
endforeach()
# mdm-check reads no environment: it has no ENV to export.
foreach(target mdm-program mdm-check)
  target_link_options(${target} PRIVATE -fwasm-exceptions -sMODULARIZE -sEXPORT_NAME=createProgram -sEXPORT_ES6
    -sUSE_ES6_IMPORT_META=0 -sENVIRONMENT=web -sINVOKE_RUN=0
    -sEXPORTED_RUNTIME_METHODS=callMain,FS$<$<STREQUAL:${target},mdm-program>:,ENV>
    -sFORCE_FILESYSTEM -sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=2GB -sTOTAL_STACK=8MB)
endforeach()
