(** The two halves of a sweep that are proved, as a program: tests/proof/proved_sweep.ml calls them. *)
From Coq Require Import ZArith List.
From Coq Require Import ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlZBigInt.
From Platon Require Import collision hit.

Extraction Language OCaml.
Extraction "proved.ml" clipAgainst hitOf.
