(** The function that is proved, as a program: tests/proof/proved_sweep.ml calls it. *)
From Coq Require Import ZArith List.
From Coq Require Import ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlZBigInt.
From Platon Require Import fraction sweep point obstacle collision.

(** A collision: the interval, and the normal of the half plane that is entered; (0, 0) at an overlap at the start. *)
Definition hitOf (vertices : list Point) (s : Segment) (interval : ClipInterval) : Point :=
  match entered interval with
  | None => point 0 0
  | Some k => match nth_error (halfPlanes vertices s) k with None => point 0 0 | Some h => normal h end
  end.

Extraction Language OCaml.
Extraction "proved.ml" clipAgainst hitOf.
