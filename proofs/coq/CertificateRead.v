(* A certificate is read as it is printed. *)

From Coq Require Import ZArith QArith Qreduction Qcanon List Bool String Ascii FMapPositive Lia.
From Mdm Require Import Numbers Certificate Text Decimals Document CertificateText NumberTexts.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- Numbers that can be printed ------------------------------------------------------------------- *)

Definition plain_integer (n : Z) : Prop := 0 <= n /\ text_length (show_integer n) <= most_digits.
Definition plain_index (j : Z) : Prop := 0 <= j /\ text_length (show_integer j) <= 18.
Definition plain_decimal (x : Q) : Prop :=
  0 <= Qnum x /\ is_decimal x /\ Qred x = x /\ text_length (show_decimal x) <= most_digits.
Definition plain_rational (x : Q) : Prop :=
  0 <= Qnum x /\ Qred x = x /\ text_length (show_integer (Qnum x)) <= most_digits /\
  text_length (show_integer (Zpos (Qden x))) <= most_digits.

Lemma at_mark_numeral mark w n length : digit mark = None -> numeral w n length -> forall rest,
  at_mark mark (w ++ rest) = let (before, after) := at_mark mark rest in (w ++ before, after).
Proof.
  intro K. induction 1 as [|ch d w n length E D N IH]; intro rest.
  - change ("" ++ rest) with rest. destruct (at_mark mark rest). reflexivity.
  - change (String ch w ++ rest) with (String ch (w ++ rest)). cbn [at_mark].
    destruct (Ascii.eqb_spec ch mark) as [->|S]; [congruence|]. rewrite IH.
    destruct (at_mark mark rest). reflexivity.
Qed.

Lemma at_mark_integer mark n : digit mark = None -> 0 <= n ->
  at_mark mark (show_integer n) = (show_integer n, None) /\
  forall rest, at_mark mark (show_integer n ++ String mark rest) = (show_integer n, Some rest).
Proof.
  intros K P. destruct (show_integer_numeral n P) as (l & _ & N & _). split.
  - pose proof (at_mark_numeral mark _ _ _ K N "") as A. cbn [at_mark] in A. rewrite append_empty in A. exact A.
  - intro rest. rewrite (at_mark_numeral mark _ _ _ K N). cbn [at_mark]. rewrite Ascii.eqb_refl, append_empty. reflexivity.
Qed.

