(* The definitions at work, evaluated by Coq's kernel: what is accepted, what is not, and what it means. *)

From Coq Require Import ZArith QArith Reals Qreals Rpower List String Ascii.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Checker Spec RealFacts Laws Theorems.
Import ListNotations.
Open Scope string_scope.

(* A text as lines of words. *)
Fixpoint words (s word : string) : list string :=
  match s with
  | EmptyString => [word]
  | String ch s => if Ascii.eqb ch " " then word :: words s "" else words s (word ++ String ch "")
  end.
Definition text_of (ls : list string) : lines := (map (fun l => words l "") ls ++ [[""]])%list.

(* ---- An open bound decides (certificate-format.md, section 9) ------------------------------------- *)

(* Classes (1, 2] and (2, 3] of spheres with the masses 2 and 1. *)
Definition sand : list row := [Row 1 2 1 0; Row 2 1 1 0; Row 3 0 1 0].

Definition four : lines := text_of
  ["mdm-certificate 1"; "law 3"; "particles 4"; "scale 10";
   "class 1 3 1.882072057762 1.882072057763"; "class 2 1 2.154434690031 2.154434690032"; "chain 2"; "end"].

(* Two particles of size 2 in the first class and one of size 2 in the second would do, were (2, 3] closed below: its
   mass f(2) is the bound that is not allowed. *)
Definition three : lines := text_of
  ["mdm-certificate 1"; "law 3"; "particles 3"; "scale 8"; "class 1 2 2 2"; "class 2 1 2 2"; "chain 2"; "end"].

Example four_is_accepted : match check (Gradation sand 1 false) four with Ok _ => True | _ => False end.
Proof. vm_compute. exact I. Qed.

Example three_is_refused :
  match check (Gradation sand 1 false) three with Refused what => what = "q >= R, q^b A < S <= q^b B" | _ => False end.
Proof. vm_compute. reflexivity. Qed.

(* At the scale 8 the first class holds two particles, and the second one, but for the strict bound. *)
Example only_the_bound : let s := 8%Z in
  (2 * 1 ^ 3 < s * 2 <= 2 * 2 ^ 3 /\ 1 * 2 ^ 3 <= s * 1 <= 1 * 3 ^ 3 /\ ~ (1 * 2 ^ 3 < s * 1))%Z.
Proof. cbv zeta. repeat split; vm_compute; congruence. Qed.

(* What the acceptance means: no sample with fewer than four spheres is described accurately, and one with four is. *)
Theorem four_is_least :
  (exists S, describes_accurately 1 sphere sand S /\ List.length S = 4%nat) /\
  forall S, describes_accurately 1 sphere sand S -> (4 <= List.length S)%nat.
Proof.
  destruct (read_certificate four) as [cert| |] eqn:R; [|vm_compute in R; discriminate..].
  vm_compute in R. injection R as R.
  assert (check_certificate (Gradation sand 1 false) cert = Ok tt) as C by (rewrite <- R; vm_compute; reflexivity).
  destruct (certificate_true _ cert sphere C) as (G' & E & Claim); [rewrite <- R; exact sphere_law|].
  rewrite <- R in E. vm_compute in E. injection E as <-.
  assert (claimed cert = Smallest 4%Z) as EN by (rewrite <- R; reflexivity). unfold claim_true in Claim. rewrite EN in Claim.
  destruct Claim as (((S & A & L) & Least) & _). split.
  - exists S. split; [|apply Nat2Z.inj; rewrite L; reflexivity]. destruct A as (A & _). rewrite <- R in A. exact A.
  - intros T D. apply Nat2Z.inj_le. apply Least. split; [rewrite <- R; exact D|]. rewrite <- R. repeat split.
    + intros j _ _. apply Nat2Z.is_nonneg.
    + apply Nat2Z.is_nonneg.
Qed.

(* A chain that is cut off proves a bound: without any step, two particles, one a class. *)
Definition four_at_most (least : string) : lines := text_of
  ["mdm-certificate 2"; "law 3"; "particles " ++ least ++ "..4"; "scale 10";
   "class 1 3 1.882072057762 1.882072057763"; "class 2 1 2.154434690031 2.154434690032"; "chain"; "end"].

Example two_are_needed :
  match check (Gradation sand 1 false) (four_at_most "2") with Ok cert => claimed cert = Between 2 4 | _ => False end.
Proof. vm_compute. reflexivity. Qed.

Example three_are_not_shown :
  match check (Gradation sand 1 false) (four_at_most "3") with
  | Refused what => what = "chain: sum of count(j, L) = N" | _ => False
  end.
Proof. vm_compute. reflexivity. Qed.

(* ---- Half-phi ------------------------------------------------------------------------------------ *)

(* phi 0, -0.5, -1, -1.5, -2: openings 1, sqrt 2, 2, sqrt 8 and 4 by their squares. *)
Definition half_phi : gradation :=
  Gradation [Row 1 1 1 0; Row 2 0 1 0; Row 4 0 1 0; Row 8 1 1 0; Row 16 0 1 0] 2 false.

Example openings_are_square_roots : size_of 2 8 = sqrt 8.
Proof.
  unfold size_of, nth_root. replace (Q2R 8) with 8%R by (unfold Q2R; simpl; field).
  destruct (Rlt_dec 0 8) as [P|N]; [apply Rpower_sqrt, P | exfalso; apply N, IZR_lt; reflexivity].
Qed.

(* A sphere above sqrt 8 weighs more than 8 spheres of size sqrt 2 = sqrt 8 / 2: at least 9 are in the first class. *)
Definition ten : lines := text_of
  ["mdm-certificate 1"; "law 3"; "particles 10"; "scale 600"; "class 1 9 1.39618951393 1.396189513931";
   "class 4 1 2.90419122184 2.904191221841"; "chain 4"; "end"].
Definition nine : lines := text_of
  ["mdm-certificate 1"; "law 3"; "particles 9"; "scale 512"; "class 1 8 1.414213562373 1.414213562374";
   "class 4 1 2.828427124746 2.828427124747"; "chain 4"; "end"].

Example ten_is_accepted : match check half_phi ten with Ok _ => True | _ => False end.
Proof. vm_compute. exact I. Qed.

Example nine_is_refused : match check half_phi nine with Refused _ => True | _ => False end.
Proof. vm_compute. exact I. Qed.

(* No sample of 9 spheres or fewer is described accurately, whatever their real sizes. *)
Theorem ten_is_least : forall S, describes_accurately 2 sphere (rows half_phi) S -> (10 <= List.length S)%nat.
Proof.
  destruct (read_certificate ten) as [cert| |] eqn:R; [|vm_compute in R; discriminate..].
  vm_compute in R. injection R as R.
  assert (check_certificate half_phi cert = Ok tt) as C by (rewrite <- R; vm_compute; reflexivity).
  destruct (certificate_true _ cert sphere C) as (G' & E & Claim); [rewrite <- R; exact sphere_law|].
  rewrite <- R in E. vm_compute in E. injection E as <-.
  assert (claimed cert = Smallest 10%Z) as EN by (rewrite <- R; reflexivity). unfold claim_true in Claim. rewrite EN in Claim.
  destruct Claim as ((_ & Least) & _). intros T D. apply Nat2Z.inj_le. apply Least.
  split; [rewrite <- R; exact D|]. rewrite <- R. repeat split.
  - intros j _ _. apply Nat2Z.is_nonneg.
  - apply Nat2Z.is_nonneg.
Qed.

(* An opening that is no decimal is named by its first 15 digits, rounded; one that is, by itself alone. *)
Example cut_below_the_root_of_2 :
  apply_cut_below 2 (Some (14142135623731 # 10000000000000)) (rows half_phi) = Ok (tl (rows half_phi)) /\
  apply_cut_below 2 (Some (14142135623730 # 10000000000000)) (rows half_phi) =
    Refused "cut-below: S is an opening below x_n" /\
  apply_cut_below 2 (Some 2%Q) (rows half_phi) = Ok (tl (tl (rows half_phi))) /\
  apply_cut_below 2 (Some (20000000000001 # 10000000000000)) (rows half_phi) =
    Refused "cut-below: S is an opening below x_n".
Proof. vm_compute. repeat split. Qed.

(* ---- Within a tolerance -------------------------------------------------------------------------- *)

Definition two_and_eight : list row := [Row 1 2 1 0; Row 2 8 1 0; Row 3 0 1 0].

(* The total of 10 % with f(x) = x: three particles. Only the open bound of the first class, f1 where q_1 >= 1, makes
   the last leaf a contradiction. *)
Definition by_hand_with (law size_1 size_2 last_leaf : string) : lines := text_of
  ["mdm-certificate 1"; "law " ++ law; "total 10"; "particles 3"; "class 1 1 3/2 " ++ size_1; "class 2 2 5 " ++ size_2;
   "split 2 1"; "leaf 4 e1 4 E 4 x2 4 F2 12 Q2 3 m"; "split 1 1"; "leaf 20 e2 20 E 20 x1 20 F1 40 Q1 3 m"; last_leaf; "end"].
Definition by_hand : string -> lines := by_hand_with "1" "1.5 1.5" "2.5 2.5".

Example tree_is_accepted :
  match check (Gradation two_and_eight 1 false) (by_hand "leaf 4 e1 4 E 4 x2 3 f1 1 F2 3 N 6 q1") with
  | Ok _ => True | _ => False
  end.
Proof. vm_compute. exact I. Qed.

(* One multiplier too many, and nothing cancels. *)
Example changed_tree_is_refused :
  match check (Gradation two_and_eight 1 false) (by_hand "leaf 4 e1 4 E 4 x2 3 f1 1 F2 3 N 7 q1") with
  | Refused what => what = "leaf: a contradiction" | _ => False
  end.
Proof. vm_compute. reflexivity. Qed.

(* The same tree for sizes that are the square roots: x^2 is rational there, x is not. *)
Example rational_masses :
  match check (Gradation two_and_eight 2 false)
    (by_hand_with "2" "1.22474487139 1.2247448714" "1.581138830084 1.581138830085"
       "leaf 4 e1 4 E 4 x2 3 f1 1 F2 3 N 6 q1") with
  | Ok _ => True | _ => False
  end /\
  match check (Gradation two_and_eight 2 false) (by_hand "leaf 4 e1 4 E 4 x2 3 f1 1 F2 3 N 6 q1") with
  | Refused what => what = "a rational mass at each opening" | _ => False
  end.
Proof. vm_compute. split; exact I || reflexivity. Qed.

(* (0, 2], (2, 5], (5, 9] with the masses 2, 1, 1, shares within 25 percentage points: 3. Were f3 strict where class 3 may
   be empty, a sample of 3 would be excluded; were it closed everywhere, 2 would do. *)
Definition occupied : lines := text_of
  ["mdm-certificate 1"; "law 1"; "retained 25"; "particles 3"; "class 1 2 4 2 2"; "class 2 1 4 4 4";
   "split 1 1"; "leaf 12 F1 34 Q1 3 R2 5 f2 2 f3 10 n 14 r1"; "split 2 1"; "split 3 1";
   "leaf 3 F2 3 F3 15 Q2 27 Q3 4 R1 1 f1"; "leaf 10 F1 4 F2 20 N 11 R3 7 f3 55 q3 6 r1";
   "leaf 1 F1 1 F3 9 N 2 R2 1 f2 7 q1 11 q2"; "end"].

Example strict_where_occupied :
  match check (Gradation [Row 0 2 1 0; Row 2 1 1 0; Row 5 1 1 0; Row 9 0 1 0] 1 false) occupied with
  | Ok _ => True | _ => False
  end.
Proof. vm_compute. exact I. Qed.

(* (0, 2], (2, 4], (4, 8], from 75 to 85 % of the mass in the first class: 5. One particle or more in the other two
   classes have a mass above the lower bounds; with closed bounds of these classes 4 would do. *)
Definition wide_with (claim last_leaf : string) : lines := text_of
  ["mdm-certificate 2"; "law 1"; "band 2 75 85"; "particles " ++ claim; "class 1 4 8 2 2";
   "class 2 1 8/3 2.666666666666 2.666666666667"; "split 2-3 1"; "leaf 20 P1 3 m 20 F2 20 F3 160 S2-3 80 q2"; last_leaf;
   "end"].
Definition open_sum : string := "leaf 16 p1 4 F1 12 d2-3 8 N 32 s2-3 24 q3".
Definition closed_bounds : string := "leaf 16 p1 4 F1 12 f2 12 f3 8 N 32 s2-3 24 q3".
Definition claim_of_wide (claim last_leaf : string) : result Certificate.claim :=
  let* cert := check (Gradation [Row 0 1 1 0; Row 2 1 1 0; Row 4 1 1 0; Row 8 0 1 0] 1 false) (wide_with claim last_leaf) in
  Ok (claimed cert).

Example strict_sum :
  claim_of_wide "5" open_sum = Ok (Smallest 5) /\
  claim_of_wide "5" closed_bounds = Refused "leaf: a contradiction" /\
  claim_of_wide "4..5" closed_bounds = Ok (Between 4 5).
Proof. vm_compute. repeat split. Qed.

(* The shares of [occupied] again, by windows of the mass: up to 4, to 8, and above. One particle of class 1 has half of the
   mass at M = 4, which is not in the second window; were it there, two particles could not be excluded. *)
Definition windows_from (first : string) : lines := text_of
  ["mdm-certificate 3"; "law 1"; "retained 25"; "particles 3"; "class 1 2 4 2 2"; "class 2 1 4 4 4";
   "split M 8"; "split M " ++ first; "window 1 t"; "window 3 N 8 t"; "window 1 N 2 t"; "end"].
Definition judged_windows (first : string) : result Certificate.claim :=
  let* cert := check (Gradation [Row 0 2 1 0; Row 2 1 1 0; Row 5 1 1 0; Row 9 0 1 0] 1 false) (windows_from first) in
  Ok (claimed cert).

Example an_end_of_a_window :
  judged_windows "4" = Ok (Smallest 3) /\
  judged_windows "39/10" = Refused "window: the greatest sum of all classes is a contradiction".
Proof. vm_compute. split; reflexivity. Qed.
