(* The tolerance's lines and the bounds on shares that the checker derives from them say the same. *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Exact Tolerant Spec Openings Reduction RealFacts.
Import ListNotations.
Open Scope R_scope.

(* ---- Intervals ----------------------------------------------------------------------------------- *)

Definition within_interval (i : interval) (x : R) : Prop := Q2R (lo i) <= x <= Q2R (hi i).

Lemma larger_le x y z : Q2R (larger x y) <= z <-> Q2R x <= z /\ Q2R y <= z.
Proof.
  unfold larger. destruct (less x y) eqn:E; [apply less_real in E | apply less_real_false in E]; lra.
Qed.

Lemma smaller_le x y z : z <= Q2R (smaller x y) <-> z <= Q2R x /\ z <= Q2R y.
Proof.
  unfold smaller. destruct (less y x) eqn:E; [apply less_real in E | apply less_real_false in E]; lra.
Qed.

Lemma narrow_within i l h x : within_interval (narrow i l h) x <-> within_interval i x /\ Q2R l <= x <= Q2R h.
Proof. unfold within_interval, narrow. cbn [lo hi]. rewrite larger_le, smaller_le. lra. Qed.

Lemma percent_real e : Q2R (percent e) = Q2R e / 100.
Proof. unfold percent. rewrite Q2R_over, Q2R_integer by (rewrite Q2R_integer; lra). reflexivity. Qed.

Lemma around_within share e i x :
  within_interval (around share e i) x <->
  within_interval i x /\ forall e', e = Some e' -> near e' x (Q2R share).
Proof.
  destruct e as [e|]; simpl.
  - rewrite narrow_within, Q2R_subtract, Q2R_add, percent_real. unfold near. split.
    + intros (A & B). split; [exact A|]. intros e' [= <-]. apply Rabs_le. lra.
    + intros (A & B). specialize (B e eq_refl). 
      assert (- (Q2R e / 100) <= x - Q2R share <= Q2R e / 100).
      { revert B. unfold Rabs. destruct (Rcase_abs (x - Q2R share)); lra. }
      split; [exact A | lra].
  - split; [intro A; split; [exact A | discriminate] | tauto].
Qed.

Lemma any_share_within x : within_interval any_share x <-> 0 <= x <= 1.
Proof. unfold within_interval, any_share. cbn [lo hi]. rewrite Q2R_0, Q2R_integer. tauto. Qed.

Lemma only_if_some {A} yes (x : A) y : only_if yes x = Some y <-> yes = true /\ x = y.
Proof. destruct yes; simpl; split; [intros [= ->]; auto | intros (_ & ->); reflexivity | discriminate | intros (? & _); discriminate]. Qed.

Section Root.
Context {d : positive}.

(* ---- Sums up to a class -------------------------------------------------------------------------- *)

Fixpoint prefix_of (w p : class -> R) (P : R) (js : list class) : Prop :=
  match js with
  | [] => True
  | j :: js => p j = P + w j /\ prefix_of w p (p j) js
  end.

Definition up_to (w : class -> R) (y : R) (js : list class) : R :=
  total (map (fun j => if Rle_dec (upper_size d j) y then w j else 0) js).

Lemma prefix_ext w p p' js : forall P P', P = P' -> (forall j, In j js -> p j = p' j) -> prefix_of w p P js -> prefix_of w p' P' js.
Proof.
  induction js as [|j js IH]; intros P P' E X H; [exact I|]. destruct H as (H & T). simpl.
  rewrite <- X by (left; reflexivity). split; [congruence|].
  apply (IH (p j)); [reflexivity | intros; apply X; right; assumption | exact T].
Qed.

Lemma above_uppers js : forall x1 j, ascend_from d x1 js -> In j js -> x1 < upper_size d j.
Proof.
  induction js as [|i js IH]; intros x1 j A I; [destruct I|]. destruct A as (E & L & A).
  destruct I as [<-|I]; [exact L|]. pose proof (IH _ _ A I). lra.
