(* A certificate of a match within a tolerance: the problem in integers, and its check (certificate-format.md,
   section 6). *)

From Coq Require Import ZArith QArith List Bool String.
From Mdm Require Import Numbers Gradation Certificate Question Exact Leaf Tree.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- Shares -------------------------------------------------------------------------------------- *)

(* lo <= share <= hi. *)
Record interval := Interval { lo : Q; hi : Q }.
Definition any_share : interval := Interval 0 (of_integer 1).
Definition narrow (i : interval) (least most : Q) : interval := Interval (larger (lo i) least) (smaller (hi i) most).

Definition percent (x : Q) : Q := over x (of_integer 100).
Definition around (share : Q) (e : option Q) (i : interval) : interval :=
  match e with
  | Some e => narrow i (subtract share (percent e)) (add share (percent e))
  | None => i
  end.

(* What the tolerance's lines demand of a class: its shares g_j and G_j with their bounds. *)
Record share := Share { g_j : Q; retained_in : interval; passing_in : interval }.

Definition only_if {A} (yes : bool) (x : A) : option A := if yes then Some x else None.

(* The lines but the band, for the rows of classes j, j + 1, ... and the largest size; [G] is G_(j-1), [each]
   the tolerances of passing-each from class j on. *)
Fixpoint shares (tol : tolerances) (all G : Q) (rs : list row) (each : list Q) : list share :=
  match rs with
  | r :: ((next :: later) as rest) =>
    let g := over (retained r) all in
    let G := add G g in
    let retained_in := around g (only_if (retained_file tol) (tolerance r)) (around g (retained_each tol) any_share) in
    let passing_in :=
      match later with
      | [] => any_share
      | _ => around G (hd_error each)
               (around G (only_if (passing_file tol) (tolerance next)) (around G (passing_all tol) any_share))
      end in
    Share g retained_in passing_in :: shares tol all G rest (tl each)
  | _ => []
  end.

Definition narrow_passing (s : share) (l h : Q) : share :=
  Share (g_j s) (retained_in s) (narrow (passing_in s) l h).
Definition narrow_by (s : share) (lines : list (Q * Q * Q)) : share :=
  fold_left (fun s '(_, l, h) => narrow_passing s (percent l) (percent h)) lines s.

(* The band's lines whose sieve is coarser than the lower opening of class j, as the gradation's openings are given. All passes a
   sieve from the largest opening on. *)
Fixpoint apply_band (js : list class) (ss : list share) (lines : list (Q * Q * Q)) : result (list share) :=
  match js, ss with
  | j :: js', s :: ss' =>
    match js', lines with
    | [], _ =>
      demand (forallb (fun '(x, _, _) => at_most (upper j) x) lines) "band: every sieve is an opening" ;;
      Ok [narrow_by s lines]
    | _, [] => Ok (s :: ss')
    | _, (x, l, h) :: rest =>
      demand (at_most (upper j) x) "band: every sieve is an opening" ;;
      let here := equal x (upper j) in
      let* later := apply_band js' ss' (if here then rest else lines) in
      Ok ((if here then narrow_passing s (percent l) (percent h) else s) :: later)
    end
  | _, _ => Ok []
  end.

(* Nothing passes the finest opening. *)
Fixpoint above_finest (x1 : Q) (lines : list (Q * Q * Q)) : result (list (Q * Q * Q)) :=
  match lines with
  | (x, l, _) :: rest =>
    if at_most x x1 then demand (equal l 0) "band: nothing passes the finest opening" ;; above_finest x1 rest
    else Ok lines
  | [] => Ok []
  end.

Fixpoint in_unit (d : Z) (K : option Q) (lines : list (Q * Q * Q)) : result (list (Q * Q * Q)) :=
  match lines with
  | [] => Ok []
  | (x, l, h) :: lines =>
    let* Y := to_power d (match K with Some K => times x K | None => x end) in
    let* lines := in_unit d K lines in
    Ok ((Y, l, h) :: lines)
  end.

Definition shares_of (q : question) (tol : tolerances) (G : gradation) : result (list share) :=
  let rs := rows G in
  demand (negb (retained_file tol || passing_file tol) || has_tolerances G) "a column tolerance_percent" ;;
  demand (match passing_each tol with [] => true | each => size each =? size rs - 2 end)
    "passing-each: k - 1 tolerances" ;;
  let all := fold_left add (map retained rs) 0%Q in
  let ss := shares tol all 0 rs (passing_each tol) in
  let x1 := match rs with r :: _ => opening r | [] => 0%Q end in
  let* lines := in_unit (root G) (size_factor q) (band tol) in
  let* lines := above_finest x1 lines in
  apply_band (classes rs) ss lines.

(* ---- The problem --------------------------------------------------------------------------------- *)

(* x^(1/b), if it is rational. With a/b in lowest terms x^(a/b) is rational iff it is. *)
Definition rational_root (b : Z) (x : Q) : result Q :=
  demand (is_power b x) "a rational mass at each opening" ;;
  Ok (fraction (Numbers.root b (Qnum x)) (Numbers.root b (Zpos (Qden x)))).

Fixpoint rational_roots (b : Z) (rs : list row) : result (list Q) :=
  match rs with
  | [] => Ok []
  | r :: rs =>
    let* x := rational_root b (opening r) in
    let* xs := rational_roots b rs in
    Ok (x :: xs)
  end.

Definition half (total : option Q) : Q :=
  match total with Some e => over e (of_integer 200) | None => of_integer 1 end.

(* 1 / c, or 0 where there are no solids. *)
Definition inverse_factor (s : solids) (j : class) : Q :=
  match s with Anything => 0 | _ => over (of_integer 1) (c j) end.

Definition denominators (w : Q) (s : share) : list Z :=
  map (fun x => Zpos (Qden x))
    [g_j s; w; lo (retained_in s); hi (retained_in s); lo (passing_in s); hi (passing_in s)].

(* A row and the next: the class between them, or, where the row begins none, one that holds nothing. *)
Definition between_rows : Type := class * bool.
Definition all_begin (js : list class) : list between_rows := map (fun j => (j, true)) js.

(* Class by class, with the roots of its openings. *)
Fixpoint limits_of (R a size_unit factor_unit unit : Z) (s : solids) (js : list between_rows) (ss : list share) (roots : list Q)
  : list limits :=
  match js, ss, roots with
  | (j, begins) :: js, s_j :: ss, x :: ((y :: _) as roots) =>
    let factor := in_units (c j) factor_unit in
    let mass_at x := factor * in_units x size_unit ^ a in
    let share x := in_units x unit in
    Limits (if begins then mass_at x else 0) (if begins then mass_at y else 1) (if equal (mass j) 0 then 0 else R)
      (share (lo (retained_in s_j))) (share (hi (retained_in s_j)))
      (share (lo (passing_in s_j))) (share (hi (passing_in s_j)))
      (share (g_j s_j)) (share (inverse_factor s j))
    :: limits_of R a size_unit factor_unit unit s js ss roots
  | _, _, _ => []
  end.

Definition derive (cert : certificate) (d : Z) (rs : list row) (js : list between_rows) (ss : list share) (tol : tolerances)
  : result problem :=
  let q := asked cert in
  let e := half (total tol) in
  let ws := map (inverse_factor (solids_of q)) (map fst js) in
  let* unit := include_all (flat_map (fun '(w, s) => denominators w s) (combine ws ss)) (Zpos (Qden e)) in
  (* x^(a/b) is Y^(a/(b d)): a'/b' in lowest terms. *)
  let n := Z.gcd (a q) (b q * d) in
  let a' := a q / n in
  let* roots := rational_roots (b q * d / n) rs in
  let size_unit := common_denominator roots in
  let factor_unit := common_denominator (map factor rs) in
  let w := volume_below (solids_of q) in
  demand_form (work_of cert (size rs - 1) (size rs - 1) * (bits unit + bits_of w) <=? work_of_steps) too_long ;;
  Ok (Problem (limits_of (min_per_class q) a' size_unit factor_unit unit (solids_of q) js ss roots)
        (size_unit ^ a' * factor_unit) unit (in_units e unit) (Z.max 1 (at_least q)) w (bound_of (claimed cert))).

(* ---- The witness --------------------------------------------------------------------------------- *)

(* Class by class: counts and masses (in a unit in which all are integers), 0 where there is no line; the
   particles of a line are in their class. *)
Fixpoint contents (a b d unit : Z) (pr : problem) (j : Z) (js : list class) (cs : list limits) (ws : list witness_line)
  : result (list (Z * Z)) :=
  match js, cs, ws with
  | [], _, [] => Ok []
  | x :: js, c_j :: cs, w :: ws' =>
    if index w =? j then
      let q := count w in
      let t := in_units (together w) unit in
      demand (f c_j * q * unit <? t * mass_unit pr) "f q < t" ;;
      demand (t * mass_unit pr <=? F c_j * q * unit) "t <= F q" ;;
      let one := over (together w) (times (of_integer q) (c x)) in
      check_size a d x w (Qnum one ^ (b * d), Zpos (Qden one) ^ (b * d)) ;;
      let* later := contents a b d unit pr (j + 1) js cs ws' in Ok ((q, t) :: later)
    else let* later := contents a b d unit pr (j + 1) js cs ws in Ok ((0, 0) :: later)
  | x :: js, c_j :: cs, [] => let* later := contents a b d unit pr (j + 1) js cs [] in Ok ((0, 0) :: later)
  | _, _, _ => Refused "witness: a class of the gradation"
  end.

(* The bounds on single classes; P is what passes the lower opening of the first, M all. *)
Fixpoint within (unit M P : Z) (cs : list limits) (qts : list (Z * Z)) : bool :=
  match cs, qts with
  | c :: cs, (q, t) :: qts =>
    let t := t * unit in
    let P := P + t in
    (floor c <=? q) && (retained_lo c * M <=? t) && (t <=? retained_hi c * M) &&
    (passing_lo c * M <=? P) && (P <=? passing_hi c * M) && within unit M P cs qts
  | [], [] => true
  | _, _ => false
  end.

Definition excess (unit M : Z) (cs : list limits) (qts : list (Z * Z)) : Z :=
  sum (map (fun '(c, (_, t)) => Z.max 0 (t * unit - g c * M)) (combine cs qts)).
Definition over_factors (cs : list limits) (qts : list (Z * Z)) : Z :=
  sum (map (fun '(c, (_, t)) => t * per_factor c) (combine cs qts)).

Definition check_witness (cert : certificate) (d : Z) (js : list class) (pr : problem) (N : Z) : result unit :=
  let q := asked cert in
  let cs := classes_of pr in
  let* unit := include_all (map (fun w => Zpos (Qden (together w))) (witness cert)) 1 in
  demand_form (work_of cert (size js) (size js) * bits unit <=? work_of_steps) too_long ;;
  let* qts := contents (a q) (b q) d unit pr 1%Z js cs (witness cert) in
  let M := sum (map snd qts) in
  demand (within (share_unit pr) M 0 cs qts) "q >= R, or a tolerance" ;;
  demand (excess (share_unit pr) M cs qts <=? half_total pr * M) "total" ;;
  demand (at_most (times (volume_enough (solids_of q)) (of_integer (share_unit pr * unit)))
                  (of_integer (over_factors cs qts))) "the volume of the solids" ;;
  demand (sum (map fst qts) =? N) "sum of q = N" ;;
  demand (at_least q <=? N) "N >= M".

Definition check_tolerant (cert : certificate) (d : Z) (rs : list row) (js : list between_rows) (ss : list share)
  (tol : tolerances) (nodes : list node) : result unit :=
  let* pr := derive cert d rs js ss tol in
  check_pi (solids_of (asked cert)) ;;
  match found (claimed cert) with
  | Some N => check_witness cert d (map fst js) pr N
  | None => Ok tt
  end ;;
  check_tree pr nodes.
