"""Messages but those of each tick: docs/protocol.md, "FlatBuffers", and the two schemas."""

from dataclasses import dataclass

import flat
from failure import Failure

HELLO, LEVEL_REQUEST, LEAVE, VOTE, CHAT, COMPANION = range(1, 7)


def hash_of_level(level):
    """The hash that names a level text."""
    state = 0xCBF29CE484222325
    for value in (len(level), *level):
        state = (state ^ value) * 0x9E3779B97F4A7C15 & 0xFFFFFFFFFFFFFFFF
        state ^= state >> 32
    return state


def _to_server(kind, body):
    return flat.finish(flat.NewTable(flat.Number(kind, 1), body))


def hello(rules_version, name, token=b"", levels=()):
    rules = flat.Number(rules_version, 4)
    return _to_server(HELLO, flat.NewTable(rules, flat.text(name), flat.byte_vector(token), flat.u64_vector(levels)))


def level_request(level_hash):
    return _to_server(LEVEL_REQUEST, flat.NewTable(flat.Number(level_hash, 8)))


def leave():
    return _to_server(LEAVE, flat.NewTable())


def vote(round_, next_):
    return _to_server(VOTE, flat.NewTable(flat.Number(round_, 4), flat.Number(int(next_), 1)))


def emote(number):
    return _to_server(CHAT, flat.NewTable(None, flat.Number(number, 4)))


def companion(local, joins, name=""):
    return _to_server(COMPANION, flat.NewTable(flat.Number(local, 4), flat.Number(int(joins), 1), flat.text(name)))


def decode_companion(data):
    """(local, joins, name)"""
    body = flat.Table(data).table(1)
    return body.number(0, 4), bool(body.number(1, 1)), body.text(2)


def decode_chat(data):
    """(text, emote)"""
    body = flat.Table(data).table(1)
    return body.text(0), body.number(1, 4)


def decode_vote(data):
    """(round, next)"""
    body = flat.Table(data).table(1)
    return body.number(0, 4), bool(body.number(1, 1))


def decode_hello(data):
    """(rules version, name, token, levels)"""
    body = flat.Table(data).table(1)
    return body.number(0, 4), body.text(1), body.bytes(2), body.u64s(3)


@dataclass
class Welcome:
    slot: int
    round: int
    level_hash: int
    max_players: int
    ticks_per_second: int
    server_name: str


@dataclass
class Refused:
    code: int
    reason: str
    next: str


@dataclass
class LevelChunk:
    hash: int
    total: int
    offset: int
    bytes: bytes


@dataclass
class StateChunk:
    round: int
    tick: int
    sync: int
    total: int
    offset: int
    bytes: bytes


@dataclass
class Roster:
    names: dict


@dataclass
class RoundStart:
    round: int
    level_hash: int


@dataclass
class RoundEnd:
    round: int
    tick: int
    next_level_hash: int
    next_title: str
    pause_ticks: int
    best_ticks: int
    best_name: str
    best_is_new: bool


@dataclass
class Bye:
    code: int
    reason: str
    next: str


@dataclass
class Notice:
    text: str


@dataclass
class VoteCount:
    round: int
    votes: int
    voters: int


@dataclass
class PlayerChat:
    slot: int
    text: str
    emote: int


@dataclass
class RoundTrips:
    codes: bytes


@dataclass
class LocalSlots:
    slots: dict  # by local number
    reason: str


def _local_slots(body):
    taken, slots = body.number(0, 1), body.bytes(1)
    return LocalSlots({local: slot for local, slot in enumerate(slots) if taken >> local & 1}, body.text(2))


def _round_end(body):
    pause_and_best = body.number(4, 4), body.number(5, 4), body.text(6), bool(body.number(7, 1))
    return RoundEnd(*_numbers(body, 4, 4, 8), body.text(3), *pause_and_best)


def _roster(body):
    return Roster({entry.number(0, 4): entry.text(1) for entry in body.tables(0)})


def _numbers(body, *sizes):
    return [body.number(field, size) for field, size in enumerate(sizes)]


# In the order of the union ToClientBody.
_READERS = (
    lambda body: Welcome(*_numbers(body, 4, 4, 8, 4, 4), body.text(5)),
    lambda body: Refused(*_numbers(body, 4), body.text(1), body.text(2)),
    lambda body: LevelChunk(*_numbers(body, 8, 4, 4), body.bytes(3)),
    lambda body: StateChunk(*_numbers(body, 4, 4, 1, 4, 4), body.bytes(5)),
    _roster,
    lambda body: RoundStart(*_numbers(body, 4, 8)),
    _round_end,
    lambda body: Bye(*_numbers(body, 4), body.text(1), body.text(2)),
    lambda body: Notice(body.text(0)),
    lambda body: VoteCount(*_numbers(body, 4, 4, 4)),
    lambda body: PlayerChat(body.number(0, 4), body.text(1), body.number(2, 4)),
    lambda body: RoundTrips(body.bytes(0)),
    _local_slots,
)


def decode(data):
    root = flat.Table(data)
    kind = root.number(0, 1)
    if not 1 <= kind <= len(_READERS):
        raise Failure(f"the server sent a message of the unknown type {kind}")
    return _READERS[kind - 1](root.table(1))
