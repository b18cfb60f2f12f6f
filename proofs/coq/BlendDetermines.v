(* A line about a blend says one thing: statements that have the same line are the same. No stockpile is given twice: of a share of
   such a name the line would not say which of the two it is of. *)

From Coq Require Import ZArith QArith List Bool String Ascii Lia.
From Mdm Require Import Numbers NumbersFacts Certificate Text Decimals Rows Document Judge VerdictLine JudgeTheorem LinePhrases FileRoot
  Blend BlendCertificate BlendSound BlendJudged BlendLine BlendPhrases BlendTheorem.
Import ListNotations.
Open Scope string_scope.

(* ---- The question as parts ----------------------------------------------------------------------------- *)

Definition name_of (stockpiles : list string) (i : Z) : string := match numbered i stockpiles with Some name => name | None => "" end.
Definition parts_of_aim (a : aim) : list blend_part :=
  match a with
  | NoAim => []
  | Cost cs => [CostsOf cs]
  | Deviation ts | MaxDeviation ts | Squares ts => [TargetsOf ts]
  end.
Fixpoint parts_interpolated (names : list string) (each : list interpolation) : list blend_part :=
  match names, each with
  | name :: names, at_ :: each =>
    (match places_of at_ with [] => [] | _ => [InterpolatedIn name at_] end ++ parts_interpolated names each)%list
  | _, _ => []
  end.

Definition share_part (stockpiles : list string) (limit : Z * Q * Q) : blend_part :=
  let '(i, x, y) := limit in ShareOf (name_of stockpiles i) x y.
Definition modulus_part (limit : standard * Q * Q) : blend_part := let '(st, x, y) := limit in ModulusOf st x y.

Definition blend_parts (s : blend_statement) : list blend_part :=
  let q := question_said s in
  ([InSteps (steps q)] ++
   map (share_part (stockpile_names s)) (share_limits q) ++
   match most_stockpiles q with Some K => [AtMost K] | None => [] end ++
   map modulus_part (modulus_limits q) ++
   match coarseness_limits q with Some (x, y) => [FactorOf x y] | None => [] end ++
   parts_of_aim (aim_of q) ++
   [SievesOf (sieves_said s)] ++
   parts_interpolated (stockpile_names s) (interpolations_said s))%list.

Lemma phrases_of_parts s : question_phrases s = map blend_phrase (blend_parts s).
Proof.
  unfold question_phrases, blend_parts. rewrite !map_app, !map_map. cbn [map app]. f_equal.
  f_equal; [|f_equal; [|f_equal; [|f_equal; [|f_equal]]]].
  - apply map_ext. intros ((i, x), y). reflexivity.
  - destruct (most_stockpiles _); reflexivity.
  - apply map_ext. intros ((st, x), y). reflexivity.
  - destruct (coarseness_limits _) as [(x, y)|]; reflexivity.
  - destruct (aim_of _); reflexivity.
  - f_equal. generalize (interpolations_said s). induction (stockpile_names s) as [|n names IH]; intros [|at_ each]; try reflexivity.
    cbn [interpolations_phrases parts_interpolated]. rewrite map_app, <- IH. f_equal. unfold interpolation_phrases.
    destruct (places_of at_) eqn:At; [|cbn [map blend_phrase]; rewrite At]; reflexivity.
Qed.

Lemma parts_said s : plain_blend_statement s = true -> forallb said_at_all (blend_parts s) = true.
Proof.
  unfold plain_blend_statement, plain_question, plain_aim, blend_parts. rewrite !andb_true_iff.
  intros (((((((((((M & Sh) & K) & Mo) & Co) & (A & _)) & _) & _) & Si) & _) & I) & _). cbv zeta.
  rewrite !forallb_app, !andb_true_iff. repeat split.
  - cbn. rewrite M. reflexivity.
  - rewrite forallb_forall in *. intros p In. apply in_map_iff in In as (((i, x), y) & <- & In). specialize (Sh _ In). cbv beta iota in Sh.
    cbn. destruct (numbered i _); [exact Sh | discriminate Sh].
  - destruct (most_stockpiles _); [cbn; rewrite K|]; reflexivity.
  - rewrite forallb_forall in *. intros p In. apply in_map_iff in In as (((st, x), y) & <- & In). exact (Mo _ In).
  - destruct (coarseness_limits _) as [(x, y)|]; [cbn; rewrite Co|]; reflexivity.
  - destruct (aim_of _); cbn in *; rewrite ?A; reflexivity.
  - cbn. rewrite Si. reflexivity.
  - clear Sh. revert I. generalize (interpolations_said s). induction (stockpile_names s) as [|n names IH];
      intros [|at_ each] I; try reflexivity.
    cbn [forallb] in I. apply andb_prop in I as (I & Is). cbn [parts_interpolated]. rewrite forallb_app, (IH each Is), andb_true_r.
    destruct (places_of at_) eqn:P; [reflexivity|]. cbn [forallb said_at_all]. rewrite I, P. reflexivity.
