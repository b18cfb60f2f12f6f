(* A certificate's file is read as it is printed, also where its band is that of the gradation file: the line "band file"
   then stands for the lines of the band. *)

From Coq Require Import ZArith QArith String Ascii List Bool Lia.
From Mdm Require Import Numbers Certificate Text Decimals Rows Document CertificateText NumberTexts CertificateRead
  CsvFields CsvRead CertificateBytes.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(* ---- Lines without a name ---------------------------------------------------------------------------------- *)

Definition without (name : string) (ls : lines) : Prop := forall l, In l ls -> named name [l] = false.

Lemma without_app name ls ms : without name ls -> without name ms -> without name (ls ++ ms).
Proof. intros L M l I. apply in_app_or in I as [I|I]; auto. Qed.
Lemma without_none name : without name [].
Proof. intros l []. Qed.
Lemma without_cons name l ls : named name [l] = false -> without name ls -> without name (l :: ls).
Proof. intros N W m [<-|I]; auto. Qed.
Lemma without_some name {A} (x : option A) g : (forall y, named name [g y] = false) -> without name (if_some x g).
Proof. intro H. destruct x; [apply without_cons; [apply H|] |]; apply without_none. Qed.
Lemma without_true name holds l : named name [l] = false -> without name (if_true holds l).
Proof. intro H. destruct holds; [apply without_cons; [exact H|] |]; apply without_none. Qed.
Lemma without_map name {A} (g : A -> line) xs : (forall x, named name [g x] = false) -> without name (map g xs).
Proof. intros H l I. apply in_map_iff in I as (x & <- & _). apply H. Qed.

Ltac lines_without :=
  repeat first
    [ apply without_app | apply without_none | apply without_cons; [reflexivity|]
    | apply without_some; intro; reflexivity | apply without_true; reflexivity ].

