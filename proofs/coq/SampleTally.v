(* What is counted and added up of a sample's rows, and the shares of its classes (certificate-format.md, section 12, where
   nothing is enclosed). A sample may have a million rows: functions on them are tail recursive. *)

From Coq Require Import ZArith QArith List Bool.
From Mdm Require Import Numbers Gradation Rows SampleFile.
Import ListNotations.
Open Scope Z_scope.

(* ---- Rows in classes -------------------------------------------------------------------------------- *)

(* Openings are given by their d-th powers, sizes by their N-th ones; a particle has the mass of its number to the power e. *)
Section Law.
Variables d N e : Z.

Definition above_opening (y : Q) (r : particles) : bool := less (power y N) (power (size_of_each r) d).

Definition is_in (j : class) (r : particles) : bool :=
  if above_opening (lower j) r then negb (above_opening (upper j) r) else false.

Definition number_where (such : particles -> bool) (rows : list particles) : Z :=
  fold_left (fun n r => if such r then n + how_many r else n) rows 0.

Definition count_in (j : class) : list particles -> Z := number_where (is_in j).

Definition mass_of_each (r : particles) : Q := power (size_of_each r) e.
Definition mass_in (j : class) (rows : list particles) : Q :=
  times (c j) (fold_left (fun m r => if is_in j r then add m (times (of_integer (how_many r)) (mass_of_each r)) else m) rows 0%Q).

Definition one_size (j : class) (rows : list particles) : bool :=
  match find (is_in j) rows with
  | Some r => forallb (fun s => if is_in j s then equal (size_of_each r) (size_of_each s) else true) rows
  | None => true
  end.

Definition finest (rs : list row) : Q := opening (hd (Row 0 0 1 0) rs).
Definition is_below (rs : list row) (r : particles) : bool := negb (above_opening (finest rs) r).
Definition is_above (rs : list row) (r : particles) : bool := above_opening (opening (last_row rs)) r.
Definition is_outside (rs : list row) (r : particles) : bool := is_below rs r || is_above rs r.
End Law.

Definition all_particles : list particles -> Z := number_where (fun _ => true).

(* ---- Shares ----------------------------------------------------------------------------------------- *)

Definition sum_of (xs : list Q) : Q := fold_left add xs 0%Q.

(* Of a class, of the sample and of the gradation: its share, and what passes its upper opening. *)
Record shares_line := SharesLine { share_of : Q; passing_of : Q; target_of : Q; target_passing_of : Q }.

(* The classes with their masses; all of the sample and of the gradation, and what passes the lower opening of the first. *)
Fixpoint shares_lines (whole all P G : Q) (jms : list (class * Q)) (done : list shares_line) : list shares_line :=
  match jms with
  | [] => rev' done
  | (j, m) :: jms =>
    let y := over m whole in
    let g := over (mass j) all in
    let P := add P y in
    let G := add G g in
    shares_lines whole all P G jms (SharesLine y P g G :: done)
  end.

Definition shares_of_sample (js : list class) (ms : list Q) : list shares_line :=
  shares_lines (sum_of ms) (sum_of (map_all mass js)) 0 0 (combine js ms) [].

(* ---- Errors ----------------------------------------------------------------------------------------- *)

Definition distance (x y : Q) : Q := if less x y then subtract y x else subtract x y.
Definition retained_error_of (l : shares_line) : Q := distance (share_of l) (target_of l).
Definition passing_error_of (l : shares_line) : Q := distance (passing_of l) (target_passing_of l).
Definition total_error_of (ls : list shares_line) : Q := sum_of (map_all retained_error_of ls).
