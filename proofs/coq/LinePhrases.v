(* What a verdict's line is made of says one thing each: numbers, the name in quotes, phrases and their list. A text is read from
   its head; numbers end where their digits do, and no phrase has a semicolon. *)

From Coq Require Import ZArith QArith List Bool String Ascii Lia.
From Mdm Require Import Numbers Gradation Certificate Question Text Decimals Rows GradationFile Document VerdictLine NumberTexts
  JudgeTheorem.
Import ListNotations.
Open Scope string_scope.

(* ---- Numbers at the head of a text -------------------------------------------------------------------- *)

Definition in_number (ch : ascii) : bool := is_digit ch || Ascii.eqb ch ".".
Definition ends (such : ascii -> bool) (w : string) : bool := match w with String ch _ => negb (such ch) | EmptyString => true end.
Definition number_ends : string -> bool := ends in_number.

Lemma every_append such u v : every such (u ++ v) = every such u && every such v.
Proof. induction u as [|ch u IH]; simpl; [reflexivity|]. rewrite IH. apply andb_assoc. Qed.

(* Texts of such characters alone, and what follows them and does not begin with one. *)
Lemma same_heads such u : forall v s t, every such u = true -> every such v = true -> ends such s = true ->
  ends such t = true -> u ++ s = v ++ t -> u = v /\ s = t.
