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
    forallb (fun '(_, _, h) => at_most 0 h) (band t)
  | None => true
  end &&
  match particles cert with Some n => 1 <=? n | None => true end &&
  match proof_of cert with
  | Exact scale z _ => (match tolerances_of q with None => positive scale | Some _ => true end) &&
                       match z with Some z => positive z | None => true end
  | Tolerant _ => true
  end.

(* ---- pan-size, cut-below, size-factor ------------------------------------------------------------ *)

Definition with_opening (x : Q) (r : row) : row := Row x (retained r) (factor r) (tolerance r).

Definition apply_pan_size (P : option Q) (rs : list row) : result (list row) :=
  match P, rs with
  | None, _ => Ok rs
  | Some P, r :: ((next :: _) as rest) =>
    demand (equal (opening r) 0 && less P (opening next)) "pan-size: x_1 = 0, P < x_2" ;;
    Ok (with_opening P r :: rest)
  | Some _, _ => Refused "pan-size: x_1 = 0, P < x_2"
  end.

Fixpoint from_opening (x : Q) (rs : list row) : list row :=
  match rs with
  | r :: rest => if less (opening r) x then from_opening x rest else rs
  | [] => []
  end.

Definition apply_cut_below (cut : option Q) (rs : list row) : result (list row) :=
  match cut with
  | None => Ok rs
  | Some x =>
    match from_opening x rs with
    | (r :: _ :: _) as left =>
      demand (equal (opening r) x) "cut-below: S is an opening below x_n" ;;
      demand (existsb (fun r => less 0 (retained r)) left) "cut-below: mass is left" ;; Ok left
    | _ => Refused "cut-below: S is an opening below x_n"
    end
  end.

Definition apply_size_factor (K : option Q) (rs : list row) : list row :=
  match K with
  | Some K => map (fun r => with_opening (times (opening r) K) r) rs
  | None => rs
  end.

(* ---- Limits 1 and 2 ------------------------------------------------------------------------------ *)

Definition too_long : string := "numbers as long as these, or so many, take too long".
Definition power_bits : Z := 2 ^ 20.
Definition work_of_steps : Z := 2 ^ 34.
Definition work_of_scales : Z := 2 ^ 32.

(* What n openings and the steps of a chain, or the nodes of a tree, take. *)
Definition work_of (cert : certificate) (n : Z) : Z :=
  let steps :=
    match proof_of cert with
    | Exact _ _ (Some chain) => size chain
    | Exact _ _ None => 0
    | Tolerant tree =>
      fold_left (fun steps v => steps + match v with Split _ _ => 1 | Leaf ms => n + size ms end) tree 0
    end in
  64 * n + steps.

Definition option_list {A} (x : option A) : list A := match x with Some x => [x] | None => [] end.

Definition longest_of_rows (rs : list row) : Z :=
  longest (fun r => Z.max (Z.max (bits_of (opening r)) (bits_of (retained r)))
                          (Z.max (bits_of (factor r)) (bits_of (tolerance r)))) rs 0.

Definition longest_of_tolerances (t : tolerances) : Z :=
  longest (fun '(x, lo, hi) => Z.max (bits_of x) (Z.max (bits_of lo) (bits_of hi))) (band t)
    (longest bits_of
       (option_list (retained_each t) ++ option_list (passing_all t) ++ option_list (total t)) 
       (longest bits_of (passing_each t) 0)).

Definition longest_count (cert : certificate) : Z :=
  let q := asked cert in
  let of_question := longest bits ([min_per_class q; at_least q] ++ option_list (particles cert)) 0 in
  let of_tolerances :=
    match tolerances_of q with Some t => longest_of_tolerances t | None => 0 end in
  let of_witness :=
    longest (fun w => Z.max (Z.max (bits (count w)) (bits_of (together w)))
                            (Z.max (bits_of (size_lo w)) (bits_of (size_hi w)))) (witness cert) 0 in
  let of_tree :=
    match proof_of cert with
    | Tolerant tree =>
      longest (fun v => match v with Split _ v => bits v | Leaf ms => longest (fun m => bits (times_m m)) ms 0 end)
        tree 0
    | Exact _ _ _ => 0
    end in
  Z.max (Z.max of_question of_tolerances) (Z.max of_witness of_tree).

Definition demand_small (cert : certificate) (rs : list row) : result unit :=
  let long := longest_of_rows rs in
  let count := longest_count cert in
  let e := Z.max (a (asked cert)) (b (asked cert)) in
  demand_form ((e * Z.max long count <=? power_bits) &&
               (work_of cert (size rs) * e * (long + count) <=? work_of_steps)) too_long.

Definition apply_question (cert : certificate) (G : gradation) : result gradation :=
  let q := asked cert in
  let* rs := apply_pan_size (pan_size q) (rows G) in
  let* rs := apply_cut_below (cut_below q) rs in
  let rs := apply_size_factor (size_factor q) rs in
  demand_small cert rs ;;
  Ok (Gradation rs (has_tolerances G)).

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

(* By Machin: pi = 16 arctan(1/5) - 4 arctan(1/239). *)
Definition check_pi (s : solids) : result unit :=
  match s with
  | Volume _ p r =>
    let unit := 10 ^ 1100 in
    let pi := 16 * arctangent 5 1 (unit / 5) 0 800 - 4 * arctangent 239 1 (unit / 239) 0 240 in
    let error := 16 * 801 + 4 * 241 in
    demand (at_most (times p (of_integer unit)) (of_integer (pi - error))) "p < pi" ;;
    demand (at_most (of_integer (pi + error)) (times r (of_integer unit))) "pi < r"
  | _ => Ok tt
  end.

(* ---- Sizes --------------------------------------------------------------------------------------- *)

(* The size of class j, which is (numerator / denominator)^(1/a), is in [lo, hi], and [lo, hi] in the class. *)
Definition check_size (a : Z) (j : class) (w : witness_line) (T : ratio) : result unit :=
  let (numerator, denominator) := T in
  let lo := size_lo w in
  let hi := size_hi w in
  let left x := Qnum x ^ a * denominator in
  let right x := numerator * Zpos (Qden x) ^ a in
  demand (less (lower j) lo && at_most lo hi) "x_j < lo <= hi" ;;
  demand (at_most hi (upper j)) "hi <= x_{j+1}" ;;
  demand (at_most (times (of_integer (10 ^ 9)) (subtract hi lo)) lo) "10^9 (hi - lo) <= lo" ;;
  if equal lo hi then demand (left lo =? right lo) "lo^a = T"
  else demand (left lo <=? right lo) "lo^a <= T" ;; demand (right hi <? left hi) "T < hi^a".
