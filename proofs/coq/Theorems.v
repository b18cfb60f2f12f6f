(* The main theorems, in the paper's words: what it means that the checker accepts. *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Chain Exact Tolerant Checker Spec Openings
  Reduction RealFacts Pi Sizes Contents ExactSound Solids ExactTheorem Shares TolerantSound TolerantTheorem.
Import ListNotations.
Open Scope R_scope.

(* The gradation as the question has it: after pan-size, cut-below and size-factor. *)
Definition asked_gradation (G : gradation) (cert : certificate) : result gradation :=
  apply_question cert (reduced G).

Lemma check_certificate_ok G cert :
  check_certificate G cert = Ok tt ->
  exists G', asked_gradation G cert = Ok G' /\ well_formed G' = true /\ sensible cert = true /\
    match tolerances_of (asked cert), proof_of cert with
    | None, Exact scale z chain => check_exact cert (root G') (rows G') (classes (rows G')) scale z chain = Ok tt
    | Some tol, Tolerant nodes => exists ss, shares_of (asked cert) tol G' = Ok ss /\
      check_tolerant cert (root G') (rows G') (all_begin (classes (rows G'))) ss tol nodes = Ok tt
    | _, _ => False
    end.
Proof.
  intro H. unfold check_certificate in H. passed H. passed H. rename x into G'. passed H.
  apply andb_prop in H0 as (_ & S). exists G'. repeat split; trivial.
  destruct (tolerances_of (asked cert)), (proof_of cert); try discriminate; [|exact H]. passed H. eauto.
Qed.

Lemma sensible_question cert :
  sensible cert = true -> check_pi (solids_of (asked cert)) = Ok tt -> proper_question (asked cert).
Proof.
  unfold sensible. cbv zeta. rewrite !andb_true_iff, !Z.leb_le. intros ((((((((A & B) & R) & _) & S) & _) & _) & _) & _) Pi.
  split; [exact A|]. split; [exact B|]. split; [exact R|].
  destruct (solids_of (asked cert)) as [|d h e|v p r].
  - split; [exact I | left; reflexivity].
  - rewrite !andb_true_iff, !Z.eqb_eq in S. destruct S as ((((A3 & B1) & D) & H) & E).
    apply less_real in D, H. apply at_most_real in E. rewrite Q2R_0 in *. split; [simpl; auto | right; auto].
  - rewrite !andb_true_iff, !Z.eqb_eq in S. destruct S as ((((A3 & B1) & V) & P) & Rr).
    apply less_real in V, P, Rr. rewrite Q2R_0 in *. apply check_pi_sound in Pi. split; [simpl; tauto | right; auto].
Qed.

(* ---- What an accepted certificate claims --------------------------------------------------------- *)

(* S has the witness's number of particles; one size a class (Cond3); and in each class that the witness names the number
   and the size that its line says. *)
Definition is_witness (f : R -> R) (cert : certificate) (G : gradation) (N : Z) (S : sample) : Prop :=
  allowed f (asked cert) G S /\ Z.of_nat (length S) = N /\ describes_articulately (root_of G) (rows G) S /\
  Forall (line_true (root_of G) (classes (rows G)) S) (witness cert).

(* No sample that the question allows has fewer particles than S in any class; and one with as many particles has as
   many in every class. *)
Definition least_in_every_class (f : R -> R) (q : question) (G : gradation) (S : sample) : Prop :=
  forall T, allowed f q G T ->
    (forall j, In j (classes (rows G)) -> (number (root_of G) j S <= number (root_of G) j T)%Z) /\
    (length T = length S ->
     forall j, In j (classes (rows G)) -> number (root_of G) j T = number (root_of G) j S).

(* With the question's law, factors, floors, solids, tolerance and least number of particles. Where an exact question
   asks for at least N particles and N are enough, several samples of N may differ in their counts. *)
Definition claim_true (f : R -> R) (cert : certificate) (G : gradation) : Prop :=
  let q := asked cert in
  match claimed cert with
  | Smallest N =>
    least_number f q G N /\
    (exists S, is_witness f cert G N S) /\
    (tolerances_of q = None -> (at_least q < N)%Z ->
     forall S, allowed f q G S -> Z.of_nat (length S) = N -> least_in_every_class f q G S)
  | Between B N => (forall S, allowed f q G S -> (B <= Z.of_nat (length S))%Z) /\ exists S, is_witness f cert G N S
  | NoneBelow B => forall S, allowed f q G S -> (B <= Z.of_nat (length S))%Z
  | NoMatch => forall S, ~ allowed f q G S
  end.

