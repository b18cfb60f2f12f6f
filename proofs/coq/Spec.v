(* What the checker's verdict is about, in the paper's words: gradation, sample, Conditions 1-4 (Eq. 9-12).

   Sizes are real numbers; the gradation's numbers are rational. To be read before anything else: all that is
   proved is proved about these definitions.

   The files of phi with fractions have openings that are irrational, such as 2^0.5 mm. A gradation gives them exactly,
   by their power x_j^d = 2 with one whole d for all of its openings, its root. d is 1 for every other gradation. *)

From Coq Require Import ZArith QArith Reals Qreals Rpower List Lra.
From Mdm Require Import Gradation Certificate.
Import ListNotations.
Open Scope R_scope.

(* ---- Sample and mass law ------------------------------------------------------------------------- *)

(* The sizes of its particles, one entry a particle. *)
Definition sample : Type := list R.

(* Size to mass (Eq. 12). *)
Record mass_law (f : R -> R) : Prop := {
  law_continuous : forall x, 0 <= x -> continuity_pt f x;
  law_increasing : forall x y, 0 <= x < y -> f x < f y;
  law_at_0 : 0 <= f 0 }.

(* Eq. 14, without the factor that all particles share. *)
Definition sphere (x : R) : R := x ^ 3.

(* f(x) = x^(a/b). *)
Definition power_law (a b : nat) (f : R -> R) : Prop :=
  mass_law f /\ forall x, 0 <= x -> 0 <= f x /\ f x ^ b = x ^ a.

(* ---- Openings ------------------------------------------------------------------------------------ *)

(* The d-th root, for y >= 0: nth_root_power in Openings.v. *)
Definition nth_root (d : positive) (y : R) : R := if Rlt_dec 0 y then Rpower y (/ IZR (Zpos d)) else 0.

Section Root.
Variable d : positive.

(* The opening that is given by its power y. *)
Definition size_of (y : Q) : R := nth_root d (Q2R y).

Definition lower_size (j : class) : R := size_of (lower j).
Definition upper_size (j : class) : R := size_of (upper j).

(* ---- Classes ------------------------------------------------------------------------------------- *)

(* Open below, closed above: a particle passes an opening of its own size. *)
Definition in_class (j : class) (x : R) : Prop := lower_size j < x <= upper_size j.

Definition in_class_dec (j : class) (x : R) : {in_class j x} + {~ in_class j x}.
Proof.
  unfold in_class. destruct (Rlt_dec (lower_size j) x), (Rle_dec x (upper_size j)); [left | right..]; tauto.
Defined.

Definition total (xs : list R) : R := fold_right Rplus 0 xs.

