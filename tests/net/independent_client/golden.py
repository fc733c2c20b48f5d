"""Makes every block of bytes of docs/protocol.md again, from the values that the page gives, and decodes it."""

from nacl import bindings

import handshake
import messages
import noise
import per_tick
from failure import check
from seal import Opener, Sealer

CLIENT_SECRET, IDENTITY_SECRET, SERVER_SECRET = bytes([1]) * 32, bytes([2]) * 32, bytes([3]) * 32
COOKIE = bytes([4]) * 17
SLOT = 5
PASSWORD = "open sesame"
NONCE = 0x0102030405060708
CONTENT = bytes([1, 2, 3])
TO_CLIENT = {
    "notice": messages.Notice("Restart at noon"),
    "vote-count": messages.VoteCount(3, 2, 5),
    "player-chat": messages.PlayerChat(5, "Wait!", 0),
    "round-trips": messages.RoundTrips(bytes([11, 0, 1, 255])),
    "local-slots": messages.LocalSlots({0: 3, 1: 5}, ""),
    "round-end": messages.RoundEnd(3, 1800, 0x0123456789ABCDEF, "Corners", 300, 743, "Ann", True),
}

COMPANION = (1, True, "Ben")

INPUTS = per_tick.Inputs(3, 18, 1, 300, 0x89ABCDEF, 302, [
    (per_tick.RIGHT, 2), (per_tick.RIGHT | per_tick.JUMP, 1), (0, 9)])  # fmt: skip
INPUTS_OF_TWO = per_tick.Inputs(3, 18, 1, 300, 0x89ABCDEF, 302, [(per_tick.RIGHT, 2)], [
    per_tick.Companion(1, 303, [(per_tick.LEFT, 1)])])  # fmt: skip
TICKS = per_tick.Ticks(3, 300, 8, 0x89ABCDEF, 96, per_tick.Link(17, 5, 4, 313), [
    per_tick.Change(300, 0, True, per_tick.RIGHT), per_tick.Change(300, 5, False, 0),
    per_tick.Change(307, 0, True, per_tick.RIGHT | per_tick.JUMP)])  # fmt: skip


class Golden:
    """A handshake with the keys of the page, played by both sides."""

    def __init__(self, version, rules_version):
        identity, signing_key = bindings.crypto_sign_seed_keypair(IDENTITY_SECRET)
        self.identity = identity
        self.version = version
        self.hello = messages.hello(rules_version, "Ann")
        self.client_key = noise.public_key(CLIENT_SECRET)
        self.echo = self.client_key[: handshake.ECHO_BYTES]
        arguments = handshake.prologue(version, identity), handshake.pre_shared_key(PASSWORD, identity)
        server_secret = bindings.crypto_sign_ed25519_sk_to_curve25519(signing_key)
        server = noise.Responder(*arguments, server_secret, SERVER_SECRET)
        client = noise.Initiator(*arguments, handshake.server_static(identity), CLIENT_SECRET)
        self.first = client.write()
        check(server.read(self.first) == b"", "the first message of the key exchange is not empty")
        self.second, *self.keys = server.write(SLOT.to_bytes(2, "little"))
        check(client.read(self.second) == (SLOT.to_bytes(2, "little"), *self.keys), "both sides disagree on the keys")

    def of_client(self):
        to_server, _ = self.keys
        return {
            "knock": handshake.knock(self.version, self.client_key),
            "open": handshake.open_(self.version, COOKIE, self.first),
            "query": handshake.query(self.version, NONCE),
            "sealed-to-server": Sealer(to_server, SLOT).seal(CONTENT),
            "inputs": INPUTS.encode(),
            "inputs-of-two": INPUTS_OF_TWO.encode(),
            "hello": self.hello,
            "vote": messages.vote(3, True),
            "chat": messages.emote(2),
        }

    def of_server(self):
        return {
            "cookie": handshake.Cookie(self.echo, True, self.identity, COOKIE),
            "accept": handshake.Accept(self.echo, self.second),
            "info": handshake.Info(NONCE, self.identity, True, 3, 16, "Platon", "0.1.0"),
            "refusal": handshake.Refusal(self.echo, 4, "until tomorrow"),
        }


def check_page(page):
    golden = Golden(page.protocol_version(), page.rules_version())
    for name, sent in golden.of_client().items():
        block = page.block(name)
        _check_bytes(name, block, sent[: len(block)])
        check(not any(sent[len(block) :]), f"after the block '{name}', the datagram has other bytes than zeros")
    for name, answer in golden.of_server().items():
        _check_both(name, page, answer.encode(golden.version), handshake.decode, answer)
    _check_sealed(page, *golden.keys)
    _check_messages(page, golden.hello)
    others = page.names() - golden.of_client().keys() - golden.of_server().keys() - TO_CLIENT.keys() - {"sealed-to-client", "ticks", "companion"}
    check(not others, f"nothing checks these blocks: {', '.join(sorted(others))}")


def _check_bytes(name, block, encoded):
    check(encoded == block, f"the block '{name}' has other bytes than {encoded.hex(' ')}")


def _check_both(name, page, encoded, decode, value):
    """Checks that the value gives the block and the block the value."""
    _check_bytes(name, page.block(name), encoded)
    decoded = decode(page.block(name))
    check(decoded == value, f"the block '{name}' was decoded as {decoded}")


def _check_sealed(page, to_server, to_client):
    opener = Opener(to_server, names_slot=True)
    _check_both("sealed-to-client", page, Sealer(to_client).seal(CONTENT), Opener(to_client).open, (False, CONTENT))
    _check_both("sealed-to-server", page, Sealer(to_server, SLOT).seal(CONTENT), opener.open, (False, CONTENT))
    sealed = page.block("sealed-to-server")
    check(opener.open(sealed) is None, "a sealed datagram was accepted twice")
    for bit in range(8 * len(sealed)):
        changed = Opener(to_server, names_slot=True).open(_flipped(sealed, bit))
        check(changed is None, f"a sealed datagram was accepted although bit {bit} was flipped")


def _flipped(data, bit):
    return bytes(byte ^ (1 << bit % 8 if index == bit // 8 else 0) for index, byte in enumerate(data))


def _check_messages(page, hello):
    _check_both("ticks", page, TICKS.encode(), per_tick.decode_ticks, TICKS)
    _check_both("inputs", page, INPUTS.encode(), per_tick.decode_inputs, INPUTS)
    _check_both("inputs-of-two", page, INPUTS_OF_TWO.encode(), per_tick.decode_inputs, INPUTS_OF_TWO)
    for name, message in TO_CLIENT.items():
        decoded = messages.decode(page.block(name))
        check(decoded == message, f"the block '{name}' was decoded as {decoded}")
    _check_both("vote", page, messages.vote(3, True), messages.decode_vote, (3, True))
    for data in (page.block("companion"), messages.companion(*COMPANION)):  # FlatBuffers leave the padding of a table open
        check(messages.decode_companion(data) == COMPANION, f"Companion was decoded as {messages.decode_companion(data)}")
    _check_both("chat", page, messages.emote(2), messages.decode_chat, ("", 2))
    _check_both("hello", page, hello, messages.decode_hello, (page.rules_version(), "Ann", b"", []))
