"""FlatBuffers by hand: as much as protocol/to_server.fbs and protocol/to_client.fbs need."""

import struct


class Table:
    """Reads a table. A field is named by its place in the schema, from 0."""

    def __init__(self, data, at=None):
        self._data = data
        self._at = self._follow(0) if at is None else at
        self._vtable = self._at - struct.unpack_from("<i", data, self._at)[0]

    def number(self, field, size):
        at = self._field(field)
        return 0 if at is None else int.from_bytes(self._data[at : at + size], "little")

    def bytes(self, field):
        at = self._reference(field)
        return b"" if at is None else self._data[at + 4 : at + 4 + self._u32(at)]

    def text(self, field):
        return self.bytes(field).decode()

    def u64s(self, field):
        at = self._reference(field)
        return [] if at is None else list(struct.unpack_from(f"<{self._u32(at)}Q", self._data, at + 4))

    def table(self, field):
        at = self._reference(field)
        return None if at is None else Table(self._data, at)

    def tables(self, field):
        at = self._reference(field)
        count = 0 if at is None else self._u32(at)
        return [Table(self._data, self._follow(at + 4 + 4 * index)) for index in range(count)]

    def _u32(self, at):
        return struct.unpack_from("<I", self._data, at)[0]

    def _follow(self, at):
        return at + self._u32(at)

    def _field(self, field):
        if 4 + 2 * field >= struct.unpack_from("<H", self._data, self._vtable)[0]:
            return None
        offset = struct.unpack_from("<H", self._data, self._vtable + 4 + 2 * field)[0]
        return self._at + offset if offset else None

    def _reference(self, field):
        at = self._field(field)
        return None if at is None else self._follow(at)


class Number:
    """A field of `size` bytes. A field of one byte fills the last one of a word of four."""

    def __init__(self, value, size):
        self.encoded = value.to_bytes(size, "little")

    def put(self, out):
        out += bytes(max(0, 4 - len(self.encoded))) + self.encoded
        return len(out) - len(self.encoded)


class Vector:
    """Elements of one, four or eight bytes, or a string."""

    def __init__(self, encoded, count, alignment, end=b""):
        self._encoded = encoded + end
        self._count = count
        self._alignment = alignment

    def write(self, out):
        _pad(out, self._alignment, 4)
        at = len(out)
        out += struct.pack("<I", self._count) + self._encoded
        return at


class NewTable:
    """A table with fields that are a Number, a Vector, a NewTable or, where absent, None. Small fields come first."""

    def __init__(self, *fields):
        self._fields = fields

    def write(self, out):
        present = max((index + 1 for index, field in enumerate(self._fields) if field), default=0)
        inline = bytearray(4)
        offsets = [0] * present
        for index in sorted(range(present), key=lambda index: _size_of(self._fields[index])):
            offsets[index] = self._put(self._fields[index], inline)
        vtable = struct.pack(f"<HH{present}H", 4 + 2 * present, len(inline), *offsets)
        _pad(out, max([4, *(len(f.encoded) for f in self._fields if isinstance(f, Number))]), len(vtable) + 4)
        out += vtable
        at = len(out)
        out += struct.pack("<i", len(vtable)) + inline[4:]
        for field, offset in zip(self._fields, offsets):
            if field and not isinstance(field, Number):
                self._refer(out, at + offset, field)
        return at

    @staticmethod
    def _put(field, inline):
        return 0 if field is None else (field if isinstance(field, Number) else Number(0, 4)).put(inline)

    @staticmethod
    def _refer(out, at, field):
        target = field.write(out)
        out[at : at + 4] = struct.pack("<I", target - at)


def _size_of(field):
    return len(field.encoded) if isinstance(field, Number) else 4


def text(value):
    return Vector(value.encode(), len(value.encode()), 4, b"\0") if value else None


def byte_vector(value):
    return Vector(value, len(value), 4) if value else None


def u64_vector(values):
    return Vector(struct.pack(f"<{len(values)}Q", *values), len(values), 8) if values else None


def finish(table):
    out = bytearray(4)
    out[:4] = struct.pack("<I", table.write(out))
    _pad(out, 4, 0)
    return bytes(out)


def _pad(out, alignment, ahead):
    """Appends zeros until the place `ahead` bytes further is aligned."""
    out += bytes(-(len(out) + ahead) % alignment)
