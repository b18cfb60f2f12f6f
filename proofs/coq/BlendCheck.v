(* The check of a certificate of a blend against what the blend is judged by (certificate-format.md, section 11; Theorem 22). *)

From Coq Require Import ZArith QArith List Bool String.
From Mdm Require Import Numbers Rows SampleTally Blend BlendCertificate BlendSieves.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- Boxes ------------------------------------------------------------------------------------------ *)

(* The least and most steps of each stockpile. *)
Definition box : Type := list (Z * Z).

Definition raise (v : Z) (bounds : Z * Z) : Z * Z := let (lo, hi) := bounds in (Z.max lo v, hi).
Definition lower (v : Z) (bounds : Z * Z) : Z * Z := let (lo, hi) := bounds in (lo, Z.min hi v).

(* With [change] of the element with this number; none where there is no such element. *)
Fixpoint changed {A} (j : Z) (change : A -> A) (l : list A) : option (list A) :=
  match l with
  | [] => None
  | x :: l => if j =? 1 then Some (change x :: l) else option_map (cons x) (changed (j - 1) change l)
  end.

Fixpoint within_share_limits (M : Z) (limits : list (Z * Q * Q)) (b : box) : result box :=
  match limits with
  | [] => Ok b
  | (i, x, y) :: limits =>
    let up := quotient_up (Qnum x * M) (Zpos (Qden x)) in
    let down := Qnum y * M / Zpos (Qden y) in
    match changed i (fun bounds => lower down (raise up bounds)) b with
    | Some b => within_share_limits M limits b
    | None => Refused "a share of a stockpile that is there"
    end
  end.

Definition whole_box (q : blend_question) (curves : list curve) : result box :=
  within_share_limits (steps q) (share_limits q) (map (fun _ => (0, steps q)) curves).

(* How many stockpiles have a share in all of the box. *)
Fixpoint used_least (b : box) : Z :=
  match b with (lo, _) :: b => (if 0 <? lo then 1 else 0) + used_least b | [] => 0 end.

Definition without_others (bounds : Z * Z) : Z * Z := let (lo, hi) := bounds in if lo =? 0 then (0, 0) else (lo, hi).