Proof.
  induction u as [|ch u IH]; intros [|ch' v] s t U V S T E; simpl in *.
  - auto.
  - apply andb_prop in V as (V & _). subst s. simpl in S. rewrite V in S. discriminate.
  - apply andb_prop in U as (U & _). subst t. simpl in T. rewrite U in T. discriminate.
  - apply andb_prop in U as (_ & U), V as (_ & V). injection E as -> E. destruct (IH v s t U V S T E) as (-> & ->). auto.
Qed.

Lemma digit_in_number ch d : digit ch = Some d -> in_number ch = true.
Proof. destruct ch as [[] [] [] [] [] [] [] []]; try discriminate; reflexivity. Qed.

(* What [digits] reads are digits. *)
Lemma digits_are w : forall value n value' n' rest, digits w value n = (value', n', rest) ->
  exists head, w = head ++ rest /\ every in_number head = true.
Proof.
  induction w as [|ch w IH]; intros value n value' n' rest H; simpl in H.
  - injection H as <- <- <-. exists "". auto.
  - destruct (digit ch) as [d|] eqn:D; [|injection H as <- <- <-; exists ""; auto].
    apply IH in H as (head & -> & E). exists (String ch head). split; [reflexivity|]. simpl.
    rewrite (digit_in_number _ _ D). exact E.
Qed.

Lemma append_nothing w : w ++ "" = w.
Proof. induction w as [|ch w IH]; simpl; congruence. Qed.

Lemma whole_digits most w n : whole most w = Some n -> every in_number w = true /\ w <> "".
Proof.
  unfold whole. destruct (digits w 0 0) as ((value, k), rest) eqn:D. unfold check.
  destruct (String.eqb rest "" && _ && _ && _) eqn:C; [|discriminate]. rewrite !andb_true_iff in C.
  destruct C as (((R & K) & _) & _). apply String.eqb_eq in R. subst rest. intros _. split.
  - apply digits_are in D as (head & -> & E). rewrite append_nothing. exact E.
  - intros ->. injection D as <- <-. discriminate.
Qed.

Lemma decimal_digits w x : decimal w = Some x -> every in_number w = true /\ w <> "".
Proof.
  unfold decimal. destruct (digits w 0 0) as ((value, n), rest) eqn:D. intro H.
  assert (1 <=? n = true)%Z as N.
  { destruct (1 <=? n)%Z; [reflexivity|]. cbn [andb] in H. destruct rest as [|ch places]; [discriminate|].
    destruct (digits places value n) as ((?, ?), ?). discriminate. }
  split; [|intros ->; injection D as <- <- <-; discriminate].
  apply digits_are in D as (head & -> & E). destruct rest as [|ch places]; [rewrite append_nothing; exact E|].
  destruct (digits places value n) as ((value', all), rest) eqn:D. unfold check in H.
  destruct (_ && Ascii.eqb ch "." && String.eqb rest "" && _ && _ && _) eqn:C; [|discriminate].
  rewrite !andb_true_iff in C. destruct C as (((((_ & P) & R) & _) & _) & _).
  apply String.eqb_eq in R. subst rest. apply digits_are in D as (tail & -> & T). rewrite append_nothing.
  rewrite every_append, E. cbn [every andb]. rewrite T. unfold in_number. rewrite P, orb_true_r. reflexivity.
Qed.

Lemma same_number_same x y : same_number x y = true -> x = y.
Proof.
  unfold same_number. rewrite andb_true_iff, !Z.eqb_eq. destruct x, y. simpl. intros (-> & E). injection E as ->. reflexivity.
Qed.

Lemma plain_text x : plain x = true ->
  decimal (show_decimal x) = Some x /\ every in_number (show_decimal x) = true /\ show_decimal x <> "".
Proof.
  unfold plain. destruct (decimal (show_decimal x)) as [y|] eqn:E; [|discriminate]. intro H.
  apply same_number_same in H. subst y. split; [reflexivity|]. exact (decimal_digits _ _ E).
Qed.

Lemma plain_integer_text n : plain_integer n = true ->
  whole most_digits (show_integer n) = Some n /\ every in_number (show_integer n) = true /\ show_integer n <> "".
Proof.
  unfold plain_integer. destruct (whole most_digits (show_integer n)) as [m|] eqn:E; [|discriminate]. intro H.
  apply Z.eqb_eq in H. subst m. split; [reflexivity|]. exact (whole_digits _ _ _ E).
Qed.

(* Numbers at the head of two texts are the same, and so is what follows. *)
Lemma same_decimals x y s t : plain x = true -> plain y = true -> number_ends s = true -> number_ends t = true ->
  show_decimal x ++ s = show_decimal y ++ t -> x = y /\ s = t.
Proof.
  intros X Y S T E. apply plain_text in X as (X & Dx & _), Y as (Y & Dy & _).
  destruct (same_heads in_number _ _ _ _ Dx Dy S T E) as (U & ->). rewrite U, Y in X. injection X as ->. auto.
Qed.

Lemma same_integers m n s t : plain_integer m = true -> plain_integer n = true -> number_ends s = true ->
  number_ends t = true -> show_integer m ++ s = show_integer n ++ t -> m = n /\ s = t.
Proof.
  intros X Y S T E. apply plain_integer_text in X as (X & Dx & _), Y as (Y & Dy & _).
  destruct (same_heads in_number _ _ _ _ Dx Dy S T E) as (U & ->). rewrite U, Y in X. injection X as ->. auto.
Qed.

(* No number begins with another character. *)
Lemma decimal_head x s ch w : plain x = true -> in_number ch = false -> show_decimal x ++ s <> String ch w.
Proof.
  intros X C E. apply plain_text in X as (_ & D & N). destruct (show_decimal x) as [|ch' v]; [contradiction|].
  injection E as -> _. simpl in D. rewrite C in D. discriminate.
Qed.

Lemma integer_head n s ch w : plain_integer n = true -> in_number ch = false -> show_integer n ++ s <> String ch w.
Proof.
  intros X C E. apply plain_integer_text in X as (_ & D & N). destruct (show_integer n) as [|ch' v]; [contradiction|].
  injection E as -> _. simpl in D. rewrite C in D. discriminate.
Qed.

Lemma append_associates u v w : (u ++ v) ++ w = u ++ v ++ w.
Proof. induction u as [|ch u IH]; simpl; congruence. Qed.

Lemma same_after u : forall s t, u ++ s = u ++ t -> s = t.
Proof. induction u as [|ch u IH]; intros s t E; [exact E|]. cbn [append] in E. injection E as E. exact (IH s t E). Qed.

(* ---- The name ------------------------------------------------------------------------------------------ *)

Definition is_mark (ch : ascii) : bool := Ascii.eqb ch quote || Ascii.eqb ch backslash.

(* What a byte of the name becomes. *)
Definition shown_as (ch : ascii) (w : string) : Prop :=
  w = escaped ch \/ (is_mark ch = true /\ w = String backslash (String ch "")) \/ (is_mark ch = false /\ w = String ch "").

Lemma printable_step ch w more good : exists head more' good',
  printable_from is_mark (String ch w) more good = head ++ printable_from is_mark w more' good' /\ shown_as ch head.
Proof.
  assert (forall b : bool, shown_as ch (if negb b then escaped ch else if is_mark ch then String backslash (String ch "") else String ch "")) as S.
  { unfold shown_as. intros []; simpl; [destruct (is_mark ch)|]; auto. }
  cbn [printable_from]. destruct more as [|more]; [destruct (character (String ch w)) as [(n, more)|]|]; do 3 eexists;
    (split; [reflexivity|]); [apply S | left; reflexivity | apply S].
Qed.

Definition of_hexadecimal (ch : ascii) : Z := if (code ch <? 58)%Z then code ch - 48 else code ch - 55.

Lemma unescaped ch :
  of_code (of_hexadecimal (hexadecimal (code ch / 16)) * 16 + of_hexadecimal (hexadecimal (code ch mod 16))) = ch.
Proof. destruct ch as [[] [] [] [] [] [] [] []]; reflexivity. Qed.

Lemma mark_cases ch : is_mark ch = true -> ch = quote \/ ch = backslash.
Proof. unfold is_mark. rewrite orb_true_iff, !Ascii.eqb_eq. auto. Qed.

Lemma same_shown ch ch' u v s t : shown_as ch u -> shown_as ch' v -> u ++ s = v ++ t -> ch = ch' /\ s = t.
Proof.
  unfold shown_as. intros [->|[(M & ->)|(M & ->)]] [->|[(M' & ->)|(M' & ->)]]; unfold escaped; cbn [append]; intro E.
  - injection E as H L ->. split; [|reflexivity]. rewrite <- (unescaped ch), <- (unescaped ch'), H, L. reflexivity.
  - injection E as E _. apply mark_cases in M' as [-> | ->]; discriminate.
  - injection E as <- _. discriminate.
  - injection E as E _. apply mark_cases in M as [-> | ->]; discriminate.
  - injection E as -> ->. auto.
  - injection E as <- _. discriminate.
  - injection E as -> _. discriminate.
  - injection E as -> _. discriminate.
  - injection E as -> ->. auto.
Qed.

Lemma shown_no_quote ch u s t : shown_as ch u -> u ++ s <> String quote t.
Proof.
  unfold shown_as. intros [->|[(M & ->)|(M & ->)]]; unfold escaped; cbn [append]; intro E; [discriminate E | discriminate E|].
  injection E as -> _. discriminate.
Qed.

Lemma same_printable w : forall w' m m' g g' s t,
  printable_from is_mark w m g ++ String quote s = printable_from is_mark w' m' g' ++ String quote t -> w = w' /\ s = t.
Proof.
  induction w as [|ch w IH]; intros [|ch' w'] m m' g g' s t E.
  - injection E as ->. auto.
  - destruct (printable_step ch' w' m' g') as (head & m2 & g2 & P & H). rewrite P, append_associates in E. symmetry in E.
    exfalso. exact (shown_no_quote _ _ _ _ H E).
  - destruct (printable_step ch w m g) as (head & m2 & g2 & P & H). rewrite P, append_associates in E.
    exfalso. exact (shown_no_quote _ _ _ _ H E).
  - destruct (printable_step ch w m g) as (head & m2 & g2 & P & H), (printable_step ch' w' m' g') as (head' & m3 & g3 & P' & H').
    rewrite P, P', !append_associates in E. destruct (same_shown _ _ _ _ _ _ H H' E) as (-> & E').
    apply IH in E' as (-> & ->). auto.
Qed.

Lemma same_names w w' s t : in_quotes w ++ s = in_quotes w' ++ t -> w = w' /\ s = t.
Proof.
  unfold in_quotes. intro E. cbn [append] in E. injection E as E. rewrite !append_associates in E. cbn [append] in E.
  exact (same_printable _ _ _ _ _ _ _ _ E).
Qed.

(* ---- Phrases ------------------------------------------------------------------------------------------- *)

Lemma plain_same x y : plain x = true -> plain y = true -> show_decimal x = show_decimal y -> x = y.
Proof. intros X Y E. apply (same_decimals x y "" "" X Y eq_refl eq_refl). rewrite E. reflexivity. Qed.

Lemma plain_integer_same m n : plain_integer m = true -> plain_integer n = true -> show_integer m = show_integer n -> m = n.
Proof. intros X Y E. apply (same_integers m n "" "" X Y eq_refl eq_refl). rewrite E. reflexivity. Qed.

Lemma decimal_is_no x ch w : plain x = true -> in_number ch = false -> show_decimal x <> String ch w.
Proof. rewrite <- (append_nothing (show_decimal x)). apply decimal_head. Qed.

Lemma integer_is_no n ch w : plain_integer n = true -> in_number ch = false -> show_integer n <> String ch w.
Proof. rewrite <- (append_nothing (show_integer n)). apply integer_head. Qed.

(* Takes what both sides of an equation of texts begin with, until they differ. *)
Ltac take E :=
  rewrite ?append_associates in E; cbn [append unit_name] in E;
  match type of E with
  | String _ _ = String _ _ => first [discriminate E | injection E as E; take E | injection E; clear E; intros; subst]
  | show_decimal _ ++ _ = show_decimal _ ++ _ =>
    apply same_decimals in E as (? & E); [subst; try take E | assumption | assumption | reflexivity | reflexivity]
  | show_integer _ ++ _ = show_integer _ ++ _ =>
    apply same_integers in E as (? & E); [subst; try take E | assumption | assumption | reflexivity | reflexivity]
  | show_decimal _ = show_decimal _ => apply plain_same in E; [subst | assumption | assumption]
  | show_integer _ = show_integer _ => apply plain_integer_same in E; [subst | assumption | assumption]
  | show_decimal _ ++ _ = String _ _ => exfalso; revert E; apply decimal_head; [assumption | reflexivity]
  | show_integer _ ++ _ = String _ _ => exfalso; revert E; apply integer_head; [assumption | reflexivity]
  | String _ _ = show_decimal _ ++ _ => symmetry in E; exfalso; revert E; apply decimal_head; [assumption | reflexivity]
  | String _ _ = show_integer _ ++ _ => symmetry in E; exfalso; revert E; apply integer_head; [assumption | reflexivity]
  | show_integer _ = String _ _ => exfalso; revert E; apply integer_is_no; [assumption | reflexivity]
  | String _ _ = show_integer _ => symmetry in E; exfalso; revert E; apply integer_is_no; [assumption | reflexivity]
  | "" = String _ _ => discriminate E
  | String _ _ = "" => discriminate E
  | _ => idtac
  end.

Lemma opposite_same x y : Qopp x = Qopp y -> x = y.
Proof. destruct x as (a, b), y as (c, d). unfold Qopp. simpl. intros [= E ->]. f_equal. lia. Qed.

Lemma same_openings u x y s t : plain_opening u x = true -> plain_opening u y = true -> number_ends s = true ->
  number_ends t = true -> opening_phrase u x ++ s = opening_phrase u y ++ t -> x = y /\ s = t.
Proof.
  unfold opening_phrase, plain_opening. intros X Y S T E. destruct u;
    try (cbn [unit_name] in E; rewrite !append_associates in E;
      apply same_decimals in E as (-> & E); trivial; cbn [append] in E; injection E as ->; auto).
  destruct (less x 0) eqn:Lx, (less y 0) eqn:Ly; repeat first [progress cbn [append] in E | injection E as E].
  - apply same_decimals in E as (E & ->); trivial. apply opposite_same in E. auto.
  - take E.
  - take E.
  - apply same_decimals in E as (-> & ->); trivial. auto.
Qed.

(* What follows the first opening with its percentage. *)
Fixpoint further_openings (u : size_unit) (each : list (Q * Q)) : string :=
  match each with
  | [] => ""
  | (e, x) :: each => ", " ++ show_decimal e ++ "% at " ++ opening_phrase u x ++ further_openings u each
  end.

Lemma joined_cons separator w w' ws : joined separator (w :: w' :: ws) = w ++ separator ++ joined separator (w' :: ws).
Proof. reflexivity. Qed.

Lemma joined_further u each : forall w,
  joined ", " (w :: map (fun '(percent, at_) => percent ++ at_)
    (map (fun '(e, x) => (show_decimal e ++ "%", " at " ++ opening_phrase u x)) each)) = w ++ further_openings u each.
Proof.
  induction each as [|(e, x) each IH]; intro w; [symmetry; apply append_nothing|].
  cbn [map]. rewrite joined_cons, IH. cbn [further_openings append]. rewrite !append_associates. cbn [append].
  reflexivity.
Qed.

Lemma each_phrase_form u e x each : each_phrase u ((e, x) :: each) =
  show_decimal e ++ "% of the total mass at " ++ opening_phrase u x ++ further_openings u each.
Proof.
  unfold each_phrase, map_all. rewrite !map_all_map. cbn [map]. rewrite map_all_map, joined_further, !append_associates. reflexivity.
Qed.

Lemma further_ends u each s : number_ends s = true -> number_ends (further_openings u each ++ s) = true.
Proof. intro S. destruct each as [|(e, x) each]; [exact S | reflexivity]. Qed.

Definition plain_each (u : size_unit) (each : list (Q * Q)) : bool := forallb (fun '(e, x) => plain e && plain_opening u x) each.

Lemma same_further u each : forall each' s t, plain_each u each = true -> plain_each u each' = true ->
  further_openings u each ++ String " " s = further_openings u each' ++ String " " t -> each = each' /\ s = t.
Proof.
  induction each as [|(e, x) each IH]; intros [|(e', x') each'] s t P P' E; cbn [further_openings append] in E.
  - injection E as ->. auto.
  - discriminate E.
  - discriminate E.
  - injection E as E. rewrite !append_associates in E. cbn [plain_each forallb] in P, P'.
    apply andb_prop in P as (P & Ps), P' as (P' & Ps'). apply andb_prop in P as (Pe & Px), P' as (Pe' & Px').
    apply same_decimals in E as (-> & E); trivial. cbn [append] in E. injection E as E. rewrite !append_associates in E.
    apply same_openings in E as (-> & E); trivial; try (apply further_ends; reflexivity).
    apply IH in E as (-> & ->); auto.
Qed.

Lemma unit_same u v : same_unit u v = true -> u = v.
Proof. destruct u, v; intro H; try reflexivity; discriminate H. Qed.

Lemma units_same u v : sizes_phrase u = sizes_phrase v -> u = v.
Proof. intro E. apply unit_same. unfold same_unit. rewrite E. apply String.eqb_refl. Qed.

(* Names in quotes, up to what is no comma. *)
Lemma joined_form separator w ws : joined separator (w :: ws) = w ++ match ws with [] => "" | _ => separator ++ joined separator ws end.
Proof. destruct ws as [|w' ws]; [symmetry; apply append_nothing | reflexivity]. Qed.

Definition no_comma (w : string) : bool := ends (Ascii.eqb ",") w.

Lemma same_materials names : forall names' s t, names <> [] -> names' <> [] -> no_comma s = true -> no_comma t = true ->
  joined ", " (map in_quotes names) ++ s = joined ", " (map in_quotes names') ++ t -> names = names' /\ s = t.
Proof.
  induction names as [|n names IH]; intros [|n' names'] s t N N' S T E; try contradiction. cbn [map] in E. rewrite !joined_form in E.
  rewrite !append_associates in E. apply same_names in E as (-> & E).
  destruct names as [|m names], names' as [|m' names']; cbn [map append] in E.
  - auto.
  - subst s. discriminate S.
  - subst t. discriminate T.
  - injection E as E. destruct (IH (m' :: names') s t ltac:(discriminate) ltac:(discriminate) S T E) as (Same & ->). rewrite Same. auto.
Qed.

(* A phrase says one part. *)
Lemma same_phrases u p q : plain_part u p = true -> plain_part u q = true -> phrase u p = phrase u q -> p = q.
Proof.
  assert (forall each, plain_part u (PassingEach each) = true -> exists e x rest, each = (e, x) :: rest /\
    plain e = true /\ plain_opening u x = true /\ plain_each u rest = true) as Each.
  { intros [|(e, x) rest] P; [discriminate P|]. exists e, x, rest. simpl in P. rewrite !andb_true_iff in P.
    unfold plain_each. tauto. }
  assert (forall v w, phrase u (SizesIn v) = w -> exists w', w = "sizes in " ++ w') as Sizes.
  { intros v w <-. destruct v; eexists; reflexivity. }
  intros P P' E.
  destruct p, q; try (destruct share); try (destruct share0); try (apply units_same in E; subst; reflexivity);
    try (apply Sizes in E as (w & E)); try (symmetry in E; apply Sizes in E as (w & E));
    unfold phrase, of_total, of_file in E; cbv zeta in E; try discriminate E; try reflexivity;
    try (apply Each in P as (e1 & x1 & rest1 & -> & P1 & P2 & P3); rewrite each_phrase_form in E);
    try (apply Each in P' as (e2 & x2 & rest2 & -> & P1' & P2' & P3'); rewrite each_phrase_form in E);
    try (cbn [plain_part] in P; rewrite ?andb_true_iff in P; repeat match type of P with _ /\ _ => destruct P as (P & ?) end);
    try (cbn [plain_part] in P'; rewrite ?andb_true_iff in P'; repeat match type of P' with _ /\ _ => destruct P' as (P' & ?) end);
    try (take E; reflexivity); try (destruct u; take E; reflexivity).
  - take E. apply same_openings in E as (-> & E); trivial; try (apply further_ends; reflexivity).
    apply same_further in E as (-> & _); trivial.
  - cbn [append] in E. destruct (Z.eqb_spec b 1) as [->|], (Z.eqb_spec b0 1) as [->|]; take E; reflexivity.
  - unfold map_all in E. rewrite !map_all_map in E. take E.
    rewrite <- (append_nothing (joined _ _)), <- (append_nothing (joined ", " (map in_quotes names0))) in E.
    apply same_materials in E as (-> & _); trivial; intros ->; discriminate.
Qed.

(* ---- The parts ----------------------------------------------------------------------------------------- *)

Definition no_semicolon (ch : ascii) : bool := negb (Ascii.eqb ch ";").

Lemma number_no_semicolon w : every in_number w = true -> every no_semicolon w = true.
Proof.
  induction w as [|ch w IH]; simpl; [reflexivity|]. intro H. apply andb_prop in H as (C & H). rewrite (IH H), andb_true_r.
  destruct ch as [[] [] [] [] [] [] [] []]; try discriminate C; reflexivity.
Qed.

Lemma decimal_no_semicolon x : plain x = true -> every no_semicolon (show_decimal x) = true.
Proof. intro X. apply plain_text in X as (_ & X & _). apply number_no_semicolon, X. Qed.

Lemma integer_no_semicolon n : plain_integer n = true -> every no_semicolon (show_integer n) = true.
Proof. intro X. apply plain_integer_text in X as (_ & X & _). apply number_no_semicolon, X. Qed.

Lemma opening_no_semicolon u x : plain_opening u x = true -> every no_semicolon (opening_phrase u x) = true.
Proof.
  unfold plain_opening, opening_phrase. intro X. destruct u; try (rewrite every_append, decimal_no_semicolon by exact X; reflexivity).
  destruct (less x 0); rewrite every_append; cbn [every]; rewrite decimal_no_semicolon by exact X; reflexivity.
Qed.

Lemma further_no_semicolon u each : plain_each u each = true -> every no_semicolon (further_openings u each) = true.
Proof.
  induction each as [|(e, x) each IH]; [reflexivity|]. cbn [plain_each forallb further_openings]. intro P.
  apply andb_prop in P as (P & Ps). apply andb_prop in P as (Pe & Px).
  rewrite !every_append, decimal_no_semicolon, opening_no_semicolon, (IH Ps) by assumption. reflexivity.
Qed.

Definition is_of_materials (p : part) : bool := match p with OfMaterials _ => true | _ => false end.

Lemma phrase_no_semicolon u p : plain_part u p = true -> is_of_materials p = false -> every no_semicolon (phrase u p) = true.
Proof.
  intros P No. destruct p; try discriminate No; try (destruct share); try (destruct unit); try (destruct each as [|(e, x) each]; [discriminate P|]);
    cbn [plain_part forallb] in P; rewrite ?andb_true_iff in P;
    repeat match type of P with _ /\ _ => destruct P as (P & ?) end;
    unfold phrase, of_total, of_file; cbv zeta; try reflexivity;
    try (rewrite !every_append, ?decimal_no_semicolon, ?integer_no_semicolon by assumption; destruct u; reflexivity).
  - rewrite each_phrase_form, !every_append, decimal_no_semicolon, opening_no_semicolon, further_no_semicolon by assumption.
    reflexivity.
  - destruct (b =? 1)%Z; rewrite !every_append, ?integer_no_semicolon by assumption; reflexivity.
Qed.

(* No other phrase begins as that of materials does. *)
Lemma no_materials u p s w : plain_part u p = true -> is_of_materials p = false -> phrase u p ++ s <> "classes of the materials " ++ w.
Proof.
  intros P No E. destruct p; try discriminate No; try (destruct share); try (destruct unit); try (destruct each as [|(e, x) each]; [discriminate P|]);
    cbn [plain_part forallb] in P; rewrite ?andb_true_iff in P; repeat match type of P with _ /\ _ => destruct P as (P & ?) end;
    unfold phrase, of_total, of_file in E; cbv zeta in E; try discriminate E;
    try (rewrite each_phrase_form in E); rewrite ?append_associates in E; try (revert E; apply decimal_head; [assumption | reflexivity]).
Qed.

(* The first phrase of two lists, up to a semicolon. *)
Lemma same_first u v p q s t : plain_part u p = true -> plain_part v q = true -> ends no_semicolon s = true -> ends no_semicolon t = true ->
  phrase u p ++ s = phrase v q ++ t -> phrase u p = phrase v q /\ s = t.
Proof.
  intros P Q S T E. destruct (is_of_materials p) eqn:Op, (is_of_materials q) eqn:Oq.
  - destruct p as [| | | | | | | | | | |names| | | | | | | | | |]; try discriminate Op. destruct q as [| | | | | | | | | | |names'| | | | | | | | | |]; try discriminate Oq.
    unfold phrase, map_all in *. rewrite !map_all_map in *. take E.
    assert (forall w, ends no_semicolon w = true -> no_comma w = true) as C.
    { intros [|ch w]; [reflexivity|]. unfold no_comma, ends, no_semicolon. rewrite negb_involutive. intro H. apply Ascii.eqb_eq in H. subst. reflexivity. }
    apply same_materials in E as (-> & ->); auto; intros ->; discriminate.
  - exfalso. destruct p; try discriminate Op. unfold phrase in E at 1. rewrite append_associates in E. symmetry in E.
    exact (no_materials v q _ _ Q Oq E).
  - exfalso. destruct q; try discriminate Oq. unfold phrase in E at 2. rewrite append_associates in E.
    exact (no_materials u p _ _ P Op E).
  - apply (same_heads no_semicolon); trivial; apply phrase_no_semicolon; assumption.
Qed.

Lemma same_joined u v l : forall m, (forall p, In p l -> plain_part u p = true) -> (forall p, In p m -> plain_part v p = true) ->
  l <> [] -> m <> [] -> joined "; " (map (phrase u) l) = joined "; " (map (phrase v) m) -> map (phrase u) l = map (phrase v) m.
Proof.
  induction l as [|p l IH]; intros [|q m] L M NL NM E; try contradiction. cbn [map] in *. rewrite !joined_form in E.
  apply same_first in E as (Same & E); [| apply L; left; reflexivity | apply M; left; reflexivity
    | destruct l; reflexivity | destruct m; reflexivity].
  rewrite Same. f_equal. destruct l as [|p' l], m as [|q' m]; [reflexivity | discriminate E | discriminate E|].
  apply IH; [intros; apply L; right; assumption | intros; apply M; right; assumption | discriminate | discriminate|].
  cbn [map append] in E. injection E as E. exact E.
Qed.

Lemma same_last u : forall v ch, u ++ String ch "" = v ++ String ch "" -> u = v.
Proof.
  induction u as [|c u IH]; intros [|c' v] ch E; cbn [append] in E; trivial.
  - injection E as _ E. destruct v; discriminate E.
  - injection E as _ E. destruct u; discriminate E.
  - injection E as -> E. f_equal. exact (IH v ch E).
Qed.

(* ---- Values -------------------------------------------------------------------------------------------- *)

(* Texts of decimals and their values: "15.27" is 1527 / 10^2. *)
Inductive decimal_text : string -> Q -> Prop :=
| without_point w n length : numeral w n length -> (1 <= length)%Z -> decimal_text w (of_integer n)
| with_point u v n m length places : numeral u n length -> (1 <= length)%Z -> numeral v m places -> (1 <= places)%Z ->
    decimal_text (u ++ "." ++ v) (n * 10 ^ places + m # Z.to_pos (10 ^ places)).

Lemma digit_value ch d : digit ch = Some d -> (0 <= d <= 9)%Z.
Proof. destruct ch as [[] [] [] [] [] [] [] []]; intro H; try discriminate H; injection H as <-; lia. Qed.

Lemma digits_numeral w : forall v n v' n' rest, digits w v n = (v', n', rest) ->
  exists head m length, w = head ++ rest /\ numeral head m length /\ v' = (v * 10 ^ length + m)%Z /\ n' = (n + length)%Z.
Proof.
  induction w as [|ch w IH]; intros v n v' n' rest H; cbn [digits] in H.
  - injection H as <- <- <-. exists "", 0%Z, 0%Z. repeat split; [constructor | lia | lia].
  - destruct (digit ch) as [d|] eqn:D; [|injection H as <- <- <-; exists "", 0%Z, 0%Z; repeat split; [constructor | lia | lia]].
    apply IH in H as (head & m & length & -> & N & V & L). pose proof (numeral_length _ _ _ N).
    exists (String ch head), (d * 10 ^ length + m)%Z, (length + 1)%Z.
    split; [reflexivity|]. split; [constructor; [exact D | exact (digit_value _ _ D) | exact N]|]. split; [|lia].
    rewrite Z.pow_add_r by lia. change (10 ^ 1)%Z with 10%Z. subst v'. ring.
Qed.

(* What is read as a decimal has its value. *)
Theorem decimal_has_value w x : decimal w = Some x -> exists y, decimal_text w y /\ (x == y)%Q.
Proof.
  unfold decimal. destruct (digits w 0 0) as ((value, n), rest) eqn:D.
  apply digits_numeral in D as (u & m & length & -> & N & -> & ->). intro H.
  destruct rest as [|ch places].
  - unfold check in H. destruct (_ && _) eqn:C in H; [|discriminate]. injection H as <-. rewrite !andb_true_iff, Z.leb_le in C.
    exists (of_integer m). rewrite append_nothing. split; [apply without_point with (length := length); [exact N | lia]|].
    replace (0 * 10 ^ length + m)%Z with m by lia. reflexivity.
  - destruct (digits places (0 * 10 ^ length + m) (0 + length)) as ((value', all), rest) eqn:D'.
    apply digits_numeral in D' as (v & k & more & -> & N' & -> & ->). unfold check in H.
    destruct (_ && _ && _ && _ && _ && _) eqn:C in H; [|discriminate]. injection H as <-.
    rewrite !andb_true_iff, Z.leb_le, Z.ltb_lt in C. destruct C as (((((C1 & P) & R) & L) & _) & _).
    apply Ascii.eqb_eq in P. apply String.eqb_eq in R. subst ch rest. rewrite append_nothing.
    exists (m * 10 ^ more + k # Z.to_pos (10 ^ more)). split.
    + apply (with_point u v m k length more N); [lia | exact N' | lia].
    + match goal with |- (fraction ?a (10 ^ ?b) == _)%Q =>
        replace b with more by lia; replace a with (m * 10 ^ more + k)%Z by ring end.
      unfold fraction. rewrite Qred_correct. reflexivity.
Qed.

(* So has every number that a line says. *)
Corollary shown_has_value x : plain x = true -> exists y, decimal_text (show_decimal x) y /\ (x == y)%Q.
Proof. intro P. apply plain_text in P as (D & _). exact (decimal_has_value _ _ D). Qed.
