(* What a line about a blend is made of says one thing each: numbers and their lists, phrases and their list. *)

From Coq Require Import ZArith QArith List Bool String Ascii Lia.
From Mdm Require Import Numbers Certificate Text Decimals Rows VerdictLine NumberTexts JudgeTheorem LinePhrases Blend
  BlendCertificate BlendLine.
Import ListNotations.
Open Scope string_scope.

(* ---- Numbers ------------------------------------------------------------------------------------------- *)

Lemma numeral_value w n length : numeral w n length -> forall m k, numeral w m k -> n = m.
Proof.
  induction 1 as [|ch d w n length D B N IH]; intros m k M; inversion M as [|ch' d' w' n' k' D' B' N']; subst; [reflexivity|].
  rewrite D in D'. injection D' as <-. rewrite (IH _ _ N'). f_equal. f_equal. f_equal.
  rewrite <- (numeral_text_length _ _ _ N), <- (numeral_text_length _ _ _ N'). reflexivity.
Qed.

Lemma numeral_digits w n length : numeral w n length -> every in_number w = true.
Proof. induction 1 as [|ch d w n length D B N IH]; [reflexivity|]. cbn [every]. rewrite (digit_in_number _ _ D). exact IH. Qed.

(* Integers from 0 up have a text each, of whatever length. *)
Lemma integer_text n : (0 <= n)%Z -> exists ch w, show_integer n = String ch w /\ in_number ch = true /\ every in_number w = true.
Proof.
  intro P. destruct (show_integer_numeral n P) as (length & L & N & _). apply numeral_digits in N as D.
  destruct (show_integer n) as [|ch w]; [inversion N; subst; lia|]. cbn [every] in D. apply andb_prop in D. exists ch, w. tauto.
Qed.

Lemma same_numbers m n s t : (0 <= m)%Z -> (0 <= n)%Z -> number_ends s = true -> number_ends t = true ->
  show_integer m ++ s = show_integer n ++ t -> m = n /\ s = t.
Proof.
  intros M N S T E. destruct (show_integer_numeral m M) as (l & _ & A & _), (show_integer_numeral n N) as (k & _ & B & _).
  destruct (same_heads in_number _ _ _ _ (numeral_digits _ _ _ A) (numeral_digits _ _ _ B) S T E) as (Same & ->).
  rewrite Same in A. rewrite (numeral_value _ _ _ A _ _ B). auto.
Qed.

Definition in_rational (ch : ascii) : bool := in_number ch || Ascii.eqb ch "/".
Definition rational_ends : string -> bool := ends in_rational.

Lemma rational_form x s : show_rational x ++ s =
  show_integer (Qnum x) ++ (if (Zpos (Qden x) =? 1)%Z then "" else "/" ++ show_integer (Zpos (Qden x))) ++ s.
Proof. unfold show_rational. destruct (_ =? _)%Z; rewrite ?append_associates; reflexivity. Qed.

Lemma ends_sooner such such' s : (forall ch, such ch = true -> such' ch = true) -> ends such' s = true -> ends such s = true.
Proof.
  intro I. destruct s as [|ch s]; [reflexivity|]. cbn [ends]. specialize (I ch). destruct (such ch); [rewrite I; trivial | trivial].
Qed.

Lemma rational_ends_number s : rational_ends s = true -> number_ends s = true.
Proof. apply ends_sooner. intros ch H. unfold in_rational. rewrite H. reflexivity. Qed.

Lemma same_rationals x y s t : from_0 x = true -> from_0 y = true -> rational_ends s = true -> rational_ends t = true ->
  show_rational x ++ s = show_rational y ++ t -> x = y /\ s = t.
Proof.
  unfold from_0. rewrite !Z.leb_le. intros X Y S T E. rewrite !rational_form in E.
  assert (forall (b : bool) u v, rational_ends v = true -> number_ends ((if b then "" else String "/" u) ++ v) = true) as End
    by (intros [] u v V; [apply rational_ends_number, V | reflexivity]).
  apply same_numbers in E as (N & E); trivial; try (apply End; assumption).
  assert (forall u v : string, rational_ends v = true -> v <> String "/" u) as Slash by (intros u v V ->; discriminate V).
  destruct x as (n, d), y as (m, e). cbn [Qnum Qden] in *. subst m.
  destruct (Z.eqb_spec (Zpos d) 1) as [D|D], (Z.eqb_spec (Zpos e) 1) as [D'|D']; cbn [append] in E.
  - injection D as ->. injection D' as ->. auto.
  - exfalso. exact (Slash _ _ S E).
  - exfalso. symmetry in E. exact (Slash _ _ T E).
  - injection E as E. apply same_numbers in E as (E & ->); try lia; try (apply rational_ends_number; assumption).
    injection E as ->. auto.
Qed.

(* ---- Lists of numbers ---------------------------------------------------------------------------------- *)

Section Listed.
Variables (A : Type) (show : A -> string) (such : A -> Prop) (goes_on : ascii -> bool).
Hypothesis same : forall x y s t, such x -> such y -> ends goes_on s = true -> ends goes_on t = true ->
  show x ++ s = show y ++ t -> x = y /\ s = t.
Hypothesis shown : forall x, such x -> exists ch w, show x = String ch w /\ goes_on ch = true.
Hypothesis comma : goes_on "," = false.

Definition no_list (ch : ascii) : bool := goes_on ch || Ascii.eqb ch ",".

Lemma same_lists xs : forall ys s t, Forall such xs -> Forall such ys -> ends no_list s = true -> ends no_list t = true ->
  joined ", " (map show xs) ++ s = joined ", " (map show ys) ++ t -> xs = ys /\ s = t.
Proof.
  assert (forall ch s, ends no_list (String ch s) = true -> goes_on ch = false /\ ch <> ","%char) as Ends.
  { intros ch s H. cbn [ends] in H. unfold no_list in H. apply negb_true_iff, orb_false_iff in H as (G & C).
    split; [exact G|]. intros ->. discriminate C. }
  assert (forall x s t, such x -> ends no_list t = true -> show x ++ s <> t) as Head.
  { intros x s t X T E. destruct (shown x X) as (ch & w & Sh & G). rewrite Sh in E. subst t.
    destruct (Ends _ _ T) as (G' & _). congruence. }
  assert (forall s, ends no_list s = true -> ends goes_on s = true) as On.
  { intros s. apply ends_sooner. intros ch H. unfold no_list. rewrite H. reflexivity. }
  induction xs as [|x xs IH]; intros [|y ys] s t Xs Ys S T E; cbn [map] in E; rewrite ?joined_form, ?append_associates in E.
  - auto.
  - inversion Ys; subst. exfalso. symmetry in E. exact (Head _ _ _ H1 S E).
  - inversion Xs; subst. exfalso. exact (Head _ _ _ H1 T E).
  - inversion Xs as [|? ? X Xs']; inversion Ys as [|? ? Y Ys']; subst.
    assert (forall zs u, ends no_list u = true ->
      ends goes_on (match map show zs with [] => "" | _ => ", " ++ joined ", " (map show zs) end ++ u) = true) as More.
    { intros [|z zs] u U; [exact (On u U)|]. cbn [map append ends]. rewrite comma. reflexivity. }
    apply same in E as (-> & E); trivial; [|apply (More xs s S) | apply (More ys t T)].
    destruct xs as [|x' xs], ys as [|y' ys]; cbn [map append] in E.
    + auto.
    + subst s. exfalso. destruct (Ends _ _ S) as (_ & C). contradiction.
    + subst t. exfalso. destruct (Ends _ _ T) as (_ & C). contradiction.
    + injection E as E. destruct (IH (y' :: ys) s t Xs' Ys' S T E) as (Same & ->). rewrite Same. auto.
Qed.
End Listed.

Definition list_ends : string -> bool := ends (no_list in_rational).

Lemma same_listed xs ys s t : forallb from_0 xs = true -> forallb from_0 ys = true -> list_ends s = true -> list_ends t = true ->
  listed xs ++ s = listed ys ++ t -> xs = ys /\ s = t.
Proof.
  unfold listed, map_all. rewrite !map_all_map, !forallb_forall, <- !Forall_forall.
  apply (same_lists Q show_rational (fun x => from_0 x = true) in_rational).
  - exact same_rationals.
  - intros x X. apply Z.leb_le, integer_text in X as (ch & w & E & D & _). rewrite <- (append_nothing (show_rational x)), rational_form, E.
    eexists ch, _. split; [reflexivity|]. unfold in_rational. rewrite D. reflexivity.
  - reflexivity.
Qed.

Lemma same_steps ns ms s t : forallb (Z.leb 0) ns = true -> forallb (Z.leb 0) ms = true ->
  joined ", " (map_all show_integer ns) ++ String " " s = joined ", " (map_all show_integer ms) ++ String " " t -> ns = ms /\ s = t.
Proof.
  unfold map_all. rewrite !map_all_map, !forallb_forall, <- !Forall_forall. intros N M E.
  apply (same_lists Z show_integer (fun n => (0 <=? n)%Z = true) in_number) in E as (-> & E); trivial.
  - injection E as ->. auto.
  - intros m n u v H H'. apply Z.leb_le in H, H'. apply same_numbers; assumption.
  - intros n H. apply Z.leb_le, integer_text in H as (ch & w & E' & D & _). eauto.
Qed.

(* No list of some numbers begins with another character. *)
Lemma listed_head x xs s ch w : from_0 x = true -> in_number ch = false -> listed (x :: xs) ++ s <> String ch w.
Proof.
  intros X C E. unfold listed, map_all in E. rewrite map_all_map in E. cbn [map] in E.
  rewrite joined_form, append_associates, rational_form in E.
  apply Z.leb_le, integer_text in X as (ch' & v & I & D & _). rewrite I in E. injection E as -> _. congruence.
Qed.

(* ---- Phrases ------------------------------------------------------------------------------------------- *)

(* What a phrase says. *)
Inductive blend_part :=
| InSteps (M : Z)
| ShareOf (stockpile : string) (x y : Q)
| AtMost (K : Z)
| ModulusOf (st : standard) (x y : Q)
| FactorOf (x y : Q)
| CostsOf (cs : list Q)
| TargetsOf (ts : list Q)
| SievesOf (ss : list Q)
| InterpolatedIn (stockpile : string) (at_ : interpolation).

Definition blend_phrase (p : blend_part) : string :=
  match p with
  | InSteps M => "shares in steps of 1/" ++ show_integer M
  | ShareOf name x y => "share of " ++ in_quotes name ++ from_to x y
  | AtMost K => "at most " ++ show_integer K ++ " stockpiles"
  | ModulusOf st x y => "fineness modulus of " ++ standard_name st ++ from_to x y
  | FactorOf x y => "coarseness factor" ++ from_to x y
  | CostsOf cs => "costs " ++ listed cs
  | TargetsOf ts => "targets " ++ listed ts ++ " percent"
  | SievesOf ss => "sieves in mm " ++ listed ss
  | InterpolatedIn name at_ => in_quotes name ++ " interpolated linear in size at " ++ joined " and at " (places_of at_)
  end.

Definition said_at_all (p : blend_part) : bool :=
  match p with
  | InSteps n | AtMost n => (0 <=? n)%Z
  | ShareOf _ x y | ModulusOf _ x y | FactorOf x y => both_from_0 x y
  | CostsOf xs | TargetsOf xs | SievesOf xs => forallb from_0 xs
  | InterpolatedIn _ at_ => forallb from_0 (at_sieves at_) && match places_of at_ with [] => false | _ => true end
  end.

(* What follows a phrase. *)
Definition phrase_ends (w : string) : bool :=
  match w with String ch _ => Ascii.eqb ch ";" || Ascii.eqb ch ")" | EmptyString => true end.

Lemma phrase_ends_list s : phrase_ends s = true -> list_ends s = true.
Proof. destruct s as [|ch s]; [reflexivity|]. cbn. rewrite orb_true_iff, !Ascii.eqb_eq. intros [-> | ->]; reflexivity. Qed.
Lemma list_ends_rational s : list_ends s = true -> rational_ends s = true.
Proof. apply ends_sooner. intros ch H. unfold no_list. rewrite H. reflexivity. Qed.

Lemma same_from_to x y x' y' s t : both_from_0 x y = true -> both_from_0 x' y' = true -> phrase_ends s = true -> phrase_ends t = true ->
  from_to x y ++ s = from_to x' y' ++ t -> x = x' /\ y = y' /\ s = t.
Proof.
  unfold both_from_0, from_to. intros X X' S T E. apply andb_prop in X as (X & Y), X' as (X' & Y'). rewrite !append_associates in E.
  apply same_after, same_rationals in E as (-> & E); trivial.
  apply same_after, same_rationals in E as (-> & E); trivial; try (apply list_ends_rational, phrase_ends_list; assumption). auto.
Qed.

Lemma places_form at_ s : joined " and at " (places_of at_) ++ s =
  (match at_sieves at_ with [] => "" | ss => listed ss ++ (if at_modulus at_ || at_factor at_ then " and at " else "") end) ++
  (if at_modulus at_ then "sieves of the modulus" ++ (if at_factor at_ then " and at " else "") else "") ++
  (if at_factor at_ then "sieves of the factor" else "") ++ s.
Proof.
  unfold places_of. destruct (at_sieves at_) as [|x xs], (at_modulus at_), (at_factor at_); cbn [app orb]; rewrite ?joined_form;
    rewrite ?append_associates; reflexivity.
Qed.

Lemma same_places a b s t : forallb from_0 (at_sieves a) = true -> forallb from_0 (at_sieves b) = true ->
  places_of a <> [] -> places_of b <> [] -> phrase_ends s = true -> phrase_ends t = true ->
  joined " and at " (places_of a) ++ s = joined " and at " (places_of b) ++ t -> a = b /\ s = t.
Proof.
  intros A B NA NB S T E. rewrite !places_form in E. destruct a as [xs m f], b as [ys m' f']. cbn [at_sieves at_modulus at_factor] in *.
  set (words := fun (m f : bool) u => (if m then "sieves of the modulus" ++ (if f then " and at " else "") else "") ++
    (if f then "sieves of the factor" else "") ++ u).
  assert (forall m f m' f' u v, phrase_ends u = true -> phrase_ends v = true -> words m f u = words m' f' v ->
    m || f = true -> m' || f' = true -> m = m' /\ f = f' /\ u = v) as Words.
  { clear. intros [] [] [] [] u v U V E N N'; try discriminate N; try discriminate N'; unfold words in E;
      cbn [append] in E; repeat (injection E as E); try discriminate E; auto; subst; try discriminate U; discriminate V. }
  change ((if m then "sieves of the modulus" ++ (if f then " and at " else "") else "") ++
    (if f then "sieves of the factor" else "") ++ s) with (words m f s) in E.
  change ((if m' then "sieves of the modulus" ++ (if f' then " and at " else "") else "") ++
    (if f' then "sieves of the factor" else "") ++ t) with (words m' f' t) in E.
  assert (forall m f u, m || f = true -> exists w, words m f u = String "s" w) as Head
    by (intros [] [] u H; try discriminate H; eexists; reflexivity).
  destruct xs as [|x xs], ys as [|y ys].
  - destruct (m || f) eqn:M, (m' || f') eqn:M'; try (apply orb_false_iff in M as (-> & ->); contradiction NA; reflexivity);
      try (apply orb_false_iff in M' as (-> & ->); contradiction NB; reflexivity).
    apply Words in E as (-> & -> & ->); auto.
  - exfalso. destruct (m || f) eqn:M; [|apply orb_false_iff in M as (-> & ->); contradiction NA; reflexivity].
    destruct (Head _ _ s M) as (w & W). cbn [append] in E. rewrite W, append_associates in E. symmetry in E. cbn [forallb] in B.
    apply andb_prop in B as (B & _). revert E. apply listed_head; [exact B | reflexivity].
  - exfalso. destruct (m' || f') eqn:M; [|apply orb_false_iff in M as (-> & ->); contradiction NB; reflexivity].
    destruct (Head _ _ t M) as (w & W). cbn [append] in E. rewrite W, append_associates in E. cbn [forallb] in A.
    apply andb_prop in A as (A & _). revert E. apply listed_head; [exact A | reflexivity].
  - rewrite !append_associates in E.
    assert (forall (b : bool) m f u, phrase_ends u = true -> b = m || f ->
      list_ends ((if b then " and at " else "") ++ words m f u) = true) as End.
    { intros b k g u U ->. destruct k, g; try reflexivity. exact (phrase_ends_list u U). }
    apply same_listed in E as (Same & E); trivial; try (apply End; trivial). injection Same as -> ->.
    destruct (m || f) eqn:M, (m' || f') eqn:M'.
    + apply same_after, Words in E as (-> & -> & ->); auto.
    + apply orb_false_iff in M' as (-> & ->). cbn [append] in E. unfold words in E at 2. cbn [append] in E. subst t. discriminate T.
    + apply orb_false_iff in M as (-> & ->). cbn [append] in E. unfold words in E at 1. cbn [append] in E. subst s. discriminate S.
    + apply orb_false_iff in M as (-> & ->), M' as (-> & ->). cbn [append] in E. unfold words in E. cbn [append] in E. subst. auto.
Qed.

(* A phrase says one part. *)
Lemma same_blend_phrases p q s t : said_at_all p = true -> said_at_all q = true -> phrase_ends s = true -> phrase_ends t = true ->
  blend_phrase p ++ s = blend_phrase q ++ t -> p = q /\ s = t.
Proof.
  intros P Q S T E. pose proof (phrase_ends_list _ S) as S'. pose proof (phrase_ends_list _ T) as T'.
  pose proof (rational_ends_number _ (list_ends_rational _ S')) as Sn. pose proof (rational_ends_number _ (list_ends_rational _ T')) as Tn.
  destruct p, q; cbn [said_at_all] in P, Q; cbn [blend_phrase] in E; rewrite ?append_associates in E; try discriminate E;
    rewrite ?Z.leb_le in P, Q.
  - apply same_after, same_numbers in E as (-> & ->); auto.
  - apply same_after, same_names in E as (-> & E). apply same_from_to in E as (-> & -> & ->); auto.
  - apply same_after, same_numbers in E as (-> & E); trivial. apply same_after in E as ->. auto.
  - apply same_after in E. destruct st, st0; try discriminate E; apply same_after, same_from_to in E as (-> & -> & ->); auto.
  - apply same_after, same_from_to in E as (-> & -> & ->); auto.
  - apply same_after, same_listed in E as (-> & ->); auto.
  - apply same_after, same_listed in E as (-> & E); trivial. apply same_after in E as ->. auto.
  - apply same_after, same_listed in E as (-> & ->); auto.
  - apply same_names in E as (-> & E). apply andb_prop in P as (P & NP), Q as (Q & NQ).
    apply same_after, same_places in E as (-> & ->); auto; intro H; [rewrite H in NP; discriminate NP | rewrite H in NQ; discriminate NQ].
Qed.

(* Phrases that a line has between its brackets. *)
Lemma same_blend_parts ps : forall qs, forallb said_at_all ps = true -> forallb said_at_all qs = true -> ps <> [] -> qs <> [] ->
  joined "; " (map blend_phrase ps) ++ ")" = joined "; " (map blend_phrase qs) ++ ")" -> ps = qs.
Proof.
  induction ps as [|p ps IH]; intros [|q qs] P Q NP NQ E; try contradiction. cbn [map] in E. rewrite !joined_form, !append_associates in E.
  cbn [forallb] in P, Q. apply andb_prop in P as (P & Ps), Q as (Q & Qs).
  apply same_blend_phrases in E as (-> & E); trivial; try (destruct ps; reflexivity); try (destruct qs; reflexivity).
  f_equal. destruct ps as [|p ps], qs as [|q' qs]; cbn [map append] in E; try discriminate E; [reflexivity|].
  injection E as E. apply IH; trivial; discriminate.
Qed.
