(* The certificate, and how its text is read (certificate-format.md, section 1).

   The text is a list of lines, a line a list of words: what lies between two line feeds, and between two
   spaces. So "end" and a line feed are the lines ["end"] and [""]. *)

From Coq Require Import ZArith QArith List Bool String Ascii FMapPositive.
From Mdm Require Import Numbers.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- What a certificate says --------------------------------------------------------------------- *)

(* The volume of the solids; a box is a volume. p and r are the bounds of pi. *)
Inductive solids :=
| Anything
| Cylinder (diameter height void_ratio : Q)
| Volume (volume p r : Q).

(* The lines of section 6. *)
Record tolerances := Tolerances {
  retained_each : option Q;
  retained_file : bool;
  passing_all : option Q;
  passing_file : bool;
  passing_each : list Q;
  total : option Q;
  band : list (Q * Q * Q) }.

(* What the gradation file does not say. The law is x^(a/b). min_per_class and at_least are 0 where the
   question has none. *)
Record question := Question {
  a : Z;
  b : Z;
  pan_size : option Q;
  cut_below : option Q;
  size_factor : option Q;
  min_per_class : Z;
  solids_of : solids;
  at_least : Z;
  tolerances_of : option tolerances }.

(* Class [index], counted from 1, holds [count] particles of one size in [size_lo, size_hi], with the mass
   [together], which is there for a tolerance only. *)
Record witness_line := Witness {
  index : Z; count : Z; together : Q; size_lo : Q; size_hi : Q }.

(* A condition of section 6: a letter and its classes from [of_class] to [up_to]; these are the same for one class, and 0
   where it has none. *)
Record multiple := Multiple { times_m : Z; letter : ascii; of_class : Z; up_to : Z }.

(* A split of the particles of the classes i to j; i = j for one class; or of the mass; or a leaf, of any mass or of a
   window of it. *)
Inductive node :=
| Split (i j v : Z)
| SplitMass (v : Q)
| Leaf (conditions : list multiple)
| Window (conditions : list multiple).

