(* The whole check: a gradation and the text of a certificate, to a verdict. *)

From Coq Require Import ZArith QArith List String.
From Mdm Require Import Numbers Gradation Certificate Question Exact Tolerant.
Import ListNotations.
Open Scope string_scope.

Definition check_certificate (G : gradation) (cert : certificate) : result unit :=
  let G := reduced G in
  demand_form (well_formed G && sensible cert) "no gradation, or no question" ;;
  let* G := apply_question cert G in
  demand_form (well_formed G) "no gradation after the question" ;;
  match tolerances_of (asked cert), proof_of cert with
  | None, Exact scale z chain => check_exact cert G scale z chain
  | Some tol, Tolerant nodes => check_tolerant cert G tol nodes
  | _, _ => Malformed "a chain for an exact match, a tree for a tolerance"
  end.

Definition check (G : gradation) (text : lines) : result certificate :=
  let* cert := read_certificate text in
  check_certificate G cert ;;
  Ok cert.

(* ---- For the driver ------------------------------------------------------------------------------ *)

Inductive verdict := Accepted | Not_proved (what : string) | Not_readable (what : string).

(* A row as words: opening, mass, factor and tolerance, each an integer or p/q in lowest terms. *)
Definition read_row (l : line) : option row :=
  match all_words rational l [] with
  | Some [x; m; c; e] => Some (Row x m c e)
  | _ => None
  end.

Fixpoint read_rows (ls : lines) (done : list row) : option (list row) :=
  match ls with
  | [] => Some (rev' done)
  | l :: ls =>
    match read_row l with
    | Some r => read_rows ls (r :: done)
    | None => None
    end
  end.

(* The gradation's rows, ascending; whether its file has tolerances; the certificate's text. *)
Definition mdm_check (gradation_rows : lines) (has_tolerances : bool) (text : lines) : verdict :=
  match read_rows gradation_rows [] with
  | Some rows =>
    match check (Gradation rows has_tolerances) text with
    | Ok _ => Accepted
    | Refused what => Not_proved what
    | Malformed what => Not_readable what
    end
  | None => Not_readable "a number of the gradation"
  end.