Lemma rational_read x : plain_rational x -> rational (show_rational x) = Some x.
Proof.
  intros (P & R & Bn & Bd). destruct x as (n, d). cbn [Qnum Qden] in *. unfold show_rational, rational. cbn [Qnum Qden].
  destruct (at_mark_integer "/" n eq_refl P) as (Whole & Parts).
  destruct (Z.eqb_spec (Zpos d) 1) as [D|D].
  - rewrite Whole, whole_read by assumption. injection D as ->. reflexivity.
  - change ("/" ++ show_integer (Zpos d)) with (String "/" (show_integer (Zpos d))).
    rewrite Parts, !whole_read by (assumption || lia). unfold check.
    assert (Z.gcd n (Zpos d) = 1) as G.
    { pose proof (Qred_iff (n # d)) as I. cbn [Qnum Qden] in I. apply I, R. }
    rewrite (proj2 (Z.leb_le 2 (Zpos d))), G by lia. reflexivity.
Qed.

Lemma number_integer least n : plain_integer n -> least <= n -> number (Integer least) (show_integer n) = Some (of_integer n).
Proof.
  intros (P & B) L. unfold number. rewrite whole_read by assumption. cbn [option_map]. unfold check, at_most, of_integer.
  cbn [Qnum Qden]. rewrite (proj2 (Z.leb_le _ _)) by lia. reflexivity.
Qed.

Lemma number_positive x : plain_decimal x -> 0 < Qnum x -> number Positive (show_decimal x) = Some x.
Proof.
  intros (P & D & R & B) L. unfold number. rewrite decimal_read by assumption. unfold check, less. cbn [Qnum Qden].
  rewrite (proj2 (Z.ltb_lt _ _)) by lia. reflexivity.
Qed.

Lemma number_not_negative x : plain_decimal x -> number NotNegative (show_decimal x) = Some x.
Proof. intros (P & D & R & B). apply decimal_read; assumption. Qed.

Lemma number_percent most x :
  plain_decimal x -> at_most x (of_integer most) = true -> number (Percent most) (show_decimal x) = Some x.
Proof. intros (P & D & R & B) L. unfold number. rewrite decimal_read by assumption. unfold check. rewrite L.
reflexivity. Qed.

Lemma number_rational x : plain_rational x -> 0 < Qnum x -> number Rational (show_rational x) = Some x.
Proof.
  intros H L. unfold number. rewrite rational_read by assumption. unfold check, less. cbn [Qnum Qden].
  rewrite (proj2 (Z.ltb_lt _ _)) by lia. reflexivity.
Qed.

Lemma class_index_read j : plain_index j -> class_index (show_integer j) = Some j.
Proof. intros (P & B). apply whole_read; assumption. Qed.

(* One class, or consecutive ones. *)
Definition plain_range (i j : Z) : Prop := plain_index i /\ plain_index j /\ i <= j.

Lemma class_range_read i j : plain_range i j -> class_range (range_word i j) = Some (i, j).
Proof.
  intros (I & J & L). unfold class_range, range_word. destruct (at_mark_integer "-" i eq_refl (proj1 I)) as (Whole & Parts).
  destruct (Z.eqb_spec i j) as [->|N].
  - rewrite Whole, class_index_read by exact J. reflexivity.
  - change (show_integer i ++ "-" ++ show_integer j) with (show_integer i ++ String "-" (show_integer j)).
    rewrite Parts, !class_index_read by assumption. unfold check. rewrite (proj2 (Z.ltb_lt _ _)) by lia. reflexivity.
Qed.

(* ---- Lines ------------------------------------------------------------------------------------------- *)

Open Scope list_scope.

(* The lines are none, or the first has this name. *)
Definition headed (name : string) (l : lines) : Prop :=
  match l with [] => True | x :: _ => exists ws, x = name :: ws end.

Lemma named_headed name other l rest :
  headed other l -> String.eqb other name = false -> named name rest = false -> named name (l ++ rest) = false.
Proof. destruct l as [|x l]; simpl; [trivial|]. intros (ws & ->) E _. exact E. Qed.

(* No line, or one with the numbers. *)
Definition says (name : string) (ks : list kind) (l : lines) (xs : list Q) : Prop :=
  (l = [] /\ xs = []) \/ exists ws, l = [name :: ws] /\ numbers ks ws = Some xs.

Lemma says_headed name ks l xs : says name ks l xs -> headed name l.
Proof. intros [(-> & _)|(ws & -> & _)]; simpl; eauto. Qed.

Lemma required_read name ks ws xs rest : numbers ks ws = Some xs -> required name ks ((name :: ws) :: rest) = Ok (xs, rest).
Proof. intro H. unfold required. rewrite String.eqb_refl, H. reflexivity. Qed.

Lemma optional_read name ks l xs rest :
  says name ks l xs -> named name rest = false -> optional name ks (l ++ rest) = Ok (xs, rest).
Proof.
  intros [(-> & ->)|(ws & -> & H)] A; unfold optional; simpl app.
  - rewrite A. reflexivity.
  - cbn [named]. rewrite String.eqb_refl. apply required_read, H.
Qed.

(* ---- Tolerances ------------------------------------------------------------------------------------- *)

Definition plain_percent (most : Z) (x : Q) : Prop := plain_decimal x /\ at_most x (of_integer most) = true.

Lemma percent_no_word most x : plain_percent most x -> show_decimal x <> "file".
Proof. intros ((P & D & R & B) & _) E. pose proof (decimal_read x P D R B) as H. rewrite E in H. discriminate H. Qed.

Lemma is_line_not_named name ws ls : named name ls = false -> is_line (name :: ws) ls = false.
Proof.
  destruct ls as [|[|w l] ls]; [reflexivity| |]; unfold is_line; intro H.
  - destruct (list_eq_dec string_dec [] (name :: ws)); [discriminate | reflexivity].
  - destruct (list_eq_dec string_dec (w :: l) (name :: ws)) as [E|]; [|reflexivity].
    injection E as -> _. cbn [named] in H. rewrite String.eqb_refl in H. discriminate.
Qed.

Lemma is_line_same l ls : is_line l (l :: ls) = true.
Proof. unfold is_line. destruct (list_eq_dec string_dec l l); congruence. Qed.

Lemma is_line_other l m ls : m <> l -> is_line l (m :: ls) = false.
Proof. unfold is_line. intro. destruct (list_eq_dec string_dec m l); congruence. Qed.

Definition to_list {A} (x : option A) : list A := match x with Some x => [x] | None => [] end.

Lemma first_to_list x : first (to_list x) = x.
Proof. destruct x; reflexivity. Qed.

Lemma retained_read name (e : option Q) (file : bool) rest :
  (forall x, e = Some x -> plain_percent 100 x) -> named name rest = false ->
  let numbered := if_some e (fun e => [name; show_decimal e]) in
  let of_file := if_true file [name; "file"] in
  unless_file name [Percent 100] (numbered ++ of_file ++ rest) = Ok (to_list e, (of_file ++ rest)%list) /\
  words name "file" (of_file ++ rest) = Ok (file, rest).
Proof.
  intros P A. cbv zeta. split.
  - unfold unless_file. destruct e as [x|]; simpl if_some; simpl to_list.
    + specialize (P x eq_refl). simpl app. rewrite is_line_other by (intros [= H]; exact (percent_no_word 100 x P H)).
      unfold optional. cbn [named]. rewrite String.eqb_refl. apply required_read. cbn [numbers].
      rewrite number_percent by apply P. reflexivity.
    + destruct file; simpl app.
      * rewrite is_line_same. reflexivity.
      * rewrite is_line_not_named by exact A. unfold optional. rewrite A. reflexivity.
  - unfold words. destruct file; simpl app.
    + rewrite is_line_same. reflexivity.
    + rewrite is_line_not_named by exact A. reflexivity.
Qed.

Lemma rev'_rev {A} (l : list A) : rev' l = rev l.
Proof. unfold rev'. rewrite rev_append_rev, app_nil_r. reflexivity. Qed.

Lemma all_words_read {A B} (read : string -> option A) (show : B -> string) (value : B -> A) (xs : list B) :
  (forall x, In x xs -> read (show x) = Some (value x)) ->
  forall done, all_words read (map show xs) done = Some (rev done ++ map value xs)%list.
Proof.
  induction xs as [|x xs IH]; intros H done; simpl.
  - rewrite rev'_rev, app_nil_r. reflexivity.
  - rewrite H by (left; reflexivity). rewrite IH by (intros; apply H; right; assumption). simpl. rewrite <- app_assoc.
    reflexivity.
Qed.

Lemma percents_read es rest :
  (forall e, In e es -> plain_percent 100 e) -> named "passing-each" rest = false ->
  percents (each_lines es ++ rest) = Ok (es, rest).
Proof.
  intros P A. destruct es as [|e es]; simpl app.
  - destruct rest as [|[|w l] rest]; simpl in *; trivial. rewrite A. reflexivity.
  - unfold percents. change (String.eqb "passing-each" "passing-each") with true. cbn [negb map]. cbv iota.
    pose proof (all_words_read (number (Percent 100)) show_decimal (fun x => x) (e :: es)) as H. rewrite map_id in H.
    cbn [map] in H. rewrite H by (intros x I; apply number_percent; apply (P x I)). reflexivity.
Qed.

Definition plain_limit (l : Q * Q * Q) : Prop :=
  let '(x, least, most) := l in plain_decimal x /\ plain_decimal least /\ plain_decimal most.

Fixpoint limits_ascend (ls : list (Q * Q * Q)) (before : option Q) : Prop :=
  match ls with
  | [] => True
  | (x, _, _) :: ls => match before with Some y => less y x = true | None => True end /\ limits_ascend ls (Some x)
  end.

Lemma bands_read ls rest : named "band" rest = false -> forall done,
  (forall l, In l ls -> plain_limit l) ->
  limits_ascend ls (match done with (x, _, _) :: _ => Some x | [] => None end) ->
  bands (map band_line ls ++ rest) done = Ok ((rev done ++ ls)%list, rest).
Proof.
  intro A. induction ls as [|((x, least), most) ls IH]; intros done P C; simpl map; simpl app.
  - rewrite app_nil_r. destruct rest as [|[|w l] rest]; simpl in *; rewrite rev'_rev; trivial. rewrite A. reflexivity.
  - cbn [bands band_line]. change (String.eqb "band" "band") with true. cbn [negb numbers]. cbv iota.
    destruct (P _ (or_introl eq_refl)) as (Px & Pl & Pm). rewrite !number_not_negative by assumption.
    destruct C as (C & C').
    assert ((match done with (before, _, _) :: _ => less before x | [] => true end) = true) as ->
      by (destruct done as [|((y, ?), ?) ?]; auto).
    cbv iota. rewrite IH; [|intros; apply P; right; assumption | exact C']. simpl. rewrite <- app_assoc. reflexivity.
Qed.

Definition plain_tolerances (t : tolerances) : Prop :=
  (forall e, retained_each t = Some e -> plain_percent 100 e) /\
  (forall e, passing_all t = Some e -> plain_percent 100 e) /\
  (forall e, In e (passing_each t) -> plain_percent 100 e) /\
  (forall e, total t = Some e -> plain_percent 200 e) /\
  (forall l, In l (band t) -> plain_limit l) /\ limits_ascend (band t) None /\
  size (passing_each t) <= 3 * most_rows /\ size (band t) <= most_rows /\
  t <> Tolerances None false None false [] None [].

Lemma says_percent name most (e : option Q) :
  (forall x, e = Some x -> plain_percent most x) ->
  says name [Percent most] (if_some e (fun e => [name; show_decimal e])) (to_list e).
Proof.
  intro P. destruct e as [x|]; [right | left; split; reflexivity]. exists [show_decimal x]. split; [reflexivity|].
  cbn [numbers]. rewrite number_percent by apply (P x eq_refl). reflexivity.
Qed.

Lemma headed_some {A} name (x : option A) ws : headed name (if_some x (fun x => name :: ws x)).
Proof. destruct x; simpl; eauto. Qed.
Lemma headed_true name holds ws : headed name (if_true holds (name :: ws)).
Proof. destruct holds; simpl; eauto. Qed.
Lemma headed_each es : headed "passing-each" (each_lines es).
Proof. destruct es; simpl; eauto. Qed.
Lemma headed_bands ls : headed "band" (map band_line ls).
Proof. destruct ls as [|((x, l), h) ls]; simpl; eauto. Qed.

Create HintDb headed_lines discriminated.
#[local] Hint Resolve headed_some headed_true headed_each headed_bands says_headed : headed_lines.

(* That what follows does not begin with a name, part by part. *)
Ltac absent :=
  repeat (eapply named_headed; [solve [eauto with headed_lines] | reflexivity |]); try reflexivity; try assumption.

Lemma tolerances_read t rest :
  plain_tolerances t -> (exists ws ls, rest = ("particles" :: ws) :: ls) ->
  read_tolerances (tolerance_lines t false ++ rest) = Ok (Some t, rest).
Proof.
  intros (Pr & Pp & Pe & Pt & Pb & Ba & Se & Sb & None_) (ws & ls & ->). destruct t as [r rf p pf each tot bd].
  cbn [retained_each retained_file passing_all passing_file passing_each total band] in *.
  unfold read_tolerances, tolerance_lines.
  cbn [retained_each retained_file passing_all passing_file passing_each total band].
  rewrite <- !app_assoc. set (rest := ("particles" :: ws) :: ls).
  edestruct (retained_read "retained" r rf) as (E1 & E2); [exact Pr | | rewrite E1; cbn [bind]; rewrite E2; cbn [bind]].
  { absent. }
  edestruct (retained_read "passing" p pf) as (E3 & E4); [exact Pp | | rewrite E3; cbn [bind]; rewrite E4; cbn [bind]].
  { absent. }
  rewrite percents_read; [|exact Pe|absent]. cbn [bind].
  rewrite (optional_read "total" [Percent 200] _ (to_list tot)); [|apply says_percent, Pt|absent]. cbn [bind].
  rewrite bands_read; [|reflexivity|exact Pb|exact Ba]. cbn [bind app rev].
  rewrite (proj2 (Z.leb_le _ _) Se), (proj2 (Z.leb_le _ _) Sb). cbn [andb demand_form bind].
  rewrite !first_to_list.
  destruct r, rf, p, pf, each, tot, bd; try reflexivity. contradiction None_. reflexivity.
Qed.

Lemma no_tolerances_read rest :
  (exists ws ls, rest = ("particles" :: ws) :: ls) -> read_tolerances rest = Ok (None, rest).
Proof.
  intros (ws & ls & ->). unfold read_tolerances, unless_file, words.
  rewrite !is_line_not_named by reflexivity. unfold optional. cbn [named].
  change (String.eqb "particles" "retained") with false. change (String.eqb "particles" "passing") with false.
  change (String.eqb "particles" "total") with false. cbn [bind]. rewrite !is_line_not_named by reflexivity.
  reflexivity.
Qed.

(* ---- The question ----------------------------------------------------------------------------------- *)

Definition plain_positive (x : Q) : Prop := plain_decimal x /\ 0 < Qnum x.

Definition plain_solids (q : question) (box : option (Q * Q * Q * Q)) : Prop :=
  match solids_of q with
  | Anything => box = None
  | Cylinder d h e =>
    (a q = 3 /\ b q = 1) /\ box = None /\ plain_positive d /\ plain_positive h /\ plain_decimal e
  | Volume v p r =>
    (a q = 3 /\ b q = 1) /\ plain_positive p /\ plain_positive r /\ bounds_of_pi p r = true /\
    match box with
    | None => plain_positive v
    | Some (x, y, z, e) =>
      plain_positive x /\ plain_positive y /\ plain_positive z /\ plain_decimal e /\ v = volume_of_box x y z e
    end
  end.

Definition plain_question (q : question) (box : option (Q * Q * Q * Q)) : Prop :=
  1 <= a q <= 1000 /\ 1 <= b q <= 1000 /\ Z.gcd (a q) (b q) = 1 /\
  (forall x, pan_size q = Some x -> plain_positive x) /\
  (forall x, cut_below q = Some x -> plain_positive x) /\
  (forall x, size_factor q = Some x -> plain_positive x /\ equal x (of_integer 1) = false) /\
  plain_integer (min_per_class q) /\ (tolerances_of q = None -> min_per_class q <> 1) /\
  plain_integer (at_least q) /\ at_least q <> 1 /\ plain_solids q box /\
  (forall t, tolerances_of q = Some t -> plain_tolerances t).

Lemma says_positive name (x : option Q) :
  (forall y, x = Some y -> plain_positive y) ->
  says name [Positive] (if_some x (fun x => [name; show_decimal x])) (to_list x).
Proof.
  intro P. destruct x as [x|]; [right | left; split; reflexivity]. exists [show_decimal x]. split; [reflexivity|].
  cbn [numbers]. rewrite number_positive by apply (P x eq_refl). reflexivity.
Qed.

Lemma says_integer name least n :
  plain_integer n -> n = 0 \/ least <= n -> 1 <= least ->
  says name [Integer least] (if_true (1 <=? n) [name; show_integer n]) (if 1 <=? n then [of_integer n] else []).
Proof.
  intros P L O. destruct (Z.leb_spec 1 n); [right | left; split; reflexivity]. exists [show_integer n].
  split; [reflexivity|].
  cbn [numbers]. rewrite number_integer by (assumption || lia). reflexivity.
Qed.

Lemma integer_read n : 0 <= n -> integer (if 1 <=? n then [of_integer n] else []) = n.
Proof. intro. destruct (Z.leb_spec 1 n); [reflexivity | cbn; lia]. Qed.

(* The numbers of the four lines of solids. *)
Definition cylinder_numbers (s : solids) : list Q := match s with Cylinder d h e => [d; h; e] | _ => [] end.
Definition box_numbers (box : option (Q * Q * Q * Q)) : list Q := match box with Some (x, y, z, e) => [x; y; z; e] | None => [] end.
Definition volume_numbers (s : solids) (box : option (Q * Q * Q * Q)) : list Q :=
  match s, box with Volume v _ _, None => [v] | _, _ => [] end.
Definition pi_numbers (s : solids) : list Q := match s with Volume _ p r => [p; r] | _ => [] end.

Lemma solids_say q box : plain_solids q box ->
  says "cylinder" [Positive; Positive; NotNegative] (cylinder_lines (solids_of q)) (cylinder_numbers (solids_of q)) /\
  says "box" [Positive; Positive; Positive; NotNegative] (box_lines box) (box_numbers box) /\
  says "solids-volume" [Positive] (volume_lines (solids_of q) box) (volume_numbers (solids_of q) box) /\
  says "pi" [Positive; Positive] (pi_lines (solids_of q)) (pi_numbers (solids_of q)) /\
  read_solids (Qmake (a q) (Z.to_pos (b q))) (cylinder_numbers (solids_of q)) (box_numbers box)
    (volume_numbers (solids_of q) box) (pi_numbers (solids_of q)) = Ok (solids_of q).
Proof.
  unfold plain_solids. destruct (solids_of q) as [|d h e|v p r].
  - intros ->. repeat split; try (left; split; reflexivity).
  - intros ((A & B) & -> & (Pd & Ld) & (Ph & Lh) & Pe). rewrite A, B.
    split; [|repeat split; try (left; split; reflexivity)].
    right. eexists. split; [reflexivity|]. cbn [numbers]. rewrite !number_positive, number_not_negative by assumption.
    reflexivity.
  - intros ((A & B) & (Pp & Lp) & (Pr & Lr) & Pi & H). rewrite A, B. split; [left; split; reflexivity|].
    destruct box as [(((x, y), z), e)|].
    + destruct H as ((Px & Lx) & (Py & Ly) & (Pz & Lz) & Pe & ->). split; [|split; [left; split; reflexivity | split]].
      * right. eexists. split; [reflexivity|]. cbn [numbers].
        rewrite !number_positive, number_not_negative by assumption. reflexivity.
      * right. eexists. split; [reflexivity|]. cbn [numbers]. rewrite !number_positive by assumption. reflexivity.
      * cbn [cylinder_numbers box_numbers volume_numbers pi_numbers read_solids]. rewrite Pi. reflexivity.
    + destruct H as (Pv & Lv). split; [left; split; reflexivity|]. split; [|split].
      * right. eexists. split; [reflexivity|]. cbn [numbers]. rewrite !number_positive by assumption. reflexivity.
      * right. eexists. split; [reflexivity|]. cbn [numbers]. rewrite !number_positive by assumption. reflexivity.
      * cbn [cylinder_numbers box_numbers volume_numbers pi_numbers read_solids]. rewrite Pi. reflexivity.
Qed.

Lemma small_integer n : 0 <= n <= 1000 -> text_length (show_integer n) <= most_digits.
Proof.
  intro H. destruct (show_integer_numeral n) as (l & L & N & Z0); [lia|]. rewrite (numeral_text_length _ _ _ N).
  destruct (Z.le_gt_cases l 4) as [|G]; [unfold most_digits; lia|]. exfalso.
  destruct (show_integer n) as [|ch w] eqn:E; inversion N as [|ch' d w' m l' Ed Bd N']; subst; [lia|].
  destruct Z0 as [Z0|Z0]; [|lia]. cbn [starts_with_zero] in Z0.
  assert (d <> 0) as D.
  { intros ->. unfold digit in Ed. destruct ((0 <=? Z.of_N (N_of_ascii ch) - 48) && (Z.of_N (N_of_ascii ch) - 48 <=? 9));
      [|discriminate]. injection Ed as Ed. assert (N_of_ascii ch = 48%N) as C by lia.
    apply (f_equal ascii_of_N) in C. rewrite ascii_N_embedding in C. subst ch. discriminate Z0. }
  pose proof (numeral_bound _ _ _ N') as Bm.
  assert (10 ^ 4 <= 10 ^ l') by (apply Z.pow_le_mono_r; lia). change (10 ^ 4) with 10000 in *. nia.
Qed.

Lemma question_read q box of_file rest cert :
  plain_question q box -> asked cert = q -> (exists ws ls, rest = ("particles" :: ws) :: ls) -> of_file = false ->
  read_question (question_lines (Document cert box of_file) ++ rest) = Ok (q, rest).
Proof.
  intros (A & B & G & Pp & Pc & Pf & Pm & Nm & Pl & Nl & Ps & Pt) E R ->.
  destruct (solids_say q box Ps) as (S1 & S2 & S3 & S4 & S5).
  unfold read_question, question_lines. cbn [certificate_of box_of band_of_file]. rewrite E. rewrite <- !app_assoc.
  set (tol := match tolerances_of q with Some t => tolerance_lines t false | None => [] end).
  assert (forall name, String.eqb "particles" name = false -> String.eqb "retained" name = false ->
            String.eqb "passing" name = false -> String.eqb "passing-each" name = false -> String.eqb "total" name = false ->
            String.eqb "band" name = false -> named name (tol ++ rest) = false) as T.
  { intros name H1 H2 H3 H4 H5 H6. subst tol. destruct R as (ws & ls & ->). destruct (tolerances_of q) as [t|].
    - unfold tolerance_lines. rewrite <- !app_assoc.
      repeat (eapply named_headed; [solve [eauto with headed_lines] | assumption |]). cbn. assumption.
    - cbn. assumption. }
  simpl app at 1.
  assert (numbers [Rational] (law_words (a q) (b q)) = Some [Qmake (a q) (Z.to_pos (b q))]) as Law.
  { unfold law_words. cbn [numbers]. rewrite number_rational; [reflexivity | | cbn [Qnum]; lia].
    split; [cbn [Qnum]; lia|]. split.
    - apply Qred_identity. cbn [Qnum Qden]. rewrite Z2Pos.id by lia. exact G.
    - cbn [Qnum Qden]. rewrite Z2Pos.id by lia. split; apply small_integer; lia. }
  rewrite (required_read "law" [Rational] _ _ _ Law). cbn [bind].
  rewrite (optional_read "pan-size" [Positive] _ (to_list (pan_size q))); [|apply says_positive, Pp | absent; apply T; reflexivity].
  cbn [bind].
  rewrite (optional_read "cut-below" [Positive] _ (to_list (cut_below q))); [|apply says_positive, Pc | absent; apply T; reflexivity].
  cbn [bind].
  rewrite (optional_read "size-factor" [Positive] _ (to_list (size_factor q)));
    [|apply says_positive; intros x Ex; apply (Pf x Ex) | absent; apply T; reflexivity].
  cbn [bind].
  rewrite (optional_read "min-per-class" [Integer 1] _ (if 1 <=? min_per_class q then [of_integer (min_per_class q)] else []));
    [|apply says_integer; [exact Pm | destruct Pm; lia | lia] | absent; apply T; reflexivity].
  cbn [bind].
  rewrite (optional_read "cylinder" _ _ _ _ S1); [|absent; apply T; reflexivity]. cbn [bind].
  rewrite (optional_read "box" _ _ _ _ S2); [|absent; apply T; reflexivity]. cbn [bind].
  rewrite (optional_read "solids-volume" _ _ _ _ S3); [|absent; apply T; reflexivity]. cbn [bind].
  rewrite (optional_read "pi" _ _ _ _ S4); [|absent; apply T; reflexivity]. cbn [bind].
  rewrite (optional_read "at-least" [Integer 2] _ (if 1 <=? at_least q then [of_integer (at_least q)] else []));
    [|apply says_integer; [exact Pl | destruct Pl; lia | lia] | apply T; reflexivity].
  cbn [bind].
  assert (read_tolerances (tol ++ rest) = Ok (tolerances_of q, rest)) as RT.
  { subst tol. destruct (tolerances_of q) as [t|]; [apply tolerances_read; auto | apply no_tolerances_read; exact R]. }
  match goal with |- bind (read_tolerances ?ls) _ = _ => change ls with (tol ++ rest) end.
  rewrite RT. cbn [bind]. rewrite !integer_read by (apply Pm || apply Pl).
  cbn [integer of_integer Qnum Qden]. rewrite !first_to_list.
  rewrite (proj2 (Z.leb_le (a q) 1000)), Z2Pos.id, (proj2 (Z.leb_le (b q) 1000)) by lia.
  cbn [andb demand_form bind].
  assert ((match to_list (size_factor q) with x :: _ => negb (equal x (of_integer 1)) | [] => true end) = true) as ->.
  { destruct (size_factor q) as [x|]; [|reflexivity]. cbn. destruct (Pf x eq_refl) as (_ & ->). reflexivity. }
  assert ((match tolerances_of q with None => negb (min_per_class q =? 1) | Some _ => true end) = true) as ->.
  { destruct (tolerances_of q); [reflexivity|]. rewrite (proj2 (Z.eqb_neq _ _)) by auto. reflexivity. }
  cbn [demand_form bind]. rewrite S5. cbn [bind]. destruct q. reflexivity.
Qed.

(* ---- Witness, chain and tree ------------------------------------------------------------------------- *)

Definition plain_witness (tolerant : bool) (w : witness_line) : Prop :=
  plain_index (index w) /\ (plain_integer (count w) /\ 1 <= count w) /\
  (if tolerant then plain_rational (together w) /\ 0 < Qnum (together w) else together w = 0%Q) /\
  plain_positive (size_lo w) /\ plain_positive (size_hi w) /\ at_most (size_lo w) (size_hi w) = true.

Fixpoint classes_ascend (ws : list witness_line) (before : option Z) : Prop :=
  match ws with
  | [] => True
  | w :: ws => match before with Some i => i < index w | None => True end /\ classes_ascend ws (Some (index w))
  end.

Lemma witness_read tolerant w : plain_witness tolerant w -> witness_of tolerant (tl (class_line tolerant w)) = Some w.
Proof.
  intros (Pi & (Pc & Lc) & Pt & (Pl & Ll) & (Ph & Lh) & L). destruct w as [i n t lo hi].
  cbn [index count together size_lo size_hi] in *.
  unfold class_line, witness_of. cbn [index count together size_lo size_hi]. destruct tolerant; cbn [app tl].
  - destruct Pt as (Pt & Lt). rewrite class_index_read, number_integer, number_rational, !number_positive by assumption.
    rewrite L. reflexivity.
  - rewrite class_index_read, number_integer, !number_positive by assumption. rewrite L, Pt. reflexivity.
Qed.

Lemma witness_lines_read tolerant ws rest : named "class" rest = false -> forall done,
  (forall w, In w ws -> plain_witness tolerant w) ->
  classes_ascend ws (match done with w :: _ => Some (index w) | [] => None end) ->
  witness_lines tolerant (map (class_line tolerant) ws ++ rest) done = Ok (rev done ++ ws, rest).
Proof.
  intro A. induction ws as [|w ws IH]; intros done P C; simpl map; simpl app.
  - rewrite app_nil_r. destruct rest as [|[|x l] rest]; cbn [witness_lines]; rewrite rev'_rev; trivial.
    cbn [named] in A. rewrite A. reflexivity.
  - pose proof (witness_read tolerant w (P w (or_introl eq_refl))) as R. destruct C as (C & C').
    unfold class_line in *. cbn [app tl witness_lines] in *. change (String.eqb "class" "class") with true. cbn [negb].
    cbv iota.
    rewrite R. replace (match done with before :: _ => index before <? index w | [] => true end) with true
      by (destruct done; [reflexivity | symmetry; apply Z.ltb_lt, C]).
    rewrite IH; [|intros; apply P; right; assumption | exact C']. simpl. rewrite <- app_assoc. reflexivity.
Qed.

Definition plain_multiple (ls : letters) (m : multiple) : Prop :=
  (plain_integer (times_m m) /\ 1 <= times_m m) /\
  if of_class m =? 0 then one_of (letter m) (of_all ls) = true /\ up_to m = 0
  else plain_range (of_class m) (up_to m) /\
       one_of (letter m) (if of_class m =? up_to m then of_single ls else of_several ls) = true.

Lemma condition_read ls m :
  plain_multiple ls m -> condition_of ls (condition_word m) = Some (letter m, of_class m, up_to m).
Proof.
  intros (_ & P). unfold condition_word, condition_of. destruct (Z.eqb_spec (of_class m) 0) as [E|E].
  - destruct P as (P & U). rewrite P, E, U. reflexivity.
  - destruct P as (J & O). pose proof (class_range_read _ _ J) as R. destruct J as ((N & B) & _).
    destruct (show_integer_numeral (of_class m) N) as (l & L & W & _).
    destruct (range_word (of_class m) (up_to m)) as [|ch w] eqn:S.
    { exfalso. unfold range_word in S. destruct (show_integer (of_class m)) as [|c u]; [inversion W; lia|].
      destruct (of_class m =? up_to m); discriminate S. }
    rewrite R, O. unfold check. rewrite (proj2 (Z.ltb_lt _ _)) by lia. reflexivity.
Qed.

Lemma terms_more ms : forall n, fold_left (fun n m => n + terms_of m) ms n = n + terms ms.
Proof.
  unfold terms. induction ms as [|m ms IH]; intro n; cbn [fold_left]; [lia|]. rewrite IH, (IH (0 + terms_of m)). lia.
Qed.

Lemma mem_add p q (seen : PositiveMap.t unit) :
  p <> q -> PositiveMap.mem p seen = false -> PositiveMap.mem p (PositiveMap.add q tt seen) = false.
Proof.
  intros N M. rewrite PositiveMap.mem_find in *. rewrite PositiveMap.gso by exact N. exact M.
Qed.

Lemma multiples_read ls ms : forall seen n done,
  (forall m, In m ms -> plain_multiple ls m) -> NoDup (map key ms) ->
  (forall m, In m ms -> PositiveMap.mem (key m) seen = false) ->
  multiples ls (multiple_words ms) seen n done = Some (rev done ++ ms, n + terms ms).
Proof.
  induction ms as [|m ms IH]; intros seen n done P D S.
  - cbn [multiple_words flat_map multiples]. rewrite rev'_rev, app_nil_r. unfold terms. cbn [fold_left]. do 2 f_equal. lia.
  - cbn [multiple_words flat_map app multiples]. destruct (P m (or_introl eq_refl)) as ((Pm & Lm) & Pc).
    rewrite (number_integer 1 _ Pm Lm), (condition_read ls m (conj (conj Pm Lm) Pc)). cbn [of_integer Qnum].
    replace (Multiple (times_m m) (letter m) (of_class m) (up_to m)) with m by (destruct m; reflexivity).
    rewrite (S m (or_introl eq_refl)). cbn [map] in D. inversion D as [|k ks Out D']; subst.
    fold (multiple_words ms). rewrite IH; trivial.
    + unfold terms at 2. cbn [rev fold_left]. rewrite terms_more, <- app_assoc. do 2 f_equal. lia.
    + intros x I. apply P. right. exact I.
    + intros x I. apply mem_add; [|apply S; right; exact I]. intro E. apply Out. rewrite <- E. apply in_map, I.
Qed.

Lemma all_multiples_read ls ms : (forall m, In m ms -> plain_multiple ls m) -> NoDup (map key ms) ->
  multiples ls (multiple_words ms) (PositiveMap.empty unit) 0 [] = Some (ms, terms ms).
Proof.
  intros P D. rewrite multiples_read; trivial. intros m _. rewrite PositiveMap.mem_find, PositiveMap.gempty. reflexivity.
Qed.

Definition plain_node (n : node) : Prop :=
  match n with
  | Split i j v => plain_range i j /\ plain_integer v /\ 1 <= v
  | SplitMass v => plain_rational v /\ 0 < Qnum v
  | Leaf ms => ms <> [] /\ (forall m, In m ms -> plain_multiple of_leaf m) /\ NoDup (map key ms)
  | Window ms => (forall m, In m ms -> plain_multiple of_windows m) /\ NoDup (map key ms)
  end.

(* As many subtrees as are to come, within the most nodes and multipliers; n is what there is before. *)
Fixpoint whole_trees (nodes : list node) (to_come n : Z) : Prop :=
  n <= most_nodes /\
  match nodes with
  | [] => to_come = 0
  | (Split _ _ _ | SplitMass _) :: nodes => to_come <> 0 /\ whole_trees nodes (to_come + 1) (n + 1)
  | (Leaf ms | Window ms) :: nodes => to_come <> 0 /\ whole_trees nodes (to_come - 1) (n + 1 + terms ms)
  end.

Lemma split_read i j v : plain_node (Split i j v) -> split_of [range_word i j; show_integer v] = Some (Split i j v).
Proof.
  intros (Pj & Pv & Lv). unfold split_of. destruct (String.eqb_spec (range_word i j) "M") as [E|_].
  - pose proof (class_range_read i j Pj) as R. rewrite E in R. discriminate R.
  - rewrite class_range_read, number_integer by assumption. reflexivity.
Qed.

Lemma split_mass_read v : plain_node (SplitMass v) -> split_of ["M"; show_rational v] = Some (SplitMass v).
Proof. intros (P & L). unfold split_of. change (String.eqb "M" "M") with true. rewrite number_rational by assumption. reflexivity. Qed.

Lemma leaf_read ms : plain_node (Leaf ms) -> leaf_of (multiple_words ms) = Some (Leaf ms, terms ms).
Proof. intros (N & P & D). unfold leaf_of. rewrite all_multiples_read by assumption. destruct ms; [contradiction | reflexivity]. Qed.

Lemma window_read ms : plain_node (Window ms) -> window_of (multiple_words ms) = Some (Window ms, terms ms).
Proof. intros (P & D). unfold window_of. rewrite all_multiples_read by assumption. reflexivity. Qed.

Lemma tree_read nodes rest : forall to_come n done,
  (forall x, In x nodes -> plain_node x) -> whole_trees nodes to_come n ->
  tree (map node_line nodes ++ rest) to_come n done = Ok (rev done ++ nodes, rest).
Proof.
  induction nodes as [|x nodes IH]; intros to_come n done P T.
  - destruct T as (L & ->). cbn [map app]. rewrite app_nil_r.
    destruct rest; cbn [tree]; rewrite (proj2 (Z.ltb_ge _ _) L), rev'_rev; reflexivity.
  - pose proof (P x (or_introl eq_refl)) as Px.
    assert (forall to_come n, whole_trees nodes to_come n ->
              tree (map node_line nodes ++ rest) to_come n (x :: done) = Ok (rev done ++ x :: nodes, rest)) as Rest.
    { intros k m T'. rewrite IH; [|intros; apply P; right; assumption | exact T']. cbn [rev]. rewrite <- app_assoc. reflexivity. }
    clear IH. cbn [map app tree].
    destruct x as [i j v|v|ms|ms]; destruct T as (L & C & T); rewrite (proj2 (Z.ltb_ge _ _) L), (proj2 (Z.eqb_neq _ _) C);
      cbn [node_line].
    + change (String.eqb "split" "split") with true. cbv iota. rewrite split_read by exact Px. exact (Rest _ _ T).
    + change (String.eqb "split" "split") with true. cbv iota. rewrite split_mass_read by exact Px. exact (Rest _ _ T).
    + change (String.eqb "leaf" "split") with false. change (String.eqb "leaf" "leaf") with true. cbv iota.
      rewrite leaf_read by exact Px. exact (Rest _ _ T).
    + change (String.eqb "window" "split") with false. change (String.eqb "window" "leaf") with false.
      change (String.eqb "window" "window") with true. cbv iota. rewrite window_read by exact Px. exact (Rest _ _ T).
Qed.

Definition plain_proof (cert : certificate) : Prop :=
  match tolerances_of (asked cert), proof_of cert with
  | None, Exact scale above chain =>
    plain_rational scale /\ 0 < Qnum scale /\
    if claims_least (asked cert) (claimed cert) then above = None /\ chain = None
    else
      (exists js, chain = Some js /\ forall j, In j js -> plain_index j) /\
      forall z, above = Some z -> at_least (asked cert) <> 0 /\ plain_rational z /\ 0 < Qnum z
  | Some _, Tolerant nodes => (forall x, In x nodes -> plain_node x) /\ whole_trees nodes 1 0
  | _, _ => False
  end.

Definition the_end : lines := [["end"]; [""]].

Lemma proof_read cert :
  plain_proof cert ->
  read_proof (asked cert) (claimed cert) (match proof_of cert with Exact scale _ _ => [scale] | Tolerant _ => [] end)
    (proof_lines (proof_of cert) ++ the_end) = Ok (proof_of cert, the_end).
Proof.
  unfold plain_proof, read_proof.
  destruct (tolerances_of (asked cert)) as [t|], (proof_of cert) as [scale above chain|nodes];
    try contradiction; cbn [proof_lines].
  - intros (P & T). rewrite tree_read by assumption. reflexivity.
  - intros (Ps & Ls & H). destruct (claims_least (asked cert) (claimed cert)).
    + destruct H as (-> & ->). reflexivity.
    + destruct H as ((js & -> & Pj) & Pz). cbn [if_some].
      assert (forall ls, (if at_least (asked cert) =? 0 then Ok ([], if_some above (fun z => ["above"; show_rational z]) ++ ("chain" :: ls) :: the_end)
               else optional "above" [Rational] (if_some above (fun z => ["above"; show_rational z]) ++ ("chain" :: ls) :: the_end))
              = Ok (to_list above, ("chain" :: ls) :: the_end)) as A.
      { intro ls. destruct above as [z|].
        - destruct (Pz z eq_refl) as (N & P & L). rewrite (proj2 (Z.eqb_neq _ _) N).
          apply optional_read; [right | reflexivity]. exists [show_rational z]. split; [reflexivity|]. cbn [numbers].
          rewrite number_rational by assumption. reflexivity.
        - destruct (at_least (asked cert) =? 0); reflexivity. }
      rewrite <- app_assoc. cbn [app]. rewrite A. cbn [bind]. unfold chain_line.
      change (String.eqb "chain" "chain") with true.
      pose proof (all_words_read class_index show_integer (fun j => j) js) as H. rewrite map_id in H.
      rewrite H by (intros; apply class_index_read, Pj; assumption). cbn [rev app bind]. rewrite first_to_list. reflexivity.
Qed.

Lemma bind_eq {A B} (r : result A) x (next : A -> result B) y : r = Ok x -> next x = y -> bind r next = y.
Proof. intros -> E. exact E. Qed.

(* ---- The whole certificate ---------------------------------------------------------------------------- *)

Definition plain_claim (c : claim) : Prop :=
  match c with
  | Smallest N => plain_integer N /\ 1 <= N
  | Between B N => plain_integer B /\ plain_integer N /\ 1 <= B < N
  | NoneBelow B => plain_integer B /\ 2 <= B
  | NoMatch => True
  end.

(* A claim without a witness is one about matches within a tolerance. *)
Definition plain_certificate (cert : certificate) (box : option (Q * Q * Q * Q)) : Prop :=
  plain_question (asked cert) box /\
  (plain_claim (claimed cert) /\ (found (claimed cert) = None -> is_tolerant cert = true /\ witness cert = [])) /\
  (forall w, In w (witness cert) -> plain_witness (is_tolerant cert) w) /\ classes_ascend (witness cert) None /\
  size (witness cert) <= most_rows /\ plain_proof cert.

Lemma not_none_numeral n : 0 <= n -> forall rest, (show_integer n ++ rest)%string <> "none".
Proof.
  intros P rest E. destruct (show_integer_numeral n P) as (l & L & N & _).
  destruct (show_integer n) as [|ch w]; inversion N as [|ch' d w' m l' Ed]; subst; [lia|].
  injection E as -> _. discriminate Ed.
Qed.

Lemma range_of_particles_read B rest : plain_integer B ->
  range_of_particles (show_integer B ++ ".." ++ rest)%string =
  match rest with
  | EmptyString => option_map (fun B => NoneBelow (Qnum B)) (number (Integer 2) (show_integer B))
  | _ =>
    match number (Integer 1) (show_integer B), number (Integer 1) rest with
    | Some B, Some N => check (less B N) (Between (Qnum B) (Qnum N))
    | _, _ => None
    end
  end.
Proof.
  intros (P & _). unfold range_of_particles. destruct (at_mark_integer "." B eq_refl P) as (_ & Parts).
  change (".." ++ rest)%string with (String "." (String "." rest)). rewrite Parts. reflexivity.
Qed.

Lemma particles_read c rest : plain_claim c -> read_particles (particles_line c :: rest) = Ok (c, rest).
Proof.
  intro P. unfold read_particles, particles_line, words. destruct c as [N|B N|B|]; cbn [claim_word].
  - destruct P as (Pn & Ln).
    assert (required "particles" [Integer 1] (["particles"; show_integer N] :: rest) = Ok ([of_integer N], rest)) as R.
    { apply required_read. cbn [numbers]. rewrite number_integer by assumption. reflexivity. }
    rewrite is_line_other by (intros [= E]; apply (not_none_numeral N (proj1 Pn) ""); rewrite append_empty; exact E).
    cbn [bind]. change (String.eqb "particles" "particles") with true.
    assert (range_of_particles (show_integer N) = None) as ->.
    { unfold range_of_particles. rewrite (proj1 (at_mark_integer "." N eq_refl (proj1 Pn))). reflexivity. }
    exact (bind_eq _ _ _ _ R eq_refl).
  - destruct P as (Pb & Pn & L).
    rewrite is_line_other by (intros [= E]; exact (not_none_numeral B (proj1 Pb) _ E)). cbn [bind].
    change (String.eqb "particles" "particles") with true. rewrite range_of_particles_read by exact Pb.
    destruct (show_integer_numeral N (proj1 Pn)) as (l & Ll & W & _).
    pose proof (number_integer 1 N Pn ltac:(lia)) as E.
    destruct (show_integer N) as [|ch w]; [inversion W; lia|].
    rewrite E, (number_integer 1 B Pb) by lia. unfold check, less. cbn [of_integer Qnum Qden].
    rewrite (proj2 (Z.ltb_lt _ _)) by lia. reflexivity.
  - destruct P as (Pb & L).
    rewrite is_line_other by (intros [= E]; exact (not_none_numeral B (proj1 Pb) _ E)). cbn [bind].
    change (String.eqb "particles" "particles") with true. rewrite <- (append_empty ".."), range_of_particles_read by exact Pb.
    rewrite number_integer by assumption. reflexivity.
  - rewrite is_line_same. reflexivity.
Qed.

Theorem certificate_read cert box :
  plain_certificate cert box -> read_certificate (document_lines (Document cert box false)) = Ok cert.
Proof.
  intros (Q & (Pc & None_) & W & Wa & Ws & P). unfold read_certificate, document_lines. cbn [certificate_of].
  set (second := is_second (claimed cert) (proof_of cert)) in *.
  set (rest := (question_lines _ ++ _)%list).
  assert (read_version ([version_line cert] ++ rest) = Ok (version_of cert, rest)) as RV.
  { unfold read_version, version_line, version_of. fold second. destruct (is_third (proof_of cert)), second; reflexivity. }
  refine (bind_eq _ _ _ _ RV _). cbv beta iota. unfold rest. clear RV rest.
  rewrite (question_read (asked cert) box false _ cert Q eq_refl); [|unfold particles_line; simpl; eauto|reflexivity].
  cbn [bind]. fold (is_tolerant cert). fold the_end.
  pose proof (proof_read cert P) as PR.
  refine (bind_eq _ _ _ _ (particles_read (claimed cert) _ Pc) _). cbv beta iota.
  assert (is_tolerant cert || match found (claimed cert) with Some _ => true | None => false end = true) as ->.
  { destruct (found (claimed cert)); [apply orb_true_r|]. destruct None_ as (-> & _); reflexivity. }
  cbn [demand_form bind].
  assert ((if is_tolerant cert then Ok ([], scale_lines (proof_of cert) ++ map (class_line (is_tolerant cert)) (witness cert) ++ proof_lines (proof_of cert) ++ the_end)
           else required "scale" [Rational] (scale_lines (proof_of cert) ++ map (class_line (is_tolerant cert)) (witness cert) ++ proof_lines (proof_of cert) ++ the_end))
          = Ok (match proof_of cert with Exact scale _ _ => [scale] | Tolerant _ => [] end,
                map (class_line (is_tolerant cert)) (witness cert) ++ proof_lines (proof_of cert) ++ the_end)) as RS.
  { unfold plain_proof in P. unfold is_tolerant in *.
    destruct (tolerances_of (asked cert)), (proof_of cert) as [scale z js|nodes]; try contradiction.
    - reflexivity.
    - destruct P as (Ps & Ls & _). cbn [scale_lines app]. apply required_read. cbn [numbers].
      rewrite number_rational by assumption. reflexivity. }
  refine (bind_eq _ _ _ _ RS _). cbv beta iota.
  assert (named "class" (proof_lines (proof_of cert) ++ the_end) = false) as NC.
  { destruct (proof_of cert) as [scale z js|[|[i j v|v|ms|ms] nodes]]; try reflexivity. destruct z, js; reflexivity. }
  assert (match found (claimed cert) with
          | Some _ => read_classes (is_tolerant cert) (map (class_line (is_tolerant cert)) (witness cert) ++ proof_lines (proof_of cert) ++ the_end)
          | None => Ok ([], map (class_line (is_tolerant cert)) (witness cert) ++ proof_lines (proof_of cert) ++ the_end)
          end = Ok (witness cert, proof_lines (proof_of cert) ++ the_end)) as RW.
  { destruct (found (claimed cert)).
    - unfold read_classes. rewrite witness_lines_read by assumption. cbn [bind rev app].
      rewrite (proj2 (Z.leb_le _ _) Ws). reflexivity.
    - destruct None_ as (_ & ->); reflexivity. }
  refine (bind_eq _ _ _ _ RW _). cbv beta iota. refine (bind_eq _ _ _ _ PR _). cbv beta iota. unfold the_end. cbn [tl].
  rewrite !is_line_same. cbn [andb demand_form bind].
  fold second. unfold version_of. fold second.
  assert (is_tolerant cert = false -> is_third (proof_of cert) = false) as Third.
  { unfold is_tolerant, plain_proof in *. destruct (tolerances_of (asked cert)), (proof_of cert); try contradiction; congruence || reflexivity. }
  destruct (is_tolerant cert), (is_third (proof_of cert)), second; try (discriminate (Third eq_refl)); destruct cert; reflexivity.
Qed.
