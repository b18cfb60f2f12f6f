(* An accepted certificate of a gradation of several materials proves its claim (Theorem 28). *)

From Coq Require Import ZArith QArith Reals Qreals String List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Exact Tolerant Mixture Spec MixtureSpec Openings
  Reduction RealFacts Sizes Contents ExactSound Solids ExactTheorem Shares TolerantSound TolerantTheorem MixtureContents Theorems.
Import ListNotations.
Open Scope list_scope.
Open Scope R_scope.

(* ---- Lines of the witness ------------------------------------------------------------------------ *)

(* The classes of all materials in the order in which certificates count them, each with its material. The last row of a material
   but the last is counted too: it begins no class, and has no particles. *)
Definition counted_classes (ms : list (string * list row)) : list (option (string * class)) :=
  interleaved (fun m => map (fun j => Some (fst m, j)) (classes (snd m))) (fun _ => None) ms.

(* What a line of the witness says of a sample. *)
Definition mixed_line_true (d : positive) (ms : list (string * list row)) (S : mixed_sample) (w : witness_line) : Prop :=
  match nth_error (counted_classes ms) (Z.to_nat (index w - 1)) with
  | Some (Some (name, j)) =>
    number d j (of_material name S) = count w /\
    forall x, In x (of_material name S) -> in_class d j x -> Q2R (size_lo w) <= x <= Q2R (size_hi w)
  | Some None => count w = 0%Z
  | None => False
  end.

(* ---- Back from all classes to those of each material --------------------------------------------- *)

Lemma both_app {A B} (P : A -> B -> Prop) l : forall l' m m', length l = length m ->
  Forall2 P (l ++ l') (m ++ m') -> Forall2 P l m /\ Forall2 P l' m'.
Proof.
  induction l as [|x l IH]; intros l' [|y m] m' E H; try discriminate E; [auto|].
  inversion H as [|? ? ? ? H1 H2]; subst. injection E as E. destruct (IH _ _ _ E H2). auto.
Qed.

