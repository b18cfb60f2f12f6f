# Programs that read files of strangers end where memory is overstepped: guarded stacks, checked functions of the C library,
# tables that are read-only before the program begins; that addresses differ from run to run is g++'s default. The
# sanitizers find more. Linkers of other systems have other options.
option(MDM_HARDENING "Guard the programs against errors of memory" ON)
if(MDM_HARDENING AND NOT MDM_SANITIZE AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
  add_compile_options(-fstack-protector-strong
    "$<$<NOT:$<CONFIG:Debug>>:SHELL:-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2>") # which needs an optimiser
  add_link_options(-Wl,-z,relro,-z,now)
endif()
