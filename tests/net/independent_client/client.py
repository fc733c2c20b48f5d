"""A client of one server. It does not compute the game: it takes the server's hashes as its own."""

import secrets
import time

import enet
import messages
import per_tick
from failure import Failure, check
from link import TIMEOUT_SECONDS, Link

INPUT_SECONDS = 0.08
LARGEST_MESSAGE = 1152


class Client:
    """Plays: each of its players holds a button from its first input on."""

    def __init__(self, socket, version, password=""):
        self._link = Link(socket, version, password)
        self.identity = self._link.identity
        self._enet = enet.Connection(secrets.token_bytes(4))
        self._begun = time.monotonic()
        self._next_inputs = 0
        self._sequence = 0
        self.buttons = None
        self.companion_buttons = {}  # by local number
        self.welcome = self.bye = self.last_ticks = None
        self.local_slots = None
        self.roster = {}
        self.notice = None
        self.round_end = None
        self.level = b""
        self.state = b""
        self.sync = 0
        self.confirmed = 0
        self.hash = 0
        self.players = {}

    def join(self, rules_version, name, token):
        self.until(lambda: self._enet.connected, "verify the ENet connection")
        self._enet.send(messages.hello(rules_version, name, token))
        self.until(lambda: self.welcome, "send Welcome")

    def leave(self):
        self._enet.send(messages.leave())
        self.until(self._enet.idle, "acknowledge Leave")

    def add_companion(self, local, name):
        self._enet.send(messages.companion(local, True, name))
        self._take_answer()

    def remove_companion(self, local):
        self._enet.send(messages.companion(local, False))
        self._take_answer()

    def _take_answer(self):
        self.local_slots = None
        self.until(lambda: self.local_slots, "answer Companion")

    def vote(self):
        self._enet.send(messages.vote(self.last_ticks.round, True))

    def disconnect(self):
        self._enet.disconnect()
        self.until(self._enet.idle, "acknowledge the end of the connection")

    def challenges(self):
        return self._link.challenges

    def until(self, done, action):
        """Sends and receives until `done` holds."""
        end = time.monotonic() + TIMEOUT_SECONDS
        while not done():
            check(time.monotonic() < end, f"the server did not {action} within {TIMEOUT_SECONDS} s")
            check(not self.bye and not self._enet.disconnected, f"the server ended the connection: {self.bye}")
            self._step()

    def _step(self):
        now = time.monotonic() - self._begun
        if self.last_ticks and now >= self._next_inputs:
            self._next_inputs = now + INPUT_SECONDS
            self._send_inputs()
        for datagram in self._enet.datagrams(int(now * 1000)):
            self._link.send(datagram)
        content = self._link.receive(0.005)
        for message in self._enet.receive(content) if content else []:
            check(len(message) <= LARGEST_MESSAGE, f"the server sent a message of {len(message)} bytes")
            self._take(message)

    def _send_inputs(self):
        runs = [] if self.buttons is None else [(self.buttons, 40)]
        first = self.confirmed + 2
        companions = [per_tick.Companion(local, first, [(buttons, 40)]) for local, buttons in sorted(self.companion_buttons.items())]
        self._sequence = (self._sequence + 1) & 0xFF
        self._enet.send_unsequenced(per_tick.Inputs(
            self.last_ticks.round, self._sequence, self.sync, self.confirmed, self.hash, first, runs,
            companions).encode())  # fmt: skip

    def _take(self, message):
        if message[0] == per_tick.MARK:
            self._take_ticks(per_tick.decode_ticks(message))
        else:
            message = messages.decode(message)
            _HANDLERS[type(message)](self, message)

    def _take_ticks(self, ticks):
        if not ticks.first <= self.confirmed < ticks.first + ticks.count:
            return
        for change in ticks.changes:
            if change.tick >= self.confirmed:
                self._apply(change)
        self.confirmed, self.hash, self.last_ticks = ticks.first + ticks.count, ticks.hash, ticks

    def _apply(self, change):
        if change.present:
            self.players[change.slot] = change.buttons
        else:
            self.players.pop(change.slot, None)

    def _take_level(self, chunk):
        check(chunk.hash == self.welcome.level_hash, "the server sent the text of another level")
        check(chunk.offset == len(self.level), "the server sent the level text out of order")
        self.level += chunk.bytes

    def _take_state(self, chunk):
        check(chunk.offset == len(self.state) % chunk.total, "the server sent the state out of order")
        self.state = (self.state if chunk.offset else b"") + chunk.bytes
        if len(self.state) == chunk.total:
            self.sync, self.confirmed, self.players = chunk.sync, chunk.tick, per_tick.players_of_state(self.state)
            self.last_ticks = None  # the hash after this tick is not known

    def _take_refused(self, refused):
        raise Failure(f"the server refuses Hello: {refused.reason}")


def _ignore(client, message):
    pass


_HANDLERS = {
    messages.Welcome: lambda client, message: setattr(client, "welcome", message),
    messages.Refused: Client._take_refused,
    messages.LevelChunk: Client._take_level,
    messages.StateChunk: Client._take_state,
    messages.Roster: lambda client, message: client.roster.update(message.names),
    messages.RoundEnd: lambda client, message: setattr(client, "round_end", message),
    messages.RoundStart: _ignore,
    messages.VoteCount: _ignore,
    messages.PlayerChat: _ignore,
    messages.RoundTrips: _ignore,
    messages.LocalSlots: lambda client, message: setattr(client, "local_slots", message),
    messages.Notice: lambda client, message: setattr(client, "notice", message.text),
    messages.Bye: lambda client, message: setattr(client, "bye", message),
}
