(* What the file of mdm solve --coq applies: what the verdict's line says is true of the file with these bytes. *)

From Coq Require Import String.
From Mdm Require Import VerdictLine Judge.
From Mdm Require Export LineTheorem.
Open Scope string_scope.

Theorem proved gradation certificate line : judge gradation certificate = Proved line -> true_of_line gradation line.
Proof.
  intro J. apply (accepted_line_true gradation certificate); [rewrite J; reflexivity|]. unfold judge in J.
  destruct (MixtureFile.read_any_gradation _) as [G| |]; try discriminate.
  destruct (check_any_statement _ _ _) as [s| |]; try discriminate. injection J as <-. eexists. reflexivity.
Qed.

(* What is printed of the verdict. *)
Definition verdict_line (verdict : judgement) : string :=
  match verdict with Proved line | Unproved line _ | Unreadable line => line end.
