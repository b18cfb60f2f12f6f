(* What a gradation file in JSON says are decimals, and no more rows than a file may have; with CsvEntries.v, of any file. *)

From Coq Require Import ZArith QArith String Ascii List Bool Lia.
From Mdm Require Import Numbers Gradation Certificate Text Decimals Rows GradationFile CsvRead CsvEntries Json.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

Definition column_good (column : option (list Q)) : Prop :=
  forall xs, column = Some xs -> Forall good xs /\ Z.of_nat (List.length xs) <= most_rows.

Record state_good (st : state) : Prop := {
  numbers_good : Forall good (numbers_of st);
  numbers_count : count_of st = Z.of_nat (List.length (numbers_of st)) /\ count_of st <= most_rows;
  sizes_good : column_good (sizes st);
  masses_good : column_good (masses st);
  factors_good : column_good (factors st);
  tolerances_good : column_good (tolerances st) }.

Lemma then_good st next : state_good st -> state_good (then_ st next).
Proof. destruct st as [nx sn un ns n ss ms fs ts]. intros [N C S M F T]. split; assumption. Qed.

Lemma key_good st key st' : state_good st -> with_key st key = Ok st' -> state_good st'.
Proof.
  destruct st as [nx sn un ns n ss ms fs ts]. intros [N C S M F T]. unfold with_key. destruct (find _ members) as [(?, m)|]; [|discriminate].
  destruct (negb _); [|discriminate]. intros [= <-]. split; assumption.
Qed.

Lemma unit_good st name st' : state_good st -> with_unit st name = Ok st' -> state_good st'.
Proof.
  destruct st as [nx sn un ns n ss ms fs ts]. intros [N C S M F T]. unfold with_unit. destruct (find _ json_units) as [(?, m)|]; [|discriminate].
  intros [= <-]. split; assumption.
Qed.

Lemma value_is_good t x : read_value t = Ok x -> good x.
Proof.
  unfold read_value, json_number. destruct t as [ch|w|w]; [discriminate | apply read_decimal_good|].
  destruct (negb (is_json_number w)); [discriminate|]. destruct (read_decimal "." w) as [y| |] eqn:R; try discriminate. cbn [bind].
  destruct (_ && _); [|discriminate]. intros [= <-]. exact (read_decimal_good _ _ _ R).
Qed.

Lemma with_number_good st of x st' : state_good st -> good x -> with_number st of x = Ok st' -> state_good st'.
Proof.
  destruct st as [nx sn un ns n ss ms fs ts]. intros [N C S M F T] G. unfold with_number. cbn [numbers_of count_of] in *.
  destruct (Z.ltb_spec n most_rows) as [L|L]; [|discriminate]. intros [= <-]. split; try assumption.
  - constructor; assumption.
  - cbn [numbers_of count_of List.length]. lia.
Qed.

