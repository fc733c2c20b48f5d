"""Datagrams before the seal: docs/protocol.md, "Handshake"."""

import hashlib
import struct
from dataclasses import dataclass

from nacl import bindings

from failure import check

KNOCK, COOKIE, OPEN, ACCEPT, REFUSAL, QUERY, INFO = range(1, 8)
WRONG_VERSION, WRONG_PASSWORD = 1, 5
KNOCK_BYTES = OPEN_BYTES = 256
QUERY_BYTES = 512
ECHO_BYTES = 16
HEAD_BYTES = 7
NO_PASSWORD = bytes(32)


def head(kind, version):
    return bytes([kind]) + b"PLTN" + version.to_bytes(2, "little")


def prologue(version, identity):
    return b"PLTN" + version.to_bytes(2, "little") + identity


def pre_shared_key(password, identity):
    """The key that a password gives with the server of this identity. It takes 64 MiB and a tenth of a second."""
    salt = hashlib.blake2b(identity, digest_size=16).digest()
    return bindings.crypto_pwhash_alg(32, password.encode(), salt, 2, 64 << 20, bindings.crypto_pwhash_ALG_ARGON2ID13)


def server_static(identity):
    return bindings.crypto_sign_ed25519_pk_to_curve25519(identity)


def knock(version, client_key):
    return (head(KNOCK, version) + client_key).ljust(KNOCK_BYTES, b"\0")


def open_(version, cookie, exchange):
    return (head(OPEN, version) + cookie + exchange).ljust(OPEN_BYTES, b"\0")


def query(version, nonce):
    return (head(QUERY, version) + nonce.to_bytes(8, "little")).ljust(QUERY_BYTES, b"\0")


@dataclass
class Cookie:
    echo: bytes
    needs_password: bool
    identity: bytes
    cookie: bytes

    def encode(self, version):
        return head(COOKIE, version) + self.echo + bytes([self.needs_password]) + self.identity + self.cookie


@dataclass
class Accept:
    echo: bytes
    exchange: bytes

    def encode(self, version):
        return head(ACCEPT, version) + self.echo + self.exchange


@dataclass
class Refusal:
    echo: bytes
    reason: int
    text: str

    def encode(self, version):
        return head(REFUSAL, version) + self.echo + bytes([self.reason]) + _counted(self.text)


@dataclass
class Info:
    nonce: int
    identity: bytes
    needs_password: bool
    players: int
    max_players: int
    name: str
    program: str

    def encode(self, version):
        numbers = struct.pack("<?HH", self.needs_password, self.players, self.max_players)
        texts = _counted(self.name) + _counted(self.program)
        return head(INFO, version) + self.nonce.to_bytes(8, "little") + self.identity + numbers + texts


def _counted(text):
    return bytes([len(text.encode())]) + text.encode()


class _Fields:
    """Takes the fields after the version from a datagram, one after another."""

    def __init__(self, datagram):
        self._left = datagram[HEAD_BYTES:]

    def bytes(self, size):
        check(len(self._left) >= size, "a datagram of the server's handshake is too short")
        taken, self._left = self._left[:size], self._left[size:]
        return taken

    def number(self, size):
        return int.from_bytes(self.bytes(size), "little")

    def text(self):
        return self.bytes(self.number(1)).decode()

    def end(self):
        check(not self._left, "a datagram of the server's handshake is too long")


def version_of(datagram):
    return int.from_bytes(datagram[5:HEAD_BYTES], "little")


def decode(datagram):
    """The Cookie, Accept, Refusal or Info that a server sent, or None if it is none of them."""
    if len(datagram) < HEAD_BYTES or datagram[1:5] != b"PLTN" or datagram[0] not in _DECODERS:
        return None
    fields = _Fields(datagram)
    result = _DECODERS[datagram[0]](fields)
    fields.end()
    return result


_DECODERS = {
    COOKIE: lambda fields: Cookie(fields.bytes(ECHO_BYTES), bool(fields.number(1)), fields.bytes(32), fields.bytes(17)),
    ACCEPT: lambda fields: Accept(fields.bytes(ECHO_BYTES), fields.bytes(50)),
    REFUSAL: lambda fields: Refusal(fields.bytes(ECHO_BYTES), fields.number(1), fields.text()),
    INFO: lambda fields: Info(fields.number(8), fields.bytes(32), bool(fields.number(1)), fields.number(2),
                              fields.number(2), fields.text(), fields.text()),
}  # fmt: skip
