# Finds Coq: the programs COQC_PROGRAM and COQCHK_PROGRAM.
find_program(COQC_PROGRAM coqc)
find_program(COQCHK_PROGRAM coqchk)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Coq REQUIRED_VARS COQC_PROGRAM COQCHK_PROGRAM REASON_FAILURE_MESSAGE "install coq")
mark_as_advanced(COQC_PROGRAM COQCHK_PROGRAM)
