(* An accepted certificate of an exact match: no match has fewer particles than its bound, and one has N (Theorems 1, 2, 5, 6,
   7). Matches are counts in classes here; the samples that have them follow. *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Chain ChainSound Exact Spec Openings
  Reduction RealFacts Sizes Contents ExactSound Solids.
Import ListNotations.
Open Scope R_scope.

Local Arguments Chain.above : simpl never.

(* ---- Floors -------------------------------------------------------------------------------------- *)

Lemma under_zero scale : (0 < fst scale)%Z -> under (0, 1)%Z scale.
Proof. unfold under. simpl. lia. Qed.

Lemma raise b L scale j floor q :
  (1 <= b)%Z -> (1 <= floor)%Z -> sound (set_floor j floor) -> bound L -> (0 < snd scale)%Z -> under L scale ->
  holds b scale (set_floor j floor) q -> (0 < m j)%Z -> (above b L (set_floor j floor) <= q)%Z.
Proof. intros B Fl W Bd D U H M. exact (proj1 (forced b B L scale (set_floor j floor) q W M Bd D U H)). Qed.

Lemma holds_floor b scale j floor floor' q :
  holds b scale (set_floor j floor) q -> ((0 < m j)%Z -> (floor' <= q)%Z) -> holds b scale (set_floor j floor') q.
Proof.
  destruct scale as (n, d). intros [H|(M & R & H)] Fl; [left; exact H | right]. simpl in *. auto.
Qed.

Lemma from_start_least b start scale j q :
  (1 <= b)%Z -> bound start -> (0 < snd scale)%Z -> (fst start * snd scale <= fst scale * snd start)%Z ->
  sound j -> (0 < m j)%Z -> holds b scale j q -> (0 < fst start)%Z -> (from_start b start j <= q)%Z.
Proof.
  destruct start as (n0, d0), scale as (n, e). unfold bound, from_start, holds. cbn [fst snd].
  intros B (N & D0) D L (_ & R & Fp) M [(E & _)|(_ & Q & _ & Hi)] P; [lia|].
  assert (n0 * m j <= q ^ b * F j * d0)%Z as K.
  { apply (Z.mul_le_mono_pos_r _ _ e); [exact D|].
    assert (n0 * e * m j <= n * d0 * m j)%Z by (apply Z.mul_le_mono_nonneg_r; lia).
    assert (n * m j * d0 <= q ^ b * F j * e * d0)%Z by (apply Z.mul_le_mono_nonneg_r; lia). lia. }
  assert (0 <= (n0 * m j - 1) / (d0 * F j))%Z as Y by (apply Z.div_pos; nia).
  assert ((n0 * m j - 1) / (d0 * F j) < q ^ b)%Z as G by (apply Z.div_lt_upper_bound; nia).
  apply root_lt in G; lia.
Qed.

Lemma with_floor_sound b R ss z j :
  (forall floor, (1 <= floor)%Z -> sound (set_floor j floor)) -> sound (with_floor b R ss z j).
Proof.
  intro W. unfold with_floor.
  set (fl := if (fst (start ss) =? 0)%Z then Z.max 1 R else Z.max (Z.max 1 R) (from_start b (start ss) j)).
  apply (W (Z.max (above b (excluded ss) (set_floor j fl)) (above b z (set_floor j fl)))).
  pose proof (above_floor b (excluded ss) (set_floor j fl)) as A. cbn [set_floor r] in A.
  assert (1 <= fl)%Z by (unfold fl; destruct (fst (start ss) =? 0)%Z; lia). lia.
Qed.

(* A solution with the least counts R that is at the start, and above what is excluded, has the floors. *)
Lemma with_floor_holds b R ss z scale j q :
  (1 <= b)%Z -> (forall floor, (1 <= floor)%Z -> sound (set_floor j floor)) ->
  bound (start ss) -> bound (excluded ss) -> bound z -> (0 < snd scale)%Z ->
  (fst (start ss) * snd scale <= fst scale * snd (start ss))%Z -> under (excluded ss) scale -> under z scale ->
  holds b scale (set_floor j (Z.max 1 R)) q -> holds b scale (with_floor b R ss z j) q.
Proof.
  intros B W Bs Be Bz D Us Ue Uz H. unfold with_floor.
  set (fl := if (fst (start ss) =? 0)%Z then Z.max 1 R else Z.max (Z.max 1 R) (from_start b (start ss) j)).
  assert (1 <= fl)%Z as Fl by (unfold fl; destruct (fst (start ss) =? 0)%Z; lia).
  assert ((0 < m j)%Z -> (Z.max 1 R <= q)%Z) as Q0.
  { intro M. destruct scale. destruct H as [(E & _)|(_ & Q & _)]; cbn [set_floor m r] in *; lia. }
  assert (holds b scale (set_floor j fl) q) as Hf.
  { apply (holds_floor b scale j (Z.max 1 R)); [exact H|]. intro M. unfold fl.
    destruct (Z.eqb_spec (fst (start ss)) 0) as [E|E]; [apply Q0, M|].
    pose proof (from_start_least b (start ss) scale (set_floor j (Z.max 1 R)) q B Bs D Us (W (Z.max 1 R) ltac:(lia)) M H) as K.
    destruct Bs as (N & _). change (from_start b (start ss) (set_floor j (Z.max 1 R))) with (from_start b (start ss) j) in K.
    specialize (Q0 M). lia. }
  apply (holds_floor b scale j fl); [exact Hf|]. intro M. apply Z.max_lub.
  - exact (raise b (excluded ss) scale j fl q B Fl (W fl Fl) Be D Ue Hf M).
  - exact (raise b z scale j fl q B Fl (W fl Fl) Bz D Uz Hf M).
Qed.

Lemma Forall2_map_left {A B C} (P : B -> C -> Prop) (g : A -> B) xs ys :
  Forall2 (fun x y => P (g x) y) xs ys -> Forall2 P (map g xs) ys.
Proof. induction 1; simpl; constructor; assumption. Qed.

Lemma Forall2_unmap_left {A B C} (P : B -> C -> Prop) (g : A -> B) xs : forall ys,
  Forall2 P (map g xs) ys -> Forall2 (fun x y => P (g x) y) xs ys.
Proof. induction xs; intros ys H; inversion H; subst; constructor; auto. Qed.

Lemma Forall2_impl_in {A B} (P Q : A -> B -> Prop) xs ys :
  (forall x y, In x xs -> P x y -> Q x y) -> Forall2 P xs ys -> Forall2 Q xs ys.
Proof.
  intros H F. induction F; constructor; [apply H; [left; reflexivity | assumption]|].
  apply IHF. intros; apply H; [right|]; assumption.
Qed.

Lemma check_above_floor b M z R ss z' js :
  check_above b M z (map (with_floor b R ss z') js) = check_above b M z (map (fun j => set_floor j 1) js).
Proof.
  unfold check_above. rewrite !map_map.
  replace (forallb (fun j => (m j =? 0)%Z || (0 <? f j)%Z) (map (with_floor b R ss z' ) js))
    with (forallb (fun j => (m j =? 0)%Z || (0 <? f j)%Z) (map (fun j => set_floor j 1) js)).
  - f_equal.
  - induction js as [|j js IH]; [reflexivity|]. cbn [map forallb]. rewrite IH. reflexivity.
Qed.

(* ---- The theorem --------------------------------------------------------------------------------- *)

Definition proper_question (q : question) : Prop :=
  (1 <= a q)%Z /\ (1 <= b q)%Z /\ (0 <= min_per_class q)%Z /\ proper_solids (solids_of q) /\
  (solids_of q = Anything \/ a q = 3%Z /\ b q = 1%Z).

(* The counts qs of the classes js are those of a match at the scale s, with all that the question demands. *)
Record match_at (law : R -> R) (q : question) (d : positive) (js : list class) (s : R) (qs : list Z) : Prop := {
  at_scale : 0 < s;
  at_counts : Forall2 (fun j n => realizes d law j n (s * Q2R (mass j)) /\ (0 < Q2R (mass j) -> (min_per_class q <= n)%Z)) js qs;
  at_solids : has_cubes (solids_of q) (s * unit_cubes js);
  at_number : (at_least q <= sum qs)%Z }.

(* With the masses that belong to the counts. *)
Definition contents_at (s : R) (js : list class) (qs : list Z) : contents :=
  map (fun '(j, n) => (n, s * Q2R (mass j))) (combine js qs).

Section Claim.
Variables (cert : certificate) (d : positive) (rs : list row) (js : list class).
Variables (scale : Q) (z : option Q) (chain : option (list Z)).
Notation q := (asked cert).
Notation u := (units_of rs).
Notation na := (Z.to_nat (a q)).
(* The degree of masses: that of the law times the root. *)
Notation bd := (b q * Zpos d)%Z.
Notation nb := (Z.to_nat (b q) * Pos.to_nat d)%nat.

Hypothesis classes_integral : Forall (integral u) js.
Hypothesis classes_proper : Forall proper js.
Hypothesis some_mass : exists j, In j js /\ 0 < Q2R (mass j).
Hypothesis question_proper : proper_question q.
Hypothesis scale_positive : 0 < Q2R scale.
Hypothesis z_positive : forall y, z = Some y -> 0 < Q2R y.
Hypothesis checked : check_exact cert (Zpos d) rs js scale z chain = Ok tt.

Variable law : R -> R.
Hypothesis power : power_law na (Z.to_nat (b q)) law.

Lemma openings_law : opening_law d na nb law.
Proof. apply law_at_openings, power. Qed.

Lemma na_positive : (1 <= na)%nat.
Proof. destruct question_proper as (A & _). lia. Qed.
Lemma nb_positive : (1 <= nb)%nat.
Proof. destruct question_proper as (_ & B & _). pose proof (Pos2Nat.is_pos d). nia. Qed.
Lemma na_z : Z.of_nat na = a q.
Proof. destruct question_proper as (A & _). lia. Qed.
Lemma nb_z : Z.of_nat nb = bd.
Proof. destruct question_proper as (_ & B & _). lia. Qed.
Lemma bd_positive : (1 <= bd)%Z.
Proof. rewrite <- nb_z. pose proof nb_positive. lia. Qed.
Lemma units_positive : (0 < of_openings u)%Z /\ (0 < of_masses u)%Z /\ (0 < of_factors u)%Z.
Proof. repeat split; apply common_denominator_spec. Qed.
Lemma in_integers_z j : in_integers u (a q) bd j = in_integers u (Z.of_nat na) (Z.of_nat nb) j.
Proof. rewrite na_z, nb_z. reflexivity. Qed.

Lemma base_sound j : In j js -> forall floor, (1 <= floor)%Z -> sound (set_floor (in_integers u (a q) bd j) floor).
Proof.
  intros J floor Fl. destruct units_positive as (Ux & Um & Uc).
  pose proof classes_integral as I. pose proof classes_proper as P. rewrite Forall_forall in I, P. rewrite in_integers_z.
  apply (in_integers_sound na nb nb_positive law openings_law); auto.
Qed.

(* What the check was about, by names. *)
Definition z_scale : ratio := match z with Some y => in_scale_units u (a q) bd y | None => (0, 1)%Z end.

Lemma scale_units_real y :
  IZR (fst (in_scale_units u (a q) bd y)) / IZR (snd (in_scale_units u (a q) bd y)) = Q2R y * per_scale na nb u /\
  (0 < snd (in_scale_units u (a q) bd y))%Z.
Proof.
  destruct units_positive as (Ux & Um & Uc). unfold in_scale_units. cbn [fst snd]. rewrite <- na_z, <- nb_z.
  pose proof (IZR_lt _ _ Ux) as Rx. pose proof (IZR_lt _ _ Um) as Rm. pose proof (den_positive y) as D. split.
  - rewrite !mult_IZR, <- !pow_IZR, Q2R_num. rewrite !Nat2Z.id. unfold per_scale. pose proof (pow_lt _ nb Rm). field. lra.
  - apply Z.mul_pos_pos; [reflexivity|]. apply Z.pow_pos_nonneg; lia.
Qed.

Lemma z_bound : bound z_scale /\ (z <> None -> 0 < fst z_scale)%Z.
Proof.
  unfold z_scale. destruct z as [y|] eqn:E; [|split; [split; simpl; lia | congruence]].
  destruct (scale_units_real y) as (R & D). destruct units_positive as (Ux & Um & Uc).
  assert (0 < fst (in_scale_units u (a q) bd y))%Z as P.
  { apply lt_IZR. apply IZR_lt in D. pose proof (z_positive y eq_refl) as Y.
    pose proof (Rmult_lt_0_compat _ _ Y (per_scale_positive na nb u Ux Um Uc)) as K. rewrite <- R in K.
    apply (Rmult_lt_compat_r _ _ _ D) in K. unfold Rdiv in K. rewrite Rmult_assoc, Rinv_l in K by lra. lra. }
  split; [split; [lia | exact D] | intros _; exact P].
Qed.

Record accepted (N B : Z) (qs : list Z) (ss : scales) : Prop := {
  acc_scales : scales_of u bd js (solids_of q) = Ok ss;
  acc_volume : (fst (enough ss) * snd (in_scale_units u (a q) bd scale) <=
                fst (in_scale_units u (a q) bd scale) * snd (enough ss))%Z;
  acc_fit : all_fit bd (min_per_class q) (in_scale_units u (a q) bd scale)
              (map (fun j => with_floor bd (min_per_class q) ss z_scale (in_integers u (a q) bd j)) js) qs = true;
  acc_counts : counts 1 (map (fun j => with_floor bd (min_per_class q) ss z_scale (in_integers u (a q) bd j)) js)
                 (witness cert) = Some qs;
  acc_sizes : check_sizes u (a q) bd (Zpos d) (in_scale_units u (a q) bd scale) (with_mass js) (witness cert) = Ok tt;
  acc_sum : sum qs = N;
  acc_at_least : (at_least q <= N)%Z;
  acc_chain : match chain with
              | Some chain =>
                check_chain bd B (B =? N)%Z (map (fun j => with_floor bd (min_per_class q) ss z_scale
                                                     (in_integers u (a q) bd j)) js) chain = Ok tt
              | None => B = at_least q
              end;
  acc_above : z <> None ->
              check_above bd (at_least q) z_scale
                (map (fun j => with_floor bd (min_per_class q) ss z_scale (in_integers u (a q) bd j)) js) = Ok tt }.

Lemma check_accepted :
  exists N B qs ss, found (claimed cert) = Some N /\ bound_of (claimed cert) = Some B /\ accepted N B qs ss.
Proof.
  pose proof checked as H. unfold check_exact in H. fold z_scale in H.
  passed H. rename x into ss. passed H. passed H. destruct x.
  destruct (found (claimed cert)) as [N|] eqn:EN; [|discriminate].
  destruct (bound_of (claimed cert)) as [B|] eqn:EB; [|discriminate].
  destruct (counts 1 _ (witness cert)) as [qs|] eqn:C; [|discriminate].
  do 6 passed H.
  exists N, B, qs, ss. split; [reflexivity|]. split; [reflexivity|]. constructor; trivial.
  - apply Z.leb_le. assumption.
  - destruct x. assumption.
  - apply Z.eqb_eq. assumption.
  - apply Z.leb_le. assumption.
  - destruct x0, chain; [assumption|]. passed H8. unfold claims_least in H8. rewrite EB in H8.
    apply Z.eqb_eq in H8. exact H8.
  - intro Nz. destruct z; [exact H | congruence].
Qed.

Lemma scales_at_nb N B qs ss : accepted N B qs ss -> scales_of u (Z.of_nat nb) js (solids_of q) = Ok ss.
Proof. intro Acc. rewrite nb_z. apply Acc. Qed.

(* A match gives a solution in integers with the floors. *)
Lemma match_solution N B qs ss s ns :
  accepted N B qs ss -> match_at law q d js s ns ->
  exists sc, solution bd (map (fun j => with_floor bd (min_per_class q) ss z_scale (in_integers u (a q) bd j)) js) ns sc.
Proof.
  intros Acc [Sp H HC M].
  destruct units_positive as (Ux & Um & Uc). pose proof classes_integral as I. pose proof classes_proper as P.
  destruct question_proper as (Qa & _ & QR & Qs & Ql). pose proof bd_positive as Qb.
  assert (Forall2 (holds_real bd (s ^ nb * per_scale na nb u))
            (map (fun j => set_floor (in_integers u (a q) bd j) (Z.max 1 (min_per_class q))) js) ns) as HR.
  { apply Forall2_map_left. rewrite Forall_forall in I, P. eapply Forall2_impl_in; [|exact H]. intros j n J (Rz & R). cbv beta.
    rewrite in_integers_z. rewrite <- nb_z at 1.
    apply (realizes_holds na nb nb_positive law openings_law u Ux Um Uc j s); auto.
    intro Mp. pose proof (Rmult_lt_0_compat _ _ Sp Mp) as K. destruct Rz as [(_ & E)|(Q1 & _)]; [lra|].
    specialize (R Mp). lia. }
  assert (0 < s ^ nb * per_scale na nb u) as Sc.
  { apply Rmult_lt_0_compat; [apply pow_lt, Sp | apply per_scale_positive; assumption]. }
  destruct (rational_scale _ _ _ _ Sc HR) as (sc & (N1 & D1 & Hq) & U).
  destruct (scales_ok u Ux Um Uc na nb js (solids_of q) ss nb_positive I P some_mass Qs ltac:(destruct Ql as [|(A3 & _)]; [tauto | right; lia])
              (scales_at_nb _ _ _ _ Acc)) as (Bs & Be & _ & Sol).
  destruct (proj1 (Sol s Sp) HC) as (St & Ex).
  pose proof (IZR_lt _ _ D1) as D1r.
  assert (forall L, bound L -> IZR (fst L) / IZR (snd L) < s ^ nb * per_scale na nb u -> under L sc) as Under.
  { intros L (Ln & Ld) HL. unfold under. apply lt_IZR. rewrite !mult_IZR. apply IZR_lt in Ld.
    apply (Rmult_lt_compat_r (IZR (snd L))) in HL; [|exact Ld]. unfold Rdiv in HL.
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r in HL by lra.
    apply (Rmult_lt_compat_r (IZR (snd sc))) in HL; [|exact D1r].
    apply (Rmult_le_compat_r (IZR (snd L))) in U; [|lra]. lra. }
  assert (fst (start ss) * snd sc <= fst sc * snd (start ss))%Z as Ust.
  { destruct Bs as (Sn & Sd). apply le_IZR. rewrite !mult_IZR. apply IZR_lt in Sd.
    apply (Rmult_le_compat_r (IZR (snd (start ss)))) in St; [|lra]. unfold Rdiv in St.
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r in St by lra.
    apply (Rmult_le_compat_r (IZR (snd sc))) in St; [|lra].
    apply (Rmult_le_compat_r (IZR (snd (start ss)))) in U; [|lra]. lra. }
  destruct z_bound as (Bz & Zp).
  assert (under z_scale sc) as Uz.
  { destruct z as [y|] eqn:Ez.
    2: { unfold z_scale. rewrite Ez. apply under_zero, N1. }
    rewrite <- Ez in *. assert (z <> None) as Nz by congruence.
    pose proof (acc_above _ _ _ _ Acc Nz) as Ab. rewrite <- map_map, check_above_floor in Ab.
    refine (above_sound bd Qb (at_least q) z_scale _ ns sc _ (Zp Nz) (proj2 Bz) Ab _ _).
    - apply Forall_forall. intros j J. rewrite map_map in J. apply in_map_iff in J as (i & <- & J). apply base_sound; [exact J | lia].
    - split; [exact N1|]. split; [exact D1|]. rewrite map_map. apply Forall2_unmap_left in Hq. apply Forall2_map_left.
      eapply Forall2_impl_in; [|exact Hq]. intros j n J Hj. apply (holds_floor _ _ _ _ _ _ Hj).
      intro Mj. destruct sc. destruct Hj as [(E0 & _)|(_ & Qj & _)]; cbn [set_floor m r] in *; lia.
    - exact M. }
  exists sc. split; [exact N1|]. split; [exact D1|]. apply Forall2_map_left. apply Forall2_unmap_left in Hq.
  eapply Forall2_impl_in; [|exact Hq]. intros j n J Hj. apply with_floor_holds; trivial.
  - apply base_sound, J.
  - apply Under; assumption.
Qed.

(* None with fewer. *)
Theorem exact_lower_bound B s ns : bound_of (claimed cert) = Some B -> match_at law q d js s ns -> (B <= sum ns)%Z.
Proof.
  intros E A. destruct check_accepted as (N & B' & qs & ss & _ & E' & Acc). rewrite E in E'. injection E' as <-.
  destruct (match_solution N B qs ss s ns Acc A) as (sc & Sol). pose proof (at_number _ _ _ _ _ _ A) as M.
  pose proof (acc_chain _ _ _ _ Acc) as C. destruct chain as [js'|]; [|lia].
  refine (chain_bound bd _ B _ _ js' _ C _ (ex_intro _ sc Sol)).
  - exact bd_positive.
  - apply Forall_forall. intros j J. apply in_map_iff in J as (i & <- & J). apply with_floor_sound, base_sound, J.
Qed.

(* One with as many particles as the bound has the least count in every class (Theorem 5 (a)), unless the bound is
   what was asked for. *)
Theorem exact_least_counts N s ns t ms :
  bound_of (claimed cert) = Some N -> (at_least q < N)%Z ->
  match_at law q d js s ns -> sum ns = N -> match_at law q d js t ms -> Forall2 Z.le ns ms.
Proof.
  intros E L A LS B. destruct check_accepted as (N' & B' & qs & ss & _ & E' & Acc).
  rewrite E in E'. injection E' as <-.
  destruct (match_solution N' N qs ss s ns Acc A) as (scS & SolS).
  destruct (match_solution N' N qs ss t ms Acc B) as (scT & SolT).
  pose proof (acc_chain _ _ _ _ Acc) as C. destruct chain as [js'|]; [|lia].
  destruct (chain_counts bd bd_positive N (N =? N')%Z
    (map (fun j => with_floor bd (min_per_class q) ss z_scale (in_integers u (a q) bd j)) js) js') as (ls & Sum & _ & Least);
    [|exact C|].
  { apply Forall_forall. intros j J. apply in_map_iff in J as (i & <- & J). apply with_floor_sound, base_sound, J. }
  rewrite (sum_eq ls ns).
  - apply Least. exists scT. exact SolT.
  - apply Least. exists scS. exact SolS.
  - congruence.
Qed.

Lemma all_fit_spec bb RR sc bs : forall qs, all_fit bb RR sc bs qs = true -> Forall2 (fun j n => fits bb RR sc j n = true) bs qs.
Proof.
  induction bs as [|j bs IH]; intros [|n qs] H; simpl in H; try discriminate; [constructor|].
  apply andb_prop in H as (H1 & H2). constructor; auto.
Qed.

Lemma fits_holds bb RR sc j n :
  (0 <= m j)%Z -> fits bb RR sc j n = true -> holds bb sc (set_floor j (Z.max 1 RR)) n.
Proof.
  destruct sc as (sn, sd). unfold fits, holds. cbn [set_floor m r f F]. intros M H.
  destruct (Z.eqb_spec (m j) 0) as [E|E]; [left; split; [exact E | apply Z.eqb_eq, H] | right].
  rewrite !andb_true_iff, !Z.leb_le, Z.ltb_lt in H. lia.
Qed.

Lemma quotient_power x y n : (x / y) ^ n = x ^ n / y ^ n.
Proof. unfold Rdiv. rewrite Rpow_mult_distr, pow_inv. reflexivity. Qed.

Lemma size_fraction s m n c mu cu xu e :
  n <> 0 -> c <> 0 -> mu <> 0 -> cu <> 0 -> xu <> 0 -> e <> 0 ->
  s * m / (n * c) = s * (cu * xu / mu) * e * (m * mu) / (n * e * (c * cu * xu)).
Proof. intros. field. repeat split; assumption. Qed.

(* The witness's sizes are those of the match at the witness's scale with the witness's counts. *)
Lemma sizes_fit s : 0 < s -> s ^ nb = Q2R scale ->
  forall post pre before ws qs (ss : scales),
  js = pre ++ post -> length before = length pre ->
  counts (Z.of_nat (length pre) + 1)
    (map (fun j => with_floor bd (min_per_class q) ss z_scale (in_integers u (a q) bd j)) post) ws = Some qs ->
  Forall2 (fun j n => realizes d law j n (s * Q2R (mass j))) post qs ->
  check_sizes u (a q) bd (Zpos d) (in_scale_units u (a q) bd scale) (with_mass post) ws = Ok tt ->
  Forall (line_fits na (Z.to_nat (b q)) js (before ++ contents_at s post qs)) ws.
Proof.
  intros Sp Es. destruct units_positive as (Ux & Um & Uc).
  pose proof classes_integral as I. pose proof classes_proper as P. rewrite Forall_forall in I, P.
  induction post as [|j post IH]; intros pre before ws qs ss E Le C Q Z.
  { destruct ws; [constructor | discriminate]. }
  assert (In j js) as J by (rewrite E; apply in_or_app; right; left; reflexivity).
  destruct qs as [|n qs']; [inversion Q|].
  assert (realizes d law j n (s * Q2R (mass j)) /\ Forall2 (fun j n => realizes d law j n (s * Q2R (mass j))) post qs') as (Qj & Q')
    by (inversion Q; auto).
  assert (forall ws', counts (Z.of_nat (length pre) + 1 + 1)
    (map (fun j => with_floor bd (min_per_class q) ss z_scale (in_integers u (a q) bd j)) post) ws' = Some qs' ->
    check_sizes u (a q) bd (Zpos d) (in_scale_units u (a q) bd scale) (with_mass post) ws' = Ok tt ->
    Forall (line_fits na (Z.to_nat (b q)) js (before ++ contents_at s (j :: post) (n :: qs'))) ws') as Rest.
  { intros ws' C' Z'. change (contents_at s (j :: post) (n :: qs')) with ([(n, s * Q2R (mass j))] ++ contents_at s post qs').
    rewrite app_assoc. apply (IH (pre ++ [j]) (before ++ [(n, s * Q2R (mass j))]) ws' qs' ss); trivial.
    - rewrite <- app_assoc. exact E.
    - rewrite !app_length, Le. reflexivity.
    - rewrite app_length. simpl length. replace (Z.of_nat (length pre + 1) + 1)%Z with (Z.of_nat (length pre) + 1 + 1)%Z by lia.
      exact C'. }
  pose proof (mass_zero na nb nb_positive law openings_law u Ux Um Uc j (I j J) (P j J)) as Mz.
  rewrite <- in_integers_z in Mz.
  cbn [map counts] in C.
  change (m (with_floor bd (min_per_class q) ss z_scale (in_integers u (a q) bd j)))
    with (m (in_integers u (a q) bd j)) in C.
  cbn [with_mass filter] in Z. fold (with_mass post) in Z.
  destruct (Z.eqb_spec (m (in_integers u (a q) bd j)) 0) as [M0|M0].
  - assert (equal (mass j) 0 = true) as E0 by (apply equal_real; rewrite Q2R_0; apply Mz, M0).
    rewrite E0 in Z. cbn [negb] in Z.
    assert (option_map (cons 0%Z) (counts (Z.of_nat (length pre) + 1 + 1) (map (fun j => with_floor bd (min_per_class q)
              ss z_scale (in_integers u (a q) bd j)) post) ws) = Some (n :: qs')) as C0 by (destruct ws; exact C).
    destruct (counts (Z.of_nat (length pre) + 1 + 1) (map (fun j => with_floor bd (min_per_class q) ss z_scale
                (in_integers u (a q) bd j)) post) ws) as [qs0|] eqn:C'; [|discriminate]. injection C0 as _ <-.
    exact (Rest ws C' Z).
  - destruct (equal (mass j) 0) eqn:E0; [exfalso; apply M0, Mz; apply equal_real in E0; rewrite E0; apply Q2R_0|].
    destruct ws as [|w ws]; [discriminate|]. destruct (Z.eqb_spec (index w) (Z.of_nat (length pre) + 1)) as [Iw|]; [|discriminate].
    destruct (counts (Z.of_nat (length pre) + 1 + 1) (map (fun j => with_floor bd (min_per_class q) ss z_scale
                (in_integers u (a q) bd j)) post) ws) as [qs0|] eqn:C'; [|discriminate].
    injection C as <- <-. cbn [negb] in Z. cbn [check_sizes] in Z.
    destruct (in_scale_units u (a q) bd scale) as (nu, e) eqn:Esc. passed Z. destruct x.
    constructor; [|exact (Rest ws C' Z)].
    assert (Z.to_nat (index w - 1) = length pre) as Place by (rewrite Iw; lia).
    exists j, (s * Q2R (mass j)). split; [rewrite E; apply nth_behind, Place|]. split; [apply nth_behind; congruence|].
    intros x X Sz.
    pose proof (scale_units_real scale) as (Rs & Ds). rewrite Esc in Rs, Ds. cbn [fst snd] in Rs, Ds.
    destruct (P j J) as ((L & U) & Cj & Mj). destruct (I j J) as (_ & _ & Dm & Dc).
    rewrite <- na_z in Z0.
    assert (1 <= IZR (count w)) as N1r.
    { apply (IZR_le 1). destruct Qj as [(_ & T0)|(N1 & _)]; [exfalso | exact N1]. apply Rmult_integral in T0 as [T0|T0]; [lra|].
      apply equal_false in E0. apply E0, eqR_Qeq. rewrite Q2R_0. exact T0. }
    pose proof (IZR_lt _ _ Ux) as Rx. pose proof (IZR_lt _ _ Um) as Rm. pose proof (IZR_lt _ _ Uc) as Rc. pose proof (IZR_lt _ _ Ds) as Rd.
    assert (0 < integer_factor u j)%Z as Fp.
    { apply lt_IZR. unfold integer_factor. rewrite in_units_real by exact Dc. apply Rmult_lt_0_compat; assumption. }
    assert (1 <= count w)%Z as N1 by (apply le_IZR; exact N1r).
    destruct question_proper as (Qa & _). pose proof bd_positive as Qb.
    refine (check_size_sound na (Zpos d) j w _ _ x na_positive eq_refl _ X _ Z0).
    + apply Z.mul_pos_pos; [apply Z.mul_pos_pos; [apply Z.pow_pos_nonneg; lia | exact Ds]|].
      apply Z.mul_pos_pos; apply Z.pow_pos_nonneg; lia.
    + rewrite pow_mult, Sz, <- pow_mult, !mult_IZR. rewrite <- nb_z, <- na_z, <- !pow_IZR, !Nat2Z.id.
      unfold integer_factor. rewrite !in_units_real by assumption. rewrite !Rpow_mult_distr.
      replace (IZR nu) with (Q2R scale * per_scale na nb u * IZR e) by (rewrite <- Rs; field; lra).
      rewrite <- Es. unfold per_scale. rewrite quotient_power, !Rpow_mult_distr.
      apply size_fraction; try apply Rgt_not_eq; try apply pow_lt; lra.
Qed.

(* One with N, in the witness's bounds. *)
Theorem exact_attained N :
  found (claimed cert) = Some N ->
  exists s ns, match_at law q d js s ns /\ sum ns = N /\
    Forall (line_fits na (Z.to_nat (b q)) js (contents_at s js ns)) (witness cert).
Proof.
  intro E. destruct check_accepted as (N' & bound & qs & ss & E' & _ & Acc). rewrite E in E'. injection E' as <-.
  destruct units_positive as (Ux & Um & Uc). pose proof classes_integral as I. pose proof classes_proper as P.
  destruct question_proper as (Qa & _ & QR & Qs & Ql). pose proof bd_positive as Qb.
  set (sc := in_scale_units u (a q) bd scale).
  destruct (scale_units_real scale) as (Rs & Ds). fold sc in Rs, Ds.
  pose proof (per_scale_positive na nb u Ux Um Uc) as K.
  destruct (real_root (Q2R scale) nb scale_positive nb_positive) as (s & Sp & Es).
  pose proof (all_fit_spec _ _ _ _ _ (acc_fit _ _ _ _ Acc)) as Ft. apply Forall2_unmap_left in Ft. fold sc in Ft.
  assert (Forall2 (fun j n => realizes d law j n (s * Q2R (mass j)) /\ (0 < Q2R (mass j) -> (min_per_class q <= n)%Z)) js qs) as Rz.
  { eapply Forall2_impl_in; [|exact Ft]. intros j n J Hj. cbv beta in Hj.
    rewrite Forall_forall in I, P.
    assert (0 <= m (in_integers u (a q) bd j))%Z as Mn by (destruct (base_sound j J 1) as (Mn & _); [lia | exact Mn]).
    apply fits_holds in Hj; [|exact Mn].
    change (holds bd sc (set_floor (in_integers u (a q) bd j) (Z.max 1 (min_per_class q))) n) in Hj.
    split.
    - destruct sc as (sn, sd). apply real_scale in Hj; [|exact Ds]. cbn [fst snd] in Rs. rewrite Rs, <- Es in Hj.
      rewrite in_integers_z in Hj. rewrite <- nb_z in Hj at 1.
      apply (holds_realizes na nb nb_positive law openings_law u Ux Um Uc j s n (Z.max 1 (min_per_class q))); auto. lia.
    - intro Mp. destruct sc as (sn, sd). destruct Hj as [(E0 & _)|(_ & Qj & _)]; [|simpl in Qj; lia].
      change (m (in_integers u (a q) bd j) = 0%Z) in E0. rewrite in_integers_z in E0.
      apply (mass_zero na nb nb_positive law openings_law u Ux Um Uc j (I j J) (P j J)) in E0. lra. }
  exists s, qs. split; [|split; [exact (acc_sum _ _ _ _ Acc)|]].
  - constructor; [exact Sp | exact Rz | |rewrite (acc_sum _ _ _ _ Acc); apply (acc_at_least _ _ _ _ Acc)].
    destruct (scales_ok u Ux Um Uc na nb js (solids_of q) ss nb_positive I P some_mass Qs ltac:(destruct Ql as [|(A3 & _)]; [tauto | right; lia])
                (scales_at_nb _ _ _ _ Acc)) as (_ & _ & Be & Sol).
    apply (proj2 (Sol s Sp)). rewrite Es, <- Rs. pose proof (acc_volume _ _ _ _ Acc) as V. fold sc in V.
    apply IZR_le in V. rewrite !mult_IZR in V. destruct Be as (_ & Ed). apply IZR_lt in Ed, Ds.
    apply (Rmult_le_reg_r (IZR (snd (enough ss)) * IZR (snd sc))); [apply Rmult_lt_0_compat; assumption|].
    replace (IZR (fst (enough ss)) / IZR (snd (enough ss)) * (IZR (snd (enough ss)) * IZR (snd sc)))
      with (IZR (fst (enough ss)) * IZR (snd sc)) by (field; lra).
    replace (IZR (fst sc) / IZR (snd sc) * (IZR (snd (enough ss)) * IZR (snd sc)))
      with (IZR (fst sc) * IZR (snd (enough ss))) by (field; lra). exact V.
  - apply (sizes_fit s Sp Es js [] [] (witness cert) qs ss eq_refl eq_refl (acc_counts _ _ _ _ Acc)); [|apply (acc_sizes _ _ _ _ Acc)].
    eapply Forall2_impl_in; [|exact Rz]. intros j n _ (H & _). exact H.
Qed.

End Claim.

Lemma classes_integral rs : Forall (integral (units_of rs)) (classes rs).
Proof.
  apply Forall_forall. intros j J. destruct (class_of_rows rs j J) as (L & U & M & C).
  repeat split; apply common_denominator_spec; assumption.
Qed.

(* ---- Samples of one gradation -------------------------------------------------------------------- *)

Section Samples.
Variables (q : question) (G : gradation) (d : positive).
Notation rs := (rows G).
Notation js := (classes rs).
Hypothesis root_proper : root G = Zpos d.
Hypothesis exact : tolerances_of q = None.
Hypothesis rows_proper : proper_rows rs.
Hypothesis solids_law : solids_of q = Anything \/ a q = 3%Z /\ b q = 1%Z.
Variable law : R -> R.
Hypothesis power : power_law (Z.to_nat (a q)) (Z.to_nat (b q)) law.

(* What the question allows, with the root by its name. *)
Lemma allowed_exactly S :
  allowed law q G S <-> describes_accurately d law rs S /\ has_enough d q rs S.
Proof. unfold allowed, root_of. rewrite exact, root_proper. tauto. Qed.

Lemma solids_of_match s S : describes_accurately_at d s law rs S ->
  has_solids (solids_of q) S <-> has_cubes (solids_of q) (s * unit_cubes js).
Proof.
  intro D. destruct solids_law as [->|(A3 & B1)]; [simpl; tauto|].
  assert (power_law 3 1 law) as P31 by (rewrite A3, B1 in power; exact power).
  destruct (solids_of q); simpl; rewrite ?(volume_of_match law rs S s P31 rows_proper D); tauto.
Qed.

(* The counts of a sample that the question allows are a match. *)
Lemma match_of_sample S : allowed law q G S ->
  (exists s, match_at law q d js s (map (fun j => number d j S) js)) /\
  Z.of_nat (length S) = sum (map (fun j => number d j S) js).
Proof.
  intro Al. apply allowed_exactly in Al as ((s & Sp & D & H) & R & V & M).
  pose proof (describes_number rs S rows_proper D) as L. split; [|exact L]. exists s.
  pose proof (proper_classes rs rows_proper) as P. constructor.
  - exact Sp.
  - rewrite Forall_forall in P. clear L M. assert (forall j, In j js -> realizes d law j (number d j S) (s * Q2R (mass j)) /\
      (0 < Q2R (mass j) -> (min_per_class q <= number d j S)%Z)) as K.
    { intros j J. split; [rewrite <- (H j J); apply sample_realizes; [apply power | auto]|].
      intro Mp. apply R; [exact J|]. apply Rlt_Qlt. rewrite Q2R_0. exact Mp. }
    clear -K. induction js as [|j l IH]; simpl; constructor; [apply K; left; reflexivity|].
    apply IH. intros; apply K; right; assumption.
  - apply (solids_of_match s S (conj D H)), V.
  - rewrite <- L. exact M.
Qed.

(* And there is one for each match. *)
Lemma sample_of_match s ns : match_at law q d js s ns ->
  exists S, allowed law q G S /\ Z.of_nat (length S) = sum ns /\ describes d rs S /\ one_size_a_class d js S /\
    contents_of d law js S = contents_at s js ns.
Proof.
  intros [Sp H V M].
  assert (Forall2 (fun j qt => realizes d law j (fst qt) (snd qt)) js (contents_at s js ns)) as Rz.
  { clear -H. unfold contents_at. induction H as [|j n l ns (Hj & _) _ IH]; constructor; [exact Hj | exact IH]. }
  destruct (sample_with_contents (d := d) law rs _ (proj1 power) rows_proper Rz) as (S & D & O & C).
  pose proof (contents_are law js S _ C) as E.
  assert (forall j n, In (j, n) (combine js ns) -> number d j S = n /\ held d law j S = s * Q2R (mass j)) as Of.
  { clear -C. unfold has_contents, contents_at in C. revert ns C. generalize js as l. induction l as [|i l IH]; intros [|m ns] C; inversion C; subst;
      intros j n I; try destruct I as [[= <- <-]|I]; try contradiction; auto. eapply IH; eassumption. }
  assert (length js = length ns) as Le by (clear -H; induction H; simpl; congruence).
  assert (forall j, In j js -> held d law j S = s * Q2R (mass j)) as Held.
  { intros j J. clear -Of J Le. revert ns Of Le. induction js as [|i l IH]; intros [|m ns] Of Le; try discriminate; [destruct J|].
    destruct J as [<-|J]; [apply (Of i m); left; reflexivity|]. apply (IH J ns); [|injection Le as Le; exact Le].
    intros j' n' I. apply Of. right. exact I. }
  assert (Z.of_nat (length S) = sum ns) as L.
  { rewrite (describes_number rs S rows_proper D). f_equal. rewrite <- (counts_of_contents (d := d) law js S), <- E.
    unfold contents_at. rewrite map_map. clear -Le. revert ns Le. induction js as [|i l IH]; intros [|m ns] Le; try discriminate; [reflexivity|].
    simpl. f_equal. apply IH. injection Le as Le. exact Le. }
  exists S. split; [|split; [exact L | split; [exact D | split; [exact O | symmetry; exact E]]]].
  apply allowed_exactly. split; [exists s; split; [exact Sp | split; assumption]|]. split; [|split].
  - intros j J Mp. apply Qlt_Rlt in Mp. rewrite Q2R_0 in Mp. clear -Of H J Mp. revert Of. induction H as [|i n l ns (_ & F) _ IH]; intro Of; [destruct J|].
    destruct J as [<-|J]; [rewrite (proj1 (Of i n (or_introl eq_refl))); exact (F Mp)|]. apply IH; [exact J|]. intros; apply Of; right; assumption.
  - apply (solids_of_match s S (conj D Held)), V.
  - rewrite L. exact M.
Qed.

End Samples.
