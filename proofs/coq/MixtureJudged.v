(* What it means that a verdict's line is true of a gradation of several materials, and that a checked statement is. *)

From Coq Require Import ZArith QArith Reals Qreals String List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Tolerant Text Rows GradationFile Mixture MixtureFile
  Document VerdictLine Judge Spec MixtureSpec RealFacts MixtureTheorem JudgeTheorem.
Import ListNotations.
Open Scope list_scope.
Open Scope R_scope.

(* ---- What the words of a line mean ------------------------------------------------------------------- *)

Section Meaning.
Variables (f : R -> R) (M : mixture) (S : mixed_sample).
Let d := root_of_mixture M.
Let ms := materials M.

(* What a part of a line demands of a sample. Some say which gradation and mass law are meant; the last ones are never said of
   several materials. *)
Definition mixed_demands (p : part) : Prop :=
  match p with
  | RetainedWithin e => mixed_within d f ms S e
  | TotalWithin e => mixed_errors d f ms S <= Q2R e / 100
  | AtLeastInEachClass r => enough_in_each_class d ms S r
  | CylinderFilled diameter height e =>
      PI / 4 * Q2R diameter ^ 2 * Q2R height <= solid_volume (sizes_of_all S) * (1 + Q2R e)
  | BoxFilled x y z e => Q2R x * Q2R y * Q2R z <= solid_volume (sizes_of_all S) * (1 + Q2R e)
  | VolumeOfSolids v => Q2R v <= solid_volume (sizes_of_all S)
  | Law _ _ | SizesIn _ | FactorsOfFile | OfMaterials _ | OpeningsTimes _ => True
  | _ => False
  end.

Definition mixed_matches (s : statement) : Prop :=
  (if is_exact s then mixture_describes_accurately d f ms S else mixture_describes d ms S /\ S <> []) /\
  (or_more s <= Z.of_nat (length S))%Z /\
  forall p, In p (parts s) -> mixed_demands p.
End Meaning.

(* The claim of the line. M is the gradation of the file with the openings as the line says. *)
Definition mixed_claim_holds (f : R -> R) (M : mixture) (s : statement) : Prop :=
  let such S := mixed_matches f M S s in
  let none_below n := forall S, such S -> (n <= Z.of_nat (length S))%Z in
  let one_of n := exists S, such S /\ Z.of_nat (length S) = n in
  match claim_of s with
  | Smallest N => one_of N /\ none_below N
  | Between B N => one_of N /\ none_below B
  | NoneBelow B => none_below B
  | NoMatch => forall S, ~ such S
  end.

(* Unit, factors and materials are what the line says, and no others. *)
Definition as_mixture_says (R : mixed_reading) (s : statement) : Prop :=
  unit_of s = mixed_sizes R /\ filter is_of_file (parts s) = mixed_parts R.

(* The statement is true of a gradation of several materials that is read, for masses by the law in the line. *)
Definition true_of_several (R : mixed_reading) (s : statement) : Prop :=
  exists M a b, as_mixture_says R s /\ with_size_factor (factor_in (parts s)) (reduced_mixture (mixture_of R)) = Ok M /\
    law_in (parts s) = Some (a, b) /\ (1 <= a)%Z /\ (1 <= b)%Z /\
    forall f, power_law (Z.to_nat a) (Z.to_nat b) f -> mixed_claim_holds f M s.

(* ---- The parts are the question ---------------------------------------------------------------------- *)

Lemma mixed_parts_of_file R p : In p (mixed_parts R) -> is_of_file p = true.
Proof.
  unfold mixed_parts. rewrite !in_app_iff, in_if_true. intros [[<-|[]]|[(_ & ->)|[<-|[]]]]; reflexivity.
Qed.

(* The tolerance says nothing of what passes. *)
Definition of_retained (t : tolerances) : Prop :=
  retained_file t = false /\ passing_file t = false /\ passing_all t = None /\ passing_each t = [] /\ band t = [].

Lemma shares_of_retained t ms ss : mixture_shares t ms = Ok ss -> of_retained t.
Proof.
  unfold mixture_shares. intro H. passed H. passed H. unfold of_retained.
  destruct (retained_file t), (passing_file t); try discriminate. destruct (passing_all t), (passing_each t), (band t); try discriminate. auto 10.
Qed.

(* Solids are of all particles. *)
Lemma mixed_solids f M S D : agrees D [] = true ->
  (forall p, In p (solid_parts (solids_of (asked (certificate_of D))) (box_of D)) -> mixed_demands f M S p) <->
  has_solids (solids_of (asked (certificate_of D))) (sizes_of_all S).
Proof.
  intro A. pose (R := Reading (Gradation [] 1 false) Millimetres false false None None).
  rewrite <- (solid_parts_meant f D R (Gradation [] 1 false) (sizes_of_all S) [] A).
  assert (forall p, In p (solid_parts (solids_of (asked (certificate_of D))) (box_of D)) ->
    (mixed_demands f M S p <-> demands f (Gradation [] 1 false) (size_factor (asked (certificate_of D))) (sizes_in R) [] (sizes_of_all S) p)) as Same.
  { intros p I. unfold solid_parts in I. destruct (solids_of (asked (certificate_of D))); [destruct I| |];
      [|destruct (box_of D) as [(((?, ?), ?), ?)|]]; destruct I as [<-|[]]; reflexivity. }
  split; intros H p I; apply (Same p I), H, I.
Qed.

Section Judged.
Variables (R : mixed_reading) (D : document) (name : string).
Let q := asked (certificate_of D).
Let s := statement_of_mixture name R D.
Hypothesis agreed : agrees D [] = true.
Hypothesis no_band_file : band_of_file D = false.
Hypothesis no_cut : pan_size q = None /\ cut_below q = None.
Hypothesis retained_only : forall t, tolerances_of q = Some t -> of_retained t.

(* Of samples the parts demand what the question does. *)
Lemma mixed_matches_allowed f M S :
  mixed_matches f M S s <-> mixture_allowed (root_of_mixture M) f (materials M) S q.
Proof.
  pose proof (mixed_solids f M S D agreed) as Solid. fold q in Solid. destruct no_cut as (Pan & Cut).
  assert ((forall p, In p (parts s) -> mixed_demands f M S p) <->
    (forall t, tolerances_of q = Some t ->
      (forall e, retained_each t = Some e -> mixed_within (root_of_mixture M) f (materials M) S e) /\
      (forall e, Certificate.total t = Some e -> mixed_errors (root_of_mixture M) f (materials M) S <= Q2R e / 100)) /\
    enough_in_each_class (root_of_mixture M) (materials M) S (min_per_class q) /\
    has_solids (solids_of q) (sizes_of_all S)) as P.
  { rewrite <- Solid. unfold s, statement_of_mixture, statement_with, parts_with. cbn [parts]. fold q. rewrite Pan, Cut.
    assert (forall t, tolerances_of q = Some t -> tolerance_parts (mixed_sizes R) (Gradation [] 1 false) q t (band_of_file D) =
      if_some (retained_each t) RetainedWithin ++ if_some (Certificate.total t) TotalWithin) as Tol.
    { intros t T. destruct (retained_only t T) as (E1 & E2 & E3 & E4 & E5). unfold tolerance_parts. rewrite E1, E2, E3, E4, E5, no_band_file.
      cbn. rewrite app_nil_r. reflexivity. }
    split.
    - intro H. split; [|split].
      + intros t T. rewrite T, (Tol t T) in H. split; intros e E; rewrite E in H.
        * apply (H (RetainedWithin e)). apply in_or_app. left. apply in_or_app. left. left. reflexivity.
        * apply (H (TotalWithin e)). apply in_or_app. left. apply in_or_app. right. left. reflexivity.
      + destruct (Z.leb_spec 1 (min_per_class q)) as [L|L].
        * apply (H (AtLeastInEachClass (min_per_class q))).
          do 6 (apply in_or_app; right). apply in_or_app. left. left. reflexivity.
        * intros n rs I j J Mj. unfold Spec.number. lia.
      + intros p I. apply H. do 7 (apply in_or_app; right). exact I.
    - intros (H1 & H2 & H3) p. rewrite !in_app_iff. intros [I|[[<-|[]]|[I|[[]|[[]|[I|[I|I]]]]]]]; try exact Logic.I.
      + destruct (tolerances_of q) as [t|]; [|destruct I]. rewrite (Tol t eq_refl), in_app_iff, !in_if_some in I. destruct (H1 t eq_refl) as (Ha & Hb).
        destruct I as [(e & E & ->)|(e & E & ->)]; [exact (Ha e E) | exact (Hb e E)].
      + apply mixed_parts_of_file in I as F. unfold mixed_parts in I. rewrite !in_app_iff, in_if_true in I.
        destruct I as [[<-|[]]|[(_ & ->)|[<-|[]]]]; exact Logic.I.
      + apply in_if_some in I as (k & _ & ->). exact Logic.I.
      + apply in_if_true in I as (_ & ->). exact H2.
      + exact (H3 p I). }
  unfold mixed_matches, mixture_allowed, mixture_has_enough, mixture_describes_within. rewrite P.
  change (is_exact s) with (match tolerances_of q with Some _ => false | None => true end). change (or_more s) with (at_least q).
  destruct (tolerances_of q) as [t|].
  - split.
    + intros ((B & N) & L & H1 & H2 & H3). destruct (H1 t eq_refl). tauto.
    + intros ((B & N & Ha & Hb) & H2 & H3 & L). split; [tauto|]. split; [exact L|]. split; [|tauto]. intros t' [= <-]. auto.
  - split; [intros (B & L & _ & H2 & H3); tauto|]. intros (B & H2 & H3 & L). split; [exact B|]. split; [exact L|]. split; [discriminate | tauto].
Qed.
End Judged.

Lemma check_mixed_document_ok R w D : check_mixed_document R w = Ok D ->
  agrees D [] = true /\ band_of_file D = false /\ check_mixture (mixture_of R) (certificate_of D) = Ok tt.
Proof.
  unfold check_mixed_document. intro H. passed H. rename x into D0. passed H. passed H. destruct x. injection H as <-.
  apply read_document_ok in H0. apply negb_true_iff in H1. split; [|auto]. unfold agrees in *. apply andb_prop in H0 as (A & _).
  rewrite A, H1. reflexivity.
Qed.

Theorem checked_mixed_statement_true name R w s : check_mixed_statement name R w = Ok s -> true_of_several R s /\ plain_statement s = true.
Proof.
  unfold check_mixed_statement. intro H. passed H. rename x into D. cbv zeta in H. passed H. injection H as <-. split; [|exact H1].
  apply check_mixed_document_ok in H0 as (A & NoBand & C). set (q := asked (certificate_of D)).
  destruct (asked_said (mixed_sizes R) (Gradation [] 1 false) (mixed_parts R) D (mixed_parts_of_file R)) as (L & _ & _ & F). fold q in L, F.
  pose proof C as C'. unfold check_mixture in C'. cbv zeta in C'. passed C'. passed C'. passed C'.
  match goal with E : asked_mixture _ _ = Ok _ |- _ => rename E into As end.
  match goal with E : well_formed_mixture _ && sensible _ = true |- _ => apply andb_prop in E as (_ & Sen) end.
  pose proof As as As'. unfold asked_mixture in As'. cbv zeta in As'. passed As'. passed As'. passed As'. injection As' as As'. subst.
  match goal with E : with_size_factor _ _ = Ok _ |- _ => rename E into Size end. rename x into M.
  assert (pan_size q = None /\ cut_below q = None) as NoCut.
  { match goal with E : match pan_size _ with _ => _ end = true |- _ => revert E end. fold q.
    destruct (pan_size q), (cut_below q); intro; try discriminate; auto. }
  assert (forall t, tolerances_of q = Some t -> of_retained t) as Only.
  { intros t T. unfold q in T. rewrite T in C'. destruct (proof_of (certificate_of D)); [discriminate|]. passed C'.
    match goal with E : mixture_shares _ _ = Ok _ |- _ => exact (shares_of_retained _ _ _ E) end. }
  exists M, (a q), (b q). split; [split; [reflexivity | exact (of_file_said _ _ _ D (mixed_parts_of_file R))]|].
  change (parts (statement_of_mixture name R D)) with (parts_with (mixed_sizes R) (Gradation [] 1 false) (mixed_parts R) D).
  rewrite F. split; [exact Size|]. split; [exact L|].
  unfold sensible in Sen. cbv zeta in Sen. rewrite !andb_true_iff, !Z.leb_le in Sen. split; [apply Sen|]. split; [apply Sen|].
  intros f Power. destruct (mixture_true _ _ f C Power) as (M' & E & T). rewrite As in E. injection E as <-.
  pose proof (mixed_matches_allowed R D name A NoBand NoCut Only f M) as Same. fold q in Same.
  unfold mixture_claim_true in T. unfold mixed_claim_holds. cbn [statement_of_mixture statement_with claim_of]. fold q in T.
  destruct (claimed (certificate_of D)) as [N|B N|B|].
  - destruct T as ((S & SA & SN & _) & Least & _).
    split; [exists S; split; [apply Same, SA | exact SN] | intros S' H; apply Least, Same, H].
  - destruct T as ((S & SA & SN & _) & Least). split; [exists S; split; [apply Same, SA | exact SN] | intros S' H; apply Least, Same, H].
  - intros S H. apply T, Same, H.
  - intros S H. apply (T S), Same, H.
Qed.
