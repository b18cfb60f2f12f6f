(* The checker as OCaml with Coq's own binary integers: mdm_checker.ml, in the current folder. Slower than
   Extract.v, but no arithmetic is trusted, and it needs no library. *)

From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlString.
From Mdm Require Import Text Judge SampleLine BlendLine.

Extraction "mdm_checker.ml" judge judge_sample judge_blend print_gradation printable.