Lemma with_column_good st of : state_good st -> state_good (with_column st of).
Proof.
  destruct st as [nx sn un ns n ss ms fs ts]. intros [N C S M F T]. cbn [numbers_of count_of sizes masses factors tolerances] in *.
  assert (column_good (Some (rev' ns))) as G.
  { intros xs [= <-]. rewrite rev'_is_rev, rev_length. split; [apply Forall_rev, N | lia]. }
  assert (Forall good [] /\ 0 <= most_rows) as (E & Z) by (split; [constructor | unfold most_rows; lia]).
  destruct of; split; cbn [with_column numbers_of count_of sizes masses factors tolerances List.length]; auto.
Qed.

Lemma token_good st t st' : state_good st -> read_token st t = Ok st' -> state_good st'.
Proof.
  intro G. assert (forall of, (let* x := read_value t in with_number st of x) = Ok st' -> state_good st') as Num.
  { intros of. destruct (read_value t) as [x| |] eqn:V; try discriminate. cbn [bind]. apply with_number_good; [exact G|].
    exact (value_is_good _ _ V). }
  assert (forall next, Ok (then_ st next) = Ok st' -> state_good st') as Then by (intros next [= <-]; apply then_good, G).
  assert (forall of, Ok (with_column st of) = Ok st' -> state_good st') as Col by (intros of [= <-]; apply with_column_good, G).
  unfold read_token, missing. destruct (next st) as [| | |m|[| |of]| |of|of|of|].
  - destruct (is_the _ t); [apply Then | discriminate].
  - destruct t; [destruct (is_the _ _); [apply Then | discriminate] | apply key_good, G | destruct (is_the _ _); [apply Then | discriminate]].
  - destruct t; try discriminate. apply key_good, G.
  - destruct (is_the _ t); [apply Then | discriminate].
  - destruct t; try discriminate; [apply Then|]. destruct (json_number w); try discriminate. apply Then.
  - destruct t; try discriminate. apply unit_good, G.
  - destruct (is_the _ t); [apply Then | discriminate].
  - destruct (is_the "," t); [apply Then|]. destruct (is_the _ t); [apply Then | discriminate].
  - destruct (is_the _ t); [apply Col | apply Num].
  - apply Num.
  - destruct (is_the "," t); [apply Then|]. destruct (is_the _ t); [apply Col | discriminate].
  - discriminate.
Qed.

Lemma tokens_good st ts st' : state_good st -> read_tokens st ts = Ok st' -> state_good st'.
Proof.
  intro G. destruct ts as [|t [|t' ts]]; cbn [read_tokens].
  - intros [= <-]. exact G.
  - apply token_good, G.
  - destruct (read_token st t) as [st1| |] eqn:R; try discriminate. cbn [bind]. apply token_good. exact (token_good _ _ _ G R).
Qed.

Lemma characters_good w : forall at_ line st at' st', state_good st -> read_characters w at_ line st = Ok (at', st') -> state_good st'.
Proof.
  induction w as [|ch w IH]; intros at_ line st at' st' G E; cbn [read_characters] in E; [injection E as _ <-; exact G|].
  destruct (read_character at_ st ch) as [(at1, st1)| |] eqn:R; try discriminate E. apply (IH _ _ _ _ _) in E; [exact E|].
  clear - R G. unfold read_character in R. destruct (next_place at_ ch) as [(at2, ts)| |]; try discriminate R. cbn [bind] in R.
  destruct ts as [|t ts]; [injection R as _ <-; exact G|].
  destruct (read_tokens st (t :: ts)) as [st2| |] eqn:T; try discriminate R. injection R as _ <-. exact (tokens_good _ _ _ G T).
Qed.

(* ---- Entries ------------------------------------------------------------------------------------------- *)

Lemma rest_of (column : option (list Q)) (default x : Q) xs :
  match column with None => Some (default, None) | Some (x :: xs) => Some (x, Some xs) | Some [] => None end = Some (x, xs) ->
  (forall l, column = Some l -> Forall good l) -> good default ->
  good x /\ (forall l, xs = Some l -> Forall good l) /\ is_there xs = is_there column /\ (is_there column = false -> x = default).
Proof.
  destruct column as [[|y l]|]; try discriminate; intros [= <- <-] G D.
  - specialize (G _ eq_refl). inversion G; subst. split; [assumption|]. split; [intros ? [= <-]; assumption|].
    split; [reflexivity | intro N; discriminate N].
  - split; [exact D|]. split; [discriminate|]. split; trivial.
Qed.

Lemma zipped_good xs : forall ms cs ts done es, zipped xs ms cs ts done = Some es ->
  Forall good xs -> Forall good ms -> (forall l, cs = Some l -> Forall good l) -> (forall l, ts = Some l -> Forall good l) ->
  Forall (entry_good (is_there ts) (is_there cs)) done ->
  Forall (entry_good (is_there ts) (is_there cs)) es /\ List.length es = (List.length xs + List.length done)%nat.
Proof.
  induction xs as [|x xs IH]; intros [|m ms] cs ts done es E Gx Gm Gc Gt D; try discriminate E; cbn [zipped] in E.
  - match type of E with (if ?b then _ else _) = _ => destruct b end; [|discriminate E]. injection E as <-.
    rewrite rev'_is_rev, rev_length. split; [apply Forall_rev, D | reflexivity].
  - match type of E with match ?r with _ => _ end = _ => destruct r as [(c, cs')|] eqn:Rc end; [|discriminate E].
    match type of E with match ?r with _ => _ end = _ => destruct r as [(t, ts')|] eqn:Rt end; [|discriminate E].
    destruct (rest_of _ _ _ _ Rc Gc good_1) as (G1 & Gc' & Tc & Nc). destruct (rest_of _ _ _ _ Rt Gt good_0) as (G2 & Gt' & Tt & Nt).
    inversion Gx as [|? ? Px Gx']; inversion Gm as [|? ? Pm Gm']; subst.
    rewrite <- Tc, <- Tt in *. destruct (IH _ _ _ _ _ E Gx' Gm' Gc' Gt') as (F & L).
    + constructor; [|exact D]. split; cbn [size_of value_of most_of factor_of tolerance_of]; auto using good_0. intros ? [= <-]. exact Px.
    + split; [exact F|]. rewrite L. cbn [List.length]. lia.
Qed.

Theorem json_entries w R : read_json w = Ok R -> from_entries R.
Proof.
  unfold read_json. destruct (read_characters w Between 1 start) as [(at_, st)| |] eqn:C; try discriminate. cbn [bind].
  apply characters_good in C; [|split; try (intros ? [=]); [constructor | cbn; unfold most_rows; lia]].
  destruct C as [_ _ S M F T]. unfold demand_at. destruct (match at_, next st with Between, Nothing => true | _, _ => false end); [|discriminate].
  cbn [bind]. destruct (sizes st) as [xs|]; [|discriminate]. destruct (masses st) as [ms|]; [|discriminate].
  destruct (one_way xs); [|discriminate]. cbn [bind].
  destruct (zipped xs ms (factors st) (tolerances st) []) as [es|] eqn:Z; [|discriminate]. intro E.
  destruct (S _ eq_refl) as (Gx & L). destruct (M _ eq_refl) as (Gm & _).
  destruct (zipped_good _ _ _ _ _ _ Z Gx Gm) as (G & Le); [intros l I; apply (F l I) | intros l I; apply (T l I) | constructor|].
  exists (unit_of st), Masses, (is_there (tolerances st)), (is_there (factors st)), 1, es.
  split; [exact E|]. split; [exact G|]. cbn [List.length] in Le. split; [lia | discriminate].
Qed.

Theorem file_entries file R : read_gradation file = Ok R -> from_entries R.
Proof.
  unfold read_gradation. destruct (string_length file 0 <=? most_text); [|discriminate]. cbn [demand_form bind].
  destruct (check_text file 0 1); try discriminate. cbn [bind].
  destruct (without_first is_space (without_mark file)) as [|ch w]; [apply csv_entries|].
  destruct (Ascii.eqb ch "{"); [apply json_entries | apply csv_entries].
Qed.
