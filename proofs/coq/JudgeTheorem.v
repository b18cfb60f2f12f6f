(* What it means that a verdict's line begins with "accepted": what the line says is true of the gradation in the file. *)

From Coq Require Import ZArith QArith Reals Qreals String Ascii List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Text Rows GradationFile Document VerdictLine Judge
  Checker Spec Openings RealFacts ExactTheorem Theorems.
Import ListNotations.
Open Scope R_scope.

(* ---- What the words of a line mean ------------------------------------------------------------------- *)

Section Meaning.
Variables (f : R -> R) (G : gradation) (K : option Q) (limits_of_file : list (Q * Q * Q)) (S : sample).
Let d := root_of G.
Let rs := rows G.

(* The size x of the file in the gradation that is asked about. *)
Definition with_factor (x : R) : R := match K with Some k => Q2R k * x | None => x end.

(* What a part of a line demands of a sample. The other parts say which gradation and mass law are meant. *)
Definition demands (p : part) : Prop :=
  match p with
  | RetainedWithin e => forall j, In j (classes rs) -> meets_retained d f rs S j e
  | RetainedAsInFile => forall j r, In (j, r) (combine (classes rs) rs) -> meets_retained d f rs S j (tolerance r)
  | PassingWithin e => forall j, In j (classes rs) -> meets_passing d f rs S j e
  | PassingAsInFile => forall j r, In (j, r) (combine (classes rs) (tl rs)) -> meets_passing d f rs S j (tolerance r)
  | PassingEach root each => forall e y, In (e, y) each ->
      let x := with_factor (size_of (Z.to_pos root) y) in
      near e (share_passing d f rs x S) (target_passing d rs x)
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
  | _ => True
  end.

(* The sample matches as the line says: exactly or within a tolerance, with enough particles, and by all parts. *)
Definition matches (s : statement) : Prop :=
  (if is_exact s then describes_accurately d f rs S else describes d rs S /\ S <> []) /\
  (or_more s <= Z.of_nat (length S))%Z /\
  forall p, In p (parts s) -> demands p.
End Meaning.

Definition limits_or_none (R : reading) : list (Q * Q * Q) := match limits R with Some ls => ls | None => [] end.

(* The claim of the line. G is the gradation of the file R with the pan, the openings and the classes as the line says. *)
Definition is_true (f : R -> R) (R : reading) (G : gradation) (K : option Q) (s : statement) : Prop :=
  let such S := matches f G K (limits_or_none R) S s in
  let none_below n := forall S, such S -> (n <= Z.of_nat (length S))%Z in
  let one_of n := exists S, such S /\ Z.of_nat (length S) = n in
  match claim_of s with
  | Smallest N => one_of N /\ none_below N
  | Between B N => one_of N /\ none_below B
  | NoneBelow B => none_below B
  | NoMatch => forall S, ~ such S
  end.

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

Section Parts.
Variables (f : R -> R) (D : document) (G0 G : gradation) (S : sample) (ls : list (Q * Q * Q)).
Hypothesis agreed : agrees D ls = true.
Let q := asked (certificate_of D).
Hypothesis asked_of_file : asked_gradation G0 (certificate_of D) = Ok G.
Hypothesis positive_root : (1 <= root G)%Z.
Hypothesis factor_nonneg : forall K, size_factor q = Some K -> 0 <= Q2R K.
Let meant := demands f G (size_factor q) ls S.

Lemma passing_each_meant es :
  meant (PassingEach (root (reduced G0)) (combine es (upper_openings (reduced G0) q))) <->
  forall j e, In (j, e) (combine (classes (rows G)) es) -> meets_passing (root_of G) f (rows G) S j e.
Proof.
  destruct (openings_of_question _ _ _ asked_of_file) as (Same & Upper). fold q in Upper.
  rewrite <- upper_of_classes in Upper.
  assert (forall y, size_of (root_of G) (with_power (size_factor q) (root G0) y) =
            with_factor (size_factor q) (size_of (Z.to_pos (root (reduced G0))) y)) as Size.
  { intro y. cbn [root reduced]. unfold root_of, with_power, with_factor. rewrite Same.
    destruct (size_factor q) as [k|] eqn:E; [|reflexivity]. unfold size_of. rewrite Q2R_times.
    replace (root G0) with (Zpos (Z.to_pos (root G0))) at 2 by (apply Z2Pos.id; lia).
    rewrite Q2R_power_pos. apply nth_root_times, factor_nonneg. reflexivity. }
  unfold meant. cbn [demands]. cbv zeta. unfold meets_passing, upper_size. split.
  - intros H j e I. apply in_combine_swap in I.
    assert (In (e, upper j) (combine es (map upper (classes (rows G))))) as U by (apply in_combine_map; eauto).
    rewrite Upper in U. apply in_combine_map in U as (y & Y & I'). rewrite <- Y, Size. apply H, I'.
  - intros H e y I.
    assert (In (e, with_power (size_factor q) (root G0) y) (combine es (map upper (classes (rows G))))) as U
      by (rewrite Upper; apply in_combine_map; eauto).
    apply in_combine_map in U as (j & J & I'). rewrite <- Size, <- J. apply H, in_combine_swap, I'.
Qed.

Lemma tolerance_parts_meant t : tolerances_of q = Some t ->
  ((forall p, In p (tolerance_parts (reduced G0) q t (band_of_file D)) -> meant p) <->
   meets_tolerances (root_of G) f (size_factor q) t (rows G) S).
Proof.
  intro T. assert (forall x l h, band_of_file D = true -> (In (x, l, h) ls <-> In (x, l, h) (band t))) as B.
  { intros x l h E. unfold agrees in agreed. fold q in agreed. rewrite T, E in agreed. apply andb_prop in agreed as (_ & A).
    apply same_limits_ok in A. rewrite A. tauto. }
  unfold tolerance_parts, meets_tolerances. split.
  - intro H. assert (forall p, meant p <-> demands f G (size_factor q) ls S p) as M by (intro; reflexivity).
    repeat split.
    + intros e E. apply (H (RetainedWithin e)). rewrite !in_app_iff, in_if_some. eauto.
    + intro E. apply (H RetainedAsInFile). rewrite !in_app_iff, in_if_true. tauto.
    + intros e E. apply (H (PassingWithin e)). rewrite !in_app_iff, (in_if_some (passing_all t)). eauto 6.
    + intro E. apply (H PassingAsInFile). rewrite !in_app_iff, (in_if_true (passing_file t)). tauto.
    + destruct (passing_each t) as [|e es] eqn:E; [intros j x I; destruct (classes (rows G)); destruct I|].
      apply passing_each_meant, H. rewrite !in_app_iff. do 4 right. left. left. reflexivity.
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
    + destruct (passing_each t) as [|e es]; [destruct I|]. destruct I as [<-|[]]. apply passing_each_meant, H5.
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
  agrees D (limits_or_none R) = true ->
  asked_gradation (gradation_of R) (certificate_of D) = Ok G -> (1 <= root G)%Z ->
  (forall K, size_factor (asked (certificate_of D)) = Some K -> 0 <= Q2R K) ->
  (matches f G (size_factor (asked (certificate_of D))) (limits_or_none R) S (statement_of name R D) <->
   allowed f (asked (certificate_of D)) G S).
Proof.
  intros A As Root Kn. set (q := asked (certificate_of D)) in *.
  pose proof (solid_parts_meant f D G S (limits_or_none R) A) as Solid. fold q in Solid.
  pose proof (fun t => tolerance_parts_meant f D (gradation_of R) G S (limits_or_none R) A As Root Kn t) as Tol. fold q in Tol.
  unfold matches, allowed, has_enough, statement_of. cbn [is_exact or_more parts]. fold q.
  set (meant := demands f G (size_factor q) (limits_or_none R) S) in *.
  assert ((forall p, In p (parts_of R D) -> meant p) <->
          (forall t, tolerances_of q = Some t -> forall p, In p (tolerance_parts (reduced (gradation_of R)) q t (band_of_file D)) -> meant p) /\
          (forall j, In j (classes (rows G)) -> (0 < mass j)%Q -> (min_per_class q <= Spec.number (root_of G) j S)%Z) /\
          (forall p, In p (solid_parts (solids_of q) (box_of D)) -> meant p)) as P.
  { unfold parts_of. fold q. split.
    - intro H. split; [|split].
      + intros t T p I. apply H. rewrite T, in_app_iff. auto.
      + intros j J M. destruct (Z.leb_spec 1 (min_per_class q)) as [L|L].
        * apply (H (AtLeastInEachClass (min_per_class q))); trivial.
          rewrite !in_app_iff, (in_if_true true). tauto.
        * unfold Spec.number. lia.
      + intros p I. apply H. rewrite !in_app_iff. tauto.
    - intros (H1 & H2 & H3) p. rewrite !in_app_iff, !in_if_true, !in_if_some.
      intros [I|[[<-|[<-|[]]]|[(_ & ->)|[(_ & ->)|[((s & x) & _ & ->)|[(x & _ & ->)|[(x & _ & ->)|[(x & _ & ->)|[(x & _ & ->)|[(_ & ->)|I]]]]]]]]]];
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

Lemma printed_accepted gradation certificate line :
  printed (judge gradation certificate) = Some line -> begins_with "accepted" line ->
  exists R D, read_gradation (bytes gradation) = Ok R /\ check_document R (bytes certificate) = Ok D /\
    line = accepted_line (statement_of (name gradation) R D).
Proof.
  unfold judge. destruct (read_gradation (bytes gradation)) as [R| |]; try discriminate.
  destruct (check_document R (bytes certificate)) as [D| |] eqn:E; try discriminate; intros [= <-] (rest & H).
  - exists R, D. auto.
  - discriminate H.
Qed.

Lemma read_document_ok ls w D : read_document ls w = Ok D -> agrees D ls = true.
Proof.
  unfold read_document. intro H. passed H. passed H. cbv zeta in H. passed H. passed H. passed H.
  injection H as <-. assumption.
Qed.

Lemma check_document_ok R w D :
  check_document R w = Ok D ->
  (exists ls, read_document ls (words_of w) = Ok D) /\ agrees D (limits_or_none R) = true /\
  check_certificate (gradation_of R) (certificate_of D) = Ok tt.
Proof.
  unfold check_document. intro H. cbv zeta in H. passed H. rename x into D0. passed H. passed H. destruct x.
  injection H as <-. split; [eauto|]. split; [|exact H2]. apply read_document_ok in H0. apply eqb_prop in H1.
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

(* If the line that is printed begins with "accepted", it is the line of a statement that is true of the gradation in the
   file. G is this gradation as the certificate asks about it, claim_true what the certificate claims besides. *)
Theorem accepted_line_true gradation certificate line :
  printed (judge gradation certificate) = Some line -> begins_with "accepted" line ->
  exists R D, let cert := certificate_of D in let s := statement_of (name gradation) R D in
    read_gradation (bytes gradation) = Ok R /\
    (exists ls, read_document ls (words_of (bytes certificate)) = Ok D) /\
    line = accepted_line s /\
    forall f, power_law (Z.to_nat (a (asked cert))) (Z.to_nat (b (asked cert))) f ->
    exists G, asked_gradation (gradation_of R) cert = Ok G /\
      is_true f R G (size_factor (asked cert)) s /\ claim_true f cert G.
Proof.
  intros P B. destruct (printed_accepted _ _ _ P B) as (R & D & ER & ED & EL).
  apply check_document_ok in ED as (Read & A & C). exists R, D. cbv zeta.
  split; [exact ER|]. split; [exact Read|]. split; [exact EL|]. intros f Law.
  destruct (certificate_true _ _ f C Law) as (G & E & T). exists G. split; [exact E|]. split; [|exact T].
  destruct (check_certificate_ok _ _ C) as (G' & E' & W & Sen & _). rewrite E in E'. injection E' as <-.
  pose proof (fun S => matches_allowed f (name gradation) R D G S A E (root_positive _ W) (factor_of_question _ Sen)) as M. unfold claim_true in T.
  unfold is_true. cbn [statement_of claim_of]. destruct (claimed (certificate_of D)) as [N|least N|least|].
  - destruct T as (((S & SA & SN) & Least) & _). split.
    + exists S. split; [apply M, SA | exact SN].
    + intros S' H. apply Least, M, H.
  - destruct T as (Least & S & SA & SN & _). split.
    + exists S. split; [apply M, SA | exact SN].
    + intros S' H. apply Least, M, H.
  - intros S H. apply T, M, H.
  - intros S H. apply (T S), M, H.
Qed.
