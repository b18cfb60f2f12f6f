(* The whole check of a certificate against a gradation. *)

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
  | None, Exact scale z chain => check_exact cert (root G) (rows G) (classes (rows G)) scale z chain
  | Some tol, Tolerant nodes =>
    let* ss := shares_of (asked cert) tol G in
    check_tolerant cert (root G) (rows G) (all_begin (classes (rows G))) ss tol nodes
  | _, _ => Malformed "a chain for an exact match, a tree for a tolerance"
  end.

Definition check (G : gradation) (text : lines) : result certificate :=
  let* cert := read_certificate text in
  check_certificate G cert ;;
  Ok cert.
