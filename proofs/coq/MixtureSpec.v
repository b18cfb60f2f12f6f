(* What a verdict on a gradation of several materials is about (Theorem 28), in the words of Spec.v: a sample is particles with
   a material and a size, and what it is described by are the rows of its material. *)

From Coq Require Import ZArith QArith Reals Qreals String List.
From Mdm Require Import Numbers Gradation Certificate Mixture Spec.
Import ListNotations.
Open Scope R_scope.

(* ---- Samples ------------------------------------------------------------------------------------- *)

Definition mixed_sample : Type := list (string * R).

Definition of_material (name : string) (S : mixed_sample) : sample :=
  map snd (filter (fun p => String.eqb name (fst p)) S).

(* The sizes of all. *)
Definition sizes_of_all (S : mixed_sample) : sample := map snd S.

Section Root.
Variable d : positive.
Variable f : R -> R.
Variable ms : list (string * list row).
Variable S : mixed_sample.

Definition each (such : string -> list row -> Prop) : Prop := forall name rs, In (name, rs) ms -> such name rs.
Definition over_materials (w : string -> list row -> R) : R := total (map (fun m => w (fst m) (snd m)) ms).

Definition of_these_materials : Prop := forall p, In p S -> In (fst p) (map fst ms).

(* ---- Conditions 2 to 4, of each material --------------------------------------------------------- *)

Definition mixture_describes : Prop := of_these_materials /\ each (fun name rs => describes d rs (of_material name S)).

(* Sizes of one material are separated by an opening of this material; of sizes of different ones nothing is said. *)
Definition mixture_describes_articulately : Prop :=
  of_these_materials /\ each (fun name rs => describes_articulately d rs (of_material name S)).

(* With the masses of all materials times one s. *)
Definition mixture_describes_accurately : Prop :=
  of_these_materials /\ exists s, 0 < s /\ each (fun name rs => describes_accurately_at d s f rs (of_material name S)).

(* ---- Tolerances ---------------------------------------------------------------------------------- *)

(* Shares are of the mass of all materials together. *)
Definition mass_of_mixture : R := over_materials (fun name rs => mass_of_all d f rs (of_material name S)).
Definition mixture_mass : R := over_materials (fun _ rs => gradation_mass rs).
Definition mixed_share (name : string) (j : class) : R := held d f j (of_material name S) / mass_of_mixture.
Definition mixed_target (j : class) : R := Q2R (mass j) / mixture_mass.

Definition mixed_within (e : Q) : Prop :=
  each (fun name rs => forall j, In j (classes rs) -> near e (mixed_share name j) (mixed_target j)).
Definition mixed_errors : R :=
  over_materials (fun name rs => total (map (fun j => Rabs (mixed_share name j - mixed_target j)) (classes rs))).

(* No tolerance on what passes an opening has a meaning here. *)
Definition mixture_describes_within (tol : tolerances) : Prop :=
  mixture_describes /\ S <> [] /\
  (forall e, retained_each tol = Some e -> mixed_within e) /\
  (forall e, Certificate.total tol = Some e -> mixed_errors <= Q2R e / 100).

(* ---- What a question demands --------------------------------------------------------------------- *)

Definition enough_in_each_class (least : Z) : Prop :=
  each (fun name rs => forall j, In j (classes rs) -> (0 < mass j)%Q -> (least <= number d j (of_material name S))%Z).

Definition mixture_has_enough (q : question) : Prop :=
  enough_in_each_class (min_per_class q) /\ has_solids (solids_of q) (sizes_of_all S) /\
  (at_least q <= Z.of_nat (length S))%Z.

Definition mixture_allowed (q : question) : Prop :=
  match tolerances_of q with
  | None => mixture_describes_accurately
  | Some tol => mixture_describes_within tol
  end /\ mixture_has_enough q.

End Root.
