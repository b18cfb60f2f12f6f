(* The checker as OCaml with the integers of zarith: mdm_checker.ml, in the current folder.

   Trusted beyond Coq: that these functions of zarith are the ones that are named here, for the arguments that
   occur (exponents and counts of bits are small, divisors are positive). In JavaScript, ../checker/javascript has
   functions of these names.

   JavaScript has a small stack, and of tail calls only those of a function to itself become loops. So the steps
   between two results are written where they are. *)

From Coq Require Import ZArith QArith Extraction ExtrOcamlBasic ExtrOcamlZBigInt ExtrOcamlString.
From Mdm Require Import Numbers Text Judge SampleLine BlendLine.

Extract Constant Z.pow => "(fun x n -> if Z.sign n < 0 then Z.zero else Z.pow x (Z.to_int n))".
Extract Constant Z.log2 => "(fun x -> if Z.sign x <= 0 then Z.zero else Z.of_int (Z.numbits x - 1))".
Extract Constant Z.gcd => "Z.gcd".
Extract Constant Z.lcm => "Z.lcm".
Extract Constant Z.ggcd =>
  "(fun x y -> let g = Z.gcd x y in
    if Z.sign g = 0 then (Z.zero, (Z.zero, Z.zero)) else (g, (Z.divexact x g, Z.divexact y g)))".
Extract Constant Z.leb => "Z.leq".
Extract Constant Z.ltb => "Z.lt".
Extract Constant code => "(fun ch -> Big_int_Z.big_int_of_int (Char.code ch))".

Extraction Inline bind demand demand_form demand_at.
Extraction "mdm_checker.ml" judge judge_sample judge_blend print_gradation printable.