Qed.

(* ---- From the parts to the question -------------------------------------------------------------------- *)

Definition kind_of (p : blend_part) : nat :=
  match p with
  | InSteps _ => 0 | ShareOf _ _ _ => 1 | AtMost _ => 2 | ModulusOf _ _ _ => 3 | FactorOf _ _ => 4
  | CostsOf _ | TargetsOf _ => 5 | SievesOf _ => 6 | InterpolatedIn _ _ => 7
  end.

Lemma of_kind k ps : forall k', (forall p, In p ps -> kind_of p = k') ->
  filter (fun p => Nat.eqb (kind_of p) k) ps = if Nat.eqb k' k then ps else [].
Proof.
  induction ps as [|p ps IH]; intros k' K; cbn [filter]; [destruct (Nat.eqb k' k); reflexivity|].
  rewrite (K p (or_introl eq_refl)), (IH k' (fun q I => K q (or_intror I))). destruct (Nat.eqb k' k); reflexivity.
Qed.

Lemma interpolated_kind names : forall each p, In p (parts_interpolated names each) ->
  exists name at_, p = InterpolatedIn name at_ /\ In name names.
Proof.
  induction names as [|n names IH]; intros [|at_ each] p I; try destruct I. cbn [parts_interpolated] in I. apply in_app_iff in I as [I|I].
  - destruct (places_of at_); [destruct I|]. destruct I as [<-|[]]. exists n, at_. split; [reflexivity | left; reflexivity].
  - destruct (IH each p I) as (name & b & -> & N). exists name, b. split; [reflexivity | right; exact N].
Qed.

(* The parts of one kind. *)
Definition nth_kind (s : blend_statement) (k : nat) : list blend_part :=
  let q := question_said s in
  match k with
  | 0 => [InSteps (steps q)]
  | 1 => map (share_part (stockpile_names s)) (share_limits q)
  | 2 => match most_stockpiles q with Some K => [AtMost K] | None => [] end
  | 3 => map modulus_part (modulus_limits q)
  | 4 => match coarseness_limits q with Some (x, y) => [FactorOf x y] | None => [] end
  | 5 => parts_of_aim (aim_of q)
  | 6 => [SievesOf (sieves_said s)]
  | _ => parts_interpolated (stockpile_names s) (interpolations_said s)
  end%nat.

Lemma kinds s k p : In p (nth_kind s k) -> (k <= 7)%nat -> kind_of p = k.
Proof.
  intros I K. destruct k as [|[|[|[|[|[|[|[|k]]]]]]]]; cbn [nth_kind] in I.
  - destruct I as [<-|[]]. reflexivity.
  - apply in_map_iff in I as (((i, x), y) & <- & _). reflexivity.
  - destruct (most_stockpiles _); [destruct I as [<-|[]]; reflexivity | destruct I].
  - apply in_map_iff in I as (((st, x), y) & <- & _). reflexivity.
  - destruct (coarseness_limits _) as [(x, y)|]; [destruct I as [<-|[]]; reflexivity | destruct I].
  - destruct (aim_of _); cbn in I; try destruct I as [<-|[]]; (reflexivity || destruct I).
  - destruct I as [<-|[]]. reflexivity.
  - apply interpolated_kind in I as (name & at_ & -> & _). reflexivity.
  - lia.
Qed.

Lemma parts_of_kind s k : (k <= 7)%nat -> filter (fun p => Nat.eqb (kind_of p) k) (blend_parts s) = nth_kind s k.
Proof.
  intro K. change (blend_parts s) with
    (nth_kind s 0 ++ nth_kind s 1 ++ nth_kind s 2 ++ nth_kind s 3 ++ nth_kind s 4 ++ nth_kind s 5 ++ nth_kind s 6 ++ nth_kind s 7)%list.
  assert (forall m, (m <= 7)%nat -> filter (fun p => Nat.eqb (kind_of p) k) (nth_kind s m) = if Nat.eqb m k then nth_kind s m else []) as F.
  { intros m M. apply of_kind. intros p I. exact (kinds s m p I M). }
  rewrite !filter_app, !F by lia. destruct k as [|[|[|[|[|[|[|[|k]]]]]]]]; cbn [Nat.eqb app]; rewrite ?app_nil_r; try reflexivity. lia.