(* The particles of class j, their number, and their mass; c is the class's factor. *)
Definition inside (j : class) (S : sample) : sample :=
  filter (fun x => if in_class_dec j x then true else false) S.
Definition number (j : class) (S : sample) : Z := Z.of_nat (length (inside j S)).
Definition held (f : R -> R) (j : class) (S : sample) : R := Q2R (c j) * total (map f (inside j S)).

(* ---- Conditions 1 to 4 --------------------------------------------------------------------------- *)

Definition least_opening (rs : list row) : R := size_of (opening (hd (Row 0 0 1 0) rs)).
Definition largest_opening (rs : list row) : R := size_of (opening (last_row rs)).

(* Cond1 (Eq. 9): nothing is retained on the largest opening. *)
Definition complete (rs : list row) : Prop := (retained (last_row rs) == 0)%Q.

(* Cond2 (Eq. 10). *)
Definition describes (rs : list row) (S : sample) : Prop :=
  complete rs /\ forall x, In x S -> least_opening rs < x <= largest_opening rs.

(* Cond3 (Eq. 11): an opening separates any two sizes; that is, one size a class. (x_i < x_j <= x_(i+1), as printed,
   has < and <= the other way round than Eq. 12.) *)
Definition describes_articulately (rs : list row) (S : sample) : Prop :=
  describes rs S /\
  forall x y, In x S -> In y S -> x < y -> exists r, In r rs /\ x <= size_of (opening r) < y.

(* Cond4 (Eq. 12), for the gradation with all masses times s. *)
Definition describes_accurately_at (s : R) (f : R -> R) (rs : list row) (S : sample) : Prop :=
  describes rs S /\ forall j, In j (classes rs) -> held f j S = s * Q2R (mass j).

(* Cond4 up to the unit of mass: the sample is a match of the gradation. *)
Definition describes_accurately (f : R -> R) (rs : list row) (S : sample) : Prop :=
  exists s, 0 < s /\ describes_accurately_at s f rs S.

(* ---- What a question demands besides ------------------------------------------------------------- *)

(* The particles' own volume. *)
Definition solid_volume (S : sample) : R := PI / 6 * total (map sphere S).

Definition has_solids (s : solids) (S : sample) : Prop :=
  match s with
  | Anything => True
  | Cylinder d h e => PI / 4 * Q2R d ^ 2 * Q2R h <= solid_volume S * (1 + Q2R e)
  | Volume v _ _ => Q2R v <= solid_volume S
  end.

Definition has_enough (q : question) (rs : list row) (S : sample) : Prop :=
  (forall j, In j (classes rs) -> (0 < mass j)%Q -> (min_per_class q <= number j S)%Z) /\
  has_solids (solids_of q) S /\
  (at_least q <= Z.of_nat (length S))%Z.

(* ---- Tolerances ---------------------------------------------------------------------------------- *)

(* The sample's mass, and what of it passes an opening y. *)
Definition mass_of_all (f : R -> R) (rs : list row) (S : sample) : R :=
  total (map (fun j => held f j S) (classes rs)).
Definition mass_passing (f : R -> R) (rs : list row) (y : R) (S : sample) : R :=
  total (map (fun j => if Rle_dec (upper_size j) y then held f j S else 0) (classes rs)).

(* The shares of the sample and of the gradation. *)
Definition share_retained (f : R -> R) (rs : list row) (j : class) (S : sample) : R :=
  held f j S / mass_of_all f rs S.
Definition share_passing (f : R -> R) (rs : list row) (y : R) (S : sample) : R :=
  mass_passing f rs y S / mass_of_all f rs S.
Definition gradation_mass (rs : list row) : R := total (map (fun j => Q2R (mass j)) (classes rs)).
Definition target_retained (rs : list row) (j : class) : R := Q2R (mass j) / gradation_mass rs.
Definition target_passing (rs : list row) (y : R) : R :=
  total (map (fun j => if Rle_dec (upper_size j) y then Q2R (mass j) else 0) (classes rs)) / gradation_mass rs.

Definition near (e : Q) (x y : R) : Prop := Rabs (x - y) <= Q2R e / 100.

Section Tolerance.
Variables (f : R -> R) (K : option Q) (tol : tolerances) (rs : list row) (S : sample).

Definition meets_retained (j : class) (e : Q) : Prop :=
  near e (share_retained f rs j S) (target_retained rs j).
Definition meets_passing (j : class) (e : Q) : Prop :=
  near e (share_passing f rs (upper_size j) S) (target_passing rs (upper_size j)).

(* An opening X of the band, in the unit that the question gives the gradation. *)
Definition scaled (x : Q) : R := match K with Some k => Q2R k * Q2R x | None => Q2R x end.

(* The lines of certificate-format.md, section 6. The tolerance of a file's row is that of the class above it for
   what is retained, and that of the class below it for what passes. *)
Definition meets_tolerances : Prop :=
  (forall e, retained_each tol = Some e -> forall j, In j (classes rs) -> meets_retained j e) /\
  (retained_file tol = true ->
     forall j r, In (j, r) (combine (classes rs) rs) -> meets_retained j (tolerance r)) /\
  (forall e, passing_all tol = Some e -> forall j, In j (classes rs) -> meets_passing j e) /\
  (passing_file tol = true ->
     forall j r, In (j, r) (combine (classes rs) (tl rs)) -> meets_passing j (tolerance r)) /\
  (forall j e, In (j, e) (combine (classes rs) (passing_each tol)) -> meets_passing j e) /\
  (forall e, Certificate.total tol = Some e ->
     total (map (fun j => Rabs (share_retained f rs j S - target_retained rs j)) (classes rs)) <= Q2R e / 100) /\
  (forall x l h, In (x, l, h) (band tol) ->
     Q2R l / 100 <= share_passing f rs (scaled x) S <= Q2R h / 100).

(* A sample of at least one particle, all of them in classes, that meets them. *)
Definition describes_within : Prop := describes rs S /\ S <> [] /\ meets_tolerances.

End Tolerance.
End Root.

(* ---- The least number ---------------------------------------------------------------------------- *)

Definition root_of (G : gradation) : positive := Z.to_pos (root G).

(* Samples that the question allows. *)
Definition allowed (f : R -> R) (q : question) (G : gradation) (S : sample) : Prop :=
  match tolerances_of q with
  | None => describes_accurately (root_of G) f (rows G) S
  | Some tol => describes_within (root_of G) f (size_factor q) tol (rows G) S
  end /\ has_enough (root_of G) q (rows G) S.

Definition least_number (f : R -> R) (q : question) (G : gradation) (n : Z) : Prop :=
  (exists S, allowed f q G S /\ Z.of_nat (length S) = n) /\
  forall S, allowed f q G S -> (n <= Z.of_nat (length S))%Z.

(* ---- A worked sample ----------------------------------------------------------------------------- *)

(* Three sieves of 1, 2 and 3; 8 is retained on the first and 27 on the second: the classes (1, 2] and (2, 3]. *)
Module Sample.

Definition sieves : list row := [Row 1 8 1 0; Row 2 27 1 0; Row 3 0 1 0].

(* An opening of a gradation with the root 1 is its number. *)
Lemma size_1 y : 0 <= Q2R y -> size_of 1 y = Q2R y.
Proof.
  intros P. unfold size_of, nth_root. destruct (Rlt_dec 0 (Q2R y)) as [L|L]; [|lra].
  rewrite Rinv_1. apply Rpower_1. exact L.
Qed.

(* Puts numbers in the place of openings, and decides which particles are in which class. *)
Ltac numbers := unfold least_opening, largest_opening, lower_size, upper_size in *; simpl in *;
  repeat rewrite size_1 in * by (unfold Q2R; simpl; lra); unfold Q2R in *; simpl in *.
Ltac decide_classes := unfold held, inside; simpl;
  repeat (destruct (in_class_dec 1 _ _) as [I|I]; unfold in_class in I; numbers; try (exfalso; lra); clear I);
  unfold sphere; simpl; lra.

(* Spheres of sizes 2 and 3: each is as large as its upper sieve, which it passes. One has the mass 2^3 = 8, the other
   3^3 = 27, and there is one size a class: Conditions 1 to 4 hold, the last at the scale 1. *)
Example matches : describes_articulately 1 sieves [2; 3] /\ describes_accurately 1 sphere sieves [2; 3].
Proof.
  assert (describes 1 sieves [2; 3]) as D.
  { split; [reflexivity|]. intros x [<-|[<-|[]]]; numbers; lra. }
  split; [split; [exact D|] | exists 1; split; [lra|]; split; [exact D|]].
  - intros x y X Y L. exists (Row 2 27 1 0). split; [simpl; auto|].
    destruct X as [<-|[<-|[]]], Y as [<-|[<-|[]]]; numbers; lra.
  - intros j [<-|[<-|[]]]; decide_classes.
Qed.

(* A sphere of size 1 does not lie on the sieve of that size: Condition 2 fails. *)
Example outside : ~ describes 1 sieves [1; 3].
Proof. intros (_ & I). specialize (I 1 (or_introl eq_refl)). numbers. lra. Qed.

(* With two spheres of size 2 the first class has 16 beside 27. The second one asks for the scale 1, at which the first
   has 8: Condition 4 fails at every scale. *)
Example no_match : ~ describes_accurately 1 sphere sieves [2; 2; 3].
Proof.
  intros (s & _ & _ & M).
  assert (held 1 sphere (Class 1 2 8 1) [2; 2; 3] = 16) as One by decide_classes.
  assert (held 1 sphere (Class 2 3 27 1) [2; 2; 3] = 27) as Two by decide_classes.
  pose proof (M _ (or_introl eq_refl)) as First. pose proof (M _ (or_intror (or_introl eq_refl))) as Second.
  simpl in First, Second. rewrite One in First. rewrite Two in Second. unfold Q2R in *. simpl in *. lra.
Qed.

End Sample.
