# Finds OCaml's compiler and zarith: OCAMLFIND_PROGRAM, and the folder ZARITH_FOLDER.
find_program(OCAMLFIND_PROGRAM ocamlfind)
find_program(OCAMLOPT_PROGRAM ocamlopt)
if(OCAMLFIND_PROGRAM)
  execute_process(COMMAND ${OCAMLFIND_PROGRAM} query zarith OUTPUT_VARIABLE ZARITH_FOLDER ERROR_QUIET
    OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Zarith REQUIRED_VARS OCAMLFIND_PROGRAM OCAMLOPT_PROGRAM ZARITH_FOLDER
  REASON_FAILURE_MESSAGE "install ocaml-nox ocaml-findlib libzarith-ocaml-dev")
mark_as_advanced(OCAMLFIND_PROGRAM OCAMLOPT_PROGRAM)
