(* The main theorems, in the paper's words: what it means that the checker accepts. *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Chain Exact Tolerant Checker Spec Reduction
  RealFacts Pi ExactSound Solids ExactTheorem TolerantTheorem.
Import ListNotations.
Open Scope R_scope.

(* The gradation as the question has it: after pan-size, cut-below and size-factor. *)
Definition asked_gradation (G : gradation) (cert : certificate) : result gradation :=
  apply_question cert (reduced G).

Lemma check_certificate_ok G cert :
  check_certificate G cert = Ok tt ->
  exists G', asked_gradation G cert = Ok G' /\ well_formed G' = true /\ sensible cert = true /\
    match tolerances_of (asked cert), proof_of cert with
    | None, Exact scale z chain => check_exact cert G' scale z chain = Ok tt
    | Some tol, Tolerant nodes => check_tolerant cert G' tol nodes = Ok tt
    | _, _ => False
    end.
Proof.
  intro H. unfold check_certificate in H. passed H. passed H. rename x into G'. passed H.
  apply andb_prop in H0 as (_ & S). exists G'. repeat split; trivial.
  destruct (tolerances_of (asked cert)), (proof_of cert); try discriminate; exact H.
Qed.

Lemma sensible_question cert :
  sensible cert = true -> check_pi (solids_of (asked cert)) = Ok tt -> proper_question (asked cert).
Proof.
  unfold sensible. cbv zeta. rewrite !andb_true_iff, !Z.leb_le. intros (((((((A & B) & R) & _) & S) & _) & _) & _) Pi.
  split; [exact A|]. split; [exact B|]. split; [exact R|].
  destruct (solids_of (asked cert)) as [|d h e|v p r].
  - split; [exact I | left; reflexivity].
  - rewrite !andb_true_iff, !Z.eqb_eq in S. destruct S as ((((A3 & B1) & D) & H) & E).
    apply less_real in D, H. apply at_most_real in E. rewrite Q2R_0 in *. split; [simpl; auto | right; auto].
  - rewrite !andb_true_iff, !Z.eqb_eq in S. destruct S as ((((A3 & B1) & V) & P) & Rr).
    apply less_real in V, P, Rr. rewrite Q2R_0 in *. apply check_pi_sound in Pi. split; [simpl; tauto | right; auto].
Qed.

(* No sample with fewer than N particles is described accurately by the gradation, and one with N is: with the
   question's law x^(a/b), factors, floors, solids and least number of particles. *)
Theorem exact_match G cert f :
  check_certificate G cert = Ok tt -> tolerances_of (asked cert) = None ->
  power_law (Z.to_nat (a (asked cert))) (Z.to_nat (b (asked cert))) f ->
  exists G' N, asked_gradation G cert = Ok G' /\ particles cert = Some N /\
    least_number f (asked cert) (rows G') N.
Proof.
  intros H T P. apply check_certificate_ok in H as (G' & E & W & S & H). rewrite T in H.
  destruct (proof_of cert) as [scale z chain|nodes] eqn:Ep; [|destruct H].
  destruct (well_formed_proper G' W) as (Wp & M).
  assert (check_pi (solids_of (asked cert)) = Ok tt) as Pi.
  { pose proof H as K. unfold check_exact in K. passed K. passed K. passed K. destruct x0. exact K2. }
  pose proof (sensible_question cert S Pi) as Q.
  assert (0 < Q2R scale /\ forall y, z = Some y -> 0 < Q2R y) as (Sp & Zp).
  { unfold sensible in S. cbv zeta in S. rewrite Ep, T, !andb_true_iff in S. destruct S as (_ & Sc & Zz).
    apply less_real in Sc. rewrite Q2R_0 in Sc. split; [exact Sc|]. intros y ->. apply less_real in Zz.
    rewrite Q2R_0 in Zz. exact Zz. }
  assert (exists N, particles cert = Some N) as (N & EN).
  { destruct (check_accepted cert G' scale z chain Zp H) as (N & _ & _ & EN & _). eauto. }
  exists G', N. split; [exact E|]. split; [exact EN|]. split.
  - destruct (exact_attained cert G' scale z chain T Wp M Q Sp Zp H f P N EN) as (s & A & L & _). eauto.
  - intros s A. exact (exact_lower_bound cert G' scale z chain T Wp M Q Zp H f P N s EN A).
Qed.

Lemma check_tolerant_ok cert G tol nodes :
  check_tolerant cert G tol nodes = Ok tt ->
  exists pr, derive cert G tol = Ok pr /\ check_pi (solids_of (asked cert)) = Ok tt /\
    (forall N, particles cert = Some N -> check_witness cert G pr N = Ok tt) /\ Tree.check_tree pr nodes = Ok tt.
Proof.
  intro H. unfold check_tolerant in H. passed H. rename x into pr. passed H. destruct x. passed H. destruct x.
  exists pr. repeat split; trivial. intros N E. rewrite E in H2. exact H2.
Qed.

(* No sample with fewer than N particles is within the tolerance. *)
Theorem tolerant_match_least G cert f :
  check_certificate G cert = Ok tt -> tolerances_of (asked cert) <> None ->
  power_law (Z.to_nat (a (asked cert))) (Z.to_nat (b (asked cert))) f ->
  exists G', asked_gradation G cert = Ok G' /\
    forall S, allowed f (asked cert) (rows G') S ->
      match particles cert with Some N => (N <= Z.of_nat (length S))%Z | None => False end.
Proof.
  intros H T P. apply check_certificate_ok in H as (G' & E & W & S & H).
  destruct (tolerances_of (asked cert)) as [tol|] eqn:Et; [|congruence].
  destruct (proof_of cert) as [scale z chain|nodes] eqn:Ep; [destruct H|].
  destruct (well_formed_proper G' W) as (Wp & M).
  apply check_tolerant_ok in H as (pr & D & Pi & _ & C).
  pose proof (sensible_question cert S Pi) as (Qa & Qb & _ & Qs & Ql).
  exists G'. split; [exact E|]. intros s A. destruct (particles cert) as [N|] eqn:EN.
  - exact (tolerant_lower_bound cert G' tol nodes Et Wp M Qa Qb Qs Ql f P pr D C N s EN A).
  - exact (tolerant_none cert G' tol nodes Et Wp M Qa Qb Qs Ql f P pr D C s EN A).
Qed.
