"""The description of a deliberate fault."""

from dataclasses import dataclass

PHYSICS = "shared/physics/"
PUBLIC_PHYSICS = "shared/include/platon/physics/"


@dataclass(frozen=True)
class Fault:
    """Replaces the only occurrence of `original` in `file`. `breaks` says what goes wrong; `test`, as Suite.Test, must fail.
    The usual faults, a few of every part, are tried with every change, the others only with --all: so are most of those in
    headers, which many files include."""

    name: str
    file: str
    original: str
    replaced: str
    breaks: str
    test: str
    usual: bool = True


def at_length(*fault):
    return Fault(*fault, usual=False)