Qed.

Lemma numbered_in {A} (l : list A) : forall i x, numbered i l = Some x -> In x l /\ (1 <= i)%Z.
Proof.
  induction l as [|y l IH]; intros i x H; cbn [numbered] in H; [discriminate|]. destruct (Z.eqb_spec i 1).
  - injection H as ->. split; [left; reflexivity | lia].
  - apply IH in H as (I & L). split; [right; exact I | lia].
Qed.

(* A name that is there once tells its number. *)
Lemma same_numbered {A} (l : list A) : NoDup l -> forall i j x, numbered i l = Some x -> numbered j l = Some x -> i = j.
Proof.
  induction 1 as [|y l N D IH]; intros i j x I J; cbn [numbered] in I, J; [discriminate|].
  destruct (Z.eqb_spec i 1), (Z.eqb_spec j 1).
  - congruence.
  - injection I as ->. apply numbered_in in J as (J & _). contradiction.
  - injection J as ->. apply numbered_in in I as (I & _). contradiction.
  - assert (i - 1 = j - 1)%Z by exact (IH _ _ _ I J). lia.
Qed.

Definition names_share (stockpiles : list string) (limit : Z * Q * Q) : bool :=
  let '(i, x, y) := limit in match numbered i stockpiles with Some _ => both_from_0 x y | None => false end.

Lemma same_shares names ls : NoDup names -> forall ls', forallb (names_share names) ls = true -> forallb (names_share names) ls' = true ->
  map (share_part names) ls = map (share_part names) ls' -> ls = ls'.