Qed.

Lemma up_to_none w y js : forall x1, ascend_from d x1 js -> y <= x1 -> up_to w y js = 0.
Proof.
  unfold up_to. induction js as [|j js IH]; intros x1 A L; simpl; [reflexivity|]. destruct A as (E & Lt & A).
  destruct (Rle_dec (upper_size d j) y); [lra|]. rewrite (IH _ A) by lra. ring.
Qed.

Lemma up_to_prefix w js : forall x1 P, ascend_from d x1 js -> prefix_of w (fun j => P + up_to w (upper_size d j) js) P js.
Proof.
  induction js as [|j js IH]; intros x1 P A; [exact I|]. destruct A as (E & L & A). simpl.
  assert (forall y, up_to w y (j :: js) = (if Rle_dec (upper_size d j) y then w j else 0) + up_to w y js) as U by reflexivity.
  rewrite U. destruct (Rle_dec (upper_size d j) (upper_size d j)) as [_|N]; [|lra].
  rewrite (up_to_none w _ js _ A) by lra. split; [ring|].
  refine (prefix_ext w _ _ js _ _ _ _ (IH _ (P + w j) A)); [ring|].
  intros i I. rewrite U. pose proof (above_uppers _ _ _ A I). destruct (Rle_dec (upper_size d j) (upper_size d i)); [ring | lra].
Qed.

Lemma prefix_scale k w p js : forall P, prefix_of w p P js -> prefix_of (fun j => w j * k) (fun j => p j * k) (P * k) js.
Proof.
  induction js as [|j js IH]; intros P H; [exact I|]. destruct H as (H & T). simpl. split; [rewrite H; ring | apply IH, T].
Qed.

Lemma up_to_all w y js : (forall j, In j js -> upper_size d j <= y) -> up_to w y js = total (map w js).
Proof.
  unfold up_to. induction js as [|j js IH]; intro H; simpl; [reflexivity|].
  destruct (Rle_dec (upper_size d j) y) as [_|N]; [|contradiction N; apply H; left; reflexivity].
  rewrite IH; [reflexivity | intros; apply H; right; assumption].
Qed.

Lemma total_nonneg {A} (w : A -> R) js : (forall j, In j js -> 0 <= w j) -> 0 <= total (map w js).
Proof.
  induction js as [|j js IH]; intro H; simpl; [lra|].
  pose proof (H j (or_introl eq_refl)). specialize (IH ltac:(intros; apply H; right; assumption)). lra.
Qed.

Lemma total_member {A} (w : A -> R) js j : (forall j, In j js -> 0 <= w j) -> In j js -> w j <= total (map w js).
Proof.
  induction js as [|i js IH]; intros H I; [destruct I|]. simpl.
  pose proof (H i (or_introl eq_refl)). pose proof (total_nonneg w js ltac:(intros; apply H; right; assumption)).
  destruct I as [<-|I]; [lra|]. specialize (IH ltac:(intros; apply H; right; assumption) I). lra.
Qed.

Lemma up_to_between w y js : (forall j, In j js -> 0 <= w j) -> 0 <= up_to w y js <= total (map w js).
Proof.
  unfold up_to. induction js as [|j js IH]; intro H; simpl; [lra|].
  pose proof (H j (or_introl eq_refl)). specialize (IH ltac:(intros; apply H; right; assumption)).
  destruct (Rle_dec (upper_size d j) y); lra.
Qed.

End Root.

Arguments up_to : clear implicits.

(* ---- Lines without the band ---------------------------------------------------------------------- *)

Section Lines.
Variable tol : tolerances.
(* Shares retained and passing of the sample, and of the gradation. *)
Variables x y gx gy : class -> R.

