(* From the names and bytes of both files to the verdict that is printed. *)

From Coq Require Import ZArith QArith List Bool String Ascii.
From Mdm Require Import Numbers Gradation Certificate Text Rows GradationFile Mixture MixtureFile Document VerdictLine
  Checker.
Import ListNotations.
Open Scope string_scope.

Record file := File { name : string; bytes : string }.

(* Accepted and refused with the line of the verdict, refused with the reason besides; malformed with what is wrong. *)
Inductive judgement := Proved (line : string) | Unproved (line reason : string) | Unreadable (message : string).

(* The checks of a certificate, of a gradation that is read. *)
Definition check_document (R : reading) (w : string) : result document :=
  let here := match limits R with Some ls => ls | None => [(of_integer 1, 0%Q, of_integer 100)] end in
  let* D := read_document here (words_of w) in
  demand (Bool.eqb (band_of_file D) (match limits R with Some _ => true | None => false end))
    "band file: an envelope as the gradation file" ;;
  check_certificate (gradation_of R) (certificate_of D) ;; Ok D.

(* Where a percentage is meant for each opening: that the openings are those that their phi give, or that each is its own
   power. *)
Definition gives_openings (R : reading) (q : question) : bool :=
  let G := reduced (gradation_of R) in
  match tolerances_of q with
  | Some t =>
    match passing_each t, sizes_in R with
    | [], _ => true
    | _, Phi => forallb (fun y => same_number y (power_of_two (exponent_of_two y))) (upper_openings G q)
    | _, _ => (root G =? 1)%Z && forallb (at_most 0) (upper_openings G q)
    end
  | None => true
  end.

(* What is proved, as a statement of which its line says all. It always can: with these tests no theorem is about the
   readers of the numbers. *)
Definition check_statement (name : string) (R : reading) (w : string) : result statement :=
  let* D := check_document R w in
  let s := statement_of name R D in
  demand_form (gives_openings R (asked (certificate_of D)) && plain_statement s) "a number that the verdict cannot say" ;;
  Ok s.

(* The same of a gradation of several materials. *)
Definition check_mixed_document (M : mixed_reading) (w : string) : result document :=
  let* D := read_document [(of_integer 1, 0%Q, of_integer 100)] (words_of w) in
  demand (negb (band_of_file D)) "band file: an envelope as the gradation file" ;;
  check_mixture (mixture_of M) (certificate_of D) ;; Ok D.

Definition check_mixed_statement (name : string) (M : mixed_reading) (w : string) : result statement :=
  let* D := check_mixed_document M w in
  let s := statement_of_mixture name M D in
  demand_form (plain_statement s) "a number that the verdict cannot say" ;;
  Ok s.

Definition check_any_statement (name : string) (G : any_gradation) (w : string) : result statement :=
  match G with One R => check_statement name R w | Several M => check_mixed_statement name M w end.

(* What is said of a certificate w that cannot be read, and what to do. Laws by a table or a sum are those of mdm-check alone. *)
Definition unreadable_text (w what program : string) : string :=
  if existsb (fun l => match l with
      | keyword :: kind :: _ => String.eqb keyword "law" && (String.eqb kind "table" || String.eqb kind "sum")
      | _ => false
      end) (words_of w)
  then "its law is a table or a sum: use mdm-check"
  else what ++ ": let " ++ program ++ " --proof write it again".

Definition judge (gradation certificate : file) : judgement :=
  match read_any_gradation (bytes gradation) with
  | Refused what | Malformed what => Unreadable (printable (name gradation) ++ ":" ++ what)
  | Ok G =>
    match check_any_statement (name gradation) G (bytes certificate) with
    | Ok s => Proved (accepted_line s)
    | Refused what =>
      Unproved (refused_line (name gradation)) (printable (name certificate) ++ ": " ++ what ++ " fails")
    | Malformed what =>
      Unreadable (printable (name certificate) ++ ": " ++ unreadable_text (bytes certificate) what "mdm solve")
    end
  end.

(* The gradation as it is read, in canonical CSV. *)
Definition print_gradation (gradation : file) : result string :=
  let printed short ls :=
    demand_form short (printable (name gradation) ++ ": a number of more than 1000 digits: choose another unit") ;;
    Ok (text_of_lines ls) in
  match read_any_gradation (bytes gradation) with
  | Refused what | Malformed what => Malformed (printable (name gradation) ++ ":" ++ what)
  | Ok (One R) =>
    let ls := gradation_lines R in
    printed (forallb (fun l => match Csv.fields_of "," l with Some fs => forallb is_short fs | None => false end) ls) ls
  | Ok (Several M) => printed (forallb (fun '(numbers, _) => forallb is_short numbers) (mixed_rows M)) (mixture_lines M)
  end.
