(* What a gradation file in CSV says are decimals, in whatever unit, and no more rows than a file may have. *)

From Coq Require Import ZArith QArith Qreduction Qcanon String Ascii List Bool Lia.
From Mdm Require Import Numbers Gradation Certificate Text Decimals SieveNames Rows Csv NumberTexts CsvRead.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- Decimals ------------------------------------------------------------------------------------------ *)

(* In lowest terms, as all numbers of a gradation. *)
Definition good (x : Q) : Prop := is_decimal x /\ Qred x = x.

Lemma reduced_decimal x : is_decimal x -> good (Qred x).
Proof.
  intros (k & K & D). split; [|apply Qred_involutive]. exists k. split; [exact K|]. apply Z.divide_trans with (2 := D).
  pose proof (Qred_correct x) as E. unfold Qeq in E.
  apply Z.gauss with (Qnum (Qred x)); [exists (Qnum x); exact E|]. rewrite Z.gcd_comm. apply Qred_iff, Qred_involutive.
Qed.

Lemma decimal_times x y : is_decimal x -> is_decimal y -> is_decimal (x * y).
Proof.
  intros (k & K & D) (l & L & E). exists (k + l). split; [lia|]. cbn [Qmult Qden]. rewrite Pos2Z.inj_mul, Z.pow_add_r by lia.
  apply Z.mul_divide_mono_l with (p := Zpos (Qden x)) in E. apply Z.mul_divide_mono_r with (p := 10 ^ l) in D.
  exact (Z.divide_trans _ _ _ E D).
Qed.

Lemma decimal_plus x y : is_decimal x -> is_decimal y -> is_decimal (x + y).
Proof. intros X Y. exact (decimal_times x y X Y). Qed.

Lemma decimal_integer n : is_decimal (of_integer n).
Proof. exists 0. split; [lia | apply Z.divide_refl]. Qed.

Lemma decimal_power n : is_decimal (power_of_ten n).
Proof.
  unfold power_of_ten. destruct (Z.leb_spec 0 n); [apply decimal_integer|]. exists (- n). split; [lia|]. cbn [Qden].
  rewrite Z2Pos.id by (apply Z.pow_pos_nonneg; lia). apply Z.divide_refl.
Qed.

Lemma good_times x y : is_decimal x -> is_decimal y -> good (times x y).
Proof. intros X Y. apply reduced_decimal, decimal_times; assumption. Qed.
Lemma good_add x y : is_decimal x -> is_decimal y -> good (add x y).
Proof. intros X Y. apply reduced_decimal, decimal_plus; assumption. Qed.
Lemma good_subtract x y : is_decimal x -> is_decimal y -> good (subtract x y).
Proof. intros X Y. apply reduced_decimal. exact (decimal_plus x (Qopp y) X Y). Qed.

Lemma good_half x : is_decimal x -> good (over x (of_integer 2)).
Proof.
  intro X. apply reduced_decimal. apply (decimal_times x (/ of_integer 2) X). exists 1. split; [lia|]. exists 5. reflexivity.
Qed.

Lemma good_0 : good 0.
Proof. split; [exact (decimal_integer 0) | reflexivity]. Qed.
Lemma good_1 : good 1.
Proof. split; [exact (decimal_integer 1) | reflexivity]. Qed.
Lemma good_100 : good (of_integer 100).
Proof. split; [exact (decimal_integer 100) | reflexivity]. Qed.

