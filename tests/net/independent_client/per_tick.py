"""Messages `inputs` and `ticks`, and the head of a full state: docs/protocol.md, "Per-tick messages"."""

from dataclasses import dataclass, field

from failure import check

MARK = 0
MAX_TICKS = 240
MAX_INPUT_TICKS = 256
LEFT, RIGHT, JUMP, DOWN, RESTART = 1, 2, 8, 16, 32  # input codes
CODE, DIRECTION, NO_PLAYER = 0x3F, 7, 7
PRESENT_IN_STATE = 0x80


def varint(value):
    out = bytearray()
    while value > 0x7F:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    return bytes(out) + bytes([value])


def zigzag(value):
    return 2 * value if value >= 0 else -2 * value - 1


def from_zigzag(value):
    return -(value + 1) // 2 if value & 1 else value // 2


class Reader:
    """Reads numbers, one after another."""

    def __init__(self, message, at=0):
        self._message = message
        self._at = at

    def byte(self):
        check(self.more(), "a per-tick message is truncated")
        self._at += 1
        return self._message[self._at - 1]

    def more(self):
        return self._at < len(self._message)

    def varint(self):
        value, shift, byte = 0, 0, 0x80
        while byte & 0x80:
            byte = self.byte()
            value |= (byte & 0x7F) << shift
            shift += 7
        check(value < 1 << 32 and (byte or shift == 7), "a varint is too large or not in the shortest form")
        return value

    def signed(self):
        return from_zigzag(self.varint())

    def fixed32(self):
        return int.from_bytes(bytes(self.byte() for _ in range(4)), "little")


def _reader_of(message):
    check(message[:1] == bytes([MARK]), "this is no per-tick message")
    return Reader(message, 1)


@dataclass
class Companion:
    local: int
    first: int
    runs: list  # as in Inputs

    def encode(self, first):
        return bytes([NO_PLAYER | self.local << 6]) + varint(self.first - first) + _runs(self.runs)


@dataclass
class Inputs:
    round: int
    sequence: int
    sync: int
    confirmed: int
    hash: int
    first: int
    runs: list = field(default_factory=list)  # (buttons, number of ticks)
    companions: list = field(default_factory=list)

    def encode(self):
        head = bytes([MARK]) + varint(self.round) + bytes([self.sequence, self.sync]) + varint(self.confirmed)
        head += self.hash.to_bytes(4, "little") + varint(self.first - self.confirmed)
        return head + _runs(self.runs) + b"".join(companion.encode(self.first) for companion in self.companions)


def _runs(runs):
    return b"".join(_run(buttons, ticks) for buttons, ticks in runs)


def _run(buttons, ticks):
    return bytes([buttons | ticks << 6]) if ticks < 4 else bytes([buttons]) + varint(ticks - 4)


def decode_inputs(message):
    reader = _reader_of(message)
    found = Inputs(reader.varint(), reader.byte(), reader.byte(), reader.varint(), reader.fixed32(), 0)
    found.first = found.confirmed + reader.varint()
    runs = found.runs
    while reader.more():
        byte = reader.byte()
        if byte & CODE == NO_PLAYER:
            found.companions.append(Companion(byte >> 6, found.first + reader.varint(), []))
            runs = found.companions[-1].runs
        else:
            runs.append((byte & CODE, byte >> 6 or reader.varint() + 4))
    return found


@dataclass
class Change:
    tick: int
    slot: int
    present: bool
    buttons: int


@dataclass
class Link:
    heard: int
    lost: int
    slack: int | None
    slack_tick: int | None


@dataclass
class Ticks:
    round: int
    first: int
    count: int
    hash: int
    sequence: int
    link: Link | None
    changes: list

    def encode(self):
        head = bytes([MARK]) + varint(self.round) + varint(self.first) + varint(self.count)
        head += self.hash.to_bytes(4, "little") + bytes([self.sequence]) + self._encoded_link()
        before = [self.first] + [change.tick for change in self.changes]
        return head + b"".join(_change(change, change.tick - last) for change, last in zip(self.changes, before))

    def _encoded_link(self):
        if self.link is None:
            return varint(0)
        link = self.link
        heard = bytes([link.heard, link.lost])
        if link.slack is None:
            return varint(1) + heard
        return varint(2 + zigzag(link.slack)) + heard + varint(zigzag(link.slack_tick - self.first))


def _change(change, ticks):
    byte = (change.buttons if change.present else NO_PLAYER) | min(ticks, 3) << 6
    return bytes([byte]) + (varint(ticks - 3) if ticks >= 3 else b"") + bytes([change.slot])


def decode_ticks(message):
    reader = _reader_of(message)
    found = Ticks(reader.varint(), reader.varint(), reader.varint(), reader.fixed32(), reader.byte(), None, [])
    check(1 <= found.count <= MAX_TICKS, f"a ticks message holds {found.count} ticks")
    found.link = _read_link(reader, found.first)
    tick = found.first
    while reader.more():
        change = _read_change(reader, tick)
        tick = change.tick
        found.changes.append(change)
    return found


def players_of_state(state):
    """The buttons of each slot that has a player, in the last tick before a full state."""
    reader = Reader(state)
    slots = [reader.byte() for _ in range(reader.varint())]
    return {slot: byte & 0x7F for slot, byte in enumerate(slots) if byte & PRESENT_IN_STATE}


def _read_link(reader, first):
    link = reader.varint()
    if link == 0:
        return None
    heard, lost = reader.byte(), reader.byte()
    if link == 1:
        return Link(heard, lost, None, None)
    return Link(heard, lost, from_zigzag(link - 2), first + reader.signed())


def _read_change(reader, last):
    byte = reader.byte()
    ticks = byte >> 6
    if ticks == 3:
        ticks += reader.varint()
    present = byte & DIRECTION != NO_PLAYER
    return Change(last + ticks, reader.byte(), present, byte & CODE if present else 0)
