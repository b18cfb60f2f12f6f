(* Samples of several materials, as what the classes of all materials hold (Theorem 28 (a)). *)

From Coq Require Import ZArith QArith Reals Qreals String List Bool OrderedTypeEx Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Exact Tolerant Mixture Spec MixtureSpec Openings
  Reduction RealFacts Sizes Contents ExactSound Solids ExactTheorem Shares TolerantSound TolerantTheorem.
Import ListNotations.
Open Scope list_scope.
Open Scope R_scope.

(* ---- Lists of what belongs to each --------------------------------------------------------------- *)

Lemma interleaved_cons {A B} (each : B -> list A) between m n ms :
  interleaved each between (m :: n :: ms) = each m ++ between m :: interleaved each between (n :: ms).
Proof. reflexivity. Qed.

Lemma interleaved_both {A A' B} (P : A -> A' -> Prop) (each : B -> list A) each' between between' ms :
  (forall m, In m ms -> Forall2 P (each m) (each' m) /\ P (between m) (between' m)) ->
  Forall2 P (interleaved each between ms) (interleaved each' between' ms).
Proof.
  induction ms as [|m [|n ms] IH]; intro H; [constructor | apply H; left; reflexivity|].
  rewrite !interleaved_cons. destruct (H m (or_introl eq_refl)) as (E & B0). apply Forall2_app; [exact E|].
  constructor; [exact B0|]. apply IH. intros; apply H; right; assumption.
Qed.

Lemma interleaved_all {A B} (P : A -> Prop) (each : B -> list A) between ms :
  (forall m, In m ms -> Forall P (each m) /\ P (between m)) -> Forall P (interleaved each between ms).
Proof.
  induction ms as [|m [|n ms] IH]; intro H; [constructor | apply H; left; reflexivity|].
  rewrite interleaved_cons. destruct (H m (or_introl eq_refl)) as (E & B0). apply Forall_app. split; [exact E|].
  constructor; [exact B0|]. apply IH. intros; apply H; right; assumption.
Qed.

Lemma interleaved_in {A B} (each : B -> list A) between ms m x :
  In m ms -> In x (each m) -> In x (interleaved each between ms).
