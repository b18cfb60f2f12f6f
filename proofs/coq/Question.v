(* The gradation as the question has it, and what the solids demand (certificate-format.md, section 2). *)

From Coq Require Import ZArith QArith List Bool String.
From Mdm Require Import Numbers Gradation Certificate.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- Bounds -------------------------------------------------------------------------------------- *)

(* The bounds of section 1 on the numbers that what follows relies on. The reader of the text has seen to them; with
   this test no theorem is about the reader. *)
Definition sensible (cert : certificate) : bool :=
  let q := asked cert in
  let positive := less 0 in
  let sphere := (a q =? 3) && (b q =? 1) in
  (1 <=? a q) && (1 <=? b q) && (0 <=? min_per_class q) && (0 <=? at_least q) &&
  match solids_of q with
  | Anything => true
  | Cylinder d h e => sphere && positive d && positive h && at_most 0 e
  | Volume v p r => sphere && positive v && positive p && positive r
  end &&
  match tolerances_of q with
  | Some t =>
    match passing_all t with Some e => at_most 0 e | None => true end && forallb (at_most 0) (passing_each t) &&
    forallb (fun '(x, _, h) => at_most 0 x && at_most 0 h) (band t)
  | None => true
  end &&
  match size_factor q with Some K => positive K | None => true end &&
  match found (claimed cert) with Some n => 1 <=? n | None => true end &&
  match proof_of cert with
  | Exact scale z _ => (match tolerances_of q with None => positive scale | Some _ => true end) &&
                       match z with Some z => positive z | None => true end
  | Tolerant _ => true
  end.

(* What is said of numbers beyond the limits of section 2; the bits of limit 1. *)
Definition too_long : string := "numbers as long as these, or so many, take too long".
Definition power_bits : Z := 2 ^ 20.

(* ---- pan-size, cut-below, size-factor ------------------------------------------------------------ *)

Definition with_opening (x : Q) (r : row) : row := Row x (retained r) (factor r) (tolerance r).

(* A length that the question gives, as openings are given. *)
Definition to_power (d : Z) (x : Q) : result Q :=
  demand_form (d * bits_of x <=? power_bits) too_long ;; Ok (power x d).

Definition apply_pan_size (d : Z) (P : option Q) (rs : list row) : result (list row) :=
  match P, rs with
  | None, _ => Ok rs
  | Some P, r :: ((next :: _) as rest) =>
    let* Y := to_power d P in
    demand (equal (opening r) 0 && less Y (opening next)) "pan-size: x_1 = 0, P < x_2" ;;
    Ok (with_opening Y r :: rest)
  | Some _, _ => Refused "pan-size: x_1 = 0, P < x_2"
  end.

(* 10^e. *)
Definition power_of_ten (e : Z) : Q := if 0 <=? e then of_integer (10 ^ e) else over (of_integer 1) (of_integer (10 ^ (- e))).

(* e with 10^e <= x < 10^(e+1), for x > 0. The bits of x tell it up to one. *)
Definition decimal_exponent (x : Q) : Z :=
  let e := (Z.log2 (Qnum x) - Z.log2 (Zpos (Qden x))) * 30103 / 100000 in
  if less x (power_of_ten e) then e - 1 else if less x (power_of_ten (e + 1)) then e else e + 1.

(* Whether Y, in lowest terms, is x^d for a fraction x. *)
Definition is_power (d : Z) (Y : Q) : bool :=
  (Numbers.root d (Qnum Y) ^ d =? Qnum Y) && (Numbers.root d (Zpos (Qden Y)) ^ d =? Zpos (Qden Y)).

(* A number S names the opening S; and, if S has at most 15 significant digits, also an irrational opening that is off by
   less than half a unit of the 15th. The powers between which the latter is. *)
Definition named_between (d : Z) (s : Q) : Q * Q :=
  let unit := power_of_ten (decimal_exponent s - 14) in
  let half := if Zpos (Qden (over s unit)) =? 1 then over unit (of_integer 2) else 0%Q in
  (power (subtract s half) d, power (add s half) d).

(* With [exact] = S^d. The root is looked for last, as it takes longest. *)
Definition is_named (d : Z) (exact low high Y : Q) : bool :=
  if equal Y exact then true
  else if less low Y then if less Y high then negb (is_power d Y) else false else false.

(* The rows from the opening that is named. *)
Fixpoint from_opening (named : Q -> bool) (rs : list row) : list row :=
  match rs with
  | r :: rest => if named (opening r) then rs else from_opening named rest
  | [] => []
  end.

Definition apply_cut_below (d : Z) (cut : option Q) (rs : list row) : result (list row) :=
  match cut with
  | None => Ok rs
  | Some s =>
    let* exact := to_power d s in
    let (low, high) := named_between d s in
    match from_opening (is_named d exact low high) rs with
    | (_ :: _ :: _) as left =>
      demand (existsb (fun r => less 0 (retained r)) left) "cut-below: mass is left" ;; Ok left
    | _ => Refused "cut-below: S is an opening below x_n"
    end
  end.

Definition apply_size_factor (d : Z) (K : option Q) (rs : list row) : result (list row) :=
  match K with
  | Some K => let* factor := to_power d K in Ok (map (fun r => with_opening (times (opening r) factor) r) rs)
  | None => Ok rs
  end.

(* ---- Limits 1 and 2 ------------------------------------------------------------------------------ *)

Definition work_of_steps : Z := 2 ^ 34.
Definition work_of_scales : Z := 2 ^ 28.

(* What n openings, a band's lines, and the steps of a chain, or the nodes and multipliers of a tree on k classes, take. *)
Definition work_of (cert : certificate) (n k : Z) : Z :=
  let steps :=
    match proof_of cert with
    | Exact _ _ (Some chain) => size chain
    | Exact _ _ None => 0
    | Tolerant tree =>
      fold_left (fun steps v => steps + match v with
        | Split _ _ _ | SplitMass _ => 1
        | Leaf ms => 1 + terms ms
        | Window ms => 64 * k + terms ms
        end) tree 0
    end in
  let bands := match tolerances_of (asked cert) with Some t => size (band t) | None => 0 end in
  64 * (n + bands) + steps.

Definition option_list {A} (x : option A) : list A := match x with Some x => [x] | None => [] end.

(* An opening counts as long as its d-th root would be. *)
Definition longest_of_rows (d : Z) (rs : list row) : Z :=
  longest (fun r => Z.max (Z.max (quotient_up (bits_of (opening r)) d) (bits_of (retained r)))
                          (Z.max (bits_of (factor r)) (bits_of (tolerance r)))) rs 0.

Definition longest_of_tolerances (t : tolerances) : Z :=
  longest (fun '(x, lo, hi) => Z.max (bits_of x) (Z.max (bits_of lo) (bits_of hi))) (band t)
    (longest bits_of
       (option_list (retained_each t) ++ option_list (passing_all t) ++ option_list (total t)) 
       (longest bits_of (passing_each t) 0)).

Definition longest_count (cert : certificate) : Z :=
  let q := asked cert in
  let of_question := longest bits ([min_per_class q; at_least q] ++ option_list (found (claimed cert)) ++ option_list (bound_of (claimed cert))) 0 in
  let of_tolerances :=
    match tolerances_of q with Some t => longest_of_tolerances t | None => 0 end in
  let of_witness :=
    longest (fun w => Z.max (Z.max (bits (count w)) (bits_of (together w)))
                            (Z.max (bits_of (size_lo w)) (bits_of (size_hi w)))) (witness cert) 0 in
  let of_tree :=
    match proof_of cert with
    | Tolerant tree =>
      longest (fun v => match v with
        | Split _ _ v => bits v
        | SplitMass v => bits_of v
        | Leaf ms | Window ms => longest (fun m => bits (times_m m)) ms 0
        end) tree 0
    | Exact _ _ _ => 0
    end in
  Z.max (Z.max of_question of_tolerances) (Z.max of_witness of_tree).

Definition demand_small (cert : certificate) (d : Z) (rs : list row) : result unit :=
  let long := longest_of_rows d rs in
  let count := longest_count cert in
  let e := Z.max (a (asked cert)) (b (asked cert)) * d in
  demand_form ((e * Z.max long count <=? power_bits) &&
               (work_of cert (size rs) (size rs - 1) * e * (long + count) <=? work_of_steps)) too_long.

Definition apply_question (cert : certificate) (G : gradation) : result gradation :=
  let q := asked cert in
  let d := root G in
  let* rs := apply_pan_size d (pan_size q) (rows G) in
  let* rs := apply_cut_below d (cut_below q) rs in
  let* rs := apply_size_factor d (size_factor q) rs in
  demand_small cert d rs ;;
  Ok (Gradation rs d (has_tolerances G)).

(* ---- Solids -------------------------------------------------------------------------------------- *)

(* 6 V / pi, or bounds of it: every sample with the volume V has more than [volume_below] (at least it, for a
   cylinder), and [volume_enough] is enough. *)
Definition volume_below (s : solids) : Q :=
  match s with
  | Anything => 0
  | Cylinder d h e => over (times (of_integer 3) (times d (times d h))) (times (of_integer 2) (add (of_integer 1) e))
  | Volume v p r => over (times (of_integer 6) v) r
  end.
Definition volume_enough (s : solids) : Q :=
  match s with
  | Volume v p r => over (times (of_integer 6) v) p
  | _ => volume_below s
  end.

(* arctan(1/m) times the unit by its series, each term a floor: off by less than one a term, and one. [n] is the
   odd number of the term, [power] the unit over m^n. *)
Fixpoint arctangent (m n power total : Z) (terms : nat) : Z :=
  match terms with
  | O => total
  | S terms =>
    let term := power / n in
    arctangent m (n + 2) (power / (m * m)) (if n mod 4 =? 1 then total + term else total - term) terms
  end.

(* Bounds with denominators of at most 100 digits are compared with 300 digits of pi, others with 1100; a bound that is
   too close to pi for them is refused. Short numbers take less time and stack. *)
Definition unit_of_pi (p r : Q) : Z :=
  if (Zpos (Qden p) <? 10 ^ 100) && (Zpos (Qden r) <? 10 ^ 100) then 10 ^ 300 else 10 ^ 1100.

(* By Machin: pi = 16 arctan(1/5) - 4 arctan(1/239). Products are not reduced: their gcd would take longer than the
   rest. *)
Definition check_pi (s : solids) : result unit :=
  match s with
  | Volume _ p r =>
    let unit := unit_of_pi p r in
    let pi := 16 * arctangent 5 1 (unit / 5) 0 800 - 4 * arctangent 239 1 (unit / 239) 0 240 in
    let error := 16 * 801 + 4 * 241 in
    demand (at_most (p * of_integer unit) (of_integer (pi - error))) "p < pi" ;;
    demand (at_most (of_integer (pi + error)) (r * of_integer unit)) "pi < r"
  | _ => Ok tt
  end.

(* ---- Sizes --------------------------------------------------------------------------------------- *)

(* The size of class j, which is (numerator / denominator)^(1/(a d)), is in [lo, hi], and [lo, hi] in the class. *)
Definition check_size (a d : Z) (j : class) (w : witness_line) (T : ratio) : result unit :=
  let (numerator, denominator) := T in
  let lo := size_lo w in
  let hi := size_hi w in
  let left x := Qnum x ^ (a * d) * denominator in
  let right x := numerator * Zpos (Qden x) ^ (a * d) in
  demand (less 0 lo && less (lower j) (power lo d) && at_most lo hi) "x_j < lo <= hi" ;;
  demand (at_most (power hi d) (upper j)) "hi <= x_{j+1}" ;;
  demand (at_most (times (of_integer (10 ^ 9)) (subtract hi lo)) lo) "10^9 (hi - lo) <= lo" ;;
  if equal lo hi then demand (left lo =? right lo) "lo^(a d) = T"
  else demand (left lo <=? right lo) "lo^(a d) <= T" ;; demand (right hi <? left hi) "T < hi^(a d)".
