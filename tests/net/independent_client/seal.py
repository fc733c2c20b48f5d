"""Sealed datagrams: docs/protocol.md, "Seal"."""

from nacl import bindings
from nacl.exceptions import CryptoError

SENT_BITS = 14
WINDOW = 512
TAG_BYTES = 16
CHALLENGE, RESPONSE = 1, 2


def _nonce(number):
    return bytes(4) + number.to_bytes(8, "little")


class Sealer:
    """Seals the datagrams of one direction. Only those to the server name a slot."""

    def __init__(self, key, slot=None):
        self._key = key
        self._slot = b"" if slot is None else slot.to_bytes(2, "little")
        self._next = 0

    def seal(self, content, control=False):
        head = 1 << 15 | control << 14 | self._next % (1 << SENT_BITS)
        clear = head.to_bytes(2, "big") + self._slot
        nonce = _nonce(self._next)
        self._next += 1
        return clear + bindings.crypto_aead_chacha20poly1305_ietf_encrypt(content, clear, nonce, self._key)


class Opener:
    """Opens the datagrams of one direction, each once."""

    def __init__(self, key, names_slot=False):
        self._key = key
        self._clear_bytes = 4 if names_slot else 2
        self._next = 0
        self._seen = set()

    def open(self, datagram):
        """(is it a control datagram, content), or None if the datagram must not be accepted."""
        if len(datagram) <= self._clear_bytes + TAG_BYTES or datagram[0] < 0x80:
            return None
        number = self._number(int.from_bytes(datagram[:2], "big"))
        content = self._decrypt(datagram, number) if self._acceptable(number) else None
        if content is None:
            return None
        self._note(number)
        return bool(datagram[0] & 0x40), content

    def _number(self, head):
        period = 1 << SENT_BITS
        below = period // 2 - 1
        nearest = self._next + (head - self._next + below) % period - below
        return nearest if nearest >= 0 else nearest + period

    def _acceptable(self, number):
        return number not in self._seen and self._next - number <= WINDOW

    def _decrypt(self, datagram, number):
        clear, sealed = datagram[: self._clear_bytes], datagram[self._clear_bytes :]
        try:
            return bindings.crypto_aead_chacha20poly1305_ietf_decrypt(sealed, clear, _nonce(number), self._key)
        except CryptoError:
            return None

    def _note(self, number):
        self._next = max(self._next, number + 1)
        self._seen = {seen for seen in self._seen | {number} if self._next - seen <= WINDOW}