Proof.
  induction ms as [|n [|n' ms] IH]; intros I X; [destruct I | destruct I as [->|[]]; exact X|].
  rewrite interleaved_cons. apply in_or_app. destruct I as [->|I]; [left; exact X | right; right; exact (IH I X)].
Qed.

Lemma interleaved_map {A A' B} (g : A -> A') (each : B -> list A) between ms :
  map g (interleaved each between ms) = interleaved (fun m => map g (each m)) (fun m => g (between m)) ms.
Proof.
  induction ms as [|m [|n ms] IH]; [reflexivity | reflexivity|]. rewrite !interleaved_cons, map_app. cbn [map]. rewrite IH. reflexivity.
Qed.

Lemma interleaved_total {B} (each : B -> list R) ms :
  total (interleaved each (fun _ => 0) ms) = total (map (fun m => total (each m)) ms).
Proof.
  induction ms as [|m [|n ms] IH]; [reflexivity | simpl; ring|]. rewrite interleaved_cons, total_app, total_cons, IH.
  cbn [map]. rewrite !total_cons. ring.
Qed.

Lemma interleaved_ext {A B} (each each' : B -> list A) between between' ms :
  (forall m, In m ms -> each m = each' m /\ between m = between' m) -> interleaved each between ms = interleaved each' between' ms.
Proof.
  induction ms as [|m [|n ms] IH]; intro H; [reflexivity | apply H; left; reflexivity|].
  rewrite !interleaved_cons. destruct (H m (or_introl eq_refl)) as (-> & ->). rewrite IH; [reflexivity|]. intros; apply H; right; assumption.
Qed.

Lemma combine_app {A B} (l l' : list A) : forall m m' : list B, length l = length m -> combine (l ++ l') (m ++ m') = combine l m ++ combine l' m'.
Proof. induction l as [|x l IH]; intros [|y m] m' E; try discriminate; [reflexivity|]. simpl. f_equal. apply IH. injection E as E. exact E. Qed.

Lemma interleaved_combine {A A' B} (each : B -> list A) (each' : B -> list A') between between' ms :
  (forall m, In m ms -> length (each m) = length (each' m)) ->
  combine (interleaved each between ms) (interleaved each' between' ms) =
  interleaved (fun m => combine (each m) (each' m)) (fun m => (between m, between' m)) ms.
Proof.
  induction ms as [|m [|n ms] IH]; intro H; [reflexivity | reflexivity|].
  rewrite !interleaved_cons, combine_app by (apply H; left; reflexivity). cbn [combine]. rewrite IH; [reflexivity|]. intros; apply H; right; assumption.
Qed.

(* ---- Particles by their material ----------------------------------------------------------------- *)

Lemma of_material_cons name p S :
  of_material name (p :: S) = if String.eqb name (fst p) then snd p :: of_material name S else of_material name S.
Proof. unfold of_material. cbn [filter]. destruct (String.eqb name (fst p)); reflexivity. Qed.

Lemma of_material_app name S T : of_material name (S ++ T) = of_material name S ++ of_material name T.
Proof. unfold of_material. rewrite filter_app, map_app. reflexivity. Qed.

Lemma of_the_material name xs : of_material name (map (pair name) xs) = xs.
Proof. induction xs as [|x xs IH]; [reflexivity|]. cbn [map]. rewrite of_material_cons. cbn [fst snd]. rewrite String.eqb_refl, IH. reflexivity. Qed.

Lemma of_no_material name S : (forall p, In p S -> fst p <> name) -> of_material name S = [].
Proof.
  induction S as [|p S IH]; intro H; [reflexivity|]. rewrite of_material_cons.
  destruct (String.eqb_spec name (fst p)) as [E|_]; [exfalso; apply (H p); [left; reflexivity | congruence]|].
  apply IH. intros; apply H; right; assumption.
Qed.

(* What is added up over all particles is added up over the materials. *)
Lemma total_by_material (g : R -> R) names S : NoDup names -> (forall p, In p S -> In (fst p) names) ->
  total (map g (map snd S)) = total (map (fun name => total (map g (of_material name S))) names).
Proof.
  intro U. induction S as [|p S IH]; intro H.
  - cbn [map of_material filter]. clear. induction names as [|n names IH]; [reflexivity|]. cbn [map]. rewrite total_cons, <- IH. simpl. ring.
  - cbn [map]. rewrite total_cons, IH by (intros; apply H; right; assumption). specialize (H p (or_introl eq_refl)). clear IH.
    assert (forall l, ~ In (fst p) l -> map (fun name => total (map g (of_material name (p :: S)))) l =
      map (fun name => total (map g (of_material name S))) l) as Other.
    { intros l N. apply map_ext_in. intros n I. rewrite of_material_cons. destruct (String.eqb_spec n (fst p)) as [->|_]; [contradiction | reflexivity]. }
    induction U as [|n names N U IH]; [destruct H|]. cbn [map]. rewrite !total_cons. destruct H as [->|H].
    + rewrite of_material_cons, String.eqb_refl, (Other names N). cbn [map]. rewrite total_cons. ring.
    + rewrite <- (IH H). rewrite of_material_cons. destruct (String.eqb_spec n (fst p)) as [->|_]; [contradiction|]. ring.
Qed.

Lemma length_by_material names S : NoDup names -> (forall p, In p S -> In (fst p) names) ->
  INR (length S) = total (map (fun name => INR (length (of_material name S))) names).
Proof.
  intros U H. assert (forall l : list R, total (map (fun _ => 1) l) = INR (length l)) as L.
  { induction l as [|x l IH]; [reflexivity|]. cbn [map]. rewrite total_cons, IH. change (length (x :: l)) with (Datatypes.S (length l)). rewrite S_INR. ring. }
  pose proof (total_by_material (fun _ => 1) names S U H) as T. rewrite L, map_length in T. rewrite T. f_equal. apply map_ext. intro n. apply L.
Qed.

(* ---- Materials ----------------------------------------------------------------------------------- *)

Lemma names_differ names : names_ascend names = true -> NoDup names.
Proof.
  assert (forall x y, before x y = true -> String_as_OT.lt x y) as L.
  { intros x y H. unfold before in H. destruct (String_as_OT.cmp x y) eqn:E; try discriminate. apply String_as_OT.cmp_lt, E. }
  assert (forall others x, names_ascend (x :: others) = true -> forall y, In y others -> String_as_OT.lt x y) as Less.
  { induction others as [|n l IH]; intros x A y I; [destruct I|]. cbn [names_ascend] in A. apply andb_prop in A as (B & A). apply L in B.
    destruct I as [<-|I]; [exact B|]. exact (String_as_OT.lt_trans _ _ _ B (IH n A y I)). }
  induction names as [|n names IH]; intro A; constructor.
  - intro I. exact (String_as_OT.lt_not_eq _ _ (Less names n A n I) eq_refl).
  - apply IH. destruct names; [reflexivity|]. cbn [names_ascend] in A. apply andb_prop in A as (_ & A). exact A.
Qed.

Definition some_mass_in (rs : list row) : Prop := exists j, In j (classes rs) /\ 0 < Q2R (mass j).

Section Materials.
Context {d : positive}.
Variable ms : list (string * list row).
Hypothesis names_unique : NoDup (map fst ms).
Hypothesis all_proper : forall name rs, In (name, rs) ms -> proper_rows rs /\ some_mass_in rs.
Hypothesis some_material : ms <> [].

Notation places := (places_of ms).
Notation js := (map fst places).

Lemma rows_there rs : some_mass_in rs -> exists r l, rs = r :: l /\ In (last_row rs) rs.
Proof.
  intros (j & J & _). destruct rs as [|r l]; [destruct J|]. exists r, l. split; [reflexivity|]. unfold last_row. clear.
  revert r. induction l as [|n l IH]; intro r; [left; reflexivity|]. right. exact (IH n).
Qed.

Lemma proper_materials m : In m ms -> proper_rows (snd m) /\ some_mass_in (snd m).
Proof. destruct m as (name, rs). apply all_proper. Qed.

Lemma last_factor_positive rs : proper_rows rs -> some_mass_in rs -> 0 < Q2R (factor (last_row rs)).
Proof.
  intros (_ & _ & _ & F) H. destruct (rows_there rs H) as (r & l & _ & I). rewrite Forall_forall in F. destruct (F _ I) as (_ & C).
  apply Qlt_Rlt in C. rewrite Q2R_0 in C. exact C.
Qed.

Lemma nothing_proper rs : proper_rows rs -> some_mass_in rs -> proper (fst (nothing_behind (last_row rs))).
Proof.
  intros P H. unfold proper, nothing_behind. cbn [fst lower upper mass c]. rewrite Q2R_0, Q2R_integer.
  pose proof (last_factor_positive rs P H). lra.
Qed.

Lemma places_proper : Forall proper js.
Proof.
  unfold places_of. rewrite interleaved_map. apply interleaved_all. intros m I. destruct (proper_materials m I) as (P & H).
  rewrite all_begin_classes. split; [apply proper_classes, P | apply nothing_proper; assumption].
Qed.

Lemma row_of_all m r : In m ms -> In r (snd m) -> In r (all_rows ms).
Proof. intros I R. apply in_flat_map. exists m. auto. Qed.

Lemma places_integral : Forall (integral (units_of (all_rows ms))) js.
Proof.
  assert (forall g r m, In m ms -> In r (snd m) -> (Zpos (Qden (g r)) | common_denominator (map g (all_rows ms)))%Z) as D.
  { intros g r m I R. apply common_denominator_spec, in_map, (row_of_all m); assumption. }
  unfold places_of. rewrite interleaved_map. apply interleaved_all. intros m I. rewrite all_begin_classes. split.
  - apply Forall_forall. intros j J. destruct (class_of_rows _ j J) as (L & U & M & C).
    apply in_map_iff in L as (r1 & E1 & L), U as (r2 & E2 & U), M as (r3 & E3 & M), C as (r4 & E4 & C).
    unfold integral. rewrite <- E1, <- E2, <- E3, <- E4. repeat split; eapply D; eassumption.
  - destruct (proper_materials m I) as (P & H). destruct (rows_there _ H) as (r & l & _ & R). unfold integral, nothing_behind.
    cbn [fst lower upper mass c Qden of_integer]. repeat split; try apply Z.divide_1_l. apply (D factor _ m I R).
Qed.

Lemma follow_app later places0 : later <> [] -> follow later places0 -> forall rs, rs <> [] ->
  follow (rs ++ later) (all_begin (classes rs) ++ nothing_behind (last_row rs) :: places0).
Proof.
  intros Ne Fo. induction rs as [|r rs IH]; [congruence|]. intros _. destruct rs as [|n rs].
  - destruct later as [|n later]; [congruence|]. split; [discriminate|]. split; [reflexivity | exact Fo].
  - split; [intros _; split; reflexivity|]. split; [reflexivity|]. apply IH. discriminate.
Qed.

Lemma places_follow : follow (all_rows ms) places.
Proof.
  assert (forall m, In m ms -> snd m <> []) as Ne.
  { intros m I. destruct (proper_materials m I) as (_ & H). destruct (rows_there _ H) as (r & l & E & _). rewrite E. discriminate. }
  clear -Ne. unfold places_of, all_rows. induction ms as [|m [|n l] IH]; [exact I | cbn [flat_map]; rewrite app_nil_r; apply classes_follow|].
  rewrite interleaved_cons. cbn [flat_map]. apply follow_app.
  - intro E. apply app_eq_nil in E as (E & _). exact (Ne n (or_intror (or_introl eq_refl)) E).
  - apply IH. intros; apply Ne; right; assumption.
  - apply Ne. left; reflexivity.
Qed.

Lemma openings_of_all : Forall (fun r => 0 <= Q2R (opening r)) (all_rows ms).
Proof.
  apply Forall_forall. intros r R. apply in_flat_map in R as (m & I & R). destruct (proper_materials m I) as (P & _).
  pose proof (openings_not_negative _ P) as F. rewrite Forall_forall in F. exact (F r R).
Qed.

Lemma mass_in_places : exists j, In j js /\ 0 < Q2R (mass j).
Proof.
  destruct ms as [|m l] eqn:E; [congruence|]. rewrite <- E in *. assert (In m ms) as I by (rewrite E; left; reflexivity).
  destruct (proper_materials m I) as (_ & j & J & M). exists j. split; [|exact M]. unfold places_of. rewrite interleaved_map.
  apply (interleaved_in _ _ ms m j I). rewrite all_begin_classes. exact J.
Qed.

(* What is added up over all classes, where it is 0 for nothing, is added up over the materials. *)
Lemma total_of_places (w : class -> R) : (forall r, w (fst (nothing_behind r)) = 0) ->
  total (map w js) = over_materials ms (fun _ rs => total (map w (classes rs))).
Proof.
  intro Z. unfold places_of, over_materials. rewrite !interleaved_map.
  rewrite (interleaved_ext _ (fun m => map w (classes (snd m))) _ (fun _ => 0)); [apply interleaved_total|].
  intros m _. rewrite all_begin_classes. split; [reflexivity | apply Z].
Qed.

Lemma mass_of_places : mass_of_classes js = mixture_mass ms.
Proof. unfold mass_of_classes. rewrite total_of_places; [reflexivity|]. intro r. apply Q2R_0. Qed.

Lemma sum_of_all_rows : Q2R (fold_left add (map retained (all_rows ms)) 0%Q) = mass_of_classes js.
Proof.
  assert (forall l x0, Q2R (fold_left add l x0) = Q2R x0 + total (map Q2R l)) as F.
  { induction l as [|q l IH]; intro x0; simpl; [ring|]. rewrite IH, Q2R_add. ring. }
  rewrite F, Q2R_0, Rplus_0_l, mass_of_places. unfold mixture_mass, over_materials, all_rows.
  assert (forall m, In m ms -> total (map Q2R (map retained (snd m))) = gradation_mass (snd m)) as Part.
  { intros m I. destruct (proper_materials m I) as (P & _). rewrite <- (sum_of_rows (snd m) P), F, Q2R_0. ring. }
  clear -Part. induction ms as [|m l IH]; [reflexivity|]. cbn [flat_map map]. rewrite !map_app, total_app, total_cons, IH.
  - rewrite Part by (left; reflexivity). reflexivity.
  - intros; apply Part; right; assumption.
Qed.

(* ---- Contents ------------------------------------------------------------------------------------ *)

Section Law.
Variable law : R -> R.
Hypothesis law_ok : mass_law law.

Definition mixed_contents (S : mixed_sample) : contents :=
  interleaved (fun m => contents_of d law (classes (snd m)) (of_material (fst m) S)) (fun _ => (0%Z, 0)) ms.

Definition one_size_each (S : mixed_sample) : Prop :=
  each ms (fun name rs => one_size_a_class d (classes rs) (of_material name S)).

Lemma mixed_realize S :
  Forall2 (fun p qt => realizes_there d law p (fst qt) (snd qt)) places (mixed_contents S).
Proof.
  apply interleaved_both. intros m I. destruct (proper_materials m I) as (P & _). split; [|split; reflexivity].
  pose proof (contents_realize (d := d) law (snd m) (of_material (fst m) S) law_ok P) as R. unfold all_begin. revert R.
  generalize (contents_of d law (classes (snd m)) (of_material (fst m) S)). intros qts R. induction R; constructor; assumption.
Qed.

(* A sample for all contents that the classes can have. *)
Lemma mixed_sample_with qts : Forall2 (fun p qt => realizes_there d law p (fst qt) (snd qt)) places qts ->
  exists S, mixture_describes d ms S /\ one_size_each S /\ mixed_contents S = qts.
Proof.
  unfold mixture_describes, of_these_materials, one_size_each, each, mixed_contents, places_of.
  clear some_material. revert qts. induction ms as [|(name, rs) l IH]; intros qts H.
  { inversion H. exists []. split; [split; [intros ? [] | intros ? ? []]|]. split; [intros ? ? [] | reflexivity]. }
  inversion names_unique as [|? ? N U]; subst.
  assert (forall qts, Forall2 (fun p qt => realizes_there d law p (fst qt) (snd qt)) (all_begin (classes rs)) qts ->
    exists T, describes d rs T /\ one_size_a_class d (classes rs) T /\ contents_of d law (classes rs) T = qts) as Here.
  { intros qts0 F. destruct (all_proper name rs (or_introl eq_refl)) as (P & _).
    destruct (sample_with_contents (d := d) law rs qts0 law_ok P) as (T & D & O & C).
    - clear -F. unfold all_begin in F. remember (map (fun j => (j, true)) (classes rs)) as places0. revert Heqplaces0. generalize (classes rs) as js0.
      induction F as [|p qt l qts Hp _ IH]; intros [|j js0] E; try discriminate E; constructor; injection E as -> E; [exact Hp | exact (IH js0 E)].
    - exists T. split; [exact D|]. split; [exact O|]. symmetry. exact (contents_are law _ T qts0 C). }
  specialize (IH U (fun n r I => all_proper n r (or_intror I))).
  assert (forall S0 T n, In n (map fst l) -> (forall p, In p S0 -> In (fst p) (map fst l)) ->
    of_material n (map (pair name) T ++ S0) = of_material n S0) as Rest.
  { intros S0 T n I _. rewrite of_material_app, of_no_material; [reflexivity|]. intros p Ip. apply in_map_iff in Ip as (x & <- & _).
    cbn [fst]. intros ->. contradiction. }
  assert (forall S0 T, (forall p, In p S0 -> In (fst p) (map fst l)) -> of_material name (map (pair name) T ++ S0) = T) as This.
  { intros S0 T I. rewrite of_material_app, of_the_material, of_no_material, app_nil_r; [reflexivity|]. intros p Ip E. apply N. rewrite <- E. exact (I p Ip). }
  destruct l as [|(name2, rs2) l].
  { cbn [interleaved snd] in H. destruct (Here qts H) as (T & D & O & C). exists (map (pair name) T).
    assert (of_material name (map (pair name) T) = T) as Eq by apply of_the_material. split; [split|split].
    - intros p Ip. apply in_map_iff in Ip as (x & <- & _). left; reflexivity.
    - intros n r [[= <- <-]|[]]. rewrite Eq. exact D.
    - intros n r [[= <- <-]|[]]. rewrite Eq. exact O.
    - cbn [interleaved fst snd]. rewrite Eq. exact C. }
  rewrite interleaved_cons in H. cbn [snd] in H. apply Forall2_app_inv_l in H as (qts1 & qts2 & F1 & F2 & ->).
  inversion F2 as [|? (n0, t0) ? qts3 Nothing F3]; subst. unfold realizes_there in Nothing. cbn [nothing_behind fst snd] in Nothing.
  destruct Nothing as (-> & ->).
  destruct (Here qts1 F1) as (T & D & O & C). destruct (IH qts3 F3) as (S0 & (I0 & D0) & O0 & C0).
  exists (map (pair name) T ++ S0).
  assert (forall n r, In (n, r) ((name2, rs2) :: l) -> of_material n (map (pair name) T ++ S0) = of_material n S0) as Eq.
  { intros n r I. apply Rest; [|exact I0]. apply in_map_iff. exists (n, r). auto. }
  split; [split|split].
  - intros p Ip. apply in_app_or in Ip as [Ip|Ip]; [apply in_map_iff in Ip as (x & <- & _); left; reflexivity | right; exact (I0 p Ip)].
  - intros n r [[= <- <-]|I]; [rewrite (This S0 T I0); exact D | rewrite (Eq n r I); exact (D0 n r I)].
  - intros n r [[= <- <-]|I]; [rewrite (This S0 T I0); exact O | rewrite (Eq n r I); exact (O0 n r I)].
  - rewrite interleaved_cons. cbn [fst snd]. rewrite (This S0 T I0), C. f_equal. f_equal. rewrite <- C0. apply interleaved_ext.
    intros (n, r) I. cbn [fst snd]. rewrite (Eq n r I). auto.
Qed.

Lemma mixed_number S : mixture_describes d ms S -> sum (map fst (mixed_contents S)) = Z.of_nat (length S).
Proof.
  intros (I & D). apply eq_IZR. rewrite <- INR_IZR_INZ, (length_by_material (map fst ms) S names_unique I). unfold mixed_contents.
  assert (forall l, IZR (sum l) = total (map IZR l)) as Sum.
  { induction l as [|x l IH]; [reflexivity|]. change (sum (x :: l)) with (x + sum l)%Z. cbn [map]. rewrite plus_IZR, total_cons, IH. reflexivity. }
  rewrite Sum, !interleaved_map. cbn [fst]. rewrite interleaved_total, map_map. f_equal. apply map_ext_in. intros (name, rs) Im. cbn [fst snd].
  rewrite counts_of_contents, <- Sum. destruct (all_proper name rs Im) as (P & _).
  rewrite <- (describes_number rs _ P (D name rs Im)). symmetry. apply INR_IZR_INZ.
Qed.

Lemma mixed_mass S : mass_of_contents (mixed_contents S) = mass_of_mixture d law ms S.
Proof.
  unfold mass_of_contents, mixed_contents. rewrite interleaved_map. cbn [snd]. rewrite interleaved_total. unfold mass_of_mixture, over_materials.
  f_equal. apply map_ext. intros (name, rs). rewrite masses_of_contents. reflexivity.
Qed.

(* What is added up over classes with their contents. *)
Lemma total_of_contents (w : class -> Z * R -> R) S : (forall r, w (fst (nothing_behind r)) (0%Z, 0) = 0) ->
  total (map (fun p => w (fst p) (snd p)) (combine js (mixed_contents S))) =
  over_materials ms (fun name rs => total (map (fun j => w j (number d j (of_material name S), held d law j (of_material name S))) (classes rs))).
Proof.
  intro Z. unfold places_of, mixed_contents, over_materials. rewrite interleaved_map, interleaved_combine, interleaved_map.
  2: { intros m _. unfold contents_of. rewrite all_begin_classes, map_length. reflexivity. }
  rewrite (interleaved_ext _ (fun m => map (fun j => w j (number d j (of_material (fst m) S), held d law j (of_material (fst m) S))) (classes (snd m)))
    _ (fun _ => 0)); [apply interleaved_total|].
  intros m _. cbn [fst snd]. split; [|apply Z]. rewrite all_begin_classes. unfold contents_of. generalize (classes (snd m)). intro l.
  induction l as [|j l IH]; [reflexivity|]. cbn [map combine fst snd]. rewrite IH. reflexivity.
Qed.

End Law.
End Materials.
