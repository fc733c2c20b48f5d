#!/usr/bin/env python3
"""Joins a server with a client that was written from docs/protocol.md alone, which proves that the page is enough.

usage: independent_client.py ROOT. PLATON_BIN names the folder of platon-server. Prints one sentence; exit 1 if the page
and the server disagree.
"""

import os
import secrets
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import golden
import handshake
import messages
import noise
import per_tick
from client import Client
from failure import Failure, check
from link import TIMEOUT_SECONDS, Refused, Socket, query
from protocol_page import Page

sys.path.append(str(Path(__file__).resolve().parent.parent / "matrix"))
import processes  # noqa: E402

LEVEL = "tests/determinism/golden/levels/icosahedron.level"
NAME = "Quixotic Axolotl"
COMPANION = "Obstinate Quokka"
NOTICE = "Restart at noon: Łódź"
PASSWORD = "correct horse battery staple"
READABLE_BYTES = 6


class Server(processes.Server):
    """A server whose console and key are in a folder."""

    def __init__(self, programs, level, folder, *options):
        self._console = [programs / "platon-server", "--console", "--socket", folder / "console"]
        options = ["--socket", folder / "console", "--key-file", folder / "key", *options]
        super().__init__(programs, level, options=options)

    def command(self, line):
        result = subprocess.run(self._console, input=line, text=True, capture_output=True, timeout=TIMEOUT_SECONDS)
        check(result.returncode == 0, f"the console does not take '{line}': {result.stderr}")