Proof.
  intro D. induction ls as [|((i, x), y) ls IH]; intros [|((i', x'), y') ls'] P P' E; try discriminate E; [reflexivity|].
  cbn [forallb names_share] in P, P'. apply andb_prop in P as (P & Ps), P' as (P' & Ps'). cbn [map share_part] in E.
  injection E as N -> -> E. unfold name_of in N. destruct (numbered i names) as [n|] eqn:I; [|discriminate P].
  destruct (numbered i' names) as [n'|] eqn:I'; [|discriminate P']. subst n'. rewrite (same_numbered names D _ _ _ I I').
  f_equal. exact (IH _ Ps Ps' E).
Qed.

Lemma same_interpolations names : NoDup names -> forall each each', List.length each = List.length names ->
  List.length each' = List.length names -> parts_interpolated names each = parts_interpolated names each' -> each = each'.
Proof.
  induction 1 as [|n names N D IH]; intros [|a each] [|b each'] L L' E; try discriminate L; try discriminate L'; [reflexivity|].
  injection L as L. injection L' as L'. cbn [parts_interpolated] in E.
  assert (forall at_ each ps, InterpolatedIn n at_ :: ps <> parts_interpolated names each) as No.
  { intros at_ l ps H. assert (In (InterpolatedIn n at_) (parts_interpolated names l)) as I by (rewrite <- H; left; reflexivity).
    apply interpolated_kind in I as (name & c & [= <- _] & I). contradiction. }
  assert (forall c, places_of c = [] -> c = Interpolation [] false false) as Nowhere.
  { intros [[|x xs] [] []] P; try discriminate P; reflexivity. }
  destruct (places_of a) eqn:A, (places_of b) eqn:B; cbn [app] in E.
  - rewrite (Nowhere a A), (Nowhere b B). f_equal. exact (IH _ _ L L' E).
  - symmetry in E. exfalso. exact (No _ _ _ E).
  - exfalso. exact (No _ _ _ E).
  - injection E as -> E. f_equal. exact (IH _ _ L L' E).
Qed.

(* ---- The claim ----------------------------------------------------------------------------------------- *)

Lemma same_stockpiles names names' s t :
  joined ", " (map_all in_quotes names) ++ String " " s = joined ", " (map_all in_quotes names') ++ String " " t -> names = names' /\ s = t.
Proof.
  unfold map_all. rewrite !map_all_map. intro E.
  apply (same_lists string in_quotes (fun _ => True) (Ascii.eqb quote)) in E as (-> & E); trivial; try reflexivity.
  - injection E as ->. auto.
  - intros x y u v _ _ _ _. apply same_names.
  - intros x _. unfold in_quotes. eexists quote, _. split; reflexivity.
  - apply Forall_forall. auto.
  - apply Forall_forall. auto.
Qed.

Definition kind_of_aim (a : aim) : nat :=
  match a with NoAim => 0 | Cost _ => 1 | Deviation _ => 2 | MaxDeviation _ => 3 | Squares _ => 4 end.

Definition value_phrase (s : blend_statement) : string :=
  if has_aim (aim_of (question_said s)) then
    ", and none has a lower " ++ aim_phrase (aim_of (question_said s)) ++ " than its " ++ show_rational (value_said s)
  else "".

Lemma same_value_phrases s s' u v : let a := aim_of (question_said s) in let a' := aim_of (question_said s') in
  (if has_aim a then from_0 (value_said s) else same_number (value_said s) 0) = true ->
  (if has_aim a' then from_0 (value_said s') else same_number (value_said s') 0) = true ->
  value_phrase s ++ String " " u = value_phrase s' ++ String " " v ->
  kind_of_aim a = kind_of_aim a' /\ value_said s = value_said s' /\ u = v.
Proof.
  cbv zeta. intros V V' E. unfold value_phrase in E.
  assert (has_aim (aim_of (question_said s)) = false -> kind_of_aim (aim_of (question_said s)) = 0%nat) as K
    by (destruct (aim_of (question_said s)); (discriminate || reflexivity)).
  assert (has_aim (aim_of (question_said s')) = false -> kind_of_aim (aim_of (question_said s')) = 0%nat) as K'
    by (destruct (aim_of (question_said s')); (discriminate || reflexivity)).
  destruct (has_aim (aim_of (question_said s))) eqn:A, (has_aim (aim_of (question_said s'))) eqn:A'; try discriminate E.
  - rewrite !append_associates in E. apply same_after in E.
    assert (kind_of_aim (aim_of (question_said s)) = kind_of_aim (aim_of (question_said s')) /\
      show_rational (value_said s) ++ String " " u = show_rational (value_said s') ++ String " " v) as (Kind & E').
    { destruct (aim_of (question_said s)), (aim_of (question_said s')); try discriminate A; try discriminate A'; try discriminate E;
        apply same_after, same_after in E; auto. }
    apply same_rationals in E' as (Same & E'); trivial. injection E' as ->. auto.
  - apply same_number_ok in V, V'. injection E as ->. rewrite K, K', V, V' by reflexivity. auto.
Qed.

(* ---- The line ------------------------------------------------------------------------------------------ *)

Lemma same_size_length {A B} (l : list A) (m : list B) : (size l =? size m)%Z = true -> List.length l = List.length m.
Proof. rewrite Z.eqb_eq, !size_is_length. lia. Qed.

Lemma nobody_twice names : given_twice names = None -> NoDup names.
Proof.
  induction names as [|n names IH]; intro H; constructor; cbn [given_twice] in H; destruct (existsb _ _) eqn:E; try discriminate H.
  - intro I. enough (existsb (String.eqb n) names = true) by congruence. apply existsb_exists. exists n. split; [exact I|].
    apply String.eqb_refl.
  - exact (IH H).
Qed.

Lemma plain_names_differ s : plain_blend_statement s = true -> NoDup (stockpile_names s).
Proof.
  unfold plain_blend_statement. rewrite !andb_true_iff. intros (_ & H). apply nobody_twice. destruct (given_twice _); [discriminate H|].
  reflexivity.
Qed.

Theorem blend_line_determines s s' : plain_blend_statement s = true -> plain_blend_statement s' = true ->
  blend_line s = blend_line s' -> s = s'.
Proof.
  intros P P' E. pose proof (plain_names_differ s P) as D. pose proof (parts_said s P) as Said. pose proof (parts_said s' P') as Said'.
  unfold blend_line in E. rewrite !phrases_of_parts in E.
  unfold plain_blend_statement in P, P'. rewrite !andb_true_iff in P, P'.
  destruct P as ((((((Q & N) & V) & _) & L) & _) & _), P' as ((((((Q' & N') & V') & _) & L') & _) & _).
  apply same_size_length in L, L'. unfold plain_question, plain_aim in Q, Q'. rewrite !andb_true_iff in Q, Q'.
  destruct Q as (((((_ & Sh) & _) & _) & _) & (_ & Ai)), Q' as (((((_ & Sh') & _) & _) & _) & (_ & Ai')).
  assert (claim_said s = claim_said s' /\ stockpile_names s = stockpile_names s' /\ specification_name s = specification_name s' /\
    (claim_said s <> None -> kind_of_aim (aim_of (question_said s)) = kind_of_aim (aim_of (question_said s'))) /\
    value_said s = value_said s' /\ blend_parts s = blend_parts s') as (Claim & Names & Spec & Kind & Value & Parts).
  { assert (joined "; " (map blend_phrase (blend_parts s)) ++ ")" = joined "; " (map blend_phrase (blend_parts s')) ++ ")" ->
      blend_parts s = blend_parts s') as Parts by (intro H; apply same_blend_parts in H; trivial; discriminate).
    set (said := joined "; " (map blend_phrase (blend_parts s)) ++ ")") in *.
    set (said' := joined "; " (map blend_phrase (blend_parts s')) ++ ")") in *. clearbody said said'.
    apply same_after in E. unfold claim_phrase in E. cbv zeta in E. fold (value_phrase s) in E. fold (value_phrase s') in E.
    destruct (claim_said s) as [ns|], (claim_said s') as [ns'|]; rewrite ?append_associates in E; try discriminate E.
    - apply same_after, (same_steps _ _ ("steps of " ++ _) ("steps of " ++ _)) in E as (-> & E); trivial. apply same_after in E.
      apply (same_stockpiles _ _ ("keeps the limits of " ++ _) ("keeps the limits of " ++ _)) in E as (Names & E).
      apply same_after, same_names in E as (Spec' & E).
      apply (same_value_phrases s s' ("(" ++ said) ("(" ++ said')) in E as (Kind & Value & E); trivial. apply same_after in E.
      repeat (split; [now auto|]). exact (Parts E).
    - apply same_after in E. apply (same_stockpiles _ _ ("keeps the limits of " ++ _) ("keeps the limits of " ++ _)) in E as (Names & E).
      apply same_after, same_names in E as (Spec' & E). apply same_after in E. apply same_number_ok in V, V'. rewrite V, V'.
      split; [reflexivity|]. split; [exact Names|]. split; [exact Spec'|]. split; [intro H; destruct (H eq_refl)|].
      split; [reflexivity | exact (Parts E)]. }
  assert (forall k, (k <= 7)%nat -> nth_kind s k = nth_kind s' k) as Each
    by (intros k K; rewrite <- !parts_of_kind, Parts by exact K; reflexivity).
  pose proof (Each 0%nat ltac:(lia)) as E0. pose proof (Each 1%nat ltac:(lia)) as E1. pose proof (Each 2%nat ltac:(lia)) as E2.
  pose proof (Each 3%nat ltac:(lia)) as E3. pose proof (Each 4%nat ltac:(lia)) as E4. pose proof (Each 5%nat ltac:(lia)) as E5.
  pose proof (Each 6%nat ltac:(lia)) as E6. pose proof (Each 7%nat ltac:(lia)) as E7. clear Each Parts Said Said' E N N' V V'.
  destruct s as [spec names q claim v sieves each], s' as [spec' names' q' claim' v' sieves' each'].
  cbn [specification_name stockpile_names question_said claim_said value_said sieves_said interpolations_said] in *.
  subst spec' names' claim' v'.
  cbn [nth_kind stockpile_names question_said sieves_said interpolations_said] in *.
  apply (same_interpolations names D each each' L L') in E7 as <-. injection E6 as <-. f_equal.
  apply (same_shares names (share_limits q) D) in E1; trivial.
  destruct q as [M shares K moduli factor a], q' as [M' shares' K' moduli' factor' a'].
  cbn [steps share_limits most_stockpiles modulus_limits coarseness_limits aim_of] in *. injection E0 as <-. subst shares'. f_equal.
  - destruct K, K'; try discriminate E2; [injection E2 as ->|]; reflexivity.
  - revert moduli' E3. induction moduli as [|((st, x), y) moduli IH];
      intros [|((st', x'), y') moduli'] E3; try discriminate E3; [reflexivity|].
    cbn [map modulus_part] in E3. injection E3 as -> -> -> E3. f_equal. exact (IH _ E3).
  - destruct factor as [(x, y)|], factor' as [(x', y')|]; try discriminate E4; [injection E4 as -> ->|]; reflexivity.
  - destruct claim as [ns|].
    + specialize (Kind ltac:(discriminate)).
      destruct a, a'; try discriminate Kind; try discriminate E5; try (injection E5 as ->); reflexivity.
    + destruct a, a'; try discriminate Ai; try discriminate Ai'; try discriminate E5; try (injection E5 as ->); reflexivity.
Qed.

(* So a line is true of files if its only statement is. *)
Theorem true_of_its_blend_statement specification stockpiles s : plain_blend_statement s = true ->
  (true_of_blend_line specification stockpiles (blend_line s) <-> is_true_of_blend specification stockpiles s).
Proof.
  intro P. split; [|intro T; exists s; auto]. intros (s' & P' & E & T). rewrite (blend_line_determines _ _ P P' E). exact T.
Qed.
