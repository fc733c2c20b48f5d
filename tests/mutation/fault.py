"""What a deliberate fault is."""

from dataclasses import dataclass

PHYSICS = "shared/physics/"
PUBLIC_PHYSICS = "shared/include/platon/physics/"


@dataclass(frozen=True)
class Fault:
    """`original` occurs once in `file`. `test` is Suite.Test. The usual ones, of every part a few, are tried for every change."""

    name: str
    file: str
    original: str
    replaced: str
    breaks: str
    test: str
    usual: bool = True


def at_length(*fault):
    return Fault(*fault, usual=False)