(* What is left of a box, where K stockpiles at most have a share; none where it is empty. *)
Definition restricted (M : Z) (K : option Z) (b : box) : option box :=
  let too_many := match K with Some K => K <? used_least b | None => false end in
  let others := match K with Some K => K =? used_least b | None => false end in
  let b := if others then map without_others b else b in
  if too_many then None
  else if forallb (fun '(lo, hi) => lo <=? hi) b && (sum (map fst b) <=? M) && (M <=? sum (map snd b)) then Some b
  else None.

(* ---- Sums over a blend ------------------------------------------------------------------------------ *)

Fixpoint weighted_sum (ns : blend) (xs : list Q) (done : Q) : Q :=
  match ns, xs with
  | n :: ns, x :: xs => weighted_sum ns xs (add done (times (of_integer n) x))
  | _, _ => done
  end.
Definition mean_of (M : Z) (ns : blend) (xs : list Q) : Q := over (weighted_sum ns xs 0) (of_integer M).

Definition deviations_of (M : Z) (js : list judged) (ts : list Q) (ns : blend) : list Q :=
  map (fun '(j, t) => distance (mean_of M ns (passing_judged j)) t) (combine js ts).

Definition value_of_blend (M : Z) (a : aim) (js : list judged) (ns : blend) : Q :=
  match a with
  | NoAim => 0
  | Cost cs => mean_of M ns cs
  | Deviation ts => fold_right add 0%Q (deviations_of M js ts ns)
  | MaxDeviation ts => fold_right larger 0%Q (deviations_of M js ts ns)
  | Squares ts => fold_right (fun d sum => add (times d d) sum) 0%Q (deviations_of M js ts ns)
  end.

(* ---- The blend itself ------------------------------------------------------------------------------- *)

Fixpoint is_in_box (b : box) (ns : blend) : bool :=
  match b, ns with
  | (lo, hi) :: b, n :: ns => if (lo <=? n) && (n <=? hi) then is_in_box b ns else false
  | [], [] => true
  | _, _ => false
  end.

Definition keeps_limits (M : Z) (ns : blend) (j : judged) : bool :=
  let p := mean_of M ns (passing_judged j) in at_most (least_judged j) p && at_most p (most_judged j).

Definition check_blend_itself (q : blend_question) (js : list judged) (b : box) (ns : blend) : result unit :=
  demand (size ns =? size b) "a number of steps for each stockpile" ;;
  demand (sum_of_steps ns =? steps q) "the sum of the steps" ;;
  demand (is_in_box b ns) "the limits of a share" ;;
  demand (match most_stockpiles q with Some K => used ns <=? K | None => true end) "at-most" ;;
  demand (forallb (keeps_limits (steps q) ns) js) "a limit, kept by the blend".

(* ---- Leaves ----------------------------------------------------------------------------------------- *)

(* What is below the value in all of a box: the constant, and for each stockpile what a whole share of it adds. [weights] are those
   of the targets' deviations. *)
Record below := Below { constant : Q; of_shares : list Q; weights : list Q }.

Fixpoint less_times (e : list Q) (m : Q) (ps : list Q) : list Q :=
  match e, ps with
  | e1 :: e, p :: ps => subtract e1 (times m p) :: less_times e m ps
  | _, _ => []
  end.

Definition minus (m : Q) : Q := Qopp m.
Definition is_squares (a : aim) : bool := match a with Squares _ => true | _ => false end.

(* [ts] are the targets that conditions may be of. *)
Definition add_multiple (a : aim) (js : list judged) (ts : list Q) (x : below) (m : blend_multiple) : result below :=
  let 'Below D e ws := x in
  let m1 := multiplier m in
  match numbered (of_sieve m) js with
  | None => Refused "a multiplier of a sieve that is there"
  | Some j =>
    let limit (sign bound : Q) := Ok (Below (add D (times sign bound)) (less_times e sign (passing_judged j)) ws) in
    let target (sign : Q) :=
      match numbered (of_sieve m) ts, numbered (of_sieve m) ws, changed (of_sieve m) (add m1) ws with
      | Some t, Some w, Some ws =>
        demand (negb (is_squares a) || equal w 0) "multipliers of one side of a target alone" ;;
        let D := add D (times sign t) in
        let D := if is_squares a then subtract D (over (times m1 m1) (of_integer 4)) else D in
        Ok (Below D (less_times e sign (passing_judged j)) ws)
      | _, _, _ => Refused "a multiplier of a target that is there"
      end in
    match side_of m with
    | LowerLimit => limit m1 (least_judged j)
    | UpperLimit => limit (minus m1) (most_judged j)
    | BelowTarget => target m1
    | AboveTarget => target (minus m1)
    end
  end.

Fixpoint add_multiples (a : aim) (js : list judged) (ts : list Q) (ms : list blend_multiple) (x : below) : result below :=
  match ms with
  | [] => Ok x
  | m :: ms =>
    demand (less 0 (multiplier m)) "a multiplier above 0" ;;
    let* x := add_multiple a js ts x m in add_multiples a js ts ms x
  end.

Definition weights_are_allowed (a : aim) (ws : list Q) : bool :=
  match a with
  | NoAim | Cost _ | Deviation _ => forallb (fun w => at_most w (of_integer 1)) ws
  | MaxDeviation _ => at_most (sum_in_lowest_terms ws) (of_integer 1)
  | Squares _ => true
  end.

(* ---- The least sum in a box ------------------------------------------------------------------------- *)

Definition cheaper (x y : Q * Z) : bool := less (fst x) (fst y).

(* Stockpiles in the order of e, each with the steps that its box has room for: the e of the one that the last of [left] steps is of. *)
Fixpoint last_filled (left : Z) (es : list (Q * Z)) (before : Q) : Q :=
  match es with
  | [] => before
  | (e, room) :: es => if left <=? room then e else last_filled (left - room) es e
  end.

Definition threshold (M : Z) (e : list Q) (b : box) : Q :=
  last_filled (M - sum (map fst b)) (sorted cheaper (combine e (map (fun '(lo, hi) => hi - lo) b))) 0.

(* Each stockpile that costs less than tau has all its steps, each that costs more none that it need not. *)
Fixpoint filled_to (tau : Q) (e : list Q) (b : box) (done : Q) : Q :=
  match e, b with
  | e1 :: e, (lo, hi) :: b =>
    let over_tau := subtract e1 tau in
    filled_to tau e b (add done (times over_tau (of_integer (if less over_tau 0 then hi else lo))))
  | _, _ => done
  end.

(* The least of the sum of e_i n_i, where the n_i of the box sum to M. *)
Definition least_sum (M : Z) (e : list Q) (b : box) : Q :=
  let tau := threshold M e b in filled_to tau e b (times tau (of_integer M)).

(* ---- Trees ------------------------------------------------------------------------------------------ *)

Definition no_costs (curves : list curve) : list Q := map (fun _ => 0%Q) curves.
Definition costs_of (a : aim) (curves : list curve) : list Q := match a with Cost cs => cs | _ => no_costs curves end.

Definition bound_in_box (q : blend_question) (a : aim) (curves : list curve) (js : list judged) (ms : list blend_multiple) (b : box)
  : result Q :=
  let ts := targets_of a in
  let* x := add_multiples a js ts ms (Below 0 (costs_of a curves) (map (fun _ => 0%Q) ts)) in
  demand (weights_are_allowed a (weights x)) "multipliers of targets, no more than the aim has of deviations" ;;
  Ok (add (constant x) (over (least_sum (steps q) (of_shares x) b) (of_integer (steps q)))).

Fixpoint check_blend_tree (q : blend_question) (curves : list curve) (js : list judged) (claimed : option Q) (nodes : list blend_node)
  (open : list box) : result unit :=
  match nodes, open with
  | [], [] => Ok tt
  | SplitSteps i v :: nodes, b :: open =>
    match changed i (lower v) b, changed i (raise (v + 1)) b with
    | Some b1, Some b2 => check_blend_tree q curves js claimed nodes (b1 :: b2 :: open)
    | _, _ => Refused "a split of a stockpile that is there"
    end
  | NoneBetter ms :: nodes, b :: open =>
    match restricted (steps q) (most_stockpiles q) b with
    | None => check_blend_tree q curves js claimed nodes open
    | Some b =>
      let* bound := bound_in_box q (aim_of q) curves js ms b in
      demand (match claimed with Some v => at_most v bound | None => false end) "a leaf without a blend of lower value" ;;
      check_blend_tree q curves js claimed nodes open
    end
  | NoBlend ms :: nodes, b :: open =>
    match restricted (steps q) (most_stockpiles q) b with
    | None => check_blend_tree q curves js claimed nodes open
    | Some b =>
      let* bound := bound_in_box q NoAim curves js ms b in
      demand (less 0 bound) "a leaf without a blend" ;;
      check_blend_tree q curves js claimed nodes open
    end
  | _, _ => Malformed "a tree with as many leaves as its splits need"
  end.

(* ---- The whole -------------------------------------------------------------------------------------- *)

Definition is_by_sieve (j : judged) : bool := match by_what j with BySieve _ => true | _ => false end.

Definition check_aim (q : blend_question) (curves : list curve) (js : list judged) : result unit :=
  match aim_of q with
  | NoAim => Ok tt
  | Cost cs => demand (size cs =? size curves) "as many costs as stockpiles"
  | Deviation ts | MaxDeviation ts | Squares ts => demand (size ts =? size (filter is_by_sieve js)) "as many targets as sieves"
  end.

(* The limit of section 11. *)
Definition terms_of_node (n : blend_node) : Z := match n with SplitSteps _ _ => 0 | NoneBetter ms | NoBlend ms => size ms end.
Definition multipliers_of (n : blend_node) : list Q :=
  match n with SplitSteps _ _ => [] | NoneBetter ms | NoBlend ms => map_all multiplier ms end.

Definition work_of_blend (C : blend_certificate) (curves : list curve) (js : list judged) : Z :=
  let q := asked_blend C in
  let nodes := blend_tree C in
  let all := fold_left (fun n node => n + 1 + terms_of_node node) nodes 0 in
  let longest_leaf := longest terms_of_node nodes 0 in
  let bits := longest bits_of (numbers_of (aim_of q)) 1 in
  let bits := fold_left (fun n node => longest bits_of (multipliers_of node) n) nodes bits in
  let bits := fold_left (fun n '(_, x, y) => longest bits_of [x; y] n) (share_limits q) bits in
  let bits := fold_left (fun n '(_, x, y) => longest bits_of [x; y] n) (modulus_limits q) bits in
  let bits := match coarseness_limits q with Some (x, y) => longest bits_of [x; y] bits | None => bits end in
  let bits := fold_left (fun n j => longest bits_of (passing_judged j) n) js bits in
  (all + size js) * (size curves + 1) * (longest_leaf + 1) * bits.

Definition check_blend_claim (C : blend_certificate) (curves : list curve) (js : list judged) : result Q :=
  let q := asked_blend C in
  demand_form (1 <=? steps q) "no steps" ;;
  demand (match claimed_blend C with Some ns => size ns =? size curves | None => true end)
    "a number of steps for each stockpile" ;;
  let* b := whole_box q curves in
  check_aim q curves js ;;
  match claimed_blend C with
  | Some ns =>
    check_blend_itself q js b ns ;;
    let v := value_of_blend (steps q) (aim_of q) js ns in
    if has_aim (aim_of q) then check_blend_tree q curves js (Some v) (blend_tree C) [b] ;; Ok v else Ok v
  | None => check_blend_tree q curves js None (blend_tree C) [b] ;; Ok 0%Q
  end.

Definition check_blend (C : blend_certificate) (curves : list curve) (limits : list (Q * Q * Q)) : result (list judged * Q) :=
  let* js := all_judged curves limits (asked_blend C) in
  demand_form (work_of_blend C curves js <=? 2 ^ 34) "more than can be checked: search for a smaller tree" ;;
  let* v := check_blend_claim C curves js in Ok (js, v).