class Visit:
    """What a client does on a server. Its token is the same in all of its connections."""

    def __init__(self, page, server, level):
        self._version = page.protocol_version()
        self._rules_version = page.rules_version()
        self._level = level
        self._server = server
        self._token = secrets.token_bytes(16)
        self._password = ""
        host, port = server.address.rsplit(":", 1)
        self._socket = Socket((host, int(port)))

    def run(self):
        self.ask_for_info(players=0)
        self.meet_other_versions()
        client = self.join()
        self.play(client)
        self.play_with_companion(client)
        self.hear_the_operator(client)
        self.vote(client)
        self.ask_for_info(players=2)
        self.move_to_another_port(client)
        client.disconnect()
        self.leave(self.resume(client))
        self.check_traffic()

    def run_with_password(self):
        self._password = PASSWORD[:-1]
        self.ask_for_info(players=0)
        self.be_refused()
        self._password = PASSWORD
        client = self.join()
        self.play(client)
        self.leave(client)

    def ask_for_info(self, players):
        info = query(self._socket, self._version)
        found = info.name, info.needs_password, info.players, info.max_players
        check(found == ("Platon", bool(self._password), players, 16) and info.program, f"the server describes itself as {info}")
        return info

    def meet_other_versions(self):
        """The server answers the Knock and nothing else, until it answers a query of its own version."""
        for version in (self._version - 1, self._version + 1):
            key = noise.public_key(secrets.token_bytes(32))
            self._socket.send(handshake.knock(version, key))
            self._socket.send(handshake.open_(version, bytes(17), key + bytes(16)))
            before = len(self._socket.received)
            query(self._socket, self._version)
            # A query that is answered late is repeated, and each is answered.
            self._check_refusal(key, [one for one in self._socket.received[before:] if not isinstance(handshake.decode(one), handshake.Info)])

    def _check_refusal(self, key, datagrams):
        check(len(datagrams) == 1, f"another version is answered with {len(datagrams)} datagrams")
        refusal = handshake.decode(datagrams[0])
        expected = isinstance(refusal, handshake.Refusal) and refusal.reason == handshake.WRONG_VERSION
        check(expected and refusal.echo == key[: handshake.ECHO_BYTES], f"another version is answered with {refusal}")
        check(handshake.version_of(datagrams[0]) == self._version, "a refusal does not tell the version of the server")

    def be_refused(self):
        try:
            Client(self._socket, self._version, self._password)
        except Refused as refused:
            check(refused.reason == handshake.WRONG_PASSWORD, f"a wrong password is answered with {refused.reason}")
        else:
            check(False, "the server lets a client with a wrong password in")

    def join(self):
        identity = query(self._socket, self._version).identity
        client = Client(self._socket, self._version, self._password)
        check(client.identity == identity, "Info and Cookie have different identities")
        client.join(self._rules_version, NAME, self._token)
        client.until(lambda: len(client.level) == len(self._level), "send the level text")
        check(client.level == self._level, "the server sent another level text than it was started with")
        hashed = messages.hash_of_level(client.level)
        check(client.welcome.level_hash == hashed, f"Welcome names another level than that with the hash {hashed}")
        return client

    def play(self, client):
        slot = client.welcome.slot
        client.until(lambda: client.last_ticks, "send ticks")
        check(slot not in client.players, "the client has a player before its first input")
        for buttons in (per_tick.RIGHT, per_tick.RIGHT | per_tick.JUMP):
            client.buttons = buttons
            client.until(lambda: client.players.get(slot) == client.buttons, "play the client's input")
        client.until(lambda: client.roster.get(slot) == NAME, "name the client's player")
        check(client.sync == 0, "the server sent a full state to a client with the right hash")

    def play_with_companion(self, client):
        own = client.welcome.slot
        client.add_companion(4, COMPANION)
        check(client.local_slots.slots == {0: own} and client.local_slots.reason, f"a fifth player is answered with {client.local_slots}")
        client.add_companion(2, COMPANION)
        slot = client.local_slots.slots.get(2)
        check(slot not in (None, own) and not client.local_slots.reason, f"a companion is answered with {client.local_slots}")
        client.until(lambda: client.roster.get(slot) == COMPANION, "name the companion")
        check(slot not in client.players, "a companion is in the game before its first input")
        client.companion_buttons = {2: per_tick.LEFT}
        client.until(lambda: client.players.get(slot) == per_tick.LEFT, "play the companion's input")
        check(client.players[own] == client.buttons, "the companion's input is that of the first player")

    def hear_the_operator(self, client):
        self._server.command(f"say {NOTICE}")
        client.until(lambda: client.notice == NOTICE, "send the text of its operator")

    def vote(self, client):
        """The only client is a majority. The rotation has one level."""
        client.vote()
        client.until(lambda: client.round_end, "end the round that the only client has voted to end")
        end = client.round_end
        found = end.round, end.next_level_hash, end.pause_ticks, end.best_ticks
        expected = client.last_ticks.round, messages.hash_of_level(self._level), 300, 0
        check(found == expected and end.next_title, f"the server ends the round with {end}")

    def move_to_another_port(self, client):
        """The server challenges the new address until it is answered there, and after that for ten seconds no more."""
        self._socket.rebind()
        self._expect_ticks(client)
        challenges = client.challenges()
        check(challenges > 0, "the server sent no challenge to the new address")
        self._expect_ticks(client)
        check(client.challenges() == challenges, "the server sent another challenge to an address that it knows")

    def _expect_ticks(self, client):
        before = client.confirmed
        client.until(lambda: client.confirmed > before + 20, "send ticks to the client's new address")

    def resume(self, before):
        client = Client(self._socket, self._version)
        client.join(self._rules_version, NAME, self._token)
        slot = client.welcome.slot
        check(slot == before.welcome.slot, "a client that resumes has another slot")
        client.until(lambda: client.local_slots, "send the slots of all players that a client resumes")
        check(client.local_slots.slots == before.local_slots.slots, f"the slots after resuming are {client.local_slots}")
        client.remove_companion(2)
        check(client.local_slots.slots == {0: slot}, f"a companion that leaves is answered with {client.local_slots}")
        client.until(lambda: client.sync and client.last_ticks, "send the full state and ticks after it")
        check(slot in client.players, "a client that resumes has no player")
        client.buttons = per_tick.LEFT
        client.until(lambda: client.players.get(slot) == per_tick.LEFT, "play the resumed client's input")
        return client

    def leave(self, client):
        client.leave()
        end = time.monotonic() + TIMEOUT_SECONDS
        while query(self._socket, self._version).players != 0:
            check(time.monotonic() < end, "the server does not remove a player that leaves")

    def check_traffic(self):
        hello = messages.hello(self._rules_version, NAME, self._token)
        check(self._readable([hello]) == {"name", "token"}, "the search for readable bytes does not find them")
        found = self._readable(self._socket.sent + self._socket.received)
        check(not found, f"the client's {' and '.join(sorted(found))} can be read in the datagrams")
        sealed = [datagram for datagram in self._socket.sent if datagram[0] & 0x80]
        check(len(sealed) > 20, f"the client sent only {len(sealed)} sealed datagrams")
        check(len(set(sealed)) == len(sealed), "the client sent two equal sealed datagrams")

    def _readable(self, datagrams):
        """Of name and token, those of which some bytes in a row occur in a datagram."""
        return {what for what, secret in (("name", NAME.encode()), ("token", self._token))
                if any(part in datagram for part in _parts(secret) for datagram in datagrams)}  # fmt: skip


def _parts(secret):
    return [secret[at : at + READABLE_BYTES] for at in range(len(secret) - READABLE_BYTES + 1)]


def run(root, programs):
    page = Page(root / "docs/protocol.md")
    golden.check_page(page)
    with tempfile.TemporaryDirectory(dir="/tmp") as folder:  # the path of a socket must be short
        with Server(programs, root / LEVEL, Path(folder)) as server:
            Visit(page, server, (root / LEVEL).read_bytes()).run()
            server.stop()
        (Path(folder) / "password").write_text(f"{PASSWORD}\n", encoding="utf-8")
        with Server(programs, root / LEVEL, Path(folder), "--password-file", Path(folder) / "password") as server:
            Visit(page, server, (root / LEVEL).read_bytes()).run_with_password()
            server.stop()


def main(arguments):
    if len(arguments) != 1 or "PLATON_BIN" not in os.environ:
        print(__doc__, file=sys.stderr)
        return 1
    try:
        run(Path(arguments[0]).resolve(), Path(os.environ["PLATON_BIN"]))
    except (Failure, processes.Failure) as failure:
        print(failure)
        return 1
    print("The client of docs/protocol.md has joined, played, resumed and left.")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
