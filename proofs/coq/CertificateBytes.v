(* A certificate's bytes are read as the lines that are printed. *)

From Coq Require Import ZArith QArith String Ascii List Bool Lia.
From Mdm Require Import Numbers Certificate Text Decimals Document CertificateText NumberTexts CertificateRead CsvFields CsvRead.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(* ---- Words ---------------------------------------------------------------------------------------------- *)

Definition in_word (ch : ascii) : bool := negb (Ascii.eqb ch line_feed) && negb (Ascii.eqb ch " ").
Definition word (w : string) : Prop := every in_word w && is_word w = true.

Lemma word_read w : forall rest done l ls, every in_word w = true ->
  split_words (w ++ rest) done l ls = split_words rest (onto w done) l ls.
Proof.
  induction w as [|ch w IH]; intros rest done l ls W; [reflexivity|]. simpl in W. apply andb_prop in W as (C & W).
  change (String ch w ++ rest)%string with (String ch (w ++ rest)). cbn [split_words onto].
  unfold in_word in C. apply andb_prop in C as (A & B).
  destruct (Ascii.eqb ch line_feed); [discriminate|]. destruct (Ascii.eqb ch " "); [discriminate|]. apply IH, W.
Qed.

Lemma reversed_onto w : reversed (onto w "") = w.
Proof. unfold reversed. rewrite onto_reversed. reflexivity. Qed.

(* What is read after a line: the end of the text, or a line feed and more. *)
Lemma words_read ws : ws <> [] -> Forall word ws -> forall l ls,
  split_words (joined " " ws) "" l ls = rev' (rev' (rev ws ++ l) :: ls) /\
  forall rest, split_words (joined " " ws ++ String line_feed rest) "" l ls = split_words rest "" [] (rev' (rev ws ++ l) :: ls).
Proof.
  induction ws as [|w ws IH]; intros N F l ls; [contradiction|]. inversion F as [|? ? W F']; subst.
  apply andb_prop in W as (W & _). destruct ws as [|v ws].
  - cbn [joined rev app]. split.
    + rewrite <- (append_empty w) at 1. rewrite word_read by exact W. cbn [split_words]. rewrite reversed_onto. reflexivity.
    + intro rest. rewrite word_read by exact W. cbn [split_words]. rewrite Ascii.eqb_refl, reversed_onto. reflexivity.
  - change (joined " " (w :: v :: ws)) with (w ++ String " " (joined " " (v :: ws)))%string.
    destruct (IH ltac:(discriminate) F' (w :: l) ls) as (A & B).
    replace (rev (w :: v :: ws) ++ l) with (rev (v :: ws) ++ w :: l)
      by (cbn [rev]; rewrite <- !app_assoc; reflexivity). split.
    + rewrite word_read by exact W. cbn [split_words]. change (Ascii.eqb " " line_feed) with false.
      change (Ascii.eqb " " " ") with true. cbv iota. rewrite reversed_onto. exact A.
    + intro rest. rewrite append_assoc, word_read by exact W.
      change (String " " (joined " " (v :: ws)) ++ String line_feed rest)%string
        with (String " " (joined " " (v :: ws) ++ String line_feed rest)).
      cbn [split_words]. change (Ascii.eqb " " line_feed) with false.
      change (Ascii.eqb " " " ") with true. cbv iota. rewrite reversed_onto. apply B.
Qed.

Lemma lines_read ls : ls <> [] -> Forall (fun l => l <> [] /\ Forall word l) ls -> forall done,
  split_words (joined (String line_feed "") (map (joined " ") ls)) "" [] done = rev done ++ ls.
Proof.
  induction ls as [|l ls IH]; intros N F done; [contradiction|]. inversion F as [|? ? (Nl & W) F']; subst.
  destruct (words_read l Nl W [] done) as (A & B). rewrite app_nil_r in A, B.
  assert (rev' (rev l) = l) as R by (rewrite rev'_is_rev, rev_involutive; reflexivity). rewrite R in A, B.
  destruct ls as [|m ls].
  - cbn [map joined]. rewrite A, rev'_is_rev. reflexivity.
  - change (joined (String line_feed "") (map (joined " ") (l :: m :: ls)))
      with (joined " " l ++ String line_feed "" ++ joined (String line_feed "") (map (joined " ") (m :: ls)))%string.
    change (String line_feed "" ++ ?x)%string with (String line_feed x). rewrite B, IH by (discriminate || exact F').
    cbn [rev]. rewrite <- app_assoc. reflexivity.
Qed.

(* ---- The words of a certificate --------------------------------------------------------------------------- *)

Lemma number_characters w : every of_number w = true -> every in_word w = true.
Proof. apply every_implies. intros [[] [] [] [] [] [] [] []]; try reflexivity; discriminate. Qed.

Lemma short_word w : every in_word w = true -> text_length w <= most_word -> word w.
Proof. intros E L. unfold word, is_word. rewrite E, string_length_text. apply Z.leb_le. lia. Qed.

Lemma integer_characters n : 0 <= n -> every in_word (show_integer n) = true.
Proof.
  intro H. destruct (show_integer_numeral n H) as (l & _ & N & _). exact (number_characters _ (numeral_of_number _ _ _ N)).
Qed.

Lemma integer_word n : plain_integer n -> word (show_integer n).
Proof. intros (P & L). apply short_word; [exact (integer_characters n P) | unfold most_word, most_digits in *; lia]. Qed.

Lemma index_word j : plain_index j -> word (show_integer j).
Proof. intros (P & L). apply short_word; [exact (integer_characters j P) | unfold most_word, most_digits in *; lia]. Qed.

Lemma decimal_word x : plain_decimal x -> word (show_decimal x).
Proof.
  intros (P & D & _ & L). apply short_word; [apply number_characters, (decimal_of_number x P D)|].
  unfold most_word, most_digits in *. lia.
Qed.

Lemma rational_word x : plain_rational x -> word (show_rational x).
Proof.
  intros (P & _ & Ln & Ld). unfold show_rational. destruct (Zpos (Qden x) =? 1); [apply integer_word; split; assumption|].
  apply short_word.
  - rewrite every_append, integer_characters by exact P. change (every in_word ("/" ++ ?x)) with (every in_word x).
    apply (integer_characters (Zpos (Qden x))). lia.
  - rewrite text_length_append. cbn [append text_length]. unfold most_word, most_digits in *. lia.
Qed.

Lemma range_word_word i j : plain_range i j -> every in_word (range_word i j) = true /\ text_length (range_word i j) <= 37.
Proof.
  intros ((Pi & Li) & (Pj & Lj) & _). unfold range_word. destruct (i =? j).
  - split; [apply integer_characters, Pi | lia].
  - rewrite !every_append, !text_length_append, !integer_characters by assumption. split; [reflexivity|]. cbn [text_length]. lia.
Qed.

Lemma claim_word_word c : plain_claim c -> word (claim_word c).
Proof.
  destruct c as [N|B N|B|]; cbn [claim_word]; [intros (P & _); apply integer_word, P| | |reflexivity].
  - intros ((Pb & Lb) & (Pn & Ln) & _). apply short_word; rewrite ?every_append, ?text_length_append.
    + rewrite !integer_characters by assumption. reflexivity.
    + cbn [text_length]. unfold most_word, most_digits in *. lia.
  - intros ((Pb & Lb) & _). apply short_word; rewrite ?every_append, ?text_length_append.
    + rewrite !integer_characters by assumption. reflexivity.
    + cbn [text_length]. unfold most_word, most_digits in *. lia.
Qed.

Lemma condition_word_word ls m : ls = of_leaf \/ ls = of_windows -> plain_multiple ls m -> word (condition_word m).
Proof.
  intros K (_ & P). unfold condition_word.
  assert (in_word (letter m) = true) as L.
  { destruct K as [-> | ->];
      (destruct (of_class m =? 0); [destruct P as (P & _)|destruct P as (_ & P); destruct (of_class m =? up_to m)]);
      revert P; destruct (letter m) as [[] [] [] [] [] [] [] []]; try reflexivity; discriminate. }
  destruct (of_class m =? 0).
  - apply short_word; [simpl; rewrite L; reflexivity | cbn [text_length]; unfold most_word, most_digits; lia].
  - destruct P as (P & _). apply range_word_word in P as (E & B). apply short_word; [simpl; rewrite L; exact E|].
    cbn [text_length]. unfold most_word, most_digits in *. lia.
Qed.

Definition line_ok (l : line) : Prop := l <> [] /\ Forall word l.

Lemma if_some_ok {A} (x : option A) (g : A -> line) : (forall y, x = Some y -> line_ok (g y)) -> Forall line_ok (if_some x g).
Proof. intro H. destruct x; simpl; auto. Qed.
Lemma if_true_ok holds l : line_ok l -> Forall line_ok (if_true holds l).
Proof. intro H. destruct holds; simpl; auto. Qed.

Ltac words := split; [discriminate | repeat constructor; auto using integer_word, index_word, decimal_word, rational_word].

Lemma tolerance_lines_ok t of_file : plain_tolerances t -> Forall line_ok (tolerance_lines t of_file).
Proof.
  intros (Pr & Pp & Pe & Pt & Pb & _). unfold tolerance_lines. rewrite !Forall_app. repeat split.
  - apply if_some_ok. intros e E. destruct (Pr e E). words.
  - apply if_true_ok. words.
  - apply if_some_ok. intros e E. destruct (Pp e E). words.
  - apply if_true_ok. words.
  - destruct (passing_each t) as [|e es] eqn:E; [constructor|]. constructor; [|constructor]. split; [discriminate|].
    constructor; [reflexivity|]. apply Forall_map, Forall_forall. intros x I. apply decimal_word, (Pe x I).
  - apply if_some_ok. intros e E. destruct (Pt e E). words.
  - destruct of_file; [constructor; [words | constructor]|]. apply Forall_map, Forall_forall. intros ((x, l), h) I.
    destruct (Pb _ I) as (A & B & C). words.
Qed.

Lemma question_lines_ok cert box of_file : plain_question (asked cert) box -> Forall line_ok (question_lines (Document cert box of_file)).
Proof.
  intros (A & B & G & Pp & Pc & Pf & Pm & _ & Pl & _ & Ps & Pt). unfold question_lines.
  cbn [certificate_of box_of band_of_file].
  rewrite !Forall_app. unfold plain_solids in Ps.
  assert (Forall line_ok (cylinder_lines (solids_of (asked cert))) /\ Forall line_ok (box_lines box) /\
          Forall line_ok (volume_lines (solids_of (asked cert)) box) /\ Forall line_ok (pi_lines (solids_of (asked cert)))) as (S1 & S2 & S3 & S4).
  { destruct (solids_of (asked cert)) as [|d h e|v p r].
    - subst. repeat split; constructor.
    - destruct Ps as (_ & -> & (Pd & _) & (Ph & _) & Pe). repeat split; try constructor; [words | constructor].
    - destruct Ps as (_ & (Ppi & _) & (Pr & _) & _ & H). destruct box as [(((x, y), z), e)|].
      + destruct H as ((Px & _) & (Py & _) & (Pz & _) & Pe & _). cbn [box_lines if_some].
        split; [constructor|]. split; [constructor; [words | constructor]|]. split; [constructor|].
        constructor; [words | constructor].
      + destruct H as (Pv & _). split; [constructor|]. split; [constructor|]. split; (constructor; [words | constructor]). }
  repeat split; trivial.
  - constructor; [|constructor]. split; [discriminate|]. unfold law_words.
    constructor; [reflexivity|]. constructor; [|constructor]. apply rational_word. split; [cbn [Qnum]; lia|]. split.
    + apply Qcanon.Qred_identity. cbn [Qnum Qden]. rewrite Z2Pos.id by lia. exact G.
    + cbn [Qnum Qden]. rewrite Z2Pos.id by lia. split; apply small_integer; lia.
  - apply if_some_ok. intros x E. destruct (Pp x E). words.
  - apply if_some_ok. intros x E. destruct (Pc x E). words.
  - apply if_some_ok. intros x E. destruct (Pf x E) as ((P & _) & _). words.
  - apply if_true_ok. words.
  - apply if_true_ok. words.
  - destruct (tolerances_of (asked cert)) as [t|]; [apply tolerance_lines_ok; auto | constructor].
Qed.

Lemma multiple_words_ok ls ms : ls = of_leaf \/ ls = of_windows ->
  (forall m, In m ms -> plain_multiple ls m) -> Forall word (multiple_words ms).
Proof.
  intro K. induction ms as [|m ms IH]; intro P; [constructor|]. cbn [multiple_words flat_map app].
  destruct (P m (or_introl eq_refl)) as ((Pm & L) & C). constructor; [apply integer_word; assumption|].
  constructor; [apply (condition_word_word ls m K); split; [split|]; assumption|]. apply IH. intros x I. apply P. right. exact I.
Qed.

Lemma document_lines_ok cert box of_file : plain_certificate cert box -> Forall line_ok (document_lines (Document cert box of_file)).
Proof.
  intros (Q & (N & _) & W & _ & _ & P). unfold document_lines. cbn [certificate_of]. rewrite !Forall_app. repeat split.
  - constructor; [|constructor]. unfold version_line, version_of.
    destruct (is_third (proof_of cert)), (is_second (claimed cert) (proof_of cert)); words.
  - apply question_lines_ok, Q.
  - constructor; [|constructor]. split; [discriminate|]. constructor; [reflexivity|]. constructor; [|constructor].
    exact (claim_word_word _ N).
  - unfold plain_proof in P. destruct (tolerances_of (asked cert)), (proof_of cert); try contradiction; [constructor|].
    destruct P as (Ps & _). constructor; [words | constructor].
  - apply Forall_map, Forall_forall. intros w I.
    destruct (W w I) as (Pi & (Pc & _) & Pt & (Pl & _) & (Ph & _) & _).
    unfold class_line. destruct (is_tolerant cert); [destruct Pt as (Pt & _)|]; words.
  - unfold plain_proof in P.
    destruct (tolerances_of (asked cert)), (proof_of cert) as [scale z js|nodes]; try contradiction; cbn [proof_lines].
    + destruct P as (P & _). apply Forall_map, Forall_forall. intros x I. specialize (P x I). destruct x as [i j v|v|ms|ms].
      * destruct P as (Pj & Pv & _). apply range_word_word in Pj as (E & B). split; [discriminate|].
        repeat constructor; [|apply integer_word, Pv]. apply short_word; [exact E|]. unfold most_word, most_digits. lia.
      * destruct P as (P & _). words.
      * destruct P as (_ & P & _). split; [discriminate|]. constructor; [reflexivity | exact (multiple_words_ok _ ms (or_introl eq_refl) P)].
      * destruct P as (P & _). split; [discriminate|]. constructor; [reflexivity | exact (multiple_words_ok _ ms (or_intror eq_refl) P)].
    + destruct P as (_ & _ & P). destruct (claims_least (asked cert) (claimed cert)).
      * destruct P as (-> & ->). constructor.
      * destruct P as ((js' & -> & Pj) & Pz). rewrite Forall_app. split.
        -- apply if_some_ok. intros y E. destruct (Pz y E) as (_ & Py & _). words.
        -- constructor; [|constructor]. split; [discriminate|]. constructor; [reflexivity|].
           apply Forall_map, Forall_forall. intros j I. apply index_word, Pj, I.
  - constructor; [words|]. constructor; [words | constructor].
Qed.

(* The bytes of a certificate in its only form are read as this certificate. *)
Theorem certificate_bytes_read cert box :
  plain_certificate cert box -> read_certificate (words_of (document_text (Document cert box false))) = Ok cert.
Proof.
  intro P. unfold words_of, document_text.
  rewrite lines_read; [exact (certificate_read cert box P) | | exact (document_lines_ok cert box false P)].
  unfold document_lines, question_lines. discriminate.
Qed.
