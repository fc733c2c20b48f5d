"""A UDP socket, the requests of the handshake, and the sealed datagrams after it."""

import secrets
import select
import socket
import time

import handshake
import noise
from failure import Failure, check
from seal import CHALLENGE, RESPONSE, Opener, Sealer

TIMEOUT_SECONDS = 60  # long: only a server that hangs reaches it
REPEAT_SECONDS = 0.25
LARGEST_DATAGRAM = 1200


class Socket:
    """A UDP socket that notes all datagrams in `sent` and `received`."""

    def __init__(self, address):
        self._address = address
        self.sent = []
        self.received = []
        self.rebind()

    def rebind(self):
        """Goes on from another port."""
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.connect(self._address)

    def send(self, datagram):
        check(len(datagram) <= LARGEST_DATAGRAM, f"the client sent a datagram of {len(datagram)} bytes")
        self.sent.append(datagram)
        self._socket.send(datagram)

    def receive(self, seconds):
        """A datagram, or None if none arrives in this time."""
        if not select.select([self._socket], [], [], max(0, seconds))[0]:
            return None
        datagram = self._socket.recv(65536)
        self.received.append(datagram)
        check(len(datagram) <= LARGEST_DATAGRAM, f"the server sent a datagram of {len(datagram)} bytes")
        return datagram

    def ask(self, request, answered):
        """Repeats a request until `answered` takes an answer, and returns what it made of it."""
        end = time.monotonic() + TIMEOUT_SECONDS
        while time.monotonic() < end:
            self.send(request)
            if (result := self._answer(request, answered)) is not None:
                return result
        raise Failure(f"the server does not answer a request of kind {request[0]}")

    def _answer(self, request, answered):
        end = time.monotonic() + REPEAT_SECONDS
        while (datagram := self.receive(end - time.monotonic())) is not None:
            if (result := answered(handshake.decode(datagram))) is not None:
                check(len(datagram) <= len(request), f"the answer to kind {request[0]} is longer than the request")
                return result
        return None


def query(socket, version):
    nonce = secrets.randbits(64)
    return socket.ask(
        handshake.query(version, nonce),
        lambda answer: answer if isinstance(answer, handshake.Info) and answer.nonce == nonce else None)  # fmt: skip


class Refused(Failure):
    """The server answered the handshake with a Refusal."""

    def __init__(self, refusal):
        super().__init__(f"the server refuses the client: {refusal}")
        self.reason = refusal.reason


class Link:
    """Sealed datagrams after a handshake with a server that needs this password, or none."""

    def __init__(self, socket, version, password=""):
        self._socket = socket
        self._password = password
        self._version = version
        self._secret = secrets.token_bytes(32)
        self._key = noise.public_key(self._secret)
        self.challenges = 0
        cookie = self._ask(handshake.knock(version, self._key), handshake.Cookie)
        self.identity = cookie.identity
        self._exchange(cookie)

    def send(self, content, control=False):
        self._socket.send(self._sealer.seal(content, control))

    def receive(self, seconds):
        """The content of a sealed datagram, or None. Answers challenges."""
        datagram = self._socket.receive(seconds)
        opened = self._opener.open(datagram) if datagram else None
        if opened is None:
            return None
        control, content = opened
        if control:
            self._answer_challenge(content)
        return None if control else content

    def _answer_challenge(self, content):
        check(content[:1] == bytes([CHALLENGE]) and len(content) == 9, "the server sent a malformed challenge")
        self.challenges += 1
        self.send(bytes([RESPONSE]) + content[1:], control=True)

    def _exchange(self, cookie):
        expected = "a" if self._password else "no"
        check(cookie.needs_password == bool(self._password), f"the server should need {expected} password")
        prologue = handshake.prologue(self._version, cookie.identity)
        static = handshake.server_static(cookie.identity)
        exchange = noise.Initiator(prologue, self._pre_shared_key(cookie.identity), static, self._secret)
        accept = self._ask(handshake.open_(self._version, cookie.cookie, exchange.write()), handshake.Accept)
        slot, to_server, to_client = exchange.read(accept.exchange)
        self._sealer = Sealer(to_server, int.from_bytes(slot, "little"))
        self._opener = Opener(to_client)

    def _pre_shared_key(self, identity):
        return handshake.pre_shared_key(self._password, identity) if self._password else handshake.NO_PASSWORD

    def _ask(self, request, kind):
        def answered(answer):
            if isinstance(answer, (kind, handshake.Refusal)) and answer.echo == self._key[: handshake.ECHO_BYTES]:
                return answer
            return None

        answer = self._socket.ask(request, answered)
        if isinstance(answer, handshake.Refusal):
            raise Refused(answer)
        return answer
