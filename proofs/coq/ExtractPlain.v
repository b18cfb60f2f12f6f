(* The checker as OCaml with Coq's own binary integers: mdm_checker.ml, in the current folder. Slower than
   Extract.v, but no arithmetic is trusted, and it needs no library.

   JavaScript, which it becomes too, has a small stack, and of tail calls only those of a function to itself become
   loops. So the steps between two results are written where they are. *)

From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlString.
From Mdm Require Import Numbers Text Judge SampleLine.

Extraction Inline bind demand demand_form demand_at.
Extraction "mdm_checker.ml" judge judge_sample print_gradation printable.
