(* From samples to the problem of Leaf.v and back (Theorem 12). *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Exact Leaf Tree Tolerant Spec Openings Reduction RealFacts
  Solids LeafSound TreeSound Shares.
Import ListNotations.
Open Scope R_scope.

Local Arguments Z.mul : simpl never.

(* x^(a/b) is Y^(na/nb) for the power Y = x^d of an opening. *)
Section Units.
Context {d : positive}.
Variables (na nb : nat).
Hypothesis b_positive : (1 <= nb)%nat.
Variable law : R -> R.
Hypothesis power : opening_law d na nb law.

(* ---- Roots of openings --------------------------------------------------------------------------- *)

Lemma rational_root_real x y :
  0 <= Q2R x -> rational_root (Z.of_nat nb) x = Ok y -> 0 <= Q2R y /\ Q2R y ^ nb = Q2R x.
Proof.
  intros X H. unfold rational_root in H. passed H. injection H as <-.
  apply andb_prop in H0 as (N & D). apply Z.eqb_eq in N, D.
  set (n := Numbers.root (Z.of_nat nb) (Qnum x)) in *. set (e := Numbers.root (Z.of_nat nb) (Zpos (Qden x))) in *.
  pose proof (den_positive x) as Dx.
  assert (0 <= Qnum x)%Z as Nx.
  { apply le_IZR. rewrite Q2R_num. apply Rmult_le_pos; lra. }
  assert (0 <= n)%Z as N0 by (apply root_spec; lia). assert (0 <= e)%Z as D0 by (apply root_spec; lia).
  assert (0 < e)%Z as Dp.
  { destruct (Z.eq_dec e 0) as [E|]; [|lia]. rewrite E, Z.pow_0_l in D by lia. discriminate. }
  rewrite Q2R_fraction by exact Dp. pose proof (IZR_lt _ _ Dp) as Dr. pose proof (IZR_le _ _ N0) as Nr. split.
  - apply Rmult_le_pos; [exact Nr | left; apply Rinv_0_lt_compat, Dr].
  - unfold Rdiv. rewrite Rpow_mult_distr, pow_inv, !pow_IZR, N, D. unfold Q2R. reflexivity.
Qed.

Lemma rational_roots_real rs : forall roots,
  Forall (fun r => 0 <= Q2R (opening r)) rs -> rational_roots (Z.of_nat nb) rs = Ok roots ->
  Forall2 (fun r x => 0 <= Q2R x /\ Q2R x ^ nb = Q2R (opening r)) rs roots.
Proof.
  induction rs as [|r rs IH]; intros roots P H; cbn [rational_roots] in H; [injection H as <-; constructor|].
  passed H. passed H. injection H as <-. inversion P; subst. constructor; [apply rational_root_real; assumption | auto].
Qed.

Lemma law_of_root x y : 0 <= Q2R x -> Q2R x ^ nb = Q2R y -> law (size_of d y) = Q2R x ^ na.
Proof.
  intros X E. assert (0 <= Q2R y) as Y by (rewrite <- E; apply pow_le, X).
  destruct power as (_ & P). destruct (P y Y) as (L & Lp).
  assert (law (size_of d y) ^ nb = (Q2R x ^ na) ^ nb) as K.
  { rewrite Lp, <- E, <- !pow_mult. f_equal. lia. }
  assert (0 <= Q2R x ^ na) as Z by (apply pow_le, X).
  apply Rle_antisym; apply (pow_le_iff _ _ nb); trivial; lra.
Qed.

(* ---- Classes in integers ------------------------------------------------------------------------- *)

(* The classes are those between the rows, in their order. *)
Fixpoint follow (rs : list row) (places : list between_rows) : Prop :=
  match rs, places with
  | r :: ((next :: _) as rest), (j, begins) :: places =>
    (begins = true -> lower j = opening r /\ upper j = opening next) /\ c j = factor r /\ follow rest places
  | [_], [] | [], [] => True
  | _, _ => False
  end.

Record represents (least : Z) (sol : solids) (mu su : R) (p : between_rows) (s : share) (l : limits) : Prop := {
  rep_f : snd p = true -> IZR (f l) = Q2R (c (fst p)) * law (lower_size d (fst p)) * mu;
  rep_F : snd p = true -> IZR (F l) = Q2R (c (fst p)) * law (upper_size d (fst p)) * mu;
  rep_none : snd p = false -> f l = 0%Z /\ F l = 1%Z;
  rep_floor : floor l = if equal (mass (fst p)) 0 then 0%Z else least;
  rep_retained_lo : IZR (retained_lo l) = Q2R (lo (retained_in s)) * su;
  rep_retained_hi : IZR (retained_hi l) = Q2R (hi (retained_in s)) * su;
  rep_passing_lo : IZR (passing_lo l) = Q2R (lo (passing_in s)) * su;
  rep_passing_hi : IZR (passing_hi l) = Q2R (hi (passing_in s)) * su;
  rep_g : IZR (g l) = Q2R (g_j s) * su;
  rep_per_factor : IZR (per_factor l) = Q2R (inverse_factor sol (fst p)) * su }.

Lemma limits_represent least size_unit factor_unit unit sol : forall rs places ss roots,
  Forall2 (fun r x => 0 <= Q2R x /\ Q2R x ^ nb = Q2R (opening r)) rs roots ->
  follow rs places -> length ss = length places ->
  (forall x, In x roots -> (Zpos (Qden x) | size_unit)%Z) ->
  (forall r, In r rs -> (Zpos (Qden (factor r)) | factor_unit)%Z) ->
  (forall p s, In (p, s) (combine places ss) ->
     forall e, In e (denominators (inverse_factor sol (fst p)) s) -> (e | unit)%Z) ->
  Forall2 (fun ps l => represents least sol (IZR (size_unit ^ Z.of_nat na * factor_unit)) (IZR unit) (fst ps) (snd ps) l)
    (combine places ss) (limits_of least (Z.of_nat na) size_unit factor_unit unit sol places ss roots).
Proof.
  induction rs as [|r rs IH]; intros places ss roots Ro Fo Le Dx Dc Du; [destruct places; [constructor | destruct Fo]|].
  destruct rs as [|next later]; [destruct places; [constructor | destruct Fo]|].
  inversion Ro as [|? x ? roots1 (Rx0 & Rx) Ro1]; subst. inversion Ro1 as [|? y ? roots2 (Ry0 & Ry) Ro2]; subst.
  destruct places as [|(j, begins) places]; [destruct Fo|]. destruct Fo as (Bounds & Cj & Fo).
  destruct ss as [|s ss]; [discriminate|].
  cbn [limits_of combine]. constructor.
  - cbn [fst snd].
    assert (forall e, In e (denominators (inverse_factor sol j) s) -> (e | unit)%Z) as D by (apply (Du (j, begins) s); left; reflexivity).
    assert (forall z, In z [g_j s; inverse_factor sol j; lo (retained_in s); hi (retained_in s); lo (passing_in s); hi (passing_in s)] ->
              IZR (in_units z unit) = Q2R z * IZR unit) as U.
    { intros z Z. apply in_units_real, D. unfold denominators. apply in_map_iff. exists z. auto. }
    assert (IZR (in_units (c j) factor_unit) = Q2R (c j) * IZR factor_unit) as Uc
      by (rewrite Cj; apply in_units_real, Dc; left; reflexivity).
    assert (forall z, In z (x :: y :: roots2) -> IZR (in_units z size_unit) = Q2R z * IZR size_unit) as Ux
      by (intros z Z; apply in_units_real, Dx, Z).
    constructor; cbn [Leaf.f Leaf.F Leaf.floor Leaf.retained_lo Leaf.retained_hi Leaf.passing_lo Leaf.passing_hi Leaf.g
                      Leaf.per_factor fst snd]; try (apply U; simpl; tauto); trivial.
    + intros ->. destruct (Bounds eq_refl) as (Lo & _). unfold lower_size. rewrite Lo.
      rewrite !mult_IZR, <- !pow_IZR, Uc, (Ux x), (law_of_root x (opening r) Rx0 Rx), Rpow_mult_distr by (simpl; tauto). ring.
    + intros ->. destruct (Bounds eq_refl) as (_ & Hi). unfold upper_size. rewrite Hi.
      rewrite !mult_IZR, <- !pow_IZR, Uc, (Ux y), (law_of_root y (opening next) Ry0 Ry), Rpow_mult_distr by (simpl; tauto). ring.
    + intros ->. split; reflexivity.
  - apply IH; trivial.
    + injection Le as Le. exact Le.
    + intros z Z. apply Dx. right; exact Z.
    + intros r' I. apply Dc. right; exact I.
    + intros i t I. apply Du. right; exact I.
Qed.

Lemma classes_follow rs : follow rs (all_begin (classes rs)).
Proof.
  induction rs as [|r rs IH]; [exact I|]. destruct rs as [|next later]; [exact I|].
  split; [intros _; split; reflexivity|]. split; [reflexivity | exact IH].
Qed.

End Units.

Arguments represents : clear implicits.

(* ---- The sample's shares ------------------------------------------------------------------------- *)

Section Sample.
Context {d : positive}.
Variables (law : R -> R) (rs : list row) (S : sample).
Hypothesis law_ok : mass_law law.
Hypothesis rows_proper : proper_rows rs.
Hypothesis some_mass : exists j, In j (classes rs) /\ 0 < Q2R (mass j).
Hypothesis mass_positive : 0 < mass_of_all d law rs S.
Notation js := (classes rs).
Notation M := (mass_of_all d law rs S).
Notation x := (fun j => share_retained d law rs j S).
Notation y := (fun j => share_passing d law rs (upper_size d j) S).
Notation gx := (fun j => target_retained rs j).
Notation gy := (fun j => target_passing d rs (upper_size d j)).
Notation pass := (fun X => share_passing d law rs X S).

Lemma held_nonneg j : In j js -> 0 <= held d law j S.
Proof.
  intro J. pose proof (proper_classes rs rows_proper) as P. rewrite Forall_forall in P. pose proof (P j J) as Pj.
  destruct (sample_realizes (d := d) law law_ok j S Pj) as [(_ & ->)|(Q & B)]; [lra|].
  destruct (proper_sizes (d := d) j Pj) as (L & _). destruct Pj as (_ & C & _). apply (IZR_le 1) in Q.
  pose proof (law_nonneg law law_ok _ L).
  assert (0 <= IZR (number d j S) * (Q2R (c j) * law (lower_size d j))) by (apply Rmult_le_pos; [|apply Rmult_le_pos]; lra). lra.
Qed.

Lemma mass_nonneg j : In j js -> 0 <= Q2R (mass j).
Proof. intro J. pose proof (proper_classes rs rows_proper) as P. rewrite Forall_forall in P. apply (P j J). Qed.

Lemma gradation_mass_positive : 0 < gradation_mass rs.
Proof.
  destruct some_mass as (j & J & Mj). unfold gradation_mass.
  pose proof (total_member (fun j => Q2R (mass j)) js j (fun i I => mass_nonneg i I) J). simpl in H. lra.
Qed.

Lemma js_ascend : ascend_from d (least_opening d rs) js.
Proof. apply classes_ascend, rows_proper. Qed.

Lemma shares_prefix : prefix_of x y 0 js /\ prefix_of gx gy 0 js.
Proof.
  split.
  - pose proof (up_to_prefix (fun j => held d law j S) js _ 0 js_ascend) as P. apply (prefix_scale (/ M)) in P.
    refine (prefix_ext _ _ _ _ _ _ _ _ P); [ring|]. intros j _. rewrite Rplus_0_l. reflexivity.
  - pose proof (up_to_prefix (fun j => Q2R (mass j)) js _ 0 js_ascend) as P. apply (prefix_scale (/ gradation_mass rs)) in P.
    refine (prefix_ext _ _ _ _ _ _ _ _ P); [ring|]. intros j _. rewrite Rplus_0_l. reflexivity.
Qed.

Lemma ratio_unit t m : 0 < m -> 0 <= t <= m -> 0 <= t / m <= 1.
Proof.
  intros Mp (A & B). split.
  - apply Rmult_le_pos; [exact A | left; apply Rinv_0_lt_compat, Mp].
  - apply (Rmult_le_reg_r m); [exact Mp|]. replace (t / m * m) with t by (field; lra). lra.
Qed.

Lemma shares_unit j : In j js -> 0 <= x j <= 1 /\ 0 <= y j <= 1.
Proof.
  intro J. split; apply ratio_unit; trivial.
  - split; [apply held_nonneg, J|]. apply (total_member (fun j => held d law j S) js j); [apply held_nonneg | exact J].
  - apply (up_to_between (fun j => held d law j S) (upper_size d j) js held_nonneg).
Qed.

Lemma uppers_le l : forall x1 j i, ascend_from d x1 l -> In i l -> last l j = j -> In j l -> upper_size d i <= upper_size d j.
Proof.
  induction l as [|k l IH]; intros x1 j i A I L J; [destruct I|]. destruct A as (E & Lt & A).
  destruct l as [|k2 l].
  { simpl in *. destruct I as [<-|[]], J as [<-|[]]. lra. }
  change (last (k :: k2 :: l) j) with (last (k2 :: l) j) in L.
  assert (In j (k2 :: l)) as J2.
  { rewrite <- L. clear. revert k2. induction l as [|k3 l IH]; intro k2; [left; reflexivity|].
    change (last (k2 :: k3 :: l) j) with (last (k3 :: l) j). right. apply IH. }
  destruct I as [<-|I]; [pose proof (above_uppers _ _ _ A J2); lra | exact (IH _ _ _ A I L J2)].
Qed.

Lemma pass_all X j : In j js -> last js j = j -> upper_size d j <= X -> pass X = 1.
Proof.
  intros J L H. unfold share_passing, mass_passing.
  change (up_to d (fun j => held d law j S) X js / M = 1). rewrite up_to_all.
  - unfold mass_of_all in *. field. lra.
  - intros i I. pose proof (uppers_le js _ j i js_ascend I L J). lra.
Qed.

Lemma pass_nothing X : X <= least_opening d rs -> pass X = 0.
Proof.
  intro H. unfold share_passing, mass_passing. change (up_to d (fun j => held d law j S) X js / M = 0).
  rewrite (up_to_none _ X js _ js_ascend H). field. lra.
Qed.

Lemma target_all j : In j js -> last js j = j -> gy j = 1.
Proof.
  intros J L. unfold target_passing. change (up_to d (fun j => Q2R (mass j)) (upper_size d j) js / gradation_mass rs = 1).
  pose proof gradation_mass_positive as G. rewrite up_to_all.
  - unfold gradation_mass in *. field. lra.
  - intros i I. exact (uppers_le js _ j i js_ascend I L J).
Qed.

(* ---- What the checker derives -------------------------------------------------------------------- *)

Lemma sum_of_rows : Q2R (fold_left add (map retained rs) 0%Q) = gradation_mass rs.
Proof.
  assert (forall l x0, Q2R (fold_left add l x0) = Q2R x0 + total (map Q2R l)) as F.
  { induction l as [|q l IH]; intro x0; simpl; [ring|]. rewrite IH, Q2R_add. ring. }
  rewrite F, Q2R_0, Rplus_0_l. destruct rows_proper as (_ & _ & C & _). unfold complete, last_row in C.
  unfold gradation_mass. revert C. clear. induction rs as [|r l IH]; [reflexivity|].
  destruct l as [|n l].
  - intro C. simpl in *. apply Qeq_eqR in C. rewrite Q2R_0 in C. rewrite C. ring.
  - intro C. change (classes (r :: n :: l)) with (Class (opening r) (opening n) (retained r) (factor r) :: classes (n :: l)).
    cbn [map total fold_right mass]. f_equal. apply IH. exact C.
Qed.

Lemma shares_length tol all l : forall G each, length (shares tol all G l each) = length (classes l).
Proof.
  induction l as [|r l IH]; intros G each; [reflexivity|]. destruct l as [|n l]; [reflexivity|].
  change (classes (r :: n :: l)) with (Class (opening r) (opening n) (retained r) (factor r) :: classes (n :: l)).
  cbn [shares length]. f_equal. apply IH.
Qed.

Lemma apply_band_length l : forall ss lines result,
  length ss = length l -> apply_band l ss lines = Ok result -> length result = length l.
Proof.
  induction l as [|j l IH]; intros [|s ss] lines result Le H; try discriminate; cbn [apply_band] in H; [injection H as <-; reflexivity|].
  destruct l as [|j2 l].
  - passed H. injection H as <-. reflexivity.
  - destruct lines as [|((X, lo1), hi1) rest]; [injection H as <-; exact Le|].
    passed H. passed H. injection H as <-. cbn [length]. f_equal. eapply IH; [|exact H1]. simpl in *. congruence.
Qed.

Lemma last_in (l : list class) none : l <> [] -> In (last l none) l /\ forall other, last l other = last l none.
Proof.
  induction l as [|i l IH]; [congruence|]. intros _. destruct l as [|i2 l]; [simpl; auto|].
  destruct (IH ltac:(congruence)) as (A & B). split; [right; exact A | exact B].
Qed.

Lemma in_unit_ok K lines : forall result, in_unit (Zpos d) K lines = Ok result ->
  result = map (fun '(X, l, h) => (power (match K with Some K => times X K | None => X end) (Zpos d), l, h)) lines.
Proof.
  induction lines as [|((X, l), h) lines IH]; intros result H; cbn [in_unit] in H; [injection H as <-; reflexivity|].
  passed H. passed H. injection H as <-. unfold to_power in H0. passed H0. injection H0 as <-.
  cbn [map]. f_equal. apply IH, H1.
Qed.

Theorem shares_of_fit q tol G ss :
  root G = Zpos d -> (forall K, size_factor q = Some K -> 0 <= Q2R K) ->
  (forall X l h, In (X, l, h) (band tol) -> 0 <= Q2R X) ->
  rows G = rs -> shares_of q tol G = Ok ss ->
  length ss = length js /\
  (Forall2 (fits_share x y gx) js ss ->
     lines_hold tol x y gx gy rs (passing_each tol)) /\
  ((forall X l h, In (X, l, h) (band tol) -> 0 <= Q2R h) -> Forall2 (fits_share x y gx) js ss ->
     forall X l h, In (X, l, h) (band tol) -> Q2R l / 100 <= pass (scaled (size_factor q) X) <= Q2R h / 100) /\
  (lines_hold tol x y gx gy rs (passing_each tol) ->
   (forall X l h, In (X, l, h) (band tol) -> Q2R l / 100 <= pass (scaled (size_factor q) X) <= Q2R h / 100) ->
     Forall2 (fits_share x y gx) js ss).
Proof.
  intros Rd Kn Xn Er H. unfold shares_of in H. rewrite Er, Rd in H. cbv zeta in H. passed H. passed H.
  passed H. rename x into given. passed H. rename x into lines. apply in_unit_ok in H2.
  set (all := fold_left add (map retained rs) 0%Q) in *.
  set (raw := shares tol all 0 rs (passing_each tol)) in *.
  destruct some_mass as (j0 & J0 & _). assert (js <> []) as Ne by (intro E; rewrite E in J0; destruct J0).
  assert (length raw = length js) as Lr by apply shares_length.
  pose proof (apply_band_length js raw lines ss Lr H) as Ls. split; [exact Ls|].
  pose proof gradation_mass_positive as Gm. destruct shares_prefix as (Px & Pg).
  assert (Forall2 (fits_share x y gx) js raw <-> lines_hold tol x y gx gy rs (passing_each tol)) as A.
  { apply shares_fit.
    - unfold all. rewrite sum_of_rows. lra.
    - intros j _. unfold all. rewrite sum_of_rows. reflexivity.
    - rewrite Q2R_0. exact Pg.
    - apply shares_unit. }
  (* What passes the opening with the power X. *)
  set (pass_power := fun X => pass (nth_root d X)).
  assert (Forall2 (fits_share x y gx) js ss <-> Forall2 (fits_share x y gx) js raw /\ band_holds pass_power lines) as B.
  { apply (apply_band_fit x y gx gy pass_power js raw lines ss (eq_sym Lr) Ne H); [intros; reflexivity|].
    intros X HX. destruct (last_in js (Class 0 0 0 0) Ne) as (Li & Ld). cbv beta.
    unfold pass_power. rewrite (pass_all (nth_root d X) _ Li (Ld _)) by (apply nth_root_le, HX).
    symmetry. apply (pass_all _ _ Li (Ld _)). lra. }
  assert (forall X l h, In (X, l, h) (band tol) ->
            pass_power (Q2R (power (match size_factor q with Some K => times X K | None => X end) (Zpos d))) =
            pass (scaled (size_factor q) X)) as Same.
  { intros X l h I. unfold pass_power. f_equal. rewrite Q2R_power_pos. specialize (Xn X l h I). unfold scaled.
    destruct (size_factor q) as [K|]; [|apply nth_root_unique, Xn]. specialize (Kn K eq_refl).
    rewrite Q2R_times, nth_root_unique; [ring | apply Rmult_le_pos; assumption]. }
  assert (band_holds pass_power given <->
          forall X l h, In (X, l, h) (band tol) -> Q2R l / 100 <= pass (scaled (size_factor q) X) <= Q2R h / 100) as C.
  { subst given. unfold band_holds. split.
    - intros Hb X l h I. rewrite <- (Same X l h I). apply Hb, in_map_iff. exists (X, l, h). auto.
    - intros Hb X l h I. apply in_map_iff in I as (((X0, l0), h0) & [= <- <- <-] & I). rewrite (Same X0 l0 h0 I). apply Hb, I. }
  assert (forall X, X <= Q2R (match rs with r :: _ => opening r | [] => 0%Q end) -> pass_power X = 0) as Z.
  { intros X HX. apply pass_nothing. unfold least_opening. destruct rs; apply nth_root_le, HX. }
  destruct (above_finest_holds pass_power _ _ _ H3 Z) as (D & E).
  split; [intro F; apply A, B, F|]. split.
  - intros Hh F. apply C. apply E; [|apply B, F]. intros X l h I. subst given.
    apply in_map_iff in I as (((X0, l0), h0) & [= <- <- <-] & I). eapply Hh, I.
  - intros F Hb. apply B. split; [apply A, F | apply D, C, Hb].
Qed.

End Sample.