(* ---- The parts of a certificate's lines ---------------------------------------------------------------------- *)

Definition before_box (cert : certificate) : lines :=
  let q := asked cert in
  [version_line cert] ++ ["law" :: law_words (a q) (b q)] ++
  if_some (pan_size q) (fun x => ["pan-size"; show_decimal x]) ++
  if_some (cut_below q) (fun x => ["cut-below"; show_decimal x]) ++
  if_some (size_factor q) (fun x => ["size-factor"; show_decimal x]) ++
  if_true (1 <=? min_per_class q) ["min-per-class"; show_integer (min_per_class q)] ++
  cylinder_lines (solids_of q).

Definition before_band (q : question) (box : option (Q * Q * Q * Q)) : lines :=
  volume_lines (solids_of q) box ++ pi_lines (solids_of q) ++
  if_true (1 <=? at_least q) ["at-least"; show_integer (at_least q)] ++
  match tolerances_of q with
  | Some t =>
    if_some (retained_each t) (fun e => ["retained"; show_decimal e]) ++
    if_true (retained_file t) ["retained"; "file"] ++
    if_some (passing_all t) (fun e => ["passing"; show_decimal e]) ++
    if_true (passing_file t) ["passing"; "file"] ++
    each_lines (passing_each t) ++
    if_some (total t) (fun e => ["total"; show_decimal e])
  | None => []
  end.

Definition band_lines (q : question) (of_file : bool) : lines :=
  match tolerances_of q with
  | Some t => if of_file then [["band"; "file"]] else map band_line (band t)
  | None => []
  end.

Definition after_band (cert : certificate) : lines :=
  [particles_line (claimed cert)] ++ scale_lines (proof_of cert) ++
  map (class_line (is_tolerant cert)) (witness cert) ++ proof_lines (proof_of cert) ++ [["end"]; [""]].

Lemma parts cert box of_file :
  document_lines (Document cert box of_file) =
  before_box cert ++ box_lines box ++ before_band (asked cert) box ++ band_lines (asked cert) of_file ++ after_band cert.
Proof.
  unfold document_lines, question_lines, before_box, before_band, band_lines, after_band, tolerance_lines.
  cbn [certificate_of box_of band_of_file]. destruct (tolerances_of (asked cert)); rewrite <- !app_assoc; reflexivity.
Qed.

Lemma before_box_without cert name : name = "box" \/ name = "band" -> without name (before_box cert).
Proof. unfold before_box. intros [-> | ->]; destruct (solids_of (asked cert)); lines_without. Qed.

Lemma box_without_band box : without "band" (box_lines box).
Proof. destruct box as [(((x, y), z), e)|]; lines_without. Qed.

Lemma before_band_without q box name : name = "box" \/ name = "band" -> without name (before_band q box).
Proof.
  unfold before_band. intros [-> | ->]; destruct (solids_of q), box; destruct (tolerances_of q) as [t|]; try destruct (passing_each t);
    lines_without.
Qed.

Lemma after_band_without cert name : name = "box" \/ name = "band" -> without name (after_band cert).
Proof.
  unfold after_band. intros [-> | ->]; destruct (proof_of cert) as [scale above [js|]|nodes]; lines_without;
    apply without_map; intros []; reflexivity.
Qed.

Lemma limits_without_box ls : without "box" (map band_line ls).
Proof. apply without_map. intros ((x, l), h). reflexivity. Qed.

(* ---- The line of the box ---------------------------------------------------------------------------------- *)

Lemma box_read cert box : plain_question (asked cert) box -> box_of_lines (document_lines (Document cert box false)) = Ok box.
Proof.
  intro P. assert (plain_solids (asked cert) box) as S by apply P.
  destruct (solids_say _ _ S) as (_ & B & _).
  assert (forall l, In l (document_lines (Document cert box false)) -> named "box" [l] = true -> In l (box_lines box)) as Only.
  { intros l I N. rewrite parts, !in_app_iff in I.
    assert (forall ls, without "box" ls -> ~ In l ls) as Not by (intros ls W J; rewrite (W l J) in N; discriminate N).
    destruct I as [I|[I|[I|[I|I]]]]; [|exact I| | |]; exfalso; revert I; apply Not.
    - apply before_box_without. auto.
    - apply before_band_without. auto.
    - unfold band_lines. destruct (tolerances_of (asked cert)); [apply limits_without_box | apply without_none].
    - apply after_band_without. auto. }
  unfold box_of_lines. destruct (find (fun l => named "box" [l]) (document_lines (Document cert box false))) as [l|] eqn:F.
  - apply find_some in F as (I & N). specialize (Only l I N). destruct box as [(((x, y), z), e)|]; [|destruct Only].
    destruct Only as [<-|[]]. destruct B as [(E & _)|(ws & E & R)]; [discriminate E|]. injection E as <-. rewrite R. reflexivity.
  - destruct box as [(((x, y), z), e)|]; [|reflexivity].
    assert (In ["box"; show_decimal x; show_decimal y; show_decimal z; show_decimal e]
              (document_lines (Document cert (Some (x, y, z, e)) false))) as I
      by (rewrite parts, !in_app_iff; right; left; left; reflexivity).
    discriminate (find_none _ _ F _ I).
Qed.

(* ---- The band of the file ------------------------------------------------------------------------------------ *)

Lemma no_band_file l : named "band" [l] = false -> is_band_file l = false.
Proof. apply is_line_not_named. Qed.

Lemma limits_put ls limits rest : without "band" ls -> forall done,
  with_limits limits (ls ++ ["band"; "file"] :: rest) done = rev done ++ ls ++ map band_line limits ++ rest.
Proof.
  induction ls as [|l ls IH]; intros W done.
  - cbn [app with_limits]. change (is_band_file ["band"; "file"]) with true. cbv iota.
    rewrite map_onto_rev, app_nil_r, !rev_append_rev, rev_involutive. reflexivity.
  - cbn [app with_limits]. rewrite no_band_file by (apply W; left; reflexivity).
    rewrite IH by (intros m I; apply W; right; exact I). cbn [rev]. rewrite <- app_assoc. reflexivity.
Qed.

Lemma no_bands ls : without "band" ls -> filter is_band ls = [] /\ existsb is_band_file ls = false.
Proof.
  induction ls as [|l ls IH]; intro W; [split; reflexivity|]. destruct (IH (fun m I => W m (or_intror I))) as (F & E).
  pose proof (W l (or_introl eq_refl)) as N. cbn [filter existsb]. unfold is_band. rewrite N, no_band_file, E by exact N. auto.
Qed.

Lemma limits_no_file ls : existsb is_band_file (map band_line ls) = false.
Proof. induction ls as [|((x, l), h) ls IH]; [reflexivity|]. cbn [map existsb]. rewrite IH, orb_false_r. apply is_line_other. discriminate. Qed.

Lemma same_number_refl x : same_number x x = true.
Proof. unfold same_number. rewrite !Z.eqb_refl. reflexivity. Qed.

Lemma same_limits_refl ls : same_limits ls ls = true.
Proof. induction ls as [|((x, l), h) ls IH]; [reflexivity|]. cbn [same_limits]. rewrite !same_number_refl. exact IH. Qed.

Lemma box_agrees q box : plain_solids q box ->
  match box, solids_of q with
  | Some (x, y, z, e), Volume v _ _ => at_most 0 e && equal v (volume_of_box x y z e)
  | Some _, _ => false
  | None, _ => true
  end = true.
Proof.
  unfold plain_solids. destruct (solids_of q) as [|d h e|v p r].
  - intros ->. reflexivity.
  - intros (_ & -> & _). reflexivity.
  - intros (_ & _ & _ & _ & H). destruct box as [(((x, y), z), e)|]; [|reflexivity].
    destruct H as (_ & _ & _ & (P & _) & ->). unfold at_most, equal. cbn [Qnum Qden].
    rewrite Z.eqb_refl, andb_true_r. apply Z.leb_le. lia.
Qed.

(* ---- The whole file ---------------------------------------------------------------------------------------- *)

(* The band is that of the file, whose limits these are. *)
Definition has_limits (cert : certificate) (limits : list (Q * Q * Q)) : Prop :=
  exists t, tolerances_of (asked cert) = Some t /\ band t = limits.

Theorem document_read limits cert box of_file :
  plain_certificate cert box -> (of_file = true -> has_limits cert limits) ->
  read_document limits (words_of (document_text (Document cert box of_file))) = Ok (Document cert box of_file).
Proof.
  intros P L. pose proof (document_lines_ok cert box of_file P) as Ok_.
  assert (words_of (document_text (Document cert box of_file)) = document_lines (Document cert box of_file)) as ->.
  { unfold words_of, document_text. apply lines_read; [|exact Ok_]. unfold document_lines, question_lines. discriminate. }
  unfold read_document.
  assert (forallb (forallb is_word) (document_lines (Document cert box of_file)) = true) as ->.
  { apply forallb_forall. intros l I. apply forallb_forall. intros w J. rewrite Forall_forall in Ok_.
    destruct (Ok_ l I) as (_ & W). rewrite Forall_forall in W. specialize (W w J). apply andb_prop in W as (_ & W). exact W. }
  cbn [demand_form bind].
  set (before := before_box cert ++ box_lines box ++ before_band (asked cert) box).
  assert (without "band" before) as Wb.
  { apply without_app; [|apply without_app]; [apply before_box_without | apply box_without_band | apply before_band_without]; auto. }
  assert (without "band" (after_band cert)) as Wa by (apply after_band_without; auto).
  assert (forall file, document_lines (Document cert box file) = before ++ band_lines (asked cert) file ++ after_band cert) as Parts.
  { intro file. unfold before. rewrite parts, <- !app_assoc. reflexivity. }
  destruct (no_bands _ Wb) as (Fb & Eb). destruct (no_bands _ Wa) as (Fa & Ea).
  assert (existsb is_band_file (document_lines (Document cert box of_file)) = of_file) as ->.
  { rewrite Parts, !existsb_app, Eb, Ea, orb_false_r. unfold band_lines. destruct of_file.
    - destruct (L eq_refl) as (t & -> & _). reflexivity.
    - destruct (tolerances_of (asked cert)); [apply limits_no_file | reflexivity]. }
  assert (negb of_file || (size (filter is_band (document_lines (Document cert box of_file))) =? 1) = true) as ->.
  { destruct of_file; [|reflexivity]. rewrite Parts, !filter_app, Fb, Fa. unfold band_lines.
    destruct (L eq_refl) as (t & -> & _). reflexivity. }
  cbn [demand_form bind].
  assert ((if of_file then with_limits limits (document_lines (Document cert box of_file)) []
           else document_lines (Document cert box of_file)) = document_lines (Document cert box false)) as ->.
  { destruct of_file; [|reflexivity]. rewrite !Parts. unfold band_lines. destruct (L eq_refl) as (t & -> & ->).
    apply (limits_put before limits (after_band cert) Wb []). }
  rewrite (certificate_read cert box P). cbn [bind]. rewrite box_read by apply P. cbn [bind].
  assert (agrees (Document cert box of_file) limits = true) as ->; [|reflexivity].
  unfold agrees. cbn [certificate_of box_of band_of_file]. rewrite (box_agrees (asked cert) box) by apply P.
  destruct of_file; [|reflexivity]. destruct (L eq_refl) as (t & -> & ->). apply same_limits_refl.
Qed.