Lemma interleaved_split {A A' B} (P : A -> A' -> Prop) (each : B -> list A) each' between between' ms :
  (forall m, In m ms -> length (each m) = length (each' m)) ->
  Forall2 P (interleaved each between ms) (interleaved each' between' ms) -> forall m, In m ms -> Forall2 P (each m) (each' m).
Proof.
  induction ms as [|m [|n ms] IH]; intros L H k I; [destruct I | destruct I as [<-|[]]; exact H|].
  rewrite !interleaved_cons in H. apply both_app in H as (H1 & H2); [|apply L; left; reflexivity].
  inversion H2 as [|? ? ? ? _ H3]; subst. destruct I as [<-|I]; [exact H1|]. apply IH; trivial. intros; apply L; right; assumption.
Qed.

Lemma of_class {A} (P : class -> A -> Prop) (g : class -> A) l : Forall2 P l (map g l) -> forall j, In j l -> P j (g j).
Proof. induction l as [|i l IH]; intros H j J; [destruct J|]. inversion H; subst. destruct J as [<-|J]; auto. Qed.

Lemma all_of_class {A} (P : class -> A -> Prop) (g : class -> A) l : (forall j, In j l -> P j (g j)) -> Forall2 P l (map g l).
Proof. induction l as [|i l IH]; intro H; constructor; [apply H; left; reflexivity | apply IH; intros; apply H; right; assumption]. Qed.

Lemma has_solids_cubes s S : has_solids s S <-> has_cubes s (total (map sphere S)).
Proof. destruct s; reflexivity. Qed.

Section Materials.
Variables (q : question) (d : positive) (ms : list (string * list row)).
Hypothesis names_unique : NoDup (map fst ms).
Hypothesis all_proper : forall name rs, In (name, rs) ms -> proper_rows rs /\ some_mass_in rs.
Hypothesis some_material : ms <> [].
Hypothesis solids_law : solids_of q = Anything \/ a q = 3%Z /\ b q = 1%Z.
Variable law : R -> R.
Hypothesis power : power_law (Z.to_nat (a q)) (Z.to_nat (b q)) law.

Notation places := (places_of ms).
Notation js := (map fst places).
Notation held_in S := (mixed_contents (d := d) ms law S).

Lemma classes_apart : js = interleaved (fun m => classes (snd m)) (fun m => fst (nothing_behind (last_row (snd m)))) ms.
Proof. unfold places_of. rewrite interleaved_map. apply interleaved_ext. intros m _. rewrite all_begin_classes. auto. Qed.

(* What holds of each class with its count and mass. *)
Lemma of_each_class (P : class -> Z * R -> Prop) S : Forall2 P js (held_in S) ->
  forall name rs j, In (name, rs) ms -> In j (classes rs) -> P j (number d j (of_material name S), held d law j (of_material name S)).
Proof.
  rewrite classes_apart. intros H name rs j I J. unfold mixed_contents in H.
  refine (of_class P _ _ (interleaved_split P _ _ _ _ ms _ H (name, rs) I) j J). intros m _. unfold contents_of. rewrite map_length. reflexivity.
Qed.

Lemma of_all_classes (P : class -> Z * R -> Prop) S : (forall r, P (fst (nothing_behind r)) (0%Z, 0)) ->
  (forall name rs j, In (name, rs) ms -> In j (classes rs) -> P j (number d j (of_material name S), held d law j (of_material name S))) ->
  Forall2 P js (held_in S).
Proof.
  intros N H. rewrite classes_apart. apply interleaved_both. intros (name, rs) I. split; [|apply N].
  apply (all_of_class P (fun j => (number d j (of_material name S), held d law j (of_material name S)))). intros j J. exact (H name rs j I J).
Qed.

(* Counts of all classes, compared one by one. *)
Lemma counts_of_each S T : Forall2 Z.le (map fst (held_in S)) (map fst (held_in T)) ->
  each ms (fun name rs => forall j, In j (classes rs) -> (number d j (of_material name S) <= number d j (of_material name T))%Z).
Proof.
  unfold mixed_contents. rewrite !interleaved_map. intros H name rs I.
  apply (counts_le (fun j => number d j (of_material name S)) (fun j => number d j (of_material name T))).
  rewrite <- !(counts_of_contents law). refine (interleaved_split Z.le _ _ _ _ ms _ H (name, rs) I).
  intros m _. unfold contents_of. rewrite !map_length. reflexivity.
Qed.

Lemma articulate S : mixture_describes d ms S -> one_size_each (d := d) ms S -> mixture_describes_articulately d ms S.
Proof.
  intros (I & D) O. split; [exact I|]. intros name rs Im. destruct (all_proper name rs Im) as (P & _).
  apply one_size_articulate; [exact P | exact (D name rs Im) | exact (O name rs Im)].
Qed.

Lemma mixed_line_of_sample S w : mixture_describes d ms S -> one_size_each (d := d) ms S ->
  line_fits (Z.to_nat (a q)) (Z.to_nat (b q)) js (held_in S) w -> mixed_line_true d ms S w.
Proof.
  intros (_ & D) O (j & t & J & C & Fits).
  set (l := interleaved
    (fun m => let T := of_material (fst m) S in
      map (fun j => (Some (fst m, j), (j, (number d j T, held d law j T)))) (classes (snd m)))
    (fun m => (None, (fst (nothing_behind (last_row (snd m))), (0%Z, 0)))) ms).
  assert (counted_classes ms = map fst l) as El.
  { unfold l, counted_classes. rewrite interleaved_map. apply interleaved_ext. intros m _. cbv zeta. rewrite map_map. auto. }
  assert (js = map (fun p => fst (snd p)) l) as Ej.
  { unfold l. rewrite classes_apart, interleaved_map. apply interleaved_ext. intros m _. cbv zeta. rewrite map_map.
    cbn [fst snd]. rewrite map_id. auto. }
  assert (held_in S = map (fun p => snd (snd p)) l) as Eh.
  { unfold l, mixed_contents. rewrite interleaved_map. apply interleaved_ext. intros m _. cbv zeta. rewrite map_map. auto. }
  assert (Forall (fun p => match fst p with
    | Some (name, j) => exists rs, In (name, rs) ms /\ In j (classes rs) /\
        snd p = (j, (number d j (of_material name S), held d law j (of_material name S)))
    | None => snd (snd p) = (0%Z, 0)
    end) l) as Each.
  { apply interleaved_all. intros (name, rs) I. split; [|reflexivity]. apply Forall_forall. cbv zeta. intros p P.
    apply in_map_iff in P as (i & <- & P). cbn [fst snd]. eauto. }
  rewrite Ej, nth_error_map in J. rewrite Eh, nth_error_map in C. unfold mixed_line_true. rewrite El, nth_error_map.
  destruct (nth_error l (Z.to_nat (index w - 1))) as [(o, (i, qt))|] eqn:N; [|discriminate J]. cbn [option_map fst snd] in *.
  injection J as ->. injection C as ->. rewrite Forall_forall in Each. specialize (Each _ (nth_error_In _ _ N)). cbn [fst snd] in Each.
  destruct o as [(name, i)|]; [|injection Each as -> _; reflexivity]. destruct Each as (rs & I & Ji & Same). injection Same as <- Cn Ht.
  split; [congruence|]. intros x X Jx. destruct (all_proper name rs I) as (W & _).
  pose proof (proper_classes rs W) as Pj. rewrite Forall_forall in Pj. destruct (proper_sizes (d := d) j (Pj j Ji)) as (L & _).
  destruct (size_of_class _ _ law rs _ j x power W (D name rs I) (O name rs I) Ji X Jx) as (E & _). rewrite <- Cn, <- Ht in E.
  apply Fits; [|exact E]. unfold in_class in Jx. lra.
Qed.

Lemma cubes_of_mixture S : mixture_describes d ms S -> solids_of q <> Anything -> total (map sphere (sizes_of_all S)) =
  over_materials ms (fun name rs => total (map (fun j => held d law j (of_material name S) / Q2R (c j)) (classes rs))).
Proof.
  intros (I & D) Ne. destruct solids_law as [E|(A3 & B1)]; [congruence|].
  assert (power_law 3 1 law) as P31 by (rewrite A3, B1 in power; exact power).
  unfold sizes_of_all. rewrite (total_by_material sphere (map fst ms) S names_unique I), map_map. unfold over_materials. f_equal.
  apply map_ext_in. intros (name, rs) Im. cbn [fst snd]. destruct (all_proper name rs Im) as (P & _).
  exact (cubes_by_class law rs _ P31 P (D name rs Im)).
Qed.

Lemma solids_of_mixture S C : mixture_describes d ms S ->
  (solids_of q <> Anything -> C = over_materials ms (fun name rs => total (map (fun j => held d law j (of_material name S) / Q2R (c j)) (classes rs)))) ->
  (has_solids (solids_of q) (sizes_of_all S) <-> has_cubes (solids_of q) C).
Proof.
  intros D H. assert (solids_of q = Anything \/ solids_of q <> Anything) as [E|E]
    by (destruct (solids_of q); [left; reflexivity | right; congruence | right; congruence]).
  - rewrite E. reflexivity.
  - rewrite has_solids_cubes, (cubes_of_mixture S D E), (H E). reflexivity.
Qed.

Lemma enough_real least S : enough_in_each_class d ms S least <->
  forall name rs j, In (name, rs) ms -> In j (classes rs) -> 0 < Q2R (mass j) -> (least <= number d j (of_material name S))%Z.
Proof.
  split; intros H name rs.
  - intros j I J M. apply (H name rs I j J). apply Rlt_Qlt. rewrite Q2R_0. exact M.
  - intros I j J M. apply (H name rs j I J). apply Qlt_Rlt in M. rewrite Q2R_0 in M. exact M.
Qed.

(* ---- Exact matches ------------------------------------------------------------------------------- *)

Section Exactly.
Hypothesis exact : tolerances_of q = None.

Lemma cubes_at s : s * unit_cubes js = over_materials ms (fun _ rs => total (map (fun j => s * Q2R (mass j) / Q2R (c j)) (classes rs))).
Proof.
  unfold unit_cubes. rewrite <- total_scal, <- (total_of_places ms (fun j => s * Q2R (mass j) / Q2R (c j))).
  - apply total_ext. intros j _. unfold Rdiv. ring.
  - intro r. cbn [nothing_behind fst mass]. rewrite Q2R_0. unfold Rdiv. ring.
Qed.

Lemma cubes_agree s S : (forall name rs j, In (name, rs) ms -> In j (classes rs) -> held d law j (of_material name S) = s * Q2R (mass j)) ->
  s * unit_cubes js = over_materials ms (fun name rs => total (map (fun j => held d law j (of_material name S) / Q2R (c j)) (classes rs))).
Proof.
  intro H. rewrite cubes_at. unfold over_materials. f_equal. apply map_ext_in. intros (name, rs) I. cbn [fst snd]. apply total_ext.
  intros j J. rewrite (H name rs j I J). reflexivity.
Qed.

Lemma match_of_mixed S : mixture_allowed d law ms S q ->
  (exists s, match_at law q d js s (map fst (held_in S))) /\ Z.of_nat (length S) = sum (map fst (held_in S)).
Proof.
  unfold mixture_allowed. rewrite exact. intros ((I & s & Sp & A) & Fl & V & Le).
  assert (mixture_describes d ms S) as D by (split; [exact I|]; intros name rs Im; apply (A name rs Im)).
  assert (forall name rs j, In (name, rs) ms -> In j (classes rs) -> held d law j (of_material name S) = s * Q2R (mass j)) as H.
  { intros name rs j Im. apply (A name rs Im). }
  pose proof (mixed_number ms names_unique all_proper law S D) as N. split; [|symmetry; exact N]. exists s. constructor.
  - exact Sp.
  - assert (Forall2 (fun j qt => realizes d law j (fst qt) (s * Q2R (mass j)) /\ (0 < Q2R (mass j) -> (min_per_class q <= fst qt)%Z)) js (held_in S)) as F.
    { apply (of_all_classes (fun j qt => realizes d law j (fst qt) (s * Q2R (mass j)) /\ (0 < Q2R (mass j) -> (min_per_class q <= fst qt)%Z))).
      - intro r. cbn [nothing_behind fst mass]. rewrite Q2R_0. split; [left; split; [reflexivity | ring] | lra].
      - intros name rs j Im J. destruct (all_proper name rs Im) as (P & _). pose proof (proper_classes rs P) as Pj. rewrite Forall_forall in Pj.
        cbn [fst]. split; [rewrite <- (H name rs j Im J); apply sample_realizes; [apply power | auto]|].
        intro M. apply (proj1 (enough_real _ S) Fl name rs j Im J M). }
    revert F. generalize (held_in S). intros qts F. induction F; constructor; assumption.
  - apply (solids_of_mixture S _ D); [intros _; apply cubes_agree, H | exact V].
  - rewrite N. exact Le.
Qed.

Lemma mixed_of_match s ns : match_at law q d js s ns ->
  exists S, mixture_allowed d law ms S q /\ Z.of_nat (length S) = sum ns /\ mixture_describes d ms S /\ one_size_each (d := d) ms S /\
    held_in S = contents_at s js ns.
Proof.
  intros [Sp F V M]. pose proof (places_proper ms all_proper) as Pp.
  assert (Forall (fun p => snd p = false -> Q2R (mass (fst p)) = 0) places) as No.
  { apply interleaved_all. intros m _. split; [|intros _; apply Q2R_0]. apply Forall_forall. intros p I. unfold all_begin in I.
    apply in_map_iff in I as (j & <- & _). discriminate. }
  assert (Forall2 (fun p qt => realizes_there d law p (fst qt) (snd qt)) places (contents_at s js ns)) as Rz.
  { unfold contents_at. clear V M. revert ns F Pp No. generalize places. intro l. induction l as [|p l IH]; intros [|n ns] F Pp No; inversion F as [|? ? ? ? (F1 & _) F2]; subst;
      [constructor|]. inversion Pp as [|? ? P1 P2]; subst. inversion No as [|? ? N1 N2]; subst. cbn [map combine]. constructor; [|exact (IH ns F2 P2 N2)].
    cbn [fst snd]. unfold realizes_there. destruct (snd p); [exact F1|]. rewrite (N1 eq_refl), Rmult_0_r in *.
    destruct F1 as [F1|(Q1 & B1 & _)]; [exact F1|]. exfalso. destruct (proper_sizes (d := d) _ P1) as (L & _). destruct P1 as (_ & C & _).
    apply (IZR_le 1) in Q1. pose proof (law_nonneg law (proj1 power) _ L).
    assert (0 <= IZR n * (Q2R (c (fst p)) * law (lower_size d (fst p)))) by (apply Rmult_le_pos; [|apply Rmult_le_pos]; lra). lra. }
  destruct (mixed_sample_with (d := d) ms names_unique all_proper law (proj1 power) _ Rz) as (S & D & O & C).
  pose proof (mixed_number ms names_unique all_proper law S D) as N.
  assert (sum (map fst (contents_at s js ns)) = sum ns) as Sn.
  { unfold contents_at. rewrite map_map. f_equal. clear -F. induction F as [|j n l ns _ _ IH]; [reflexivity|]. cbn [combine map fst]. rewrite IH. reflexivity. }
  assert (Forall2 (fun j qt => snd qt = s * Q2R (mass j) /\ (0 < Q2R (mass j) -> (min_per_class q <= fst qt)%Z)) js (held_in S)) as E.
  { rewrite C. unfold contents_at. clear -F. induction F as [|j n l ns (_ & F) _ IH]; constructor; [split; [reflexivity | exact F] | exact IH]. }
  pose proof (of_each_class _ S E) as Each. cbv beta in Each. cbn [fst snd] in Each.
  exists S. split; [|split; [rewrite <- N, C; exact Sn | split; [exact D | split; [exact O | exact C]]]].
  unfold mixture_allowed. rewrite exact. split; [|split; [|split]].
  - destruct D as (I & D). split; [exact I|]. exists s. split; [exact Sp|]. intros name rs Im. split; [exact (D name rs Im)|].
    intros j J. apply (Each name rs j Im J).
  - apply enough_real. intros name rs j Im J. apply (Each name rs j Im J).
  - apply (solids_of_mixture S (s * unit_cubes js) D); [intros _; apply cubes_agree; intros name rs j Im J; apply (Each name rs j Im J) | exact V].
  - rewrite <- N, C, Sn. exact M.
Qed.

End Exactly.

(* ---- Matches within a tolerance ------------------------------------------------------------------ *)

Section Within.
Variables (tol : tolerances) (ss : list share).
Hypothesis tolerant : tolerances_of q = Some tol.
Hypothesis shared : mixture_shares tol ms = Ok ss.
Notation all := (fold_left add (map retained (all_rows ms)) 0%Q).

Lemma shares_there : ss = map (share_there tol all) places.
Proof. pose proof shared as H. unfold mixture_shares in H. passed H. passed H. injection H as <-. reflexivity. Qed.

Lemma all_is : Q2R all = mass_of_classes js /\ 0 < Q2R all.
Proof.
  rewrite (sum_of_all_rows ms all_proper). split; [reflexivity|].
  apply (all_positive places (places_proper ms all_proper) (mass_in_places ms names_unique all_proper some_material)).
Qed.

Lemma mixture_targets : Forall2 (has_target js) js ss.
Proof.
  rewrite shares_there. destruct all_is as (E & P). unfold has_target. rewrite <- E. generalize places. intro l. induction l as [|p l IH]; constructor; [|exact IH].
  cbn [share_there g_j]. apply Q2R_over. lra.
Qed.

Lemma mixture_nothing : Forall2 nothing_where_none places ss.
Proof.
  rewrite shares_there. generalize places. intro l. induction l as [|p l IH]; constructor; [|exact IH].
  intro B. unfold share_there. rewrite B. cbn [retained_in narrow hi]. unfold smaller.
  destruct (less 0 _) eqn:E; [rewrite Q2R_0; lra|]. apply less_real_false in E. rewrite Q2R_0 in E. exact E.
Qed.

(* Of a class alone. *)
Definition fits_there (M : R) (p : between_rows) (qt : Z * R) : Prop :=
  realizes_there d law p (fst qt) (snd qt) /\ (0 < Q2R (mass (fst p)) -> (min_per_class q <= fst qt)%Z) /\
  within_interval (retained_in (share_there tol all p)) (snd qt / M).

Lemma unit_share t M : 0 < M -> 0 <= t <= M -> within_interval any_share (t / M).
Proof. intros Mp T. apply any_share_within. apply ratio_unit; assumption. Qed.

Lemma fits_of_all M : 0 < M -> forall l qts P, 0 <= P -> Forall (fun qt => 0 <= snd qt) qts -> P + total (map snd qts) <= M ->
  Forall2 (fits_there M) l qts -> fits_from d law (min_per_class q) M P l (map (share_there tol all) l) qts.
Proof.
  intro Mp. induction l as [|p l IH]; intros qts P P0 T Le F; inversion F as [|? (n, t) ? qts' (F1 & F2 & F3) F4]; subst; [exact I|].
  inversion T as [|? ? T1 T2]; subst. cbn [map fits_from fst snd] in *. rewrite total_cons in Le.
  assert (0 <= total (map snd qts')) as Rest.
  { apply total_nonneg. intros x X. rewrite Forall_forall in T2. exact (T2 x X). }
  split; [exact F1|]. split; [exact F2|]. split; [exact F3|]. split; [apply unit_share; lra|]. apply IH; trivial; lra.
Qed.

Lemma all_of_fits M : forall l qts P, fits_from d law (min_per_class q) M P l (map (share_there tol all) l) qts -> Forall2 (fits_there M) l qts.
Proof.
  induction l as [|p l IH]; intros [|(n, t) qts] P F; try destruct F as []; constructor.
  - split; [assumption|]. split; apply H0.
  - destruct H0 as (_ & _ & _ & F). exact (IH _ _ F).
Qed.

Lemma retained_there M j t : within_interval (retained_in (share_there tol all (j, true))) (t / M) <->
  within_interval any_share (t / M) /\ forall e, retained_each tol = Some e -> near e (t / M) (Q2R (mass j) / mixture_mass ms).
Proof.
  destruct all_is as (E & P). unfold share_there. cbn [snd fst retained_in]. rewrite around_within.
  rewrite Q2R_over by lra. rewrite E, (mass_of_places ms). reflexivity.
Qed.

Lemma errors_of_mixture S : total (map (fun p => Rabs (snd (snd p) / mass_of_contents (held_in S) - Q2R (mass (fst p)) / mass_of_classes js))
    (combine js (held_in S))) = mixed_errors d law ms S.
Proof.
  rewrite (mixed_mass (d := d) ms law S), (mass_of_places ms). set (M := mass_of_mixture d law ms S). set (G := mixture_mass ms).
  refine (eq_trans (total_of_contents (d := d) ms law (fun j qt => Rabs (snd qt / M - Q2R (mass j) / G)) S _) _); [|reflexivity].
  intro r. cbn [nothing_behind fst snd mass]. rewrite Q2R_0. unfold Rdiv. rewrite !Rmult_0_l, Rminus_0_r. apply Rabs_R0.
Qed.

Lemma cubes_in_contents S : total (map (fun p => snd (snd p) / Q2R (c (fst p))) (combine js (held_in S))) =
  over_materials ms (fun name rs => total (map (fun j => held d law j (of_material name S) / Q2R (c j)) (classes rs))).
Proof.
  refine (eq_trans (total_of_contents (d := d) ms law (fun j qt => snd qt / Q2R (c j)) S _) _); [|reflexivity].
  intro r. cbn [snd]. unfold Rdiv. ring.
Qed.

Lemma contents_signs S : Forall (fun qt => 0 <= snd qt) (held_in S).
Proof.
  pose proof (mixed_realize (d := d) ms all_proper law (proj1 power) S) as Rz.
  pose proof (places_proper ms all_proper) as Pp. revert Rz Pp. generalize (held_in S). generalize places. intros l qts Rz Pp.
  induction Rz as [|p qt l qts H _ IH]; constructor; cbn [map] in Pp; inversion Pp as [|? ? P1 P2]; subst.
  - exact (proj2 (there_signs d law p (fst qt) (snd qt) (proj1 power) P1 H)).
  - exact (IH P2).
Qed.

Lemma share_of_contents S qt : 0 < mass_of_contents (held_in S) -> In qt (held_in S) -> within_interval any_share (snd qt / mass_of_contents (held_in S)).
Proof.
  intros Mp I. pose proof (contents_signs S) as T. rewrite Forall_forall in T. apply unit_share; [exact Mp|]. split; [exact (T qt I)|].
  exact (total_member (fun qt : Z * R => snd qt) (held_in S) qt T I).
Qed.

Lemma mass_of_some S : mixture_describes d ms S -> S <> [] -> 0 < mass_of_contents (held_in S).
Proof.
  intros D Ne. pose proof (mixed_number ms names_unique all_proper law S D) as N.
  assert (1 <= sum (map fst (held_in S)))%Z as One by (rewrite N; destruct S; [congruence | simpl length; lia]).
  apply some_positive in One as (qt & I & Q1). pose proof (contents_signs S) as T. rewrite Forall_forall in T.
  assert (0 < snd qt) as Tp.
  { pose proof (mixed_realize (d := d) ms all_proper law (proj1 power) S) as Rz. pose proof (places_proper ms all_proper) as Pp.
    clear -Rz I Q1 Pp power. revert Rz Pp I. generalize (held_in S). generalize places. intros l qts Rz Pp I.
    induction Rz as [|p qt' l qts H _ IH]; [destruct I|]. cbn [map] in Pp. inversion Pp as [|? ? P1 P2]; subst.
    destruct I as [->|I]; [|exact (IH P2 I)]. unfold realizes_there in H. destruct (snd p); [|destruct H; lia].
    destruct H as [(E & _)|(_ & B & _)]; [lia|]. destruct (proper_sizes (d := d) _ P1) as (L & _). destruct P1 as (_ & C & _).
    apply (IZR_le 1) in Q1. pose proof (law_nonneg law (proj1 power) _ L).
    assert (0 <= IZR (fst qt) * (Q2R (c (fst p)) * law (lower_size d (fst p)))) by (apply Rmult_le_pos; [|apply Rmult_le_pos]; lra). lra. }
  pose proof (total_member snd (held_in S) qt T I) as Le. unfold mass_of_contents. lra.
Qed.

Lemma within_of_mixed S : mixture_allowed d law ms S q ->
  within_at law q d tol places ss (held_in S) /\ Z.of_nat (length S) = sum (map fst (held_in S)).
Proof.
  unfold mixture_allowed. rewrite tolerant. intros ((D & Ne & Ret & Tot) & Fl & V & Le).
  pose proof (mixed_number ms names_unique all_proper law S D) as N. split; [|symmetry; exact N].
  pose proof (mass_of_some S D Ne) as Mp. pose proof (mixed_mass (d := d) ms law S) as Em.
  assert (forall e, retained_each tol = Some e -> 0 <= Q2R e) as Pe.
  { intros e E. destruct ms as [|(name, rs) l] eqn:Em2; [congruence|]. rewrite <- Em2 in *.
    assert (In (name, rs) ms) as I by (rewrite Em2; left; reflexivity). destruct (all_proper name rs I) as (_ & j & J & _).
    pose proof (Ret e E name rs I j J) as H. unfold near in H. pose proof (Rabs_pos (mixed_share d law ms S name j - mixed_target ms j)). lra. }
  constructor; rewrite ?N.
  - destruct S; [congruence | simpl length; lia].
  - exact Mp.
  - rewrite shares_there. apply fits_of_all; [exact Mp | lra | apply contents_signs | unfold mass_of_contents; lra|].
    set (M := mass_of_contents (held_in S)) in *. pose proof (mixed_realize (d := d) ms all_proper law (proj1 power) S) as Rz.
    apply interleaved_both. intros (name, rs) I. cbn [fst snd]. split.
    + unfold all_begin, contents_of. destruct (all_proper name rs I) as (P & _). pose proof (proper_classes rs P) as Pj. rewrite Forall_forall in Pj.
      assert (forall j, In j (classes rs) -> fits_there M (j, true) (number d j (of_material name S), held d law j (of_material name S))) as H.
      { intros j J. split; [apply sample_realizes; [apply power | auto]|]. split; [exact (proj1 (enough_real _ S) Fl name rs j I J)|].
        cbn [snd]. apply retained_there. split.
        - refine (share_of_contents S (number d j (of_material name S), held d law j (of_material name S)) Mp _).
          apply (interleaved_in _ _ ms (name, rs) _ I). cbn [fst snd]. unfold contents_of. apply in_map_iff. exists j. auto.
        - intros e E. rewrite Em. exact (Ret e E name rs I j J). }
      clear -H. induction (classes rs) as [|j l IH]; constructor; [apply H; left; reflexivity | apply IH; intros; apply H; right; assumption].
    + split; [split; reflexivity|]. split; [cbn [nothing_behind fst snd mass]; rewrite Q2R_0; lra|].
      change (within_interval (narrow (around (over 0 all) (retained_each tol) any_share) 0 0) (0 / M)).
      replace (0 / M) with 0 by (field; lra). rewrite narrow_within, around_within, any_share_within, Q2R_0.
      split; [|lra]. split; [lra|]. intros e E. destruct all_is as (_ & Ap). rewrite Q2R_over, Q2R_0 by lra. unfold near, Rdiv.
      rewrite Rmult_0_l, Rminus_0_r, Rabs_R0. pose proof (Pe e E). lra.
  - intros e E. rewrite errors_of_mixture. exact (Tot e E).
  - intros _. rewrite cubes_in_contents. apply (solids_of_mixture S _ D); [reflexivity | exact V].
  - exact Le.
Qed.

Lemma mixed_of_within qts : within_at law q d tol places ss qts ->
  exists S, mixture_allowed d law ms S q /\ Z.of_nat (length S) = sum (map fst qts) /\ mixture_describes d ms S /\
    one_size_each (d := d) ms S /\ held_in S = qts.
Proof.
  intros [One Mp Fi To So Le]. rewrite shares_there in Fi. apply all_of_fits in Fi.
  destruct (mixed_sample_with (d := d) ms names_unique all_proper law (proj1 power) qts) as (S & D & O & C).
  { clear -Fi. induction Fi as [|p qt l rest (H & _) _ IH]; constructor; assumption. }
  subst qts. pose proof (mixed_number ms names_unique all_proper law S D) as N. rewrite N in *.
  assert (forall name rs j, In (name, rs) ms -> In j (classes rs) ->
    fits_there (mass_of_contents (held_in S)) (j, true) (number d j (of_material name S), held d law j (of_material name S))) as Each.
  { intros name rs j I J. assert (Forall2 (fits_there (mass_of_contents (held_in S))) (all_begin (classes rs)) (contents_of d law (classes rs) (of_material name S))) as F.
    { refine (interleaved_split (fits_there (mass_of_contents (held_in S))) _ _ _ _ ms _ Fi (name, rs) I). intros m _. unfold all_begin, contents_of. rewrite !map_length. reflexivity. }
    unfold all_begin, contents_of in F. revert F J. generalize (classes rs). intros l F J. induction l as [|i l IH]; [destruct J|].
    inversion F as [|? ? ? ? F1 F2]; subst. destruct J as [<-|J]; [exact F1 | exact (IH F2 J)]. }
  exists S. split; [|split; [reflexivity | split; [exact D | split; [exact O | reflexivity]]]].
  unfold mixture_allowed. rewrite tolerant. split; [|split; [|split]].
  - split; [exact D|]. split; [intros ->; simpl in One; lia|]. split.
    + intros e E name rs I j J. destruct (Each name rs j I J) as (_ & _ & W). cbn [snd] in W. apply retained_there in W as (_ & W).
      specialize (W e E). rewrite (mixed_mass (d := d) ms law S) in W. exact W.
    + intros e E. rewrite <- errors_of_mixture. exact (To e E).
  - apply enough_real. intros name rs j I J. destruct (Each name rs j I J) as (_ & Fl & _). exact Fl.
  - apply (solids_of_mixture S (over_materials ms (fun name rs => total (map (fun j => held d law j (of_material name S) / Q2R (c j)) (classes rs)))) D); [reflexivity|].
    rewrite <- cubes_in_contents. destruct (solids_of q) eqn:Es; [exact I | apply So; discriminate | apply So; discriminate].
  - exact Le.
Qed.

End Within.
End Materials.

(* ---- An accepted certificate --------------------------------------------------------------------- *)

Definition root_of_mixture (M : mixture) : positive := Z.to_pos (mixture_root M).

Lemma well_formed_materials M : well_formed_mixture M = true ->
  NoDup (map fst (materials M)) /\ (forall name rs, In (name, rs) (materials M) -> proper_rows rs /\ some_mass_in rs) /\
  materials M <> [] /\ mixture_root M = Zpos (root_of_mixture M).
Proof.
  unfold well_formed_mixture. rewrite !andb_true_iff. intros ((W & A) & N). rewrite forallb_forall in W.
  split; [exact (names_differ _ A)|]. split; [|split].
  - intros name rs I. exact (well_formed_proper _ (W (name, rs) I)).
  - intro E. rewrite E in N. discriminate.
  - destruct (materials M) as [|(name, rs) l]; [discriminate|]. exact (well_formed_root _ (W (name, rs) (or_introl eq_refl))).
Qed.

(* S has the witness's number of particles; one size a class (Cond3 of each material); and in each class that the witness names
   the number and the size that its line says. *)
Definition is_mixed_witness (f : R -> R) (cert : certificate) (M : mixture) (N : Z) (S : mixed_sample) : Prop :=
  let d := root_of_mixture M in
  mixture_allowed d f (materials M) S (asked cert) /\ Z.of_nat (length S) = N /\
  mixture_describes_articulately d (materials M) S /\ Forall (mixed_line_true d (materials M) S) (witness cert).

(* No sample that the question allows has fewer particles than S in any class; and one with as many particles has as
   many in every class. *)
Definition least_in_classes_of_all (f : R -> R) (q : question) (M : mixture) (S : mixed_sample) : Prop :=
  let d := root_of_mixture M in
  forall T, mixture_allowed d f (materials M) T q ->
    each (materials M) (fun name rs => forall j, In j (classes rs) ->
      (number d j (of_material name S) <= number d j (of_material name T))%Z /\
      (length T = length S -> number d j (of_material name T) = number d j (of_material name S))).

(* With the question's law, factors, floors, solids, tolerance and least number of particles. *)
Definition mixture_claim_true (f : R -> R) (cert : certificate) (M : mixture) : Prop :=
  let d := root_of_mixture M in
  let such S := mixture_allowed d f (materials M) S (asked cert) in
  let none_below n := forall S, such S -> (n <= Z.of_nat (length S))%Z in
  let attained n := exists S, is_mixed_witness f cert M n S in
  match claimed cert with
  | Smallest N =>
    attained N /\ none_below N /\
    (tolerances_of (asked cert) = None -> (at_least (asked cert) < N)%Z ->
     forall S, such S -> Z.of_nat (length S) = N -> least_in_classes_of_all f (asked cert) M S)
  | Between B N => attained N /\ none_below B
  | NoneBelow B => none_below B
  | NoMatch => forall S, ~ such S
  end.

Lemma claim_from_bounds f cert M :
  let such S := mixture_allowed (root_of_mixture M) f (materials M) S (asked cert) in
  (forall B, bound_of (claimed cert) = Some B -> forall S, such S -> (B <= Z.of_nat (length S))%Z) ->
  (forall N, found (claimed cert) = Some N -> exists S, is_mixed_witness f cert M N S) ->
  (claimed cert = NoMatch -> forall S, ~ such S) ->
  (tolerances_of (asked cert) = None -> forall N, bound_of (claimed cert) = Some N -> (at_least (asked cert) < N)%Z ->
    forall S, such S -> Z.of_nat (length S) = N -> least_in_classes_of_all f (asked cert) M S) ->
  mixture_claim_true f cert M.
Proof.
  cbv zeta. intros Lower Attained None_ Counts. unfold mixture_claim_true. destruct (claimed cert) as [N|B N|B|].
  - split; [exact (Attained N eq_refl)|]. split; [exact (Lower N eq_refl)|]. intros T L. exact (Counts T N eq_refl L).
  - split; [exact (Attained N eq_refl) | exact (Lower B eq_refl)].
  - exact (Lower B eq_refl).
  - exact (None_ eq_refl).
Qed.

Theorem mixture_true M cert f :
  check_mixture M cert = Ok tt -> power_law (Z.to_nat (a (asked cert))) (Z.to_nat (b (asked cert))) f ->
  exists M', asked_mixture cert (reduced_mixture M) = Ok M' /\ mixture_claim_true f cert M'.
Proof.
  intros H P. unfold check_mixture in H. cbv zeta in H. passed H. passed H. rename x into M'. passed H.
  apply andb_prop in H0 as (_ & S). exists M'. split; [exact H1|]. clear H1.
  destruct (well_formed_materials M' H2) as (Nu & Ap & Ne & Rd). set (d := root_of_mixture M') in *. set (ms := materials M') in *.
  pose proof (places_proper ms Ap) as Pp. pose proof (mass_in_places ms Nu Ap Ne) as Mp.
  destruct (tolerances_of (asked cert)) as [tol|] eqn:T; destruct (proof_of cert) as [scale z chain|nodes] eqn:Ep; try discriminate H.
  - passed H. rename x into ss. match goal with E : mixture_shares _ _ = Ok _ |- _ => rename E into Sh end. rewrite Rd in H. apply check_tolerant_ok in H as (pr & D & Pi & Wi & C).
    pose proof (sensible_question cert S Pi) as (Qa & Qb & _ & Qs & Ql).
    destruct (sensible_tolerances cert tol S T) as (Np & _).
    pose proof (places_follow ms Ap) as Fo. pose proof (openings_of_all ms Ap) as On.
    pose proof (mixture_targets ms Nu Ap Ne tol ss Sh) as Targets. pose proof (mixture_nothing ms tol ss Sh) as Nothing.
    pose proof (within_of_mixed (asked cert) d ms Nu Ap Ne Ql f P tol ss T Sh) as Down.
    pose proof (mixed_of_within (asked cert) d ms Nu Ap Ne Ql f P tol ss T Sh) as Up.
    apply claim_from_bounds.
    + intros B EB s A. destruct (Down s A) as (At & ->).
      exact (tolerant_lower_bound cert d (all_rows ms) (places_of ms) ss tol nodes Fo On Pp Mp Targets Nothing Qa Qb Qs f P pr D C B _ EB At).
    + intros N EN.
      destruct (tolerant_attained cert d (all_rows ms) (places_of ms) ss tol Fo On Pp Mp Targets Nothing Qa Qb Qs f P pr D N (Np N EN) (Wi N EN))
        as (qts & At & Sum & Lines).
      destruct (Up qts At) as (s & A & L & Ds & O & C'). exists s. split; [exact A|]. split; [congruence|].
      split; [exact (articulate d ms Ap s Ds O)|]. rewrite <- C' in Lines. eapply Forall_impl; [|exact Lines].
      intros w. exact (mixed_line_of_sample (asked cert) d ms Ap f P s w Ds O).
    + intros EN s A. destruct (Down s A) as (At & _).
      exact (tolerant_none cert d (all_rows ms) (places_of ms) ss tol nodes Fo On Pp Mp Targets Nothing Qa Qb Qs f P pr D C _ EN At).
    + intro E. congruence.
  - rewrite Rd in H. pose proof (places_integral ms Ap) as I.
    assert (check_pi (solids_of (asked cert)) = Ok tt) as Pi.
    { pose proof H as K. unfold check_exact in K. passed K. passed K. passed K. destruct x0. exact K2. }
    pose proof (sensible_question cert S Pi) as Q. pose proof Q as (_ & _ & _ & _ & Ql).
    assert (0 < Q2R scale /\ forall y, z = Some y -> 0 < Q2R y) as (Sp & Zp).
    { unfold sensible in S. cbv zeta in S. rewrite Ep, T, !andb_true_iff in S. destruct S as (_ & Sc & Zz).
      apply less_real in Sc. rewrite Q2R_0 in Sc. split; [exact Sc|]. intros y ->. apply less_real in Zz.
      rewrite Q2R_0 in Zz. exact Zz. }
    set (js := map fst (places_of ms)) in *.
    destruct (check_accepted cert d (all_rows ms) js scale z chain Zp H) as (N & B & _ & _ & EN & EB & _).
    pose proof (match_of_mixed (asked cert) d ms Nu Ap Ql f P T) as Down. pose proof (mixed_of_match (asked cert) d ms Nu Ap Ql f P T) as Up.
    fold js in Down, Up. apply claim_from_bounds.
    + intros B' EB' s A. destruct (Down s A) as ((t & At) & ->).
      exact (exact_lower_bound cert d (all_rows ms) js scale z chain I Pp Mp Q Zp H f P B' t _ EB' At).
    + intros N' EN'.
      destruct (exact_attained cert d (all_rows ms) js scale z chain I Pp Mp Q Sp Zp H f P N' EN') as (t & ns & At & Sum & Lines).
      destruct (Up t ns At) as (s & A & L & Ds & O & C). exists s. split; [exact A|]. split; [congruence|].
      split; [exact (articulate d ms Ap s Ds O)|]. rewrite <- C in Lines. eapply Forall_impl; [|exact Lines].
      intros w. exact (mixed_line_of_sample (asked cert) d ms Ap f P s w Ds O).
    + intro E. rewrite E in EN. discriminate EN.
    + intros _ N' EB' Lt.
      assert (forall S' T', mixture_allowed d f ms S' (asked cert) -> Z.of_nat (length S') = N' -> mixture_allowed d f ms T' (asked cert) ->
        each ms (fun name rs => forall j, In j (classes rs) ->
          (number d j (of_material name S') <= number d j (of_material name T'))%Z)) as K.
      { intros S' T' AS LS AT. destruct (Down S' AS) as ((s1 & At1) & L1), (Down T' AT) as ((s2 & At2) & _).
        apply (counts_of_each d ms f S' T').
        apply (exact_least_counts cert d (all_rows ms) js scale z chain I Pp Mp Q Zp H f P N' s1 _ s2 _ EB' Lt At1 ltac:(congruence) At2). }
      intros S' A' L' T' At name rs Im j J. split; [exact (K S' T' A' L' At name rs Im j J)|]. intro Lt'. apply Z.le_antisymm.
      * exact (K T' S' At ltac:(congruence) A' name rs Im j J).
      * exact (K S' T' A' L' At name rs Im j J).
Qed.