(* Of the class j between the openings of r and next. *)
Definition line_holds (j : class) (r next : row) (later : list row) (each : list Q) : Prop :=
  (forall e, retained_each tol = Some e -> near e (x j) (gx j)) /\
  (retained_file tol = true -> near (tolerance r) (x j) (gx j)) /\
  match later with
  | [] => True
  | _ =>
    (forall e, passing_all tol = Some e -> near e (y j) (gy j)) /\
    (passing_file tol = true -> near (tolerance next) (y j) (gy j)) /\
    (forall e, hd_error each = Some e -> near e (y j) (gy j))
  end.

Fixpoint lines_hold (rs : list row) (each : list Q) : Prop :=
  match rs with
  | r :: ((next :: later) as rest) =>
    line_holds (Class (opening r) (opening next) (retained r) (factor r)) r next later each /\ lines_hold rest (tl each)
  | _ => True
  end.

(* The class's share, its own bounds and those of what passes. *)
Definition fits_share (j : class) (s : share) : Prop :=
  Q2R (g_j s) = gx j /\ within_interval (retained_in s) (x j) /\ within_interval (passing_in s) (y j).

Lemma shares_fit all rs : forall G each,
  Q2R all <> 0 -> (forall j, In j (classes rs) -> Q2R (mass j) / Q2R all = gx j) ->
  prefix_of gx gy (Q2R G) (classes rs) ->
  (forall j, In j (classes rs) -> 0 <= x j <= 1 /\ 0 <= y j <= 1) ->
  Forall2 fits_share (classes rs) (shares tol all G rs each) <-> lines_hold rs each.
Proof.
  induction rs as [|r rs IH]; intros G each Al Gx Pr Un; [simpl; split; [trivial | constructor]|].
  destruct rs as [|next later]; [simpl; split; [trivial | constructor]|].
  set (j := Class (opening r) (opening next) (retained r) (factor r)).
  change (classes (r :: next :: later)) with (j :: classes (next :: later)) in *.
  destruct Pr as (Pj & Pr).
  assert (Q2R (over (retained r) all) = gx j) as Eg.
  { rewrite Q2R_over by exact Al. exact (Gx j (or_introl eq_refl)). }
  assert (Q2R (add G (over (retained r) all)) = gy j) as EG by (rewrite Q2R_add, Eg, Pj; reflexivity).
  destruct (Un j (or_introl eq_refl)) as (Ux & Uy).
  specialize (IH (add G (over (retained r) all)) (tl each) Al ltac:(intros; apply Gx; right; assumption)).
  rewrite EG in IH. specialize (IH Pr ltac:(intros; apply Un; right; assumption)).
  change (lines_hold (r :: next :: later) each) with
    (line_holds j r next later each /\ lines_hold (next :: later) (tl each)).
  rewrite <- IH. clear IH.
  set (s := Share (over (retained r) all)
    (around (over (retained r) all) (only_if (retained_file tol) (tolerance r))
       (around (over (retained r) all) (retained_each tol) any_share))
    match later with
    | [] => any_share
    | _ => around (add G (over (retained r) all)) (hd_error each)
             (around (add G (over (retained r) all)) (only_if (passing_file tol) (tolerance next))
                (around (add G (over (retained r) all)) (passing_all tol) any_share))
    end).
  change (shares tol all G (r :: next :: later) each)
    with (s :: shares tol all (add G (over (retained r) all)) (next :: later) (tl each)).
  assert (fits_share j s <-> line_holds j r next later each) as K.
  { unfold line_holds, fits_share, s. cbn [g_j retained_in passing_in]. rewrite !around_within, Eg, any_share_within.
    assert (forall (yes : bool) e u v, (forall e', only_if yes e = Some e' -> near e' u v) <-> (yes = true -> near e u v)) as O.
    { intros yes e u v. split.
      - intros H Y. apply H. apply only_if_some. auto.
      - intros H e' Ee. apply only_if_some in Ee as (Y & <-). auto. }
    rewrite O. destruct later as [|n2 later].
    - rewrite any_share_within. tauto.
    - rewrite !around_within, EG, any_share_within, O. tauto. }
  split.
  - intro H. inversion H as [|? ? ? ? H1 H2]; subst. apply K in H1. tauto.
  - intro H. constructor; [apply K; tauto | tauto].
Qed.

(* ---- The band ------------------------------------------------------------------------------------ *)

Variable pass : R -> R.

Definition band_holds (lines : list (Q * Q * Q)) : Prop :=
  forall X l h, In (X, l, h) lines -> Q2R l / 100 <= pass (Q2R X) <= Q2R h / 100.

Lemma narrow_by_fit j lines : forall s,
  (forall X l h, In (X, l, h) lines -> pass (Q2R X) = y j) ->
  fits_share j (narrow_by s lines) <-> fits_share j s /\ band_holds lines.
Proof.
  unfold narrow_by. induction lines as [|((X, l), h) lines IH]; intros s P; simpl.
  { split; [intro H; split; [exact H | intros ? ? ? []] | tauto]. }
  rewrite IH by (intros; eapply P; right; eassumption).
  assert (fits_share j (narrow_passing s (percent l) (percent h)) <->
          fits_share j s /\ Q2R l / 100 <= y j <= Q2R h / 100) as ->.
  { unfold fits_share, narrow_passing. cbn [g_j retained_in passing_in]. rewrite narrow_within, !percent_real. tauto. }
  rewrite <- (P X l h (or_introl eq_refl)). unfold band_holds. split.
  - intros ((A & B) & C). split; [exact A|]. intros X' l' h' [[= <- <- <-]|I]; [exact B | eapply C; exact I].
  - intros (A & C). split; [split; [exact A | apply C; left; reflexivity]|]. intros X' l' h' I. apply C. right; exact I.
Qed.

Lemma apply_band_fit js : forall ss lines result,
  length js = length ss -> js <> [] -> apply_band js ss lines = Ok result ->
  (forall j, In j js -> pass (Q2R (upper j)) = y j) ->
  (forall X, Q2R (upper (last js (Class 0 0 0 0))) <= X -> pass X = y (last js (Class 0 0 0 0))) ->
  Forall2 fits_share js result <-> Forall2 fits_share js ss /\ band_holds lines.
Proof.
  induction js as [|j js IH]; intros [|s ss] lines result Le Ne H P T; try discriminate; try congruence.
  cbn [apply_band] in H. destruct js as [|j2 js].
  - passed H. injection H as <-. destruct ss; [|discriminate]. rewrite forallb_forall in H0. simpl in T.
    assert (forall X l h, In (X, l, h) lines -> pass (Q2R X) = y j) as E.
    { intros X l h I. apply T. specialize (H0 _ I). simpl in H0. apply at_most_real, H0. }
    pose proof (narrow_by_fit j lines s E) as K. split.
    + intro F. inversion F as [|? ? ? ? F1 _]; subst. apply K in F1 as (F1 & F2). split; [constructor; [exact F1 | constructor] | exact F2].
    + intros (F & B). inversion F as [|? ? ? ? F1 _]; subst. constructor; [apply K; auto | constructor].
  - destruct lines as [|((X, l), h) rest].
    { injection H as <-. split; [intro F; split; [exact F | intros ? ? ? []] | tauto]. }
    passed H. passed H. injection H as <-. rename x0 into later.
    apply (IH ss _ later) in H1; [|simpl in *; lia | congruence | intros; apply P; right; assumption | exact T].
    destruct (equal X (upper j)) eqn:E.
    + apply equal_real in E. pose proof (P j (or_introl eq_refl)) as Pj. rewrite <- E in Pj.
      assert (fits_share j (narrow_passing s (percent l) (percent h)) <->
              fits_share j s /\ Q2R l / 100 <= pass (Q2R X) <= Q2R h / 100) as K.
      { unfold fits_share, narrow_passing. cbn [g_j retained_in passing_in]. rewrite narrow_within, !percent_real, Pj. tauto. }
      split.
      * intro F. inversion F as [|? ? ? ? F1 F2]; subst. apply K in F1 as (F1 & B1). apply H1 in F2 as (F2 & B2).
        split; [constructor; assumption|]. intros X' l' h' [[= <- <- <-]|I]; [exact B1 | eapply B2; exact I].
      * intros (F & B). inversion F as [|? ? ? ? F1 F2]; subst. constructor.
        -- apply K. split; [exact F1 | apply B; left; reflexivity].
        -- apply H1. split; [exact F2 | intros ? ? ? I; apply B; right; exact I].
    + split.
      * intro F. inversion F as [|? ? ? ? F1 F2]; subst. apply H1 in F2 as (F2 & B2). split; [constructor; assumption | exact B2].
      * intros (F & B). inversion F as [|? ? ? ? F1 F2]; subst. constructor; [exact F1 | apply H1; auto].
Qed.

Lemma above_finest_holds x1 lines : forall rest,
  above_finest x1 lines = Ok rest -> (forall X, X <= Q2R x1 -> pass X = 0) ->
  (band_holds lines -> band_holds rest) /\
  ((forall X l h, In (X, l, h) lines -> 0 <= Q2R h) -> band_holds rest -> band_holds lines).
Proof.
  induction lines as [|((X, l), h) lines IH]; intros rest H P; cbn [above_finest] in H.
  { injection H as <-. tauto. }
  destruct (at_most X x1) eqn:E; [|injection H as <-; tauto].
  passed H. apply at_most_real in E. apply equal_real in H0. rewrite Q2R_0 in H0. destruct (IH rest H P) as (A & B). split.
  - intro F. apply A. intros ? ? ? I. apply F. right; exact I.
  - intros N F X' l' h' [[= <- <- <-]|I].
    + rewrite (P _ E), H0. pose proof (N X l h (or_introl eq_refl)). lra.
    + apply B; [intros ? ? ? I'; eapply N; right; exact I' | exact F | exact I].
Qed.

(* ---- The lines as Spec.v has them ---------------------------------------------------------------- *)

Lemma lines_hold_of rs : forall each,
  (forall e, retained_each tol = Some e -> forall j, In j (classes rs) -> near e (x j) (gx j)) ->
  (retained_file tol = true -> forall j r, In (j, r) (combine (classes rs) rs) -> near (tolerance r) (x j) (gx j)) ->
  (forall e, passing_all tol = Some e -> forall j, In j (classes rs) -> near e (y j) (gy j)) ->
  (passing_file tol = true -> forall j r, In (j, r) (combine (classes rs) (tl rs)) -> near (tolerance r) (y j) (gy j)) ->
  (forall j e, In (j, e) (combine (classes rs) each) -> near e (y j) (gy j)) ->
  lines_hold rs each.
Proof.
  induction rs as [|r rs IH]; intros each H1 H2 H3 H4 H5; [exact I|]. destruct rs as [|next later]; [exact I|].
  set (j := Class (opening r) (opening next) (retained r) (factor r)).
  change (classes (r :: next :: later)) with (j :: classes (next :: later)) in *.
  split; [split; [|split]|].
  - intros e E. apply H1; [exact E | left; reflexivity].
  - intro E. apply H2; [exact E | left; reflexivity].
  - assert ((forall e, passing_all tol = Some e -> near e (y j) (gy j)) /\
      (passing_file tol = true -> near (tolerance next) (y j) (gy j)) /\
      (forall e, hd_error each = Some e -> near e (y j) (gy j))) as K.
    { split; [|split].
      - intros e E. apply H3; [exact E | left; reflexivity].
      - intro E. apply H4; [exact E | left; reflexivity].
      - intros e E. destruct each as [|e0 each]; [discriminate|]. injection E as ->. apply H5. left; reflexivity. }
    destruct later; [exact I | exact K].
  - apply IH.
    + intros e E i Ii. apply H1; [exact E | right; exact Ii].
    + intros E i r' Ii. apply (H2 E). right; exact Ii.
    + intros e E i Ii. apply H3; [exact E | right; exact Ii].
    + intros E i r' Ii. apply (H4 E). cbn [tl] in *. destruct later as [|n2 later]; [destruct Ii|]. right; exact Ii.
    + intros i e Ii. apply H5. destruct each as [|e0 each]; [rewrite combine_nil in Ii; destruct Ii|]. right; exact Ii.
Qed.

Lemma of_lines_hold rs : forall each,
  lines_hold rs each ->
  (forall e, 0 <= Q2R e -> forall j, In j (classes rs) -> last (classes rs) j = j -> near e (y j) (gy j)) ->
  Forall (fun r => 0 <= Q2R (tolerance r)) rs -> Forall (fun e => 0 <= Q2R e) each ->
  (forall e, passing_all tol = Some e -> 0 <= Q2R e) ->
  (forall e, retained_each tol = Some e -> forall j, In j (classes rs) -> near e (x j) (gx j)) /\
  (retained_file tol = true -> forall j r, In (j, r) (combine (classes rs) rs) -> near (tolerance r) (x j) (gx j)) /\
  (forall e, passing_all tol = Some e -> forall j, In j (classes rs) -> near e (y j) (gy j)) /\
  (passing_file tol = true -> forall j r, In (j, r) (combine (classes rs) (tl rs)) -> near (tolerance r) (y j) (gy j)) /\
  (forall j e, In (j, e) (combine (classes rs) each) -> near e (y j) (gy j)).
Proof.
  induction rs as [|r rs IH]; intros each H Last Tr Te Tp; [repeat split; intros; contradiction|].
  destruct rs as [|next later]; [repeat split; intros; contradiction|].
  set (j := Class (opening r) (opening next) (retained r) (factor r)).
  change (classes (r :: next :: later)) with (j :: classes (next :: later)) in *.
  destruct H as ((A & B & C) & D). fold j in A, B, C.
  inversion Tr as [|? ? _ Tr']; subst. inversion Tr' as [|? ? Tn _]; subst.
  assert (Forall (fun e => 0 <= Q2R e) (tl each)) as Te' by (destruct each; [exact Te | inversion Te; assumption]).
  assert ((forall e, passing_all tol = Some e -> near e (y j) (gy j)) /\
      (passing_file tol = true -> near (tolerance next) (y j) (gy j)) /\
      (forall e, hd_error each = Some e -> near e (y j) (gy j))) as (C1 & C2 & C3).
  { destruct later as [|n2 later]; [|exact C].
    assert (forall e, 0 <= Q2R e -> near e (y j) (gy j)) as L by (intros e E; apply Last; [exact E | left; reflexivity | reflexivity]).
    split; [intros e E; apply L, Tp, E|]. split; [intros _; apply L, Tn|].
    intros e E. apply L. destruct each as [|e0 each]; [discriminate|]. injection E as ->. inversion Te; assumption. }
  destruct (IH (tl each) D) as (I1 & I2 & I3 & I4 & I5); trivial.
  { intros e E i Ii Li. apply Last; [exact E | right; exact Ii|].
    destruct later as [|n2 later]; [destruct Ii|]. exact Li. }
  split; [|split; [|split; [|split]]].
  - intros e E i [<-|Ii]; [apply A, E | apply (I1 e E), Ii].
  - intros E i r' [[= <- <-]|Ii]; [apply B, E | apply (I2 E), Ii].
  - intros e E i [<-|Ii]; [apply C1, E | apply (I3 e E), Ii].
  - intros E i r' Ii. cbn [tl combine] in Ii. destruct Ii as [[= <- <-]|Ii]; [apply C2, E|]. apply (I4 E).
    cbn [tl]. exact Ii.
  - intros i e Ii. destruct each as [|e0 each]; [destruct Ii|]. destruct Ii as [[= <- <-]|Ii]; [apply C3; reflexivity | apply I5, Ii].
Qed.

End Lines.
