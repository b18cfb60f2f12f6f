(* If a verdict's line begins with "accepted", what it says is true of the gradation in the file, of one material or of several. *)

From Coq Require Import ZArith QArith Reals Qreals String Ascii List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Text Rows GradationFile Mixture MixtureFile Document
  VerdictLine Judge Spec Theorems MixtureTheorem JudgeTheorem MixtureJudged.
Import ListNotations.
Open Scope R_scope.

(* The statement is true of this file: of the gradation that is read from its bytes. *)
Definition is_true (gradation : file) (s : statement) : Prop :=
  file_name s = name gradation /\
  match read_any_gradation (bytes gradation) with
  | Ok (One R) => true_of_one R s
  | Ok (Several R) => true_of_several R s
  | Refused _ | Malformed _ => False
  end.

(* What it means that a line is true of a file. A line has one statement at most: line_determines. *)
Definition true_of_line (gradation : file) (line : string) : Prop :=
  exists s, plain_statement s = true /\ line = accepted_line s /\ is_true gradation s.

Lemma printed_accepted gradation certificate line :
  printed (judge gradation certificate) = Some line -> begins_with "accepted" line ->
  exists G s, read_any_gradation (bytes gradation) = Ok G /\ check_any_statement (name gradation) G (bytes certificate) = Ok s /\
    line = accepted_line s.
Proof.
  unfold judge. destruct (read_any_gradation (bytes gradation)) as [G| |]; try discriminate.
  destruct (check_any_statement _ G (bytes certificate)) as [s| |] eqn:E; try discriminate; intros [= <-] (rest & H).
  - exists G, s. auto.
  - discriminate H.
Qed.

(* If the line that is printed begins with "accepted", it is true of the gradation in the file. *)
Theorem accepted_line_true gradation certificate line :
  printed (judge gradation certificate) = Some line -> begins_with "accepted" line -> true_of_line gradation line.
Proof.
  intros P B. destruct (printed_accepted _ _ _ P B) as (G & s & EG & ES & ->). exists s. unfold is_true. rewrite EG.
  destruct G as [R|R]; cbn [check_any_statement] in ES.
  - pose proof (checked_statement_true _ _ _ _ ES) as T. apply check_statement_ok in ES as (D & _ & -> & _ & Plain). auto.
  - destruct (checked_mixed_statement_true _ _ _ _ ES) as (T & Plain). split; [exact Plain|]. split; [reflexivity|]. split; [|exact T].
    unfold check_mixed_statement in ES. passed ES. cbv zeta in ES. passed ES. injection ES as <-. reflexivity.
Qed.

(* What the certificate claims besides: a sample with the counts and sizes of its witness, and of a least exact match the
   least count in every class, of one material and of several. G is the gradation as the certificate asks about it. *)
Theorem accepted_certificate_true gradation certificate line :
  printed (judge gradation certificate) = Some line -> begins_with "accepted" line ->
  exists G D, let cert := certificate_of D in
    read_any_gradation (bytes gradation) = Ok G /\
    forall f, power_law (Z.to_nat (a (asked cert))) (Z.to_nat (b (asked cert))) f ->
    match G with
    | One R =>
      line = accepted_line (statement_of (name gradation) R D) /\ check_document R (bytes certificate) = Ok D /\
      exists G, asked_gradation (gradation_of R) cert = Ok G /\ claim_true f cert G
    | Several R =>
      line = accepted_line (statement_of_mixture (name gradation) R D) /\ check_mixed_document R (bytes certificate) = Ok D /\
      exists M, asked_mixture cert (reduced_mixture (mixture_of R)) = Ok M /\ mixture_claim_true f cert M
    end.
Proof.
  intros P B. destruct (printed_accepted _ _ _ P B) as (G & s & EG & ES & ->). exists G. destruct G as [R|R]; cbn [check_any_statement] in ES.
  - apply check_statement_ok in ES as (D & ED & -> & _). exists D. cbv zeta. split; [exact EG|]. intros f Power.
    split; [reflexivity|]. split; [exact ED|]. apply check_document_ok in ED as (_ & C). exact (certificate_true _ _ f C Power).
  - unfold check_mixed_statement in ES. passed ES. rename x into D. cbv zeta in ES. passed ES. injection ES as <-. exists D. cbv zeta.
    split; [exact EG|]. intros f Power. split; [reflexivity|]. split; [assumption|].
    match goal with E : check_mixed_document _ _ = Ok _ |- _ => apply check_mixed_document_ok in E as (_ & _ & C) end.
    exact (mixture_true _ _ f C Power).
Qed.
