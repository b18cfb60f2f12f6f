(* What the theorems rest on. The integer ones: nothing ("Closed under the global context"). The others: the axioms of
   the standard library's real numbers. *)

From Mdm Require Import ChainSound Reduction TreeSound Laws Pi Theorems.

Print Assumptions chain_sound.
Print Assumptions chain_least.
Print Assumptions chain_unique.
Print Assumptions open_start.
Print Assumptions above_sound.
Print Assumptions realizable.
Print Assumptions match_counts.
Print Assumptions tree_sound.
Print Assumptions check_pi_sound.
Print Assumptions power_law_exists.
Print Assumptions exact_match.
Print Assumptions match_within_tolerance.
Print Assumptions mdm_check_accepted.
