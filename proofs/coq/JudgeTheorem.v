(* What it means that a verdict's line begins with "accepted": what the line says is true of the gradation in the file. *)

From Coq Require Import ZArith QArith Reals Qreals String Ascii List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Text Rows GradationFile Document VerdictLine Judge
  Checker Spec Openings RealFacts ExactTheorem Theorems GradationRead.
Import ListNotations.
Open Scope R_scope.

(* ---- What the words of a line mean ------------------------------------------------------------------- *)

Section Meaning.
Variables (f : R -> R) (G : gradation) (K : option Q) (unit : size_unit) (limits_of_file : list (Q * Q * Q)) (S : sample).
Let d := root_of G.
Let rs := rows G.

(* The size x of the file in the gradation that is asked about. *)
Definition with_factor (x : R) : R := match K with Some k => Q2R k * x | None => x end.

(* The size of an opening that is given by a phi, or by its length. *)
Definition size_in_file (x : Q) : R := match unit with Phi => Rpower 2 (- Q2R x) | _ => Q2R x end.

(* What a part of a line demands of a sample. The last ones demand nothing of it: they say which gradation and mass law
   are meant (as_file_says, as_line_says and law_in, below). *)
Definition demands (p : part) : Prop :=
  match p with
  | RetainedWithin e => forall j, In j (classes rs) -> meets_retained d f rs S j e
  | RetainedAsInFile => forall j r, In (j, r) (combine (classes rs) rs) -> meets_retained d f rs S j (tolerance r)
  | PassingWithin e => forall j, In j (classes rs) -> meets_passing d f rs S j e
  | PassingAsInFile => forall j r, In (j, r) (combine (classes rs) (tl rs)) -> meets_passing d f rs S j (tolerance r)
  | PassingEach each => forall e x, In (e, x) each ->
      let y := with_factor (size_in_file x) in
      near e (share_passing d f rs y S) (target_passing d rs y)
  | TotalWithin e =>
    total (map (fun j => Rabs (share_retained d f rs j S - target_retained rs j)) (classes rs)) <= Q2R e / 100
  | BandAt x l h => Q2R l / 100 <= share_passing d f rs (scaled K x) S <= Q2R h / 100
  | BandOfFile => forall x l h, In (x, l, h) limits_of_file ->
      Q2R l / 100 <= share_passing d f rs (scaled K x) S <= Q2R h / 100
  | AtLeastInEachClass r => forall j, In j (classes rs) -> (0 < mass j)%Q -> (r <= Spec.number d j S)%Z
  | CylinderFilled diameter height e =>
      PI / 4 * Q2R diameter ^ 2 * Q2R height <= solid_volume S * (1 + Q2R e)
  | BoxFilled x y z e => Q2R x * Q2R y * Q2R z <= solid_volume S * (1 + Q2R e)
  | VolumeOfSolids v => Q2R v <= solid_volume S
  | Law _ _ | PanCountedAs _ | LeftOutBelow _ | OpeningsTimes _ => True
  | SizesIn _ | FactorsOfFile | OfMaterials _ | PanImplied | SumsTo _ _ | MiddleOfLimits => True
  end.

(* The sample matches as the line says: exactly or within a tolerance, with enough particles, and by all parts. *)
Definition matches (s : statement) : Prop :=
  (if is_exact s then describes_accurately d f rs S else describes d rs S /\ S <> []) /\
  (or_more s <= Z.of_nat (length S))%Z /\
  forall p, In p (parts s) -> demands p.
End Meaning.

Definition limits_or_none (R : reading) : list (Q * Q * Q) := match limits R with Some ls => ls | None => [] end.

(* The claim of the line. G is the gradation of the file R with the pan, the openings and the classes as the line says. *)
Definition claim_holds (f : R -> R) (R : reading) (G : gradation) (K : option Q) (s : statement) : Prop :=
  let such S := matches f G K (sizes_in R) (limits_or_none R) S s in
  let none_below n := forall S, such S -> (n <= Z.of_nat (length S))%Z in
  let one_of n := exists S, such S /\ Z.of_nat (length S) = n in
  match claim_of s with
  | Smallest N => one_of N /\ none_below N
  | Between B N => one_of N /\ none_below B
  | NoneBelow B => none_below B
  | NoMatch => forall S, ~ such S
  end.

(* ---- What a line says of its file -------------------------------------------------------------------- *)

Fixpoint first {A} (pick : part -> option A) (ps : list part) : option A :=
  match ps with p :: ps => match pick p with Some x => Some x | None => first pick ps end | [] => None end.

Definition law_in := first (fun p => match p with Law a b => Some (a, b) | _ => None end).
Definition pan_in := first (fun p => match p with PanCountedAs x => Some x | _ => None end).
Definition cut_in := first (fun p => match p with LeftOutBelow x => Some x | _ => None end).
Definition factor_in := first (fun p => match p with OpeningsTimes k => Some k | _ => None end).

(* Unit, factors, an implied pan, the sum of shares and an envelope are what the line says, and no others. *)
Definition is_of_file (p : part) : bool :=
  match p with SizesIn _ | FactorsOfFile | OfMaterials _ | PanImplied | SumsTo _ _ | MiddleOfLimits => true | _ => false end.
Definition as_file_says (R : reading) (s : statement) : Prop :=
  unit_of s = sizes_in R /\ filter is_of_file (parts s) = file_parts R.

(* The gradation of the file with the pan, the classes and the openings that the line says. *)
Definition as_line_says (G : gradation) (s : statement) : result gradation :=
  let d := root G in
  let* rs := apply_pan_size d (pan_in (parts s)) (rows G) in
  let* rs := apply_cut_below d (cut_in (parts s)) rs in
  let* rs := apply_size_factor d (factor_in (parts s)) rs in
  Ok (Gradation rs d (has_tolerances G)).

(* The statement is true of a gradation that is read, for masses by the law in the line. *)
Definition true_of_one (R : reading) (s : statement) : Prop :=
  exists G a b, as_file_says R s /\ as_line_says (reduced (gradation_of R)) s = Ok G /\ law_in (parts s) = Some (a, b) /\
    (1 <= a)%Z /\ (1 <= b)%Z /\
    forall f, power_law (Z.to_nat a) (Z.to_nat b) f -> claim_holds f R G (factor_in (parts s)) s.

(* ---- The parts are the question ---------------------------------------------------------------------- *)

Lemma same_number_ok x y : same_number x y = true -> x = y.
Proof.
  unfold same_number. rewrite andb_true_iff, !Z.eqb_eq. destruct x, y. simpl. intros (-> & E). injection E as ->.
  reflexivity.
Qed.

Lemma same_limits_ok ls : forall ms, same_limits ls ms = true -> ls = ms.
Proof.
  induction ls as [|((x, l), h) ls IH]; intros [|((x', l'), h') ms]; simpl; try discriminate; trivial.
  destruct (same_number x x' && same_number l l' && same_number h h') eqn:E; [|discriminate].
  rewrite !andb_true_iff in E. destruct E as ((A & B) & C).
  apply same_number_ok in A, B, C. subst. intro H. f_equal. auto.
Qed.

Lemma in_if_some {A} (x : option A) (p : A -> part) q : In q (if_some x p) <-> exists y, x = Some y /\ q = p y.
Proof.
  destruct x; simpl; split; [intros [<-|[]]; eauto | intros (y & [= ->] & ->); auto | intros [] | intros (y & [=] & _)].
Qed.

Lemma in_if_true holds (p q : part) : In q (if_true holds p) <-> holds = true /\ q = p.
Proof. destruct holds; simpl; intuition (congruence || auto). Qed.

Lemma map_onto_rev {A B} (g : A -> B) l : forall done, map_onto g l done = (rev (map g l) ++ done)%list.
Proof. induction l as [|x l IH]; intro done; simpl; [reflexivity|]. rewrite IH, <- app_assoc. reflexivity. Qed.

Lemma map_all_map {A B} (g : A -> B) l : rev' (map_onto g l []) = map g l.
Proof. unfold rev'. rewrite rev_append_rev, map_onto_rev, !app_nil_r, rev_involutive. reflexivity. Qed.

Lemma volume_of_box_real x y z e : 0 <= Q2R e ->
  Q2R (volume_of_box x y z e) = Q2R x * Q2R y * Q2R z / (1 + Q2R e).
Proof.
  intro E. unfold volume_of_box. rewrite Q2R_over; rewrite Q2R_add, Q2R_integer; [|lra].
  rewrite !Q2R_times. unfold Rdiv. ring.
Qed.

(* ---- Openings with their percentages ----------------------------------------------------------------- *)

Lemma nth_root_times d k y : 0 <= k -> nth_root d (y * k ^ Pos.to_nat d) = k * nth_root d y.
Proof.
  intro K. pose proof (pow_le _ (Pos.to_nat d) K) as P. destruct (Rlt_dec 0 y) as [Y|Y].
  - replace (y * k ^ Pos.to_nat d) with ((k * nth_root d y) ^ Pos.to_nat d).
    + apply nth_root_unique, Rmult_le_pos; [exact K | apply nth_root_nonneg].
    + rewrite Rpow_mult_distr, nth_root_power by lra. ring.
  - unfold nth_root. destruct (Rlt_dec 0 y); [contradiction|]. destruct (Rlt_dec 0 (y * k ^ Pos.to_nat d)); [nra | ring].
Qed.

Lemma in_combine_map {A B C} (g : B -> C) l : forall (es : list A) e u,
  In (e, u) (combine es (map g l)) <-> exists x, g x = u /\ In (e, x) (combine es l).
Proof.
  induction l as [|x l IH]; intros [|e0 es] e u; cbn [map combine In]; try solve [split; [intros [] | intros (? & _ & [])]].
  rewrite IH. split.
  - intros [[= <- <-]|(y & E & I)]; eauto.
  - intros (y & <- & [[= <- <-]|I]); eauto.
Qed.

Lemma in_combine_swap {A B} (l : list A) : forall (m : list B) x y, In (x, y) (combine l m) <-> In (y, x) (combine m l).
Proof.
  induction l as [|a l IH]; intros [|b m] x y; cbn [combine In]; try tauto. rewrite IH.
  split; (intros [[= <- <-]|I]; [left; reflexivity | right; exact I]).
Qed.

Lemma upper_of_classes rs : map upper (classes rs) = map opening (tl rs).
Proof.
  induction rs as [|r [|r' rs] IH]; try reflexivity. cbn [classes map tl upper] in *. f_equal. exact IH.
Qed.

(* A class of the question ends at an opening of the file, to the power of the root, times the factor. *)
Definition with_power (K : option Q) (d : Z) (y : Q) : Q := match K with Some k => times y (power k d) | None => y end.

Lemma openings_of_question G0 cert G : asked_gradation G0 cert = Ok G ->
  root G = root G0 /\
  map opening (tl (rows G)) =
    map (with_power (size_factor (asked cert)) (root G0)) (upper_openings (reduced G0) (asked cert)).
Proof.
  unfold asked_gradation, apply_question, upper_openings. cbv zeta. intro H.
  passed H. passed H. passed H. passed H. injection H as <-. rewrite H0. cbn [bind]. rewrite H1. cbn [root rows reduced].
  split; [reflexivity|]. unfold apply_size_factor in H2. cbn [root reduced] in H2. destruct (size_factor (asked cert)) as [k|].
  - apply bind_ok in H2 as (y & P & H2). injection H2 as <-. unfold to_power in P. passed P. injection P as <-.
    destruct x0 as [|r rs]; [reflexivity|]. cbn [map tl]. rewrite !map_map. reflexivity.
  - injection H2 as <-. rewrite map_map. reflexivity.
Qed.

Lemma power_of_two_real n : Q2R (power_of_two n) = Rpower 2 (IZR n).
Proof.
  assert (forall m, (0 <= m)%Z -> IZR (2 ^ m) = Rpower 2 (IZR m)) as P.
  { intros m M. rewrite <- (Z2Nat.id m M) at 2. rewrite <- INR_IZR_INZ, Rpower_pow by lra.
    rewrite <- (Z2Nat.id m M) at 1. symmetry. apply pow_IZR. }
  unfold power_of_two. destruct (Z.leb_spec 0 n) as [L|L].
  - rewrite Q2R_integer. apply P, L.
  - unfold Q2R. cbn [Qnum Qden]. rewrite Z2Pos.id by (apply Z.pow_pos_nonneg; lia). rewrite P by lia.
    rewrite opp_IZR, Rpower_Ropp, Rinv_inv. lra.
Qed.

(* 2^-phi is the d-th root of 2^n. *)
Lemma phi_size d n : (1 <= d)%Z ->
  Rpower 2 (- Q2R (as_in_file Phi d (power_of_two n))) = nth_root (Z.to_pos d) (Q2R (power_of_two n)).
Proof.
  intro D. unfold as_in_file. rewrite exponent_of_power, power_of_two_real. unfold nth_root.
  destruct (Rlt_dec 0 (Rpower 2 (IZR n))) as [_|N]; [|exfalso; apply N, exp_pos].
  rewrite Rpower_mult. f_equal. unfold fraction. rewrite (Qeq_eqR _ _ (Qred_correct _)). unfold Q2R. cbn [Qnum Qden].
  rewrite opp_IZR. field. apply not_0_IZR. lia.
Qed.

Section Parts.
Variables (f : R -> R) (D : document) (R : reading) (G : gradation) (S : sample) (ls : list (Q * Q * Q)).
Let G0 := gradation_of R.
Let unit := sizes_in R.
Hypothesis agreed : agrees D ls = true.
Let q := asked (certificate_of D).
Hypothesis asked_of_file : asked_gradation G0 (certificate_of D) = Ok G.
Hypothesis positive_root : (1 <= root G)%Z.
Hypothesis factor_nonneg : forall K, size_factor q = Some K -> 0 <= Q2R K.
Hypothesis given : gives_openings R q = true.
Let meant := demands f G (size_factor q) unit ls S.

Lemma openings_in_file t y : tolerances_of q = Some t -> passing_each t <> [] -> In y (upper_openings (reduced G0) q) ->
  size_in_file unit (as_in_file unit (root G0) y) = size_of (root_of G) y.
Proof.
  intros T E I. destruct (openings_of_question _ _ _ asked_of_file) as (Same & _). unfold root_of, size_of in *.
  unfold gives_openings in given. rewrite T in given. destruct (passing_each t) as [|e es]; [contradiction|].
  fold G0 in given, Same, I. fold unit in given. rewrite Same in *.
  destruct unit; unfold size_in_file, as_in_file; try (apply andb_prop in given as (One & Pos);
    apply Z.eqb_eq in One; cbn [reduced root] in One; rewrite One; symmetry; apply nth_root_1; rewrite forallb_forall in Pos;
    specialize (Pos y I); apply at_most_real in Pos; rewrite Q2R_0 in Pos; exact Pos).
  rewrite forallb_forall in given. specialize (given y I). apply same_number_ok in given. rewrite given.
  apply phi_size, positive_root.
Qed.

Lemma passing_each_meant t : tolerances_of q = Some t -> passing_each t <> [] ->
  meant (PassingEach (combine (passing_each t) (map_all (as_in_file unit (root G0)) (upper_openings (reduced G0) q)))) <->
  forall j e, In (j, e) (combine (classes (rows G)) (passing_each t)) -> meets_passing (root_of G) f (rows G) S j e.
Proof.
  intros T NE. destruct (openings_of_question _ _ _ asked_of_file) as (Same & Upper). fold q in Upper. fold G0 in Same, Upper.
  rewrite <- upper_of_classes in Upper.
  assert (forall y, size_of (root_of G) (with_power (size_factor q) (root G0) y) =
            with_factor (size_factor q) (size_of (root_of G) y)) as Size.
  { intro y. unfold root_of, with_power, with_factor. rewrite Same.
    destruct (size_factor q) as [k|] eqn:E; [|reflexivity]. unfold size_of. rewrite Q2R_times.
    replace (root G0) with (Zpos (Z.to_pos (root G0))) at 2 by (apply Z2Pos.id; lia).
    rewrite Q2R_power_pos. apply nth_root_times, factor_nonneg. reflexivity. }
  unfold meant. cbn [demands]. cbv zeta. unfold meets_passing, upper_size, map_all. rewrite map_all_map. set (es := passing_each t) in *. split.
  - intros H j e I. apply in_combine_swap in I.
    assert (In (e, upper j) (combine es (map upper (classes (rows G))))) as U by (apply in_combine_map; eauto).
    rewrite Upper in U. apply in_combine_map in U as (y & Y & I').
    pose proof (openings_in_file t y T NE (in_combine_r _ _ _ _ I')) as Z.
    rewrite <- Y, Size, <- Z. apply H, in_combine_map. eauto.
  - intros H e x Ix. apply in_combine_map in Ix as (y & <- & I').
    rewrite (openings_in_file t y T NE (in_combine_r _ _ _ _ I')), <- Size.
    assert (In (e, with_power (size_factor q) (root G0) y) (combine es (map upper (classes (rows G))))) as U
      by (rewrite Upper; apply in_combine_map; eauto).
    apply in_combine_map in U as (j & J & I''). rewrite <- J. apply H, in_combine_swap, I''.
Qed.

Lemma tolerance_parts_meant t : tolerances_of q = Some t ->
  ((forall p, In p (tolerance_parts unit (reduced G0) q t (band_of_file D)) -> meant p) <->
   meets_tolerances (root_of G) f (size_factor q) t (rows G) S).
Proof.
  intro T. assert (forall x l h, band_of_file D = true -> (In (x, l, h) ls <-> In (x, l, h) (band t))) as B.
  { intros x l h E. unfold agrees in agreed. fold q in agreed. rewrite T, E in agreed. apply andb_prop in agreed as (_ & A).
    apply same_limits_ok in A. rewrite A. tauto. }
  unfold tolerance_parts, meets_tolerances. split.
  - intro H. assert (forall p, meant p <-> demands f G (size_factor q) unit ls S p) as M by (intro; reflexivity).
    repeat split.
    + intros e E. apply (H (RetainedWithin e)). rewrite !in_app_iff, in_if_some. eauto.
    + intro E. apply (H RetainedAsInFile). rewrite !in_app_iff, in_if_true. tauto.
    + intros e E. apply (H (PassingWithin e)). rewrite !in_app_iff, (in_if_some (passing_all t)). eauto 6.
    + intro E. apply (H PassingAsInFile). rewrite !in_app_iff, (in_if_true (passing_file t)). tauto.
    + pose proof (passing_each_meant t T) as Each. destruct (passing_each t) as [|e es] eqn:E;
        [intros j x I; destruct (classes (rows G)); destruct I|].
      apply Each, H; [discriminate|]. rewrite !in_app_iff. do 4 right. left. left. reflexivity.
    + intros e E. apply (H (TotalWithin e)). rewrite !in_app_iff, (in_if_some (Certificate.total t)). eauto 10.
    + destruct (band_of_file D) eqn:E.
      * apply (H BandOfFile) with (h := h); [rewrite !in_app_iff; simpl; tauto | apply B; trivial].
      * apply (H (BandAt x l h)). rewrite map_all_map, !in_app_iff, in_map_iff. do 6 right. exists (x, l, h). auto.
    + destruct (band_of_file D) eqn:E.
      * apply (H BandOfFile) with (l := l); [rewrite !in_app_iff; simpl; tauto | apply B; trivial].
      * apply (H (BandAt x l h)). rewrite map_all_map, !in_app_iff, in_map_iff. do 6 right. exists (x, l, h). auto.
  - intros (H1 & H2 & H3 & H4 & H5 & H6 & H7) p. rewrite !in_app_iff, !in_if_some, !in_if_true.
    intros [(e & E & ->)|[(E & ->)|[(e & E & ->)|[(E & ->)|[I|[(e & E & ->)|I]]]]]].
    + exact (H1 e E).
    + exact (H2 E).
    + exact (H3 e E).
    + exact (H4 E).
    + pose proof (passing_each_meant t T) as Each. destruct (passing_each t) as [|e es]; [destruct I|].
      destruct I as [<-|[]]. apply Each, H5. discriminate.
    + exact (H6 e E).
    + destruct (band_of_file D) eqn:E.
      * destruct I as [<-|[]]. intros x l h I. apply H7, B; trivial.
      * rewrite map_all_map, in_map_iff in I. destruct I as (((x, l), h) & <- & I). exact (H7 x l h I).
Qed.

Lemma solid_parts_meant :
  (forall p, In p (solid_parts (solids_of q) (box_of D)) -> meant p) <-> has_solids (solids_of q) S.
Proof.
  unfold agrees in agreed. fold q in agreed. apply andb_prop in agreed as (A & _).
  unfold solid_parts, has_solids. destruct (solids_of q) as [|x h e|v lo hi].
  - simpl. tauto.
  - split; [intro H; apply (H (CylinderFilled x h e)); left; reflexivity | intros H p [<-|[]]; exact H].
  - destruct (box_of D) as [(((x, y), z), e)|].
    + apply andb_prop in A as (E & V). apply at_most_real in E. rewrite Q2R_0 in E. apply equal_real in V.
      rewrite (volume_of_box_real x y z e E) in V.
      assert (Q2R v <= solid_volume S <-> Q2R x * Q2R y * Q2R z <= solid_volume S * (1 + Q2R e)) as C.
      { rewrite V. split; intro H.
        - apply (Rmult_le_compat_r (1 + Q2R e)) in H; [|lra]. unfold Rdiv in H.
          rewrite Rmult_assoc, Rinv_l in H by lra. lra.
        - apply (Rmult_le_reg_r (1 + Q2R e)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
      split; [intro H; apply C, (H (BoxFilled x y z e)); left; reflexivity | intros H p [<-|[]]; apply C, H].
    + split; [intro H; apply (H (VolumeOfSolids v)); left; reflexivity | intros H p [<-|[]]; exact H].
Qed.
End Parts.

(* Of samples the parts demand what the question does. *)
Lemma matches_allowed f name R D G S :
  agrees D (limits_or_none R) = true -> gives_openings R (asked (certificate_of D)) = true ->
  asked_gradation (gradation_of R) (certificate_of D) = Ok G -> (1 <= root G)%Z ->
  (forall K, size_factor (asked (certificate_of D)) = Some K -> 0 <= Q2R K) ->
  (matches f G (size_factor (asked (certificate_of D))) (sizes_in R) (limits_or_none R) S (statement_of name R D) <->
   allowed f (asked (certificate_of D)) G S).
Proof.
  intros A Gv As Root Kn. set (q := asked (certificate_of D)) in *.
  pose proof (solid_parts_meant f D R G S (limits_or_none R) A) as Solid. fold q in Solid.
  pose proof (fun t => tolerance_parts_meant f D R G S (limits_or_none R) A As Root Kn Gv t) as Tol. fold q in Tol.
  unfold matches, allowed, has_enough, statement_of, statement_with. cbn [is_exact or_more parts]. fold q.
  set (meant := demands f G (size_factor q) (sizes_in R) (limits_or_none R) S) in *.
  assert ((forall p, In p (parts_of R D) -> meant p) <->
          (forall t, tolerances_of q = Some t -> forall p, In p (tolerance_parts (sizes_in R) (reduced (gradation_of R)) q t (band_of_file D)) -> meant p) /\
          (forall j, In j (classes (rows G)) -> (0 < mass j)%Q -> (min_per_class q <= Spec.number (root_of G) j S)%Z) /\
          (forall p, In p (solid_parts (solids_of q) (box_of D)) -> meant p)) as P.
  { unfold parts_of, parts_with. fold q. split.
    - intro H. split; [|split].
      + intros t T p I. apply H. rewrite T, in_app_iff. auto.
      + intros j J M. destruct (Z.leb_spec 1 (min_per_class q)) as [L|L].
        * apply (H (AtLeastInEachClass (min_per_class q))); trivial.
          rewrite !in_app_iff, (in_if_true true). tauto.
        * unfold Spec.number. lia.
      + intros p I. apply H. rewrite !in_app_iff. tauto.
    - intros (H1 & H2 & H3) p. unfold file_parts. rewrite !in_app_iff, !in_if_true, !in_if_some.
      intros [I|[[<-|[]]|[[[<-|[]]|[(_ & ->)|[(_ & ->)|[((s & x) & _ & ->)|(x & _ & ->)]]]]|[(x & _ & ->)|[(x & _ & ->)|[(x & _ & ->)|[(_ & ->)|I]]]]]]];
        try exact Logic.I.
      + destruct (tolerances_of q) as [t|]; [exact (H1 t eq_refl p I) | destruct I].
      + exact H2.
      + exact (H3 p I). }
  rewrite P, Solid. destruct (tolerances_of q) as [t|] eqn:T.
  - unfold describes_within. rewrite <- (Tol t eq_refl). split.
    + intros ((B & N) & L & H1 & H2 & H3). specialize (H1 t eq_refl). tauto.
    + intros ((B & N & H1) & H2 & H3 & L). split; [tauto|]. split; [exact L|]. split; [|tauto]. intros t' [= <-]. exact H1.
  - split.
    + intros (B & L & _ & H2 & H3). auto.
    + intros (B & H2 & H3 & L). split; [exact B|]. split; [exact L|]. split; [discriminate | tauto].
Qed.

(* ---- The theorem ------------------------------------------------------------------------------------- *)

Definition printed (j : judgement) : option string :=
  match j with Proved line | Unproved line _ => Some line | Unreadable _ => None end.

Definition begins_with (prefix line : string) : Prop := exists rest, line = (prefix ++ rest)%string.

Lemma check_statement_ok name R w s : check_statement name R w = Ok s ->
  exists D, check_document R w = Ok D /\ s = statement_of name R D /\ gives_openings R (asked (certificate_of D)) = true /\
    plain_statement s = true.
Proof.
  unfold check_statement. intro H. passed H. rename x into D. cbv zeta in H. passed H. injection H as <-.
  apply andb_prop in H1 as (A & B). exists D. auto.
Qed.

Lemma read_document_ok ls w D : read_document ls w = Ok D -> agrees D ls = true.
Proof.
  unfold read_document. intro H. passed H. passed H. cbv zeta in H. passed H. passed H. passed H.
  injection H as <-. assumption.
Qed.

Lemma check_document_ok R w D :
  check_document R w = Ok D ->
  agrees D (limits_or_none R) = true /\
  check_certificate (gradation_of R) (certificate_of D) = Ok tt.
Proof.
  unfold check_document. intro H. cbv zeta in H. passed H. rename x into D0. passed H. passed H. destruct x.
  injection H as <-. split; [|exact H2]. apply read_document_ok in H0. apply eqb_prop in H1.
  unfold agrees in *. apply andb_prop in H0 as (A & B). rewrite A. rewrite H1 in *. unfold limits_or_none.
  destruct (limits R); exact B.
Qed.

Lemma root_positive G : well_formed G = true -> (1 <= root G)%Z.
Proof. unfold well_formed. rewrite !andb_true_iff, !Z.leb_le. tauto. Qed.

Lemma factor_of_question cert : sensible cert = true ->
  forall K, size_factor (asked cert) = Some K -> 0 <= Q2R K.
Proof.
  unfold sensible. cbv zeta. rewrite !andb_true_iff. intros (((_ & P) & _) & _) K E. rewrite E in P.
  apply less_real in P. rewrite Q2R_0 in P. lra.
Qed.

(* ---- The line says the question ---------------------------------------------------------------------- *)

Open Scope list_scope.

Lemma first_app {A} (pick : part -> option A) ps qs :
  first pick (ps ++ qs) = match first pick ps with Some x => Some x | None => first pick qs end.
Proof. induction ps as [|p ps IH]; simpl; [reflexivity|]. destruct (pick p); trivial. Qed.

Lemma first_none {A} (pick : part -> option A) ps : (forall p, In p ps -> pick p = None) -> first pick ps = None.
Proof. induction ps as [|p ps IH]; simpl; intro H; [reflexivity|]. rewrite (H p) by auto. apply IH. auto. Qed.

Lemma filter_none (such : part -> bool) ps : (forall p, In p ps -> such p = false) -> filter such ps = [].
Proof. induction ps as [|p ps IH]; simpl; intro H; [reflexivity|]. rewrite (H p) by auto. apply IH. auto. Qed.

Lemma filter_all (such : part -> bool) ps : (forall p, In p ps -> such p = true) -> filter such ps = ps.
Proof. induction ps as [|p ps IH]; simpl; intro H; [reflexivity|]. rewrite (H p) by auto. f_equal. apply IH. auto. Qed.

(* The parts that say how a sample is to match. *)
Definition is_demand (p : part) : bool :=
  match p with Law _ _ | PanCountedAs _ | LeftOutBelow _ | OpeningsTimes _ => false | _ => negb (is_of_file p) end.

Lemma tolerance_parts_demand unit G q t band p : In p (tolerance_parts unit G q t band) -> is_demand p = true.
Proof.
  unfold tolerance_parts. rewrite map_all_map, !in_app_iff, !in_if_some, !in_if_true.
  intros [(e & _ & ->)|[(_ & ->)|[(e & _ & ->)|[(_ & ->)|[I|[(e & _ & ->)|I]]]]]]; try reflexivity.
  - destruct (passing_each t); [destruct I|]. destruct I as [<-|[]]. reflexivity.
  - destruct band; [destruct I as [<-|[]]; reflexivity|].
    apply in_map_iff in I as (((x, l), h) & <- & _). reflexivity.
Qed.

Lemma solid_parts_demand s box p : In p (solid_parts s box) -> is_demand p = true.
Proof.
  unfold solid_parts. destruct s; [intros []| |destruct box as [(((x, y), z), e)|]]; intros [<-|[]]; reflexivity.
Qed.

Lemma file_parts_of_file R p : In p (file_parts R) -> is_of_file p = true.
Proof.
  unfold file_parts. rewrite !in_app_iff, !in_if_true, !in_if_some.
  intros [[<-|[]]|[(_ & ->)|[(_ & ->)|[((s & x) & _ & ->)|(x & _ & ->)]]]]; reflexivity.
Qed.

(* The parts that are no demand, in their order, among those that are. *)
Section Said.
Variables (unit : size_unit) (G : gradation) (of_file : list part) (D : document).
Hypothesis all_of_file : forall p, In p of_file -> is_of_file p = true.
Let q := asked (certificate_of D).
Let ps := parts_with unit G of_file D.

Lemma parts_split : exists before after,
  (forall p, In p (before ++ after) -> is_demand p = true) /\
  ps = before ++ [Law (a q) (b q)] ++ of_file ++
    if_some (pan_size q) PanCountedAs ++ if_some (cut_below q) LeftOutBelow ++ if_some (size_factor q) OpeningsTimes ++ after.
Proof.
  exists (match tolerances_of q with Some t => tolerance_parts unit G q t (band_of_file D) | None => [] end).
  exists (if_true (1 <=? min_per_class q)%Z (AtLeastInEachClass (min_per_class q)) ++ solid_parts (solids_of q) (box_of D)).
  split; [|reflexivity]. intro p. rewrite !in_app_iff, in_if_true. intros [I|[(_ & ->)|I]]; [|reflexivity|].
  - destruct (tolerances_of q) as [t|]; [|destruct I]. apply tolerance_parts_demand in I. exact I.
  - apply solid_parts_demand in I. exact I.
Qed.

Lemma first_of_parts {A} (pick : part -> option A) :
  (forall p, is_demand p = true \/ is_of_file p = true -> pick p = None) ->
  first pick ps =
  first pick ([Law (a q) (b q)] ++ if_some (pan_size q) PanCountedAs ++ if_some (cut_below q) LeftOutBelow ++
    if_some (size_factor q) OpeningsTimes).
Proof.
  intros Others. destruct parts_split as (before & after & Demand & ->).
  rewrite !first_app, (first_none pick before), (first_none pick of_file), (first_none pick after).
  - destruct (first pick [Law (a q) (b q)]), (first pick (if_some (pan_size q) PanCountedAs)),
      (first pick (if_some (cut_below q) LeftOutBelow)), (first pick (if_some (size_factor q) OpeningsTimes)); reflexivity.
  - intros p I. apply Others. left. apply Demand, in_app_iff. auto.
  - intros p I. apply Others. right. exact (all_of_file p I).
  - intros p I. apply Others. left. apply Demand, in_app_iff. auto.
Qed.

Lemma asked_said : law_in ps = Some (a q, b q) /\ pan_in ps = pan_size q /\ cut_in ps = cut_below q /\ factor_in ps = size_factor q.
Proof.
  unfold law_in, pan_in, cut_in, factor_in.
  repeat split; rewrite first_of_parts by (intros []; cbn; intuition discriminate);
    destruct (pan_size q), (cut_below q), (size_factor q); reflexivity.
Qed.

Lemma of_file_said : filter is_of_file ps = of_file.
Proof.
  destruct parts_split as (before & after & Demand & ->).
  assert (forall p, is_demand p = true -> is_of_file p = false) as Not by (intros []; cbn; congruence).
  rewrite !filter_app, (filter_none _ before), (filter_none _ after), (filter_all _ of_file).
  - destruct (pan_size q), (cut_below q), (size_factor q); cbn; rewrite ?app_nil_r; reflexivity.
  - exact all_of_file.
  - intros p I. apply Not, Demand, in_app_iff. auto.
  - intros p I. apply Not, Demand, in_app_iff. auto.
Qed.
End Said.

Lemma question_said name R D : let q := asked (certificate_of D) in let ps := parts (statement_of name R D) in
  law_in ps = Some (a q, b q) /\ pan_in ps = pan_size q /\ cut_in ps = cut_below q /\ factor_in ps = size_factor q.
Proof. exact (asked_said _ _ _ D (file_parts_of_file R)). Qed.

Lemma file_said name R D : as_file_says R (statement_of name R D).
Proof. split; [reflexivity | exact (of_file_said _ _ _ D (file_parts_of_file R))]. Qed.

Lemma gradation_said name R D G : asked_gradation (gradation_of R) (certificate_of D) = Ok G ->
  as_line_says (reduced (gradation_of R)) (statement_of name R D) = Ok G.
Proof.
  destruct (question_said name R D) as (_ & P & C & F). unfold asked_gradation, apply_question, as_line_says. cbv zeta.
  rewrite P, C, F. intro H. passed H. passed H. passed H. passed H. rewrite H0. cbn [bind]. rewrite H1. cbn [bind].
  rewrite H2. exact H.
Qed.

(* ---- The theorems ------------------------------------------------------------------------------------ *)

Lemma statement_holds name R D G f :
  agrees D (limits_or_none R) = true -> gives_openings R (asked (certificate_of D)) = true ->
  check_certificate (gradation_of R) (certificate_of D) = Ok tt ->
  asked_gradation (gradation_of R) (certificate_of D) = Ok G -> claim_true f (certificate_of D) G ->
  claim_holds f R G (size_factor (asked (certificate_of D))) (statement_of name R D).
Proof.
  intros A Gv C E T. destruct (check_certificate_ok _ _ C) as (G' & E' & W & Sen & _). rewrite E in E'. injection E' as <-.
  pose proof (fun S => matches_allowed f name R D G S A Gv E (root_positive _ W) (factor_of_question _ Sen)) as M.
  unfold claim_true in T. unfold claim_holds. cbn [statement_of statement_with claim_of].
  destruct (claimed (certificate_of D)) as [N|least N|least|].
  - destruct T as (((S & SA & SN) & Least) & _). split.
    + exists S. split; [apply M, SA | exact SN].
    + intros S' H. apply Least, M, H.
  - destruct T as (Least & S & SA & SN & _). split.
    + exists S. split; [apply M, SA | exact SN].
    + intros S' H. apply Least, M, H.
  - intros S H. apply T, M, H.
  - intros S H. apply (T S), M, H.
Qed.

Theorem checked_statement_true name R w s : check_statement name R w = Ok s -> true_of_one R s.
Proof.
  intro ES. apply check_statement_ok in ES as (D & ED & -> & Gv & _). apply check_document_ok in ED as (A & C).
  destruct (check_certificate_ok _ _ C) as (G & E & _ & Sen & _).
  destruct (question_said name R D) as (L & _ & _ & F).
  exists G, (a (asked (certificate_of D))), (b (asked (certificate_of D))).
  split; [apply file_said|]. split; [apply gradation_said, E|]. split; [exact L|].
  unfold sensible in Sen. cbv zeta in Sen. rewrite !andb_true_iff, !Z.leb_le in Sen. split; [tauto|]. split; [tauto|].
  intros f Power. rewrite F. destruct (certificate_true _ _ f C Power) as (G' & E' & T). rewrite E in E'. injection E' as <-.
  apply statement_holds; assumption.
Qed.