Lemma counts_le (g h : class -> Z) l : Forall2 Z.le (map g l) (map h l) -> forall j, In j l -> (g j <= h j)%Z.
Proof.
  induction l as [|i l IH]; intros F j J; [destruct J|]. simpl in F. inversion F; subst.
  destruct J as [<-|J]; [assumption | apply IH; assumption].
Qed.

Theorem exact_match G cert f :
  check_certificate G cert = Ok tt -> tolerances_of (asked cert) = None ->
  power_law (Z.to_nat (a (asked cert))) (Z.to_nat (b (asked cert))) f ->
  exists G', asked_gradation G cert = Ok G' /\ (exists N, found (claimed cert) = Some N) /\ claim_true f cert G'.
Proof.
  intros H T P. apply check_certificate_ok in H as (G' & E & W & S & H). rewrite T in H.
  destruct (proof_of cert) as [scale z chain|nodes] eqn:Ep; [|destruct H].
  destruct (well_formed_proper G' W) as (Wp & M). pose proof (well_formed_root G' W) as Rd.
  assert (check_pi (solids_of (asked cert)) = Ok tt) as Pi.
  { pose proof H as K. unfold check_exact in K. passed K. passed K. passed K. destruct x0. exact K2. }
  pose proof (sensible_question cert S Pi) as Q.
  assert (0 < Q2R scale /\ forall y, z = Some y -> 0 < Q2R y) as (Sp & Zp).
  { unfold sensible in S. cbv zeta in S. rewrite Ep, T, !andb_true_iff in S. destruct S as (_ & Sc & Zz).
    apply less_real in Sc. rewrite Q2R_0 in Sc. split; [exact Sc|]. intros y ->. apply less_real in Zz.
    rewrite Q2R_0 in Zz. exact Zz. }
  rewrite Rd in H. set (d := root_of G') in *. set (js := classes (rows G')) in *.
  pose proof (classes_integral (rows G')) as I. pose proof (proper_classes (rows G') Wp) as Pj. fold js in I, Pj, M.
  pose proof Q as (_ & _ & _ & _ & Ql).
  destruct (check_accepted cert d (rows G') js scale z chain Zp H) as (N & B & _ & _ & EN & EB & _).
  pose proof (match_of_sample (asked cert) G' d Rd T Wp Ql f P) as Down. pose proof (sample_of_match (asked cert) G' d Rd T Wp Ql f P) as Up.
  fold js in Down, Up.
  assert (exists s, is_witness f cert G' N s) as Attained.
  { destruct (exact_attained cert d (rows G') js scale z chain I Pj M Q Sp Zp H f P N EN) as (s & ns & At & Sum & Lines).
    destruct (Up s ns At) as (S' & A & L & D & O & C). exists S'. split; [exact A|]. split; [congruence|].
    split; [exact (one_size_articulate _ _ Wp D O)|]. rewrite <- C in Lines. eapply Forall_impl; [|exact Lines].
    intros w. apply (line_of_sample _ _ f (rows G') S' w P Wp D O). }
  assert (forall S', allowed f (asked cert) G' S' -> (B <= Z.of_nat (length S'))%Z) as Lower.
  { intros S' A. destruct (Down S' A) as ((s & At) & ->).
    exact (exact_lower_bound cert d (rows G') js scale z chain I Pj M Q Zp H f P B s _ EB At). }
  exists G'. split; [exact E|]. split; [eauto|]. unfold claim_true.
  destruct (claimed cert) as [n|least n|least|] eqn:EC; try discriminate EN.
  2: { injection EN as ->. injection EB as ->. split; assumption. }
  injection EN as ->. injection EB as <-. split; [split; [|exact Lower]|split; [exact Attained|]].
  - destruct Attained as (s & A & L & _). eauto.
  - intros _ Lt s' A' L' t At.
    assert (bound_of (claimed cert) = Some N) as EB by (rewrite EC; reflexivity).
    assert (forall S' T', allowed f (asked cert) G' S' -> Z.of_nat (length S') = N -> allowed f (asked cert) G' T' ->
      Forall2 Z.le (map (fun j => number d j S') js) (map (fun j => number d j T') js)) as K.
    { intros S' T' AS LS AT. destruct (Down S' AS) as ((s1 & At1) & L1), (Down T' AT) as ((s2 & At2) & _).
      apply (exact_least_counts cert d (rows G') js scale z chain I Pj M Q Zp H f P N s1 _ s2 _ EB Lt At1 ltac:(congruence) At2). }
    split; [exact (counts_le _ _ _ (K s' t A' L' At))|]. intros Lt' j J.
    apply Z.le_antisymm.
    + apply (counts_le _ _ _ (K t s' At ltac:(congruence) A') j J).
    + apply (counts_le _ _ _ (K s' t A' L' At) j J).
Qed.

Lemma check_tolerant_ok cert d rs js ss tol nodes :
  check_tolerant cert d rs js ss tol nodes = Ok tt ->
  exists pr, derive cert d rs js ss tol = Ok pr /\ check_pi (solids_of (asked cert)) = Ok tt /\
    (forall N, found (claimed cert) = Some N -> check_witness cert d (map fst js) pr N = Ok tt) /\ Tree.check_tree pr nodes = Ok tt.
Proof.
  intro H. unfold check_tolerant in H. passed H. rename x into pr. passed H. destruct x. passed H. destruct x.
  exists pr. repeat split; trivial. intros N E. rewrite E in H2. exact H2.
Qed.

Lemma sensible_tolerances cert tol :
  sensible cert = true -> tolerances_of (asked cert) = Some tol ->
  (forall N, found (claimed cert) = Some N -> (1 <= N)%Z) /\
  Forall (fun e => 0 <= Q2R e) (passing_each tol) /\
  (forall e, passing_all tol = Some e -> 0 <= Q2R e) /\
  (forall X l h, In (X, l, h) (band tol) -> 0 <= Q2R X /\ 0 <= Q2R h) /\
  (forall K, size_factor (asked cert) = Some K -> 0 <= Q2R K).
Proof.
  unfold sensible. cbv zeta. intros S T. rewrite T, !andb_true_iff in S.
  destruct S as ((((_ & ((Pa & Pe) & Bd)) & Kp) & N) & _).
  split; [|split; [|split; [|split]]].
  - intros n E. rewrite E in N. apply Z.leb_le, N.
  - apply Forall_forall. intros e I. rewrite forallb_forall in Pe. specialize (Pe e I). apply at_most_real in Pe.
    rewrite Q2R_0 in Pe. exact Pe.
  - intros e E. rewrite E in Pa. apply at_most_real in Pa. rewrite Q2R_0 in Pa. exact Pa.
  - intros X l h I. rewrite forallb_forall in Bd. specialize (Bd _ I). apply andb_prop in Bd as (B1 & B2).
    apply at_most_real in B1, B2. rewrite Q2R_0 in B1, B2. auto.
  - intros K E. rewrite E in Kp. apply less_real in Kp. rewrite Q2R_0 in Kp. lra.
Qed.

Lemma well_formed_tolerances G : well_formed G = true -> Forall (fun r => 0 <= Q2R (tolerance r)) (rows G).
Proof.
  unfold well_formed. rewrite !andb_true_iff. intros ((((_ & _) & P) & _) & _). apply Forall_forall. intros r I.
  rewrite forallb_forall in P. specialize (P r I). rewrite !andb_true_iff in P. destruct P as (_ & P).
  apply at_most_real in P. rewrite Q2R_0 in P. exact P.
Qed.

Theorem match_within_tolerance G cert f :
  check_certificate G cert = Ok tt -> tolerances_of (asked cert) <> None ->
  power_law (Z.to_nat (a (asked cert))) (Z.to_nat (b (asked cert))) f ->
  exists G', asked_gradation G cert = Ok G' /\ claim_true f cert G'.
Proof.
  intros H T P. apply check_certificate_ok in H as (G' & E & W & S & H).
  destruct (tolerances_of (asked cert)) as [tol|] eqn:Et; [|congruence].
  destruct (proof_of cert) as [scale z chain|nodes] eqn:Ep; [destruct H|].
  destruct (well_formed_proper G' W) as (Wp & M). pose proof (well_formed_root G' W) as Rd.
  destruct H as (ss & Sh & H). rewrite Rd in H. set (d := root_of G') in *. set (js := classes (rows G')) in *.
  apply check_tolerant_ok in H as (pr & D & Pi & Wi & C).
  pose proof (sensible_question cert S Pi) as (Qa & Qb & _ & Qs & Ql).
  destruct (sensible_tolerances cert tol S Et) as (Np & Te & Tp & Tb & Kn).
  assert (forall X l h, In (X, l, h) (band tol) -> 0 <= Q2R X) as Bx by (intros X l h I; apply (Tb X l h I)).
  assert (forall X l h, In (X, l, h) (band tol) -> 0 <= Q2R h) as Bh by (intros X l h I; apply (Tb X l h I)).
  exists G'. split; [exact E|].
  pose proof (within_of_sample (asked cert) G' d tol ss Et Rd Kn Bx Wp M Ql f P Sh) as Down.
  pose proof (sample_of_within (asked cert) G' d tol ss Et Rd Kn Bx Wp M Ql f P Sh (well_formed_tolerances G' W) Te Tp Bh) as Up.
  pose proof (shares_have_targets (asked cert) G' tol ss Wp M Sh) as Targets. pose proof (rows_all_begin (asked cert) G' tol ss Wp M Sh) as None_.
  pose proof (proper_classes (rows G') Wp) as Pj. fold js in Down, Up, Targets, None_, Pj, M.
  rewrite <- (all_begin_classes js) in Pj, M. rewrite <- (all_begin_classes js) in Targets at 1 2.
  pose proof (classes_follow (rows G')) as Fo. fold js in Fo. pose proof (openings_not_negative (rows G') Wp) as On.
  assert (forall B, bound_of (claimed cert) = Some B -> forall s, allowed f (asked cert) G' s -> (B <= Z.of_nat (length s))%Z) as Lower.
  { intros B EB s A. destruct (Down s A) as (At & ->).
    exact (tolerant_lower_bound cert d (rows G') (all_begin js) ss tol nodes Fo On Pj M Targets None_ Qa Qb Qs f P pr D C B _ EB At). }
  assert (forall N, found (claimed cert) = Some N -> exists s, is_witness f cert G' N s) as Attained.
  { intros N EN.
    destruct (tolerant_attained cert d (rows G') (all_begin js) ss tol Fo On Pj M Targets None_ Qa Qb Qs f P pr D N (Np N EN) (Wi N EN))
      as (qts & At & Sum & Lines).
    destruct (Up qts At) as (s & A & L & Ds & O & Cs). exists s. split; [exact A|]. split; [congruence|].
    split; [exact (one_size_articulate _ _ Wp Ds O)|]. rewrite <- Cs, all_begin_classes in Lines. eapply Forall_impl; [|exact Lines].
    intros w. apply (line_of_sample _ _ f (rows G') s w P Wp Ds O). }
  unfold claim_true. destruct (claimed cert) as [N|B N|B|] eqn:EN.
  - destruct (Attained N eq_refl) as (s & A). split; [split; [exists s; split; apply A | exact (Lower N eq_refl)]|].
    split; [exists s; exact A | congruence].
  - split; [exact (Lower B eq_refl) | exact (Attained N eq_refl)].
  - exact (Lower B eq_refl).
  - intros s A. destruct (Down s A) as (At & _).
    exact (tolerant_none cert d (rows G') (all_begin js) ss tol nodes Fo On Pj M Targets None_ Qa Qb Qs f P pr D C _ EN At).
Qed.

Theorem certificate_true G cert f :
  check_certificate G cert = Ok tt ->
  power_law (Z.to_nat (a (asked cert))) (Z.to_nat (b (asked cert))) f ->
  exists G', asked_gradation G cert = Ok G' /\ claim_true f cert G'.
Proof.
  intros C P. destruct (tolerances_of (asked cert)) as [tol|] eqn:Et.
  - apply (match_within_tolerance G); congruence.
  - destruct (exact_match G cert f C Et P) as (G' & E & _ & L). eauto.
Qed.
