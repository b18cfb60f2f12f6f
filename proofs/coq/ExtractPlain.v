(* The checker as OCaml with Coq's own binary integers: mdm_checker.ml, in the current folder. Slower than
   Extract.v, but no arithmetic is trusted. *)

From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNativeString.
From Mdm Require Import Checker.

Extraction "mdm_checker.ml" mdm_check.
