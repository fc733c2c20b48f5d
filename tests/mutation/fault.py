"""What a deliberate fault is."""

from dataclasses import dataclass

PHYSICS = "shared/physics/"


@dataclass(frozen=True)
class Fault:
    """`original` occurs once in `file`. The usual ones, of every part a few, are tried for every change."""

    name: str
    file: str
    original: str
    replaced: str
    breaks: str
    program: str
    test: str
    usual: bool = True


def at_length(*fault):
    return Fault(*fault, usual=False)
