# Finds js_of_ocaml, the compiler from OCaml's bytecode to JavaScript: the program JS_OF_OCAML_PROGRAM.
find_program(JS_OF_OCAML_PROGRAM js_of_ocaml)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(JsOfOcaml REQUIRED_VARS JS_OF_OCAML_PROGRAM REASON_FAILURE_MESSAGE "install js-of-ocaml")
mark_as_advanced(JS_OF_OCAML_PROGRAM)
