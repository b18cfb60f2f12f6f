(* The main theorems, in the paper's words: what it means that the checker accepts. *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Chain Exact Tolerant Checker Spec Reduction
  RealFacts Pi Sizes ExactSound Solids ExactTheorem TolerantTheorem.
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
    least_number f (asked cert) (rows G') N /\
    (* One with one size a class (Cond3), in the classes, numbers and sizes of the witness's lines. *)
    exists S, allowed f (asked cert) (rows G') S /\ Z.of_nat (length S) = N /\
      describes_articulately (rows G') S /\ Forall (line_true (classes (rows G')) S) (witness cert).
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
  destruct (exact_attained cert G' scale z chain T Wp M Q Sp Zp H f P N EN) as (s & A & L & O & Lines).
  assert (describes (rows G') s) as D.
  { destruct A as (A & _). rewrite T in A. destruct A as (sc & _ & D & _). exact D. }
  exists G', N. split; [exact E|]. split; [exact EN|]. split; [split; [eauto|]|].
  - intros t A'. exact (exact_lower_bound cert G' scale z chain T Wp M Q Zp H f P N t EN A').
  - exists s. split; [exact A|]. split; [exact L|]. split; [exact (one_size_articulate _ _ Wp D O) | exact Lines].
Qed.

Lemma check_tolerant_ok cert G tol nodes :
  check_tolerant cert G tol nodes = Ok tt ->
  exists pr, derive cert G tol = Ok pr /\ check_pi (solids_of (asked cert)) = Ok tt /\
    (forall N, particles cert = Some N -> check_witness cert G pr N = Ok tt) /\ Tree.check_tree pr nodes = Ok tt.
Proof.
  intro H. unfold check_tolerant in H. passed H. rename x into pr. passed H. destruct x. passed H. destruct x.
  exists pr. repeat split; trivial. intros N E. rewrite E in H2. exact H2.
Qed.

Lemma sensible_tolerances cert tol :
  sensible cert = true -> tolerances_of (asked cert) = Some tol ->
  (forall N, particles cert = Some N -> (1 <= N)%Z) /\
  Forall (fun e => 0 <= Q2R e) (passing_each tol) /\
  (forall e, passing_all tol = Some e -> 0 <= Q2R e) /\
  (forall X l h, In (X, l, h) (band tol) -> 0 <= Q2R h).
Proof.
  unfold sensible. cbv zeta. intros S T. rewrite T, !andb_true_iff in S.
  destruct S as (((_ & ((Pa & Pe) & Bd)) & N) & _). repeat split.
  - intros n E. rewrite E in N. apply Z.leb_le, N.
  - apply Forall_forall. intros e I. rewrite forallb_forall in Pe. specialize (Pe e I). apply at_most_real in Pe.
    rewrite Q2R_0 in Pe. exact Pe.
  - intros e E. rewrite E in Pa. apply at_most_real in Pa. rewrite Q2R_0 in Pa. exact Pa.
  - intros X l h I. rewrite forallb_forall in Bd. specialize (Bd _ I). apply at_most_real in Bd. rewrite Q2R_0 in Bd. exact Bd.
Qed.

Lemma well_formed_tolerances G : well_formed G = true -> Forall (fun r => 0 <= Q2R (tolerance r)) (rows G).
Proof.
  unfold well_formed. rewrite !andb_true_iff. intros ((((_ & _) & P) & _) & _). apply Forall_forall. intros r I.
  rewrite forallb_forall in P. specialize (P r I). rewrite !andb_true_iff in P. destruct P as (_ & P).
  apply at_most_real in P. rewrite Q2R_0 in P. exact P.
Qed.

(* No sample with fewer than N particles is within the tolerance, and one with N is. Or, where none is claimed, no
   sample of any number is. *)
Theorem match_within_tolerance G cert f :
  check_certificate G cert = Ok tt -> tolerances_of (asked cert) <> None ->
  power_law (Z.to_nat (a (asked cert))) (Z.to_nat (b (asked cert))) f ->
  exists G', asked_gradation G cert = Ok G' /\
    match particles cert with
    | Some N =>
      least_number f (asked cert) (rows G') N /\
      exists S, allowed f (asked cert) (rows G') S /\ Z.of_nat (length S) = N /\
        describes_articulately (rows G') S /\ Forall (line_true (classes (rows G')) S) (witness cert)
    | None => forall S, ~ allowed f (asked cert) (rows G') S
    end.
Proof.
  intros H T P. apply check_certificate_ok in H as (G' & E & W & S & H).
  destruct (tolerances_of (asked cert)) as [tol|] eqn:Et; [|congruence].
  destruct (proof_of cert) as [scale z chain|nodes] eqn:Ep; [destruct H|].
  destruct (well_formed_proper G' W) as (Wp & M).
  apply check_tolerant_ok in H as (pr & D & Pi & Wi & C).
  pose proof (sensible_question cert S Pi) as (Qa & Qb & _ & Qs & Ql).
  destruct (sensible_tolerances cert tol S Et) as (Np & Te & Tp & Tb).
  exists G'. split; [exact E|]. destruct (particles cert) as [N|] eqn:EN.
  - destruct (tolerant_attained cert G' tol Et Wp M Qa Qb Qs Ql f P pr D (well_formed_tolerances G' W) Te Tp Tb N
                (Np N eq_refl) (Wi N eq_refl)) as (s & A & L & Ds & O & Lines).
    split; [split; [eauto|]|].
    + intros t A'. exact (tolerant_lower_bound cert G' tol nodes Et Wp M Qa Qb Qs Ql f P pr D C N t EN A').
    + exists s. split; [exact A|]. split; [exact L|]. split; [exact (one_size_articulate _ _ Wp Ds O) | exact Lines].
  - intros s. exact (tolerant_none cert G' tol nodes Et Wp M Qa Qb Qs Ql f P pr D C s EN).
Qed.

(* The driver's function: the rows and the text as words. *)
Theorem mdm_check_accepted words has text f :
  mdm_check words has text = Accepted ->
  exists rows0 cert G',
    read_rows words [] = Some rows0 /\ read_certificate text = Ok cert /\
    asked_gradation (Gradation rows0 has) cert = Ok G' /\
    (power_law (Z.to_nat (a (asked cert))) (Z.to_nat (b (asked cert))) f ->
     match particles cert with
     | Some N => least_number f (asked cert) (rows G') N
     | None => forall S, ~ allowed f (asked cert) (rows G') S
     end).
Proof.
  unfold mdm_check. destruct (read_rows words []) as [rows0|]; [|discriminate].
  destruct (check (Gradation rows0 has) text) as [cert0| |] eqn:C; [|discriminate|discriminate]. intros _.
  unfold check in C. passed C. rename x into cert. passed C. destruct x. injection C as _.
  pose proof (check_certificate_ok _ _ C1) as (G' & E & _).
  exists rows0, cert, G'. repeat split; trivial. intro P.
  destruct (tolerances_of (asked cert)) as [tol|] eqn:Et.
  - destruct (match_within_tolerance _ cert f C1) as (G2 & E2 & L); [congruence | exact P|].
    rewrite E in E2. injection E2 as <-. destruct (particles cert); [exact (proj1 L) | exact L].
  - destruct (exact_match _ cert f C1 Et P) as (G2 & N & E2 & EN & L & _).
    rewrite E in E2. injection E2 as <-. rewrite EN. exact L.
Qed.