(* A proof by a chain, with the witness's scale (to the power b); or by a tree, in preorder. *)
Inductive proof :=
| Exact (scale : Q) (above : option Q) (chain : option (list Z))
| Tolerant (tree : list node).

(* The smallest match has N particles; none has fewer than B, and one has N; none has fewer than B; there is none of any
   number. *)
Inductive claim := Smallest (N : Z) | Between (B N : Z) | NoneBelow (B : Z) | NoMatch.

(* How many particles the witness has; the number below which no match is claimed to be. *)
Definition found (c : claim) : option Z :=
  match c with Smallest N | Between _ N => Some N | NoneBelow _ | NoMatch => None end.
Definition bound_of (c : claim) : option Z :=
  match c with Smallest B | Between B _ | NoneBelow B => Some B | NoMatch => None end.

Record certificate := Certificate {
  asked : question;
  claimed : claim;
  witness : list witness_line;
  proof_of : proof }.

(* What only versions from 2 on have: bounds, and sums of consecutive classes. *)
Definition of_sum_of_classes (n : node) : bool :=
  match n with
  | Split i j _ => negb (i =? j)
  | SplitMass _ => false
  | Leaf ms | Window ms => existsb (fun m => negb (of_class m =? up_to m)) ms
  end.
Definition is_second (c : claim) (p : proof) : bool :=
  match c with Between _ _ | NoneBelow _ => true | Smallest _ | NoMatch => false end ||
  match p with Tolerant nodes => existsb of_sum_of_classes nodes | Exact _ _ _ => false end.

(* What only version 3 has: windows of the mass. *)
Definition of_window (n : node) : bool := match n with SplitMass _ | Window _ => true | Split _ _ _ | Leaf _ => false end.
Definition is_third (p : proof) : bool :=
  match p with Tolerant nodes => existsb of_window nodes | Exact _ _ _ => false end.

(* ---- Numbers ------------------------------------------------------------------------------------- *)

Definition most_digits : Z := 100000.
Definition most_rows : Z := 2 ^ 20.
Definition most_nodes : Z := 2 ^ 22.

Definition digit (ch : ascii) : option Z :=
  let n := Z.of_N (N_of_ascii ch) - 48 in if (0 <=? n) && (n <=? 9) then Some n else None.

(* The value of [value] followed by the digits at the head of a word, how many digits these are more than
   [n], and the rest of the word. *)
Fixpoint digits (w : string) (value n : Z) : Z * Z * string :=
  match w with
  | EmptyString => (value, n, w)
  | String ch rest =>
    match digit ch with
    | Some d => digits rest (10 * value + d) (n + 1)
    | None => (value, n, w)
    end
  end.

Definition starts_with_zero (w : string) : bool :=
  match w with String ch _ => Ascii.eqb ch "0" | EmptyString => false end.

Definition check {A} (holds : bool) (value : A) : option A := if holds then Some value else None.

(* An integer in its only form. *)
Definition whole (most : Z) (w : string) : option Z :=
  let '(value, n, rest) := digits w 0 0 in
  check (String.eqb rest "" && (1 <=? n) && (n <=? most) && (negb (starts_with_zero w) || (n =? 1))) value.

(* An integer or a decimal in its only form. *)
Definition decimal (w : string) : option Q :=
  let '(value, n, rest) := digits w 0 0 in
  let integral := (1 <=? n) && (negb (starts_with_zero w) || (n =? 1)) in
  match rest with
  | EmptyString => check (integral && (n <=? most_digits)) (of_integer value)
  | String ch places =>
    let '(value, all, rest) := digits places value n in
    check (integral && Ascii.eqb ch "." && String.eqb rest "" && (n <? all) && (all <=? most_digits) &&
           negb (value mod 10 =? 0))
      (fraction value (10 ^ (all - n)))
  end.

(* What is before the first [mark] of a word, and what behind it. *)
Fixpoint at_mark (mark : ascii) (w : string) : string * option string :=
  match w with
  | EmptyString => (w, None)
  | String ch rest =>
    if Ascii.eqb ch mark then (EmptyString, Some rest)
    else let (before, after) := at_mark mark rest in (String ch before, after)
  end.

(* An integer or p/q with q >= 2 in lowest terms. *)
Definition rational (w : string) : option Q :=
  match at_mark "/" w with
  | (_, None) => option_map of_integer (whole most_digits w)
  | (n, Some d) =>
    match whole most_digits n, whole most_digits d with
    | Some n, Some d => check ((2 <=? d) && (Z.gcd n d =? 1)) (Qmake n (Z.to_pos d))
    | _, _ => None
    end
  end.

Inductive kind := Integer (least : Z) | Positive | NotNegative | Percent (most : Z) | Rational.

Definition number (k : kind) (w : string) : option Q :=
  let such (value : option Q) (holds : Q -> bool) :=
    match value with Some x => check (holds x) x | None => None end in
  match k with
  | Integer least => such (option_map of_integer (whole most_digits w)) (at_most (of_integer least))
  | Positive => such (decimal w) (less 0)
  | NotNegative => decimal w
  | Percent most => such (decimal w) (fun x => at_most x (of_integer most))
  | Rational => such (rational w) (less 0)
  end.

Definition class_index (w : string) : option Z := whole 18 w.

(* One class, or i-j with i < j. *)
Definition class_range (w : string) : option (Z * Z) :=
  match at_mark "-" w with
  | (_, None) => option_map (fun j => (j, j)) (class_index w)
  | (i, Some j) =>
    match class_index i, class_index j with
    | Some i, Some j => check (i <? j) (i, j)
    | _, _ => None
    end
  end.

(* ---- Lines --------------------------------------------------------------------------------------- *)

Definition line : Type := list string.
Definition lines : Type := list line.

(* A reader takes something from the head of the lines; what it cannot read is malformed. *)
Definition reader (A : Type) : Type := lines -> result (A * lines).

Definition named (name : string) (ls : lines) : bool :=
  match ls with (w :: _) :: _ => String.eqb w name | _ => false end.

Fixpoint numbers (ks : list kind) (l : line) : option (list Q) :=
  match ks, l with
  | [], [] => Some []
  | k :: ks, w :: l =>
    match number k w, numbers ks l with
    | Some x, Some xs => Some (x :: xs)
    | _, _ => None
    end
  | _, _ => None
  end.

(* The numbers of a line that must be there. *)
Definition required (name : string) (ks : list kind) : reader (list Q) := fun ls =>
  match ls with
  | (w :: l) :: ls =>
    match String.eqb w name, numbers ks l with
    | true, Some xs => Ok (xs, ls)
    | true, None => Malformed ("a number of the line " ++ name)
    | false, _ => Malformed ("the line " ++ name ++ " is missing")
    end
  | _ => Malformed ("the line " ++ name ++ " is missing")
  end.

(* No numbers where the line is absent. *)
Definition optional (name : string) (ks : list kind) : reader (list Q) := fun ls =>
  if named name ls then required name ks ls else Ok ([], ls).

Definition is_line (l : line) (ls : lines) : bool :=
  match ls with
  | found :: _ => if list_eq_dec string_dec found l then true else false
  | [] => false
  end.

(* The line "name file", or "name none": whether it is there. *)
Definition words (name word : string) : reader bool := fun ls =>
  if is_line [name; word] ls then Ok (true, tl ls) else Ok (false, ls).

Definition unless_file (name : string) (ks : list kind) : reader (list Q) := fun ls =>
  if is_line [name; "file"] ls then Ok ([], ls) else optional name ks ls.

(* All words of a line, read by [read]; their order is kept. *)
Fixpoint all_words {A} (read : string -> option A) (l : line) (done : list A) : option (list A) :=
  match l with
  | [] => Some (rev' done)
  | w :: l =>
    match read w with
    | Some x => all_words read l (x :: done)
    | None => None
    end
  end.

Definition percents : reader (list Q) := fun ls =>
  match ls with
  | (w :: l) :: rest =>
    if negb (String.eqb w "passing-each") then Ok ([], ls) else
    match l, all_words (number (Percent 100)) l [] with
    | _ :: _, Some xs => Ok (xs, rest)
    | _, _ => Malformed "a number of the line passing-each"
    end
  | _ => Ok ([], ls)
  end.

(* The band's lines: numbers, and sieves that ascend. *)
Fixpoint bands (ls : lines) (done : list (Q * Q * Q)) : result (list (Q * Q * Q) * lines) :=
  match ls with
  | (w :: l) :: rest =>
    if negb (String.eqb w "band") then Ok (rev' done, ls) else
    match numbers [NotNegative; NotNegative; NotNegative] l with
    | Some [x; lo; hi] =>
      let ascends := match done with (before, _, _) :: _ => less before x | [] => true end in
      if ascends then bands rest ((x, lo, hi) :: done) else Malformed "sieves of a band that do not ascend"
    | _ => Malformed "a number of the line band"
    end
  | _ => Ok (rev' done, ls)
  end.

(* ---- Witness, chain and tree --------------------------------------------------------------------- *)

Definition witness_of (with_mass : bool) (l : line) : option witness_line :=
  let read (j q t lo hi : string) (t_needed : bool) :=
    match class_index j, number (Integer 1) q, (if t_needed then number Rational t else Some 0%Q),
          number Positive lo, number Positive hi with
    | Some j, Some q, Some t, Some lo, Some hi => check (at_most lo hi) (Witness j (Qnum q) t lo hi)
    | _, _, _, _, _ => None
    end in
  match with_mass, l with
  | true, [j; q; t; lo; hi] => read j q t lo hi true
  | false, [j; q; lo; hi] => read j q "" lo hi false
  | _, _ => None
  end.

Fixpoint witness_lines (with_mass : bool) (ls : lines) (done : list witness_line)
  : result (list witness_line * lines) :=
  match ls with
  | (w :: l) :: rest =>
    if negb (String.eqb w "class") then Ok (rev' done, ls) else
    match witness_of with_mass l with
    | Some w =>
      let ascends := match done with before :: _ => (index before <? index w)%Z | [] => true end in
      if ascends then witness_lines with_mass rest (w :: done) else Malformed "classes that do not ascend"
    | None => Malformed "a number of a line class"
    end
  | _ => Ok (rev' done, ls)
  end.

Fixpoint one_of (ch : ascii) (letters : string) : bool :=
  match letters with
  | EmptyString => false
  | String l letters => Ascii.eqb ch l || one_of ch letters
  end.

(* The letters of conditions of all classes, of single ones, and of several. *)
Record letters := Letters { of_all : string; of_single : string; of_several : string }.
Definition of_leaf : letters := Letters "EmwnN" "fFqQrRpPex" "sSd".
Definition of_windows : letters := Letters "tTEwnN" "pP" "sS".

(* A condition, with a class, several, or none. *)
Definition condition_of (ls : letters) (w : string) : option (ascii * Z * Z) :=
  match w with
  | EmptyString => None
  | String ch EmptyString => check (one_of ch (of_all ls)) (ch, 0, 0)%Z
  | String ch classes =>
    match class_range classes with
    | Some (i, j) => check (one_of ch (if (i =? j)%Z then of_single ls else of_several ls) && (0 <? i)%Z) (ch, i, j)
    | None => None
    end
  end.

(* A different number for each condition: an index has at most 18 digits. *)
Definition key (m : multiple) : positive :=
  let classes := if of_class m =? up_to m then 2 * of_class m else 2 * (of_class m * 2 ^ 60 + up_to m) + 1 in
  Z.to_pos (256 * classes + Z.of_N (N_of_ascii (letter m)) + 1).

(* What a multiplier counts in the limits 2 and 5: the sum d has a term for each of its classes. *)
Definition terms_of (m : multiple) : Z := if Ascii.eqb (letter m) "d" then up_to m - of_class m + 1 else 1.
Definition terms (ms : list multiple) : Z := fold_left (fun n m => n + terms_of m) ms 0.

(* Multipliers and their conditions, none twice, and what they count. *)
Fixpoint multiples (ls : letters) (l : line) (seen : PositiveMap.t unit) (n : Z) (done : list multiple)
  : option (list multiple * Z) :=
  match l with
  | m :: w :: l =>
    match number (Integer 1) m, condition_of ls w with
    | Some m, Some (ch, i, j) =>
      let m := Multiple (Qnum m) ch i j in
      if PositiveMap.mem (key m) seen then None
      else multiples ls l (PositiveMap.add (key m) tt seen) (n + terms_of m) (m :: done)
    | _, _ => None
    end
  | [] => Some (rev' done, n)
  | _ => None
  end.

(* A split, of particles or of the mass. *)
Definition split_of (l : line) : option node :=
  match l with
  | [classes; v] =>
    if String.eqb classes "M" then option_map SplitMass (number Rational v) else
    match class_range classes, number (Integer 1) v with
    | Some (i, j), Some v => Some (Split i j (Qnum v))
    | _, _ => None
    end
  | _ => None
  end.
(* A leaf that says nothing is none; a window may be without a match by itself. *)
Definition leaf_of (l : line) : option (node * Z) :=
  match multiples of_leaf l (PositiveMap.empty unit) 0 [] with
  | Some ((_ :: _) as ms, n) => Some (Leaf ms, n)
  | _ => None
  end.
Definition window_of (l : line) : option (node * Z) :=
  option_map (fun '(ms, n) => (Window ms, n)) (multiples of_windows l (PositiveMap.empty unit) 0 []).

(* Nodes until every split has its two subtrees: [to_come] subtrees are still to come. [n] counts the nodes
   and multipliers. *)
Fixpoint tree (ls : lines) (to_come n : Z) (done : list node) : result (list node * lines) :=
  if (most_nodes <? n)%Z then Malformed "too many nodes and multipliers" else
  if (to_come =? 0)%Z then Ok (rev' done, ls) else
  match ls with
  | (w :: l) :: rest =>
    if String.eqb w "split" then
      match split_of l with
      | Some split => tree rest (to_come + 1) (n + 1) (split :: done)
      | None => Malformed "a line split"
      end
    else if String.eqb w "leaf" then
      match leaf_of l with
      | Some (leaf, m) => tree rest (to_come - 1) (n + 1 + m) (leaf :: done)
      | None => Malformed "a line leaf"
      end
    else if String.eqb w "window" then
      match window_of l with
      | Some (window, m) => tree rest (to_come - 1) (n + 1 + m) (window :: done)
      | None => Malformed "a line window"
      end
    else Malformed "a line split, leaf or window is missing"
  | _ => Malformed "a line split, leaf or window is missing"
  end.

Definition chain_line : reader (list Z) := fun ls =>
  match ls with
  | (w :: l) :: ls =>
    match String.eqb w "chain", all_words class_index l [] with
    | true, Some js => Ok (js, ls)
    | true, None => Malformed "a number of the line chain"
    | false, _ => Malformed "the line chain is missing"
    end
  | _ => Malformed "the line chain is missing"
  end.

(* ---- The whole certificate ----------------------------------------------------------------------- *)

Definition first (xs : list Q) : option Q := match xs with x :: _ => Some x | [] => None end.
Definition integer (xs : list Q) : Z := match xs with x :: _ => Qnum x | [] => 0 end.

Definition sphere (law : Q) : bool := equal law (of_integer 3).

(* At most 1000 digits after the point: the denominator divides 10^1000. The test with 10^100 is for short numbers, as
   dividing long ones needs much stack. *)
Definition has_1000_decimals (x : Q) : bool :=
  (10 ^ 100 mod Zpos (Qden x) =? 0) || (10 ^ 1000 mod Zpos (Qden x) =? 0).

Definition bounds_of_pi (p r : Q) : bool :=
  at_most (of_integer 3) p && less p r && at_most r (of_integer 4) && has_1000_decimals p && has_1000_decimals r.

Definition read_solids (law : Q) (cylinder box volume pi : list Q) : result solids :=
  match cylinder, box, volume, pi with
  | [], [], [], [] => Ok Anything
  | [d; h; e], [], [], [] =>
    demand_form (sphere law) "solids need law 3" ;; Ok (Cylinder d h e)
  | [], [x; y; z; e], [], [p; r] =>
    demand_form (sphere law && bounds_of_pi p r) "solids need law 3 and bounds of pi" ;;
    Ok (Volume (over (times x (times y z)) (add (of_integer 1) e)) p r)
  | [], [], [v], [p; r] =>
    demand_form (sphere law && bounds_of_pi p r) "solids need law 3 and bounds of pi" ;; Ok (Volume v p r)
  | _, _, _, _ => Malformed "one line of solids alone, and pi with a box or a volume"
  end.

Definition read_tolerances : reader (option tolerances) := fun ls =>
  let* (retained, ls) := unless_file "retained" [Percent 100] ls in
  let* (retained_file, ls) := words "retained" "file" ls in
  let* (passing, ls) := unless_file "passing" [Percent 100] ls in
  let* (passing_file, ls) := words "passing" "file" ls in
  let* (each, ls) := percents ls in
  let* (total, ls) := optional "total" [Percent 200] ls in
  let* (band, ls) := bands ls [] in
  demand_form ((size each <=? 3 * most_rows) && (size band <=? most_rows))
    "more numbers than there are sieves" ;;
  match retained, retained_file, passing, passing_file, each, total, band with
  | [], false, [], false, [], [], [] => Ok (None, ls)
  | _, _, _, _, _, _, _ =>
    Ok (Some (Tolerances (first retained) retained_file (first passing) passing_file each (first total) band), ls)
  end.

Definition read_version : reader Z := fun ls =>
  let* (version, ls) := required "mdm-certificate" [Integer 1] ls in
  demand_form (integer version <=? 3) "a version above 3" ;;
  Ok (integer version, ls).

Definition read_question : reader question := fun ls =>
  let* (law, ls) := required "law" [Rational] ls in
  let* (pan_size, ls) := optional "pan-size" [Positive] ls in
  let* (cut_below, ls) := optional "cut-below" [Positive] ls in
  let* (size_factor, ls) := optional "size-factor" [Positive] ls in
  let* (per_class, ls) := optional "min-per-class" [Integer 1] ls in
  let* (cylinder, ls) := optional "cylinder" [Positive; Positive; NotNegative] ls in
  let* (box, ls) := optional "box" [Positive; Positive; Positive; NotNegative] ls in
  let* (volume, ls) := optional "solids-volume" [Positive] ls in
  let* (pi, ls) := optional "pi" [Positive; Positive] ls in
  let* (at_least, ls) := optional "at-least" [Integer 2] ls in
  let* (tolerances, ls) := read_tolerances ls in
  let law := match law with x :: _ => x | [] => 0%Q end in
  demand_form ((Qnum law <=? 1000) && (Zpos (Qden law) <=? 1000)) "a law with numbers above 1000" ;;
  demand_form (match size_factor with x :: _ => negb (equal x (of_integer 1)) | [] => true end)
    "a size-factor of 1" ;;
  demand_form (match tolerances with None => negb (integer per_class =? 1) | Some _ => true end)
    "min-per-class 1 says nothing of an exact match" ;;
  let* solids := read_solids law cylinder box volume pi in
  Ok (Question (Qnum law) (Zpos (Qden law)) (first pan_size) (first cut_below) (first size_factor)
        (integer per_class) solids (integer at_least) tolerances, ls).

(* B..N with 1 <= B < N, or B.. with B >= 2. *)
Definition range_of_particles (w : string) : option claim :=
  match at_mark "." w with
  | (least, Some (String dot most)) =>
    if negb (Ascii.eqb dot ".") then None else
    match most with
    | EmptyString => option_map (fun B => NoneBelow (Qnum B)) (number (Integer 2) least)
    | _ =>
      match number (Integer 1) least, number (Integer 1) most with
      | Some B, Some N => check (less B N) (Between (Qnum B) (Qnum N))
      | _, _ => None
      end
    end
  | _ => None
  end.

Definition read_particles : reader claim := fun ls =>
  let* (none, ls) := words "particles" "none" ls in
  if none then Ok (NoMatch, ls) else
  match ls with
  | [name; w] :: rest =>
    match String.eqb name "particles", range_of_particles w with
    | true, Some c => Ok (c, rest)
    | _, _ => let* (n, ls) := required "particles" [Integer 1] ls in Ok (Smallest (integer n), ls)
    end
  | _ => let* (n, ls) := required "particles" [Integer 1] ls in Ok (Smallest (integer n), ls)
  end.

Definition read_classes (with_mass : bool) : reader (list witness_line) := fun ls =>
  let* (ws, ls) := witness_lines with_mass ls [] in
  demand_form (size ws <=? most_rows) "more classes than a gradation can have" ;; Ok (ws, ls).

(* Whether the bound is what is demanded of every sample. *)
Definition claims_least (asked : question) (c : claim) : bool :=
  match bound_of c with Some B => B =? at_least asked | None => false end.

Definition read_proof (asked : question) (c : claim) (scale : list Q) : reader proof := fun ls =>
  match tolerances_of asked with
  | Some _ => let* (nodes, ls) := tree ls 1 0 [] in Ok (Tolerant nodes, ls)
  | None =>
    let scale := match scale with x :: _ => x | [] => 0%Q end in
    if claims_least asked c then Ok (Exact scale None None, ls) else
    let* (above, ls) := if at_least asked =? 0 then Ok ([], ls) else optional "above" [Rational] ls in
    let* (js, ls) := chain_line ls in
    Ok (Exact scale (first above) (Some js), ls)
  end.

Definition read_certificate (ls : lines) : result certificate :=
  let* (version, ls) := read_version ls in
  let* (asked, ls) := read_question ls in
  let tolerant := match tolerances_of asked with Some _ => true | None => false end in
  let* (claimed, ls) := read_particles ls in
  demand_form (tolerant || match found claimed with Some _ => true | None => false end)
    "an exact match without a witness" ;;
  let* (scale, ls) := if tolerant then Ok ([], ls) else required "scale" [Rational] ls in
  let* (classes, ls) := match found claimed with Some _ => read_classes tolerant ls | None => Ok ([], ls) end in
  let* (proof, ls) := read_proof asked claimed scale ls in
  let ended := is_line ["end"] ls && is_line [""] (tl ls) && match tl (tl ls) with [] => true | _ => false end in
  demand_form ended "the line end is missing, or something follows it" ;;
  let second := is_second claimed proof in
  demand_form ((2 <=? version) || negb second) "what only versions from 2 on have" ;;
  demand_form ((version =? 3) || negb (is_third proof)) "what only version 3 has" ;;
  demand_form (tolerant || (version =? if second then 2 else 1))
    "version 2 without a tolerance or bounds, or version 3 without a tolerance" ;;
  Ok (Certificate asked claimed classes proof).
