(* The sizes that a file says can be printed, and are the same sizes where they are read again. *)

From Coq Require Import ZArith QArith Qabs Qreduction Qcanon String Ascii List Bool Permutation Lia.
From Mdm Require Import Numbers Gradation Certificate Text Decimals Rows Csv GradationFile NumberTexts CsvFields
  CsvRead GradationRead SortedRows FileRoot CsvEntries.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(* As [plain_size], but for the number of digits. *)
Definition size_form (unit : size_unit) (d : Z) (x : Q) : Prop :=
  match unit with
  | Phi => x = 0%Q \/ exists n, x = power_of_two n /\ good (fraction (Z.abs n) d)
  | Inches | SieveNames => False
  | _ => good x
  end.

Lemma short_size unit d x :
  size_form unit d x -> 0 <= Qnum x -> is_short (show_size unit d x) = true -> plain_size unit d x.
Proof.
  intros F P S. destruct unit; try contradiction; try (destruct F; repeat split; assumption).
  destruct F as [->|(n & -> & D & R)]; [left; reflexivity|]. right. exists n. split; [reflexivity|].
  split; [|split; [exact D | split; [exact R|]]].
  - unfold fraction. pose proof (Qred_correct (Z.abs n # Z.to_pos d)) as E. unfold Qeq in E. cbn [Qnum Qden] in E. nia.
  - rewrite phi_shown in S. cbv zeta in S. destruct (0 <? n); [|exact S]. unfold is_short in *. apply Z.leb_le in S. apply Z.leb_le.
    rewrite string_length_text in *. cbn [text_length] in S.
    change (has "." (String "-" ?w)) with (has "." w) in S. lia.
Qed.

(* ---- Texts ---------------------------------------------------------------------------------------------- *)

Lemma decimal_text x : 0 <= Qnum x -> good x -> field_text (show_decimal x).
Proof.
  intros P (D & _). destruct (decimal_of_number x P D) as (E & N). split; [|exact N].
  exact (every_implies _ _ _ number_of_field E).
Qed.

Lemma form_text u d x : size_form u d x -> 0 <= Qnum x -> field_text (show_size u d x).
Proof.
  intros F P. destruct u; try contradiction; try (apply decimal_text; assumption).
  destruct F as [->|(n & -> & G)]; [split; [reflexivity | discriminate]|]. rewrite phi_shown. cbv zeta.
  destruct (decimal_text (fraction (Z.abs n) d)) as (E & N); [|exact G|].
  - unfold fraction. pose proof (Qred_correct (Z.abs n # Z.to_pos d)) as Q. unfold Qeq in Q. cbn [Qnum Qden] in Q. nia.
  - destruct (0 <? n); [|split; assumption]. split; [exact E | discriminate].
Qed.

(* What --print demands of each line. *)
Definition short_line (l : string) : bool :=
  match fields_of "," l with Some fields => forallb is_short fields | None => false end.

Lemma short_fields fields : fields <> [] -> (forall w, In w fields -> field_text w) -> short_line (joined "," fields) = true ->
  forall w, In w fields -> is_short w = true.
Proof. intros N T S. unfold short_line in S. rewrite texts_fields in S by assumption. apply forallb_forall, S. Qed.

(* ---- The root ------------------------------------------------------------------------------------------- *)

(* What the root of a file is to its sizes. *)
Lemma root_of_file unit es d : file_root unit es = Ok d ->
  1 <= d /\ match unit with Phi => forall phi, has_phi es phi -> Z.divide (Zpos (Qden phi)) d | _ => d = 1 end.
Proof.
  unfold file_root. destruct unit; try (intros [= <-]; split; [lia | reflexivity]).
  destruct (phi_root es 1 0) as [(d1, g1)| |] eqn:F; try discriminate. cbn [bind].
  destruct (at_most _ _); [|discriminate]. intros [= ->].
  destruct (root_found _ _ _ _ _ (Z.le_refl 1) F) as (P & _ & _ & _ & Each & _). split; [exact P|]. intros phi H. apply Each, H.
Qed.

Lemma phi_times d phi : 1 <= d -> Z.divide (Zpos (Qden phi)) d ->
  forall n, n = Qnum phi * (d / Zpos (Qden phi)) -> Qeq (n # Z.to_pos d) phi.
Proof.
  intros D (k & E) n ->. unfold Qeq. cbn [Qnum Qden].
  rewrite Z2Pos.id by lia. rewrite E at 1. rewrite E, Z.div_mul by lia. ring.
Qed.

Lemma opening_form unit es d e : file_root unit es = Ok d -> In e es -> (forall x, size_of e = Some x -> good x) -> size_form (printed_unit unit) d (opening_of unit d (size_of e)).
Proof.
  intros root_is I G. destruct (root_of_file _ _ _ root_is) as (D & R). destruct (size_of e) as [x|] eqn:S.
  - specialize (G x eq_refl). destruct unit; cbn [printed_unit size_form opening_of]; try exact G.
    + apply good_times; [apply G|]. exists 1. split; [lia|]. exists 2. reflexivity.
    + right. eexists. split; [reflexivity|]. rewrite Z.abs_opp.
      assert (Z.divide (Zpos (Qden x)) d) as Dv by (apply R; exists e; auto).
      assert (fraction (Z.abs (Qnum x * (d / Zpos (Qden x)))) d = Qred (Qabs x)) as ->.
      { unfold fraction. apply Qred_complete. rewrite <- (phi_times d x D Dv _ eq_refl) at 3. reflexivity. }
      apply reduced_decimal. destruct G as (G & _). destruct x. exact G.
  - destruct unit; cbn [printed_unit size_form opening_of]; try exact good_0. left. reflexivity.
Qed.

Lemma said_again es d e : file_root Phi es = Ok d -> In e es -> (forall x, size_of e = Some x -> good x) ->
  size_said Phi d (opening_of Phi d (size_of e)) = size_of e.
Proof.
  intros root_is I G. destruct (root_of_file _ _ _ root_is) as (D & R). destruct (size_of e) as [x|] eqn:S; [|reflexivity].
  assert (Z.divide (Zpos (Qden x)) d) as Dv by (apply R; exists e; auto). destruct (G x eq_refl) as (_ & Red).
  cbn [opening_of]. unfold phi_opening, size_said. rewrite power_not_zero, exponent_of_power, Z.opp_involutive. f_equal.
  unfold fraction. rewrite <- Red at 3. apply Qred_complete, phi_times; trivial.
Qed.

(* Other entries with the same sizes, and perhaps a pan. *)
Lemma root_again unit es d es' : file_root unit es = Ok d -> Forall (fun e => forall x, size_of e = Some x -> good x) es ->
  (forall e', In e' es' -> exists x, size_of e' = size_said (printed_unit unit) d x /\
     (x = 0%Q \/ exists e, In e es /\ x = opening_of unit d (size_of e))) ->
  (forall e, In e es -> exists e', In e' es' /\ size_of e' = size_said (printed_unit unit) d (opening_of unit d (size_of e))) ->
  (unit = Phi -> size es' <= size es) -> file_root (printed_unit unit) es' = Ok d.
Proof.
  intros root_is G To From L. destruct (root_of_file _ _ _ root_is) as (_ & R). rewrite Forall_forall in G.
  destruct unit; try (rewrite R; reflexivity). cbn [printed_unit] in *. apply (file_root_same Phi es); auto.
  - intro phi. split; intros (e & I & S).
    + destruct (From e I) as (e' & I' & S'). exists e'. split; [exact I'|]. rewrite S', (said_again es d e root_is I (G e I)). exact S.
    + destruct (To e I) as (x & Sx & [->|(e1 & I1 & ->)]); rewrite S in Sx; [discriminate Sx|].
      exists e1. split; [exact I1|]. rewrite (said_again es d e1 root_is I1 (G e1 I1)) in Sx. symmetry. exact Sx.
Qed.

(* ---- Entries in a list ------------------------------------------------------------------------------------ *)

Lemma entries_from_in {A} (g : A -> Z -> entry) xs : forall line e, In e (entries_from g xs line) -> exists x l, In x xs /\ e = g x l.
Proof.
  induction xs as [|x xs IH]; intros line e I; [destruct I|]. destruct I as [<-|I].
  - exists x, line. split; [left|]; reflexivity.
  - destruct (IH _ _ I) as (y & l & J & E). exists y, l. split; [right; exact J | exact E].
Qed.

Lemma in_entries_from {A} (g : A -> Z -> entry) xs x : In x xs -> forall line, exists l, In (g x l) (entries_from g xs line).
Proof.
  induction xs as [|y xs IH]; intros I line; [destruct I|]. destruct I as [->|I].
  - exists line. left. reflexivity.
  - destruct (IH I (line + 1)) as (l & J). exists l. right. exact J.
Qed.

Lemma entries_from_length {A} (g : A -> Z -> entry) xs : forall line, List.length (entries_from g xs line) = List.length xs.
Proof. induction xs as [|x xs IH]; intro line; cbn; [reflexivity|]. rewrite IH. reflexivity. Qed.