Lemma read_decimal_good point w x : read_decimal point w = Ok x -> good x.
Proof.
  unfold read_decimal. destruct (signed w) as (sign, unsigned). destruct (file_digits unsigned 0 0) as ((whole, n), rest).
  destruct (match rest with
            | String ch places => if Ascii.eqb ch point then file_digits places whole n else (whole, n, rest)
            | EmptyString => (whole, n, rest)
            end) as ((value, all), rest').
  destruct (exponent_of rest') as [exponent|]; [|discriminate]. destruct (all <? 1); [discriminate|].
  destruct (most_digits_of_file <? all); [discriminate|]. destruct (most_exponent <? Z.abs exponent); [discriminate|].
  generalize (sign * value). intros m E. assert (times (of_integer m) (power_of_ten (exponent - (all - n))) = x) as <- by congruence.
  apply good_times; [apply decimal_integer | apply decimal_power].
Qed.

(* ---- Sieves ------------------------------------------------------------------------------------------- *)

Definition some_places (x : Q) : bool := 10 ^ 3 mod Zpos (Qden x) =? 0.

Lemma some_places_decimal x : some_places x = true -> is_decimal x.
Proof.
  intro E. exists 3. split; [lia|]. apply Z.eqb_eq in E. apply Z.mod_divide; [lia | exact E].
Qed.

Definition decimal_kind (k : sieve_kind) : bool :=
  match k with Length u => some_places u | Of_table openings => forallb (fun entry => some_places (fst entry)) openings end.

Lemma kinds_decimal : forallb (fun k => decimal_kind (snd k)) sieve_kinds = true.
Proof. reflexivity. Qed.

Lemma kind_found name kinds middle k : kind_of_name name kinds = Some (middle, k) -> exists marks, In (marks, k) kinds.
Proof.
  induction kinds as [|((before, after), k') kinds IH]; [discriminate|]. cbn [kind_of_name].
  destruct (between_marks before after name).
  - intros [= _ ->]. exists (before, after). left. reflexivity.
  - intro E. destruct (IH E) as (marks & I). exists marks. right. exact I.
Qed.

Lemma sieve_opening_good name point x : sieve_opening name point = Ok x -> good x.
Proof.
  unfold sieve_opening. destruct (kind_of_name name sieve_kinds) as [(middle, k)|] eqn:K; [|discriminate].
  apply kind_found in K as (marks & I). pose proof kinds_decimal as D. rewrite forallb_forall in D. specialize (D _ I).
  cbn [snd] in D. destruct k as [u|openings]; cbn [decimal_kind] in D.
  - destruct (read_decimal point middle) as [y| |] eqn:R; try discriminate. intros [= <-].
    apply good_times; [apply (read_decimal_good _ _ _ R) | apply some_places_decimal, D].
  - destruct (find (fun entry => String.eqb (snd entry) middle) openings) as [(opening, ?)|] eqn:F; [|discriminate].
    apply find_some in F as (J & _). intros [= <-]. rewrite forallb_forall in D. apply reduced_decimal, some_places_decimal.
    exact (D _ J).
Qed.

(* ---- Rows of CSV ---------------------------------------------------------------------------------------- *)

(* What an entry says: decimals, and no factor or tolerance where the file has none. *)
Record entry_good (t c : bool) (e : entry) : Prop := {
  size_good : forall x, size_of e = Some x -> good x;
  value_good : good (value_of e);
  most_good : good (most_of e);
  factor_good : good (factor_of e);
  tolerance_good : good (tolerance_of e);
  no_tolerance : t = false -> tolerance_of e = 0%Q;
  no_factor : c = false -> factor_of e = 1%Q }.

Lemma number_good delimiter point w x point' : read_number delimiter point w = Ok (x, point') -> good x.
Proof.
  unfold read_number. destruct (point_for delimiter point w) as [(p, k)| |]; try discriminate. cbn [bind].
  destruct (read_decimal p w) as [y| |] eqn:R; try discriminate. intros [= <- _]. exact (read_decimal_good _ _ _ R).
Qed.

Lemma read_size_good unit delimiter point w size point' x :
  read_size unit delimiter point w = Ok (size, point') -> size = Some x -> good x.
Proof.
  unfold read_size. destruct (String.eqb (lower_case w) "pan"); [intros [= <- _]; discriminate|].
  assert (forall r, r = read_number delimiter point w ->
    (let* (x, known) := r in Ok (Some x, known)) = Ok (size, point') -> size = Some x -> good x) as N.
  { intros [(y, p)| |] R; try discriminate. intros [= <- _] [= <-]. symmetry in R. exact (number_good _ _ _ _ _ R). }
  destruct unit; try (apply N; reflexivity).
  destruct (if is_length (normal_name w) then point_for delimiter point (normal_name w) else Ok ("."%char, point)) as [(p, k)| |];
    try discriminate. cbn [bind].
  destruct (sieve_opening (normal_name w) p) as [y| |] eqn:S; try discriminate. intros [= <- _] [= <-].
  exact (sieve_opening_good _ _ _ S).
Qed.

Lemma further_good columns : forall fields delimiter point e e' point',
  read_further columns fields delimiter point e = Ok (e', point') ->
  forall t c, entry_good t c e ->
  entry_good (t || existsb (fun column => match column with Tolerance => true | _ => false end) columns)
             (c || existsb (fun column => match column with Factor => true | _ => false end) columns) e'.
Proof.
  induction columns as [|column columns IH]; intros [|field fields] delimiter point e e' point' E t c G; try discriminate E.
  - injection E as <- _. cbn [existsb]. rewrite !orb_false_r. exact G.
  - cbn [read_further] in E. destruct (read_number delimiter point field) as [(x, p)| |] eqn:R; try discriminate E. cbn [bind] in E.
    apply number_good in R. destruct e as [s v m f tol l]. destruct G as [Gs Gv Gm Gf Gt Nt Nf].
    cbn [size_of value_of most_of factor_of tolerance_of] in *. cbn [existsb].
    destruct column; rewrite ?orb_true_l, ?orb_false_l.
    + rewrite orb_true_r. refine (IH _ _ _ _ _ _ E true c _). split; auto. discriminate.
    + rewrite orb_true_r. refine (IH _ _ _ _ _ _ E t true _). split; auto. discriminate.
    + refine (IH _ _ _ _ _ _ E t c _). split; auto.
Qed.

Lemma read_entry_good h delimiter point fields line e point' :
  read_entry h delimiter point fields line = Ok (e, point') -> entry_good (has_tolerance h) (has_factor h) e.
Proof.
  unfold read_entry. destruct fields as [|size [|value others]]; try discriminate.
  destruct (read_size (unit_of h) delimiter point size) as [(s, p1)| |] eqn:S; try discriminate. cbn [bind].
  destruct (read_number delimiter p1 value) as [(v, p2)| |] eqn:V; try discriminate. cbn [bind]. intro E.
  apply (further_good _ _ _ _ _ _ _ E false false). split; auto using good_0, good_1.
  - intros x. apply (read_size_good _ _ _ _ _ _ _ S).
  - exact (number_good _ _ _ _ _ V).
Qed.

(* Where a file has limits it has neither tolerances nor factors. *)
Lemma header_limits names h : header_of names = Some h -> quantity_of h = Limits -> has_tolerance h = false /\ has_factor h = false.
Proof.
  unfold header_of. destruct names as [|size [|second others]]; try discriminate.
  destruct (list_eq_dec string_dec (second :: others) limits_columns).
  - destruct (named_one size_units size); [|discriminate]. intros [= <-] _. split; reflexivity.
  - destruct (named_one size_units size); [|discriminate].
    destruct (named_one quantities second) as [what|] eqn:N; [|discriminate]. destruct (further_columns others); [|discriminate].
    intros [= <-]. cbn [quantity_of]. intros ->. unfold named_one in N.
    destruct (find (fun entry => String.eqb (fst entry) second) quantities) as [(name, q)|] eqn:F; [|discriminate N].
    injection N as ->. apply find_some in F as (I & _). cbn in I. repeat (destruct I as [I|I]; [discriminate I|]). destruct I.
Qed.

(* ---- Lines ---------------------------------------------------------------------------------------------- *)

Record state_good (st : state) : Prop := {
  state_none : header_found st = None -> entries st = [] /\ count_of st = 0;
  state_entries : forall h line, header_found st = Some (h, line) ->
    Forall (entry_good (has_tolerance h) (has_factor h)) (entries st) /\
    (quantity_of h = Limits -> has_tolerance h = false /\ has_factor h = false);
  state_count : count_of st = Z.of_nat (List.length (entries st)) /\ count_of st <= most_rows }.

Lemma row_line_good st h begins fields line st' :
  state_good st -> header_found st = Some (h, begins) -> read_row_line st h begins fields line = Ok st' -> state_good st'.
Proof.
  intros [N E C] H. unfold read_row_line, demand_at. destruct (Z.ltb_spec (count_of st) most_rows) as [L|L]; [|discriminate]. cbn [bind].
  destruct (read_entry h (delimiter_of st) (point_of st) fields line) as [(e, p)| |] eqn:R; try discriminate.
  cbn [on_line bind]. intros [= <-]. destruct (E _ _ H) as (G & Lim). split; cbn [header_found entries count_of].
  - discriminate.
  - intros ? ? [= <- <-]. split; [|exact Lim]. constructor; [exact (read_entry_good _ _ _ _ _ _ _ R) | exact G].
  - cbn [List.length]. lia.
Qed.

Lemma header_line_good st w line st' : read_header_line st w line = Ok st' -> state_good st'.
Proof.
  unfold read_header_line. destruct (fields_of (if has ";" w then ";" else ",")%char w) as [names|]; [|discriminate].
  destruct (header_of names) as [h|] eqn:H; [|discriminate]. intros [= <-]. split; cbn [header_found entries count_of].
  - discriminate.
  - intros ? ? [= <- <-]. split; [constructor | exact (header_limits _ _ H)].
  - split; [reflexivity | unfold most_rows; lia].
Qed.

Lemma line_good st w line st' : state_good st -> read_line st w line = Ok st' -> state_good st'.
Proof.
  intros G. unfold read_line. destruct (without_first is_blank w) as [|ch behind]; [intros [= <-]; exact G|].
  destruct (Ascii.eqb ch "#").
  - unfold read_comment, demand_at.
    match goal with |- context [if ?b then Ok tt else _] => destruct b end; [|discriminate]. intros [= <-]. exact G.
  - destruct (header_found st) as [(h, begins)|] eqn:H; [|apply header_line_good].
    destruct (fields_of (delimiter_of st) w) as [fields|]; [|discriminate]. apply row_line_good; assumption.
Qed.

Lemma lines_good w : forall current line st st', state_good st -> read_lines w current line st = Ok st' -> state_good st'.
Proof.
  induction w as [|ch w IH]; intros current line st st' G E; cbn [read_lines] in E; [exact (line_good _ _ _ _ G E)|].
  destruct (Ascii.eqb ch line_feed); [|exact (IH _ _ _ _ G E)].
  match type of E with match ?r with _ => _ end = _ => destruct r as [st1| |] eqn:R end; try discriminate E.
  exact (IH _ _ _ _ (line_good _ _ _ _ G R) E).
Qed.

(* What is read of a file is the gradation of such entries. *)
Definition from_entries (R : reading) : Prop :=
  exists unit what t c line es,
    gradation_of_entries unit what t c line es = Ok R /\ Forall (entry_good t c) es /\
    Z.of_nat (List.length es) <= most_rows /\ (what = Limits -> t = false /\ c = false).

Theorem csv_entries w R : read_csv w = Ok R -> from_entries R.
Proof.
  unfold read_csv. destruct (read_lines w "" 1 start) as [st| |] eqn:L; try discriminate. cbn [bind].
  apply lines_good in L; [|split; cbn; [split; reflexivity | discriminate | unfold most_rows; lia]].
  destruct (header_found st) as [(h, line)|] eqn:H; [|discriminate].
  unfold demand_at. match goal with |- context [if ?b then Ok tt else _] => destruct b end; [|discriminate]. cbn [bind].
  intro E. destruct L as [_ G C]. destruct (G _ _ H) as (Es & Lim).
  exists (unit_of h), (quantity_of h), (has_tolerance h), (has_factor h), line, (rev' (entries st)).
  split; [exact E|]. rewrite rev'_is_rev, rev_length. split; [apply Forall_rev, Es|]. split; [lia | exact Lim].
Qed.
