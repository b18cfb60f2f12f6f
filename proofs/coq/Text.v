(* Texts as sequences of bytes, and what both formats and all messages need of them.

   A string of Coq is a list of bytes. Functions that meet whole files are tail recursive: they build what they return
   in reverse. *)

From Coq Require Import ZArith QArith List Bool String Ascii.
From Mdm Require Import Numbers Certificate.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

Definition tab : ascii := "009".
Definition line_feed : ascii := "010".
Definition carriage_return : ascii := "013".
Definition quote : ascii := """".
Definition backslash : ascii := "\".

Definition code (ch : ascii) : Z := Z.of_N (N_of_ascii ch).
Definition of_code (n : Z) : ascii := ascii_of_N (Z.to_N n).
Definition between (lo hi ch : ascii) : bool :=
  match Ascii.compare lo ch, Ascii.compare ch hi with Gt, _ => false | _, Gt => false | _, _ => true end.

Definition is_blank (ch : ascii) : bool := Ascii.eqb ch " " || Ascii.eqb ch tab.
Definition is_space (ch : ascii) : bool := is_blank ch || Ascii.eqb ch line_feed || Ascii.eqb ch carriage_return.
Definition is_digit (ch : ascii) : bool := between "0" "9" ch.

(* ---- Sequences ----------------------------------------------------------------------------------- *)

Fixpoint onto (w done : string) : string :=
  match w with EmptyString => done | String ch w => onto w (String ch done) end.
Definition reversed (w : string) : string := onto w "".

Fixpoint string_length (w : string) (n : Z) : Z :=
  match w with EmptyString => n | String _ w => string_length w (n + 1) end.

Fixpoint after_prefix (prefix w : string) : option string :=
  match prefix, w with
  | EmptyString, _ => Some w
  | String p prefix, String ch w => if Ascii.eqb p ch then after_prefix prefix w else None
  | _, EmptyString => None
  end.
Definition before_suffix (suffix w : string) : option string :=
  option_map reversed (after_prefix (reversed suffix) (reversed w)).

Fixpoint without_first (such : ascii -> bool) (w : string) : string :=
  match w with
  | String ch rest => if such ch then without_first such rest else w
  | EmptyString => w
  end.

Fixpoint every (such : ascii -> bool) (w : string) : bool :=
  match w with String ch w => such ch && every such w | EmptyString => true end.
Fixpoint some (such : ascii -> bool) (w : string) : bool :=
  match w with String ch w => such ch || some such w | EmptyString => false end.

Fixpoint mapped (change : ascii -> ascii) (w : string) : string :=
  match w with String ch w => String (change ch) (mapped change w) | EmptyString => "" end.
Definition lower_case (w : string) : string :=
  mapped (fun ch => if between "A" "Z" ch then of_code (code ch + 32) else ch) w.

Fixpoint joined (separator : string) (ws : list string) : string :=
  match ws with
  | [] => ""
  | [w] => w
  | w :: ws => w ++ separator ++ joined separator ws
  end.

(* Each line with a line feed behind it. *)
Definition text_of_lines (ls : list string) : string :=
  reversed (fold_left (fun done l => String line_feed (onto l done)) ls "").

(* ---- UTF-8 --------------------------------------------------------------------------------------- *)

(* The code point at the head of a text, and its length in bytes less one; none where it is no valid UTF-8. *)
Definition character (w : string) : option (Z * nat) :=
  let low (ch : ascii) := code ch - 128 in
  let valid (from to n : Z) (tails : list ascii) (length : nat) :=
    if forallb (between "128" "191") tails && (from <=? n) && (n <=? to) && negb ((55296 <=? n) && (n <=? 57343))
    then Some (n, length) else None in
  match w with
  | EmptyString => None
  | String x w =>
    if code x <? 128 then Some (code x, 0%nat) else
    match w with
    | EmptyString => None
    | String y w =>
      if code x <? 224 then valid 128 2047 ((code x - 192) * 64 + low y) [y] 1%nat else
      match w with
      | EmptyString => None
      | String z w =>
        if code x <? 240 then valid 2048 65535 (((code x - 224) * 64 + low y) * 64 + low z) [y; z] 2%nat else
        match w with
        | EmptyString => None
        | String t _ =>
          valid 65536 1114111 ((((code x - 240) * 64 + low y) * 64 + low z) * 64 + low t) [y; z; t] 3%nat
        end
      end
    end
  end.

Definition is_control (n : Z) : bool := (n <? 32) || ((127 <=? n) && (n <? 160)).

(* Invisible characters, line separators and marks of the direction of writing could make a message lie. *)
Definition misleads (n : Z) : bool :=
  let within lo hi := (lo <=? n) && (n <=? hi) in
  within 173 173 || within 1564 1564 || within 8203 8207 || within 8232 8238 || within 8288 8297 ||
  within 65279 65279.

(* Line separators and marks of the direction of writing: an editor may show a line of its own, or another order, where
   there is none. *)
Definition rearranges (n : Z) : bool :=
  let within lo hi := (lo <=? n) && (n <=? hi) in
  within 1564 1564 || within 8206 8207 || within 8232 8238 || within 8294 8297.

Definition hexadecimal (n : Z) : ascii := of_code (if n <? 10 then 48 + n else 55 + n).
Definition escaped (ch : ascii) : string :=
  String backslash (String "x" (String (hexadecimal (code ch / 16)) (String (hexadecimal (code ch mod 16)) ""))).

(* What is no plain character is escaped as \xNN, and what [marked] says with a backslash. [more] bytes of a character
   are to come, as they are if it is [plain]. *)
Fixpoint printable_from (marked : ascii -> bool) (w : string) (more : nat) (plain : bool) : string :=
  match w with
  | EmptyString => ""
  | String ch rest =>
    let shown (plain : bool) :=
      if negb plain then escaped ch
      else if marked ch then String backslash (String ch "") else String ch "" in
    match more with
    | S more => (shown plain ++ printable_from marked rest more plain)%string
    | O =>
      match character w with
      | Some (n, more) =>
        let plain := negb (is_control n || misleads n) in
        (shown plain ++ printable_from marked rest more plain)%string
      | None => (escaped ch ++ printable_from marked rest 0 true)%string
      end
    end
  end.
Definition printable (w : string) : string := printable_from (fun _ => false) w 0 true.
(* In double quotes, for a verdict. *)
Definition in_quotes (w : string) : string :=
  String quote (printable_from (fun ch => Ascii.eqb ch quote || Ascii.eqb ch backslash) w 0 true ++ String quote "").

Fixpoint cut (n : nat) (w : string) : string :=
  match n, w with
  | S n, String ch w => String ch (cut n w)
  | O, String _ _ => "..."
  | _, EmptyString => ""
  end.
(* For a message. *)
Definition quoted (w : string) : string := "'" ++ printable (cut 80 w) ++ "'".

(* ---- Integers in texts ---------------------------------------------------------------------------- *)

Definition digit_of (n : Z) : ascii := of_code (48 + n).

(* The digits of n >= 0, of which there are at most as many as [fuel] and one more. *)
Fixpoint show_digits (fuel : nat) (n : Z) (done : string) : string :=
  let (tens, ones) := Z.div_eucl n 10 in
  let done := String (digit_of ones) done in
  match fuel with
  | O => done
  | S fuel => if tens =? 0 then done else show_digits fuel tens done
  end.
Definition show_integer (n : Z) : string := show_digits (Z.to_nat (Z.log2 n)) n "".

(* ---- What is wrong, and where --------------------------------------------------------------------- *)

Definition wrong {A} (line : Z) (what : string) : result A := Malformed (show_integer line ++ ": " ++ what).
Definition demand_at (line : Z) (holds : bool) (what : string) : result unit :=
  if holds then Ok tt else wrong line what.

(* ---- A file's text -------------------------------------------------------------------------------- *)

(* Valid UTF-8 without control characters but tab, LF, and CR before LF, and without line separators and marks of the
   direction of writing. [more] bytes of a character are to come. *)
Fixpoint check_text (w : string) (more : nat) (line : Z) : result unit :=
  match w with
  | EmptyString => Ok tt
  | String ch rest =>
    match more with
    | S more => check_text rest more line
    | O =>
      if between " " "~" ch || Ascii.eqb ch tab then check_text rest 0 line
      else if Ascii.eqb ch line_feed then check_text rest 0 (line + 1)
      else if Ascii.eqb ch carriage_return then
        match rest with
        | String next _ =>
          if Ascii.eqb next line_feed then check_text rest 0 line
          else wrong line "a carriage return that no line feed follows: end lines with LF or CRLF"
        | EmptyString => wrong line "a carriage return that no line feed follows: end lines with LF or CRLF"
        end
      else
        match character w with
        | None => wrong line "not valid UTF-8: save the file as UTF-8 text"
        | Some (n, more) =>
          if is_control n then wrong line "a control character: give a text file without them"
          else if rearranges n then wrong line "a line separator or a mark of the direction of writing: remove it"
          else check_text rest more line
        end
    end
  end.

Definition byte_order_mark : string := String "239" (String "187" (String "191" "")).
Definition without_mark (w : string) : string :=
  match after_prefix byte_order_mark w with Some rest => rest | None => w end.
