(* A certificate's file: its bytes as lines of words, and what the file says beyond the certificate that is checked
   (certificate-format.md, sections 1 and 6). *)

From Coq Require Import ZArith QArith List Bool String Ascii.
From Mdm Require Import Numbers Certificate Text Decimals Rows.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* What lies between two line feeds is a line, and a word of it between two spaces. The word that is being read is in
   reverse, and so are the line and the lines that are done. *)
Fixpoint split_words (w word : string) (l : line) (done : lines) : lines :=
  match w with
  | EmptyString => rev' (rev' (reversed word :: l) :: done)
  | String ch w =>
    if Ascii.eqb ch line_feed then split_words w "" [] (rev' (reversed word :: l) :: done)
    else if Ascii.eqb ch " " then split_words w "" (reversed word :: l) done
    else split_words w (String ch word) l done
  end.
Definition words_of (file : string) : lines := split_words file "" [] [].

(* The certificate; the sides of its box with the void ratio, where it has one; whether its band is that of the file. *)
Record document := Document { certificate_of : certificate; box_of : option (Q * Q * Q * Q); band_of_file : bool }.

(* ---- The line "band file" --------------------------------------------------------------------------- *)

Definition is_band (l : line) : bool := named "band" [l].
Definition is_band_file (l : line) : bool := is_line ["band"; "file"] [l].

Definition band_line (limit : Q * Q * Q) : line :=
  let '(x, least, most) := limit in ["band"; show_decimal x; show_decimal least; show_decimal most].

(* With a line of the band for each row of the envelope in the place of "band file". *)
Fixpoint with_limits (limits : list (Q * Q * Q)) (ls done : lines) : lines :=
  match ls with
  | l :: ls =>
    if is_band_file l then rev_append done (rev_append (map_onto band_line limits []) ls)
    else with_limits limits ls (l :: done)
  | [] => rev' done
  end.

(* ---- The whole -------------------------------------------------------------------------------------- *)

(* No number is longer; longer words would take the readers of numbers long. *)
Definition most_word : Z := 2 * most_digits + 2.
Definition is_word (w : string) : bool := string_length w 0 <=? most_word.

Definition box_of_lines (ls : lines) : result (option (Q * Q * Q * Q)) :=
  match find (fun l => named "box" [l]) ls with
  | Some (_ :: words) =>
    match numbers [Positive; Positive; Positive; NotNegative] words with
    | Some [x; y; z; e] => Ok (Some (x, y, z, e))
    | _ => Malformed "a number of the line box"
    end
  | _ => Ok None
  end.

Definition volume_of_box (x y z e : Q) : Q := over (times x (times y z)) (add (of_integer 1) e).

Definition same_number (x y : Q) : bool := (Qnum x =? Qnum y) && (Zpos (Qden x) =? Zpos (Qden y)).

Fixpoint same_limits (ls ms : list (Q * Q * Q)) : bool :=
  match ls, ms with
  | (x, l, h) :: ls, (x', l', h') :: ms =>
    if same_number x x' && same_number l l' && same_number h h' then same_limits ls ms else false
  | [], [] => true
  | _, _ => false
  end.

(* That the certificate has the box and the limits: its reader has seen to them; with this test no theorem is about the
   reader. *)
Definition agrees (D : document) (limits : list (Q * Q * Q)) : bool :=
  let q := asked (certificate_of D) in
  match box_of D, solids_of q with
  | Some (x, y, z, e), Volume v _ _ => at_most 0 e && equal v (volume_of_box x y z e)
  | Some _, _ => false
  | None, _ => true
  end &&
  (negb (band_of_file D) || match tolerances_of q with Some t => same_limits (band t) limits | None => false end).

(* [limits] are those of the gradation file, if it is an envelope. *)
Definition read_document (limits : list (Q * Q * Q)) (ls : lines) : result document :=
  demand_form (forallb (forallb is_word) ls) "a word that is longer than any number" ;;
  let of_file := existsb is_band_file ls in
  demand_form (negb of_file || (size (filter is_band ls) =? 1)) "more lines of a band beside the line band file" ;;
  let ls := if of_file then with_limits limits ls [] else ls in
  let* cert := read_certificate ls in
  let* box := box_of_lines ls in
  let D := Document cert box of_file in
  demand_form (agrees D limits) "the line box or band file" ;;
  Ok D.
