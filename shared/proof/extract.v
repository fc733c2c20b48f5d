(** What is proved, as a program: tests/proof/proved_sweep.ml calls it. *)
From Coq Require Import ZArith List.
From Coq Require Import ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlZBigInt.
From Platon Require Import polygon collision hit boxes near.

Extraction Language OCaml.
Extraction "proved.ml" clipAgainst hitOf overlapsBox boundsOfSweep boundsOf isValid placeOf.
