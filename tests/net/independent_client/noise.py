"""Pattern NKpsk0 of the Noise Protocol Framework, revision 34, with 25519, ChaChaPoly and BLAKE2b."""

import hashlib
import hmac

from nacl import bindings

NAME = b"Noise_NKpsk0_25519_ChaChaPoly_BLAKE2b"
HASH_BYTES = 64
KEY_BYTES = 32


def public_key(secret):
    return bindings.crypto_scalarmult_base(secret)


def shared_secret(secret, public):
    return bindings.crypto_scalarmult(secret, public)


def _hkdf(chain, material, outputs):
    temporary = hmac.new(chain, material, hashlib.blake2b).digest()
    result = [b""]
    for index in range(1, outputs + 1):
        result.append(hmac.new(temporary, result[-1] + bytes([index]), hashlib.blake2b).digest())
    return result[1:]


class Exchange:
    """The symmetric state, which both sides compute alike. `ephemeral` and `es`, `ee` are the tokens of the pattern."""

    def __init__(self, prologue, pre_shared_key, server_static):
        self._chain = self._hash = NAME.ljust(HASH_BYTES, b"\0")
        self._key = None
        self._nonce = 0
        self._mix_hash(prologue)
        self._mix_hash(server_static)
        self._mix_key_and_hash(pre_shared_key)

    def seal(self, payload):
        sealed = bindings.crypto_aead_chacha20poly1305_ietf_encrypt(payload, self._hash, self._next_nonce(), self._key)
        self._mix_hash(sealed)
        return sealed

    def open(self, sealed):
        payload = bindings.crypto_aead_chacha20poly1305_ietf_decrypt(sealed, self._hash, self._next_nonce(), self._key)
        self._mix_hash(sealed)
        return payload

    def mix_ephemeral(self, public):
        self._mix_hash(public)
        self.mix_key(public)

    def mix_key(self, material):
        self._chain, key = _hkdf(self._chain, material, 2)
        self._set_key(key)

    def split(self):
        """(key of the initiator, key of the responder)"""
        first, second = _hkdf(self._chain, b"", 2)
        return first[:KEY_BYTES], second[:KEY_BYTES]

    def _mix_key_and_hash(self, material):
        self._chain, mixed, key = _hkdf(self._chain, material, 3)
        self._mix_hash(mixed)
        self._set_key(key)

    def _mix_hash(self, data):
        self._hash = hashlib.blake2b(self._hash + data).digest()

    def _set_key(self, key):
        self._key = key[:KEY_BYTES]
        self._nonce = 0

    def _next_nonce(self):
        nonce = bytes(4) + self._nonce.to_bytes(8, "little")
        self._nonce += 1
        return nonce


class Initiator:
    """The client's side."""

    def __init__(self, prologue, pre_shared_key, server_static, secret):
        self._exchange = Exchange(prologue, pre_shared_key, server_static)
        self._server_static = server_static
        self._secret = secret

    def write(self):
        public = public_key(self._secret)
        self._exchange.mix_ephemeral(public)
        self._exchange.mix_key(shared_secret(self._secret, self._server_static))
        return public + self._exchange.seal(b"")

    def read(self, message):
        """(payload, key to the server, key to the client)"""
        self._exchange.mix_ephemeral(message[:KEY_BYTES])
        self._exchange.mix_key(shared_secret(self._secret, message[:KEY_BYTES]))
        return self._exchange.open(message[KEY_BYTES:]), *self._exchange.split()


class Responder:
    """The server's side, with which the golden datagrams are made."""

    def __init__(self, prologue, pre_shared_key, static_secret, secret):
        self._exchange = Exchange(prologue, pre_shared_key, public_key(static_secret))
        self._static_secret = static_secret
        self._secret = secret
        self._client = None

    def read(self, message):
        self._client = message[:KEY_BYTES]
        self._exchange.mix_ephemeral(self._client)
        self._exchange.mix_key(shared_secret(self._static_secret, self._client))
        return self._exchange.open(message[KEY_BYTES:])

    def write(self, payload):
        """(message, key to the server, key to the client)"""
        public = public_key(self._secret)
        self._exchange.mix_ephemeral(public)
        self._exchange.mix_key(shared_secret(self._secret, self._client))
        return public + self._exchange.seal(payload), *self._exchange.split()
