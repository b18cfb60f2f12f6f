(* What the file of mdm solve --coq applies: the main theorems for one gradation and one certificate, with all that is
   to be evaluated in one equation. *)

From Coq Require Import ZArith QArith Reals List.
From Mdm Require Import Numbers Gradation Certificate Checker Spec Sizes Theorems.
Open Scope R_scope.

(* The certificate is accepted, and the gradation as the question has it. *)
Definition judged (G : gradation) (cert : certificate) : result unit * result gradation :=
  (check_certificate G cert, asked_gradation G cert).

(* Exactly or within a tolerance, as the question says. *)
Theorem smallest G asked_G q N ws proof f :
  judged G (Certificate q (Smallest N) ws proof) = (Ok tt, Ok asked_G) ->
  power_law (Z.to_nat (a q)) (Z.to_nat (b q)) f ->
  least_number f q asked_G N /\
  exists S, allowed f q asked_G S /\ Z.of_nat (length S) = N /\
    describes_articulately (root_of asked_G) (rows asked_G) S /\
    Forall (line_true (root_of asked_G) (classes (rows asked_G)) S) ws.
Proof.
  intros J P. injection J as C E. destruct (tolerances_of q) eqn:T.
  - destruct (match_within_tolerance _ _ f C) as (G' & E' & M); [simpl; congruence | exact P|].
    rewrite E in E'. injection E' as <-. destruct M as (L & (S & W) & _). split; [exact L | exists S; exact W].
  - destruct (exact_match _ _ f C T P) as (G' & E' & _ & L & (S & W) & _).
    rewrite E in E'. injection E' as <-. split; [exact L | exists S; exact W].
Qed.

Theorem no_match G asked_G q ws proof f :
  judged G (Certificate q NoMatch ws proof) = (Ok tt, Ok asked_G) ->
  power_law (Z.to_nat (a q)) (Z.to_nat (b q)) f ->
  forall S, ~ allowed f q asked_G S.
Proof.
  intros J P. injection J as C E. destruct (tolerances_of q) eqn:T.
  - destruct (match_within_tolerance _ _ f C) as (G' & E' & M); [simpl; congruence | exact P|].
    rewrite E in E'. injection E' as <-. exact M.
  - destruct (exact_match _ _ f C T P) as (G' & _ & (N & NE) & _). discriminate NE.
Qed.
