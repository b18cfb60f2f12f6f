(* What a blend is judged by (certificate-format.md, section 11): the sieves of the specification, then the fineness moduli, then the
   coarseness factor, as if they were sieves too. *)

From Coq Require Import ZArith QArith List Bool String.
From Mdm Require Import Numbers Rows Blend.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* In the place of what passes, a modulus has the mean of what passes its sieves, and the limit c of the factor what passes 9.5 mm less
   c / 100 of what passes 2.36 mm. *)
Inductive judged_by := BySieve (s : Q) | ByModulus | ByFactor.

(* Limits, and what passes each stockpile; and whether that is interpolated. *)
Record judged := Judged {
  by_what : judged_by;
  least_judged : Q;
  most_judged : Q;
  passing_judged : list Q;
  interpolated_judged : list bool }.

Definition is_interpolated_at (s : Q) (c : curve) : bool := match told_at c s with Known _ i => i | Unknown => false end.

Definition hundred : Q := of_integer 100.

(* ---- Sieves ----------------------------------------------------------------------------------------- *)

Definition judged_sieve (curves : list curve) (limit : Q * Q * Q) : judged :=
  let '(s, least, most) := limit in
  Judged (BySieve s) least most (map (percent_at s) curves) (map (is_interpolated_at s) curves).

Definition limits_something (limit : Q * Q * Q) : bool := let '(_, least, most) := limit in less 0 least || less most hundred.

Fixpoint judged_sieves (curves : list curve) (limits : list (Q * Q * Q)) (done : list judged) : result (list judged) :=
  match limits with
  | [] => Ok (rev' done)
  | (s, least, most) :: limits =>
    if told_by_all curves s then judged_sieves curves limits (judged_sieve curves (s, least, most) :: done)
    else
      demand (negb (less 0 s && limits_something (s, least, most))) "what a stockpile tells of a sieve that has a limit" ;;
      judged_sieves curves limits done
  end.

(* ---- Moduli and the factor -------------------------------------------------------------------------- *)

Definition sum_in_lowest_terms (xs : list Q) : Q := fold_right add 0%Q xs.

Definition mean_of_modulus (st : standard) (c : curve) : Q :=
  over (sum_in_lowest_terms (map (fun s => percent_at s c) (sieves_of_modulus st))) (of_integer (size (sieves_of_modulus st))).

(* 100 (1 - x / n) *)
Definition mean_at (st : standard) (x : Q) : Q :=
  times hundred (subtract (of_integer 1) (over x (of_integer (size (sieves_of_modulus st))))).

Definition judged_modulus (curves : list curve) (limit : standard * Q * Q) : judged :=
  let '(st, x, y) := limit in
  Judged ByModulus (mean_at st y) (mean_at st x) (map (mean_of_modulus st) curves)
    (map (fun c => existsb (fun s => is_interpolated_at s c) (sieves_of_modulus st)) curves).

Definition difference_of_factor (x : Q) (c : curve) : Q :=
  subtract (percent_at coarse_sieve c) (times (over x hundred) (percent_at fine_sieve c)).

Definition judged_factor (curves : list curve) (x least most : Q) : judged :=
  Judged ByFactor least most (map (difference_of_factor x) curves)
    (map (fun c => is_interpolated_at coarse_sieve c || is_interpolated_at fine_sieve c) curves).

(* The sides -100 and 100 hold of themselves. *)
Definition judged_factors (curves : list curve) (limits : option (Q * Q)) : list judged :=
  match limits with
  | None => []
  | Some (x, y) =>
    ((if less 0 x then [judged_factor curves x (of_integer (-100)) (subtract hundred x)] else []) ++
     (if less y hundred then [judged_factor curves y (subtract hundred y) hundred] else []))%list
  end.

(* ---- All of them ------------------------------------------------------------------------------------ *)

(* The readers of files see to this; with this test no theorem is about them. *)
Definition are_percents (c : curve) : bool := forallb (fun '(_, p) => at_most 0 p && at_most p hundred) c.

Definition all_judged (curves : list curve) (limits : list (Q * Q * Q)) (q : blend_question) : result (list judged) :=
  demand_form (forallb are_percents curves) "a stockpile of which less than nothing passes an opening" ;;
  demand_form (match coarseness_limits q with
      | Some (x, y) => at_most 0 x && at_most x y && at_most y hundred
      | None => true
      end) "limits of a coarseness factor that are not in order from 0 to 100" ;;
  let* sieves := judged_sieves curves limits [] in
  demand (match sieves with [] => false | _ => true end) "a limit in the specification" ;;
  demand (forallb (fun '(st, _, _) => forallb (told_by_all curves) (sieves_of_modulus st)) (modulus_limits q))
    "what a stockpile tells of a sieve of the fineness modulus" ;;
  demand (match coarseness_limits q with
      | Some _ => told_by_all curves coarse_sieve && told_by_all curves fine_sieve
      | None => true
      end) "what a stockpile tells of a sieve of the coarseness factor" ;;
  Ok (sieves ++ map (judged_modulus curves) (modulus_limits q) ++ judged_factors curves (coarseness_limits q))%list.
