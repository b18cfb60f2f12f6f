(* What the theorems rest on. The integer ones: nothing ("Closed under the global context"). The others: the axioms of
   the standard library's real numbers. *)

From Mdm Require Import ChainSound Reduction TreeSound Laws Pi Theorems MixtureTheorem LineTheorem LineDetermines LinePhrases ExactSample
  SampleTheorem SampleDetermines BlendTheorem BlendDetermines CsvFields GradationRead EnvelopeRead PrintRead DocumentRead Examples.

Print Assumptions chain_bound.
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
Print Assumptions ten_is_least.
Print Assumptions match_within_tolerance.
Print Assumptions certificate_true.
Print Assumptions mixture_true.
Print Assumptions document_read.
Print Assumptions accepted_line_true.
Print Assumptions accepted_certificate_true.
Print Assumptions line_determines.
Print Assumptions decimal_has_value.
Print Assumptions described_accurately.
Print Assumptions accepted_sample_line_true.
Print Assumptions sample_line_determines.
Print Assumptions accepted_blend_best.
Print Assumptions accepted_blend_line_true.
Print Assumptions blend_line_determines.
Print Assumptions fields_read_exactly.
Print Assumptions gradation_read.
Print Assumptions envelope_read.
Print Assumptions print_read.
