"""The client's side of a connection of ENet 1.3, without sockets and clocks."""

import struct
from dataclasses import dataclass

from failure import check

ACKNOWLEDGE, CONNECT, VERIFY_CONNECT, DISCONNECT, PING, RELIABLE, UNSEQUENCED = 1, 2, 3, 4, 5, 6, 9
BODY_BYTES = {ACKNOWLEDGE: 4, VERIFY_CONNECT: 40, DISCONNECT: 4, PING: 0, RELIABLE: 2, UNSEQUENCED: 4}
CHANNEL_OF_DATA = {RELIABLE: 0, UNSEQUENCED: 1}
MAX_COMMANDS = 16
TO_ACKNOWLEDGE, UNSEQUENCED_FLAG = 0x80, 0x40
SENT_TIME, COMPRESSED = 0x8000, 0x4000
NO_PEER, NO_SESSION, WHOLE_CONNECTION = 0xFFF, 0xFF, 0xFF
MTU = 1180
WINDOW = 65536
CHANNELS = 2
RESEND_MS = 300
PING_MS = 500


@dataclass
class Command:
    kind: int
    flags: int
    channel: int
    number: int
    body: bytes
    data: bytes = b""

    def encode(self):
        return struct.pack(">BBH", self.kind | self.flags, self.channel, self.number) + self.body + self.data


def decode(datagram):
    """(sent time or None, commands)"""
    peer, at, sent_time = int.from_bytes(datagram[:2], "big"), 2, None
    check(not peer & COMPRESSED, "the server sent a compressed ENet datagram")
    if peer & SENT_TIME:
        at, sent_time = 4, int.from_bytes(datagram[2:4], "big")
    commands = []
    while at < len(datagram):
        command, at = _decode_command(datagram, at)
        commands.append(command)
    check(len(commands) <= MAX_COMMANDS, f"the server sent {len(commands)} ENet commands in a datagram")
    return sent_time, commands


def _decode_command(datagram, at):
    first, channel, number = struct.unpack_from(">BBH", datagram, at)
    kind = first & 0x0F
    check(kind in BODY_BYTES, f"the server sent the ENet command {kind}")
    check(CHANNEL_OF_DATA.get(kind, channel) == channel, f"the server sent the ENet command {kind} on a wrong channel")
    body = datagram[at + 4 : at + 4 + BODY_BYTES[kind]]
    end = at + 4 + len(body)
    size = int.from_bytes(body[-2:], "big") if kind in CHANNEL_OF_DATA else 0
    check(end + size <= len(datagram), "the server sent a truncated ENet command")
    return Command(kind, first & 0xF0, channel, number, body, datagram[end : end + size]), end + size


class Connection:
    """Queues commands; `datagram` takes what is to be sent at a time in milliseconds."""

    def __init__(self, connect_id):
        self.connected = False
        self.disconnected = False
        self._connect_id = connect_id
        self._peer = NO_PEER
        self._numbers = {WHOLE_CONNECTION: 0, 0: 0, 1: 0}
        self._group = 0
        self._once = []
        self._unacknowledged = {}
        self._expected = 1
        self._early = {}
        self._last_sent_ms = 0
        self._reliable(CONNECT, WHOLE_CONNECTION, self._connect_body())

    def send(self, message):
        self._reliable(RELIABLE, 0, struct.pack(">H", len(message)), message)

    def send_unsequenced(self, message):
        self._group = (self._group + 1) & 0xFFFF
        body = struct.pack(">HH", self._group, len(message))
        self._once.append(Command(UNSEQUENCED, UNSEQUENCED_FLAG, 1, 0, body, message))

    def disconnect(self):
        self._reliable(DISCONNECT, WHOLE_CONNECTION, bytes(4))

    def idle(self):
        """Whether the server has acknowledged everything."""
        return not self._unacknowledged

    def receive(self, datagram):
        """Messages that can be delivered now."""
        sent_time, commands = decode(datagram)
        return [message for command in commands for message in self._handle(command, sent_time)]

    def datagrams(self, now_ms):
        """Datagrams to be sent now: what is new, and what was not acknowledged in time."""
        if self.connected and self.idle() and now_ms - self._last_sent_ms >= PING_MS:
            self._reliable(PING, WHOLE_CONNECTION)
        commands, self._once = self._once + self._due(now_ms), []
        if commands:
            self._last_sent_ms = now_ms
        return [self._datagram(part, now_ms) for part in _parts(commands)]

    def _reliable(self, kind, channel, body=b"", data=b""):
        self._numbers[channel] = (self._numbers[channel] + 1) & 0xFFFF
        command = Command(kind, TO_ACKNOWLEDGE, channel, self._numbers[channel], body, data)
        self._unacknowledged[channel, command.number] = [command, None]

    def _due(self, now_ms):
        due = []
        for entry in self._unacknowledged.values():
            command, sent_ms = entry
            if sent_ms is None or now_ms - sent_ms >= RESEND_MS:
                entry[1] = now_ms
                due.append(command)
        return due

    def _datagram(self, commands, now_ms):
        return struct.pack(">HH", self._peer | SENT_TIME, now_ms & 0xFFFF) + b"".join(c.encode() for c in commands)

    def _connect_body(self):
        """Own peer, sessions, MTU, window, channels, bandwidths, the throttle's three numbers, id, data."""
        sizes = struct.pack(">HBB5I", 0, NO_SESSION, NO_SESSION, MTU, WINDOW, CHANNELS, 0, 0)
        return sizes + struct.pack(">3I", 5000, 2, 2) + self._connect_id + bytes(4)

    def _handle(self, command, sent_time):
        if command.flags & TO_ACKNOWLEDGE:
            check(sent_time is not None, "the server sent a reliable ENet command without its time")
            self._take(command)
            self._acknowledge(command, sent_time)
        if command.kind == ACKNOWLEDGE:
            self._unacknowledged.pop((command.channel, int.from_bytes(command.body[:2], "big")), None)
        if command.kind == UNSEQUENCED:
            return [command.data]
        return self._in_order(command) if command.kind == RELIABLE else []

    def _take(self, command):
        if command.kind == VERIFY_CONNECT and not self.connected:
            self._verify(command.body)
        elif command.kind == DISCONNECT:
            self.disconnected = True

    def _verify(self, body):
        peer, _, session = struct.unpack_from(">HBB", body)
        check(body[-4:] == self._connect_id, "the server verified another ENet connection")
        self._peer = peer | session << 12
        self._unacknowledged.pop((WHOLE_CONNECTION, 1), None)
        self.connected = True

    def _acknowledge(self, command, sent_time):
        body = struct.pack(">HH", command.number, sent_time)
        self._once.append(Command(ACKNOWLEDGE, 0, command.channel, command.number, body))

    def _in_order(self, command):
        if (command.number - self._expected) & 0xFFFF < 0x8000:
            self._early[command.number] = command.data
        ready = []
        while self._expected in self._early:
            ready.append(self._early.pop(self._expected))
            self._expected = (self._expected + 1) & 0xFFFF
        return ready


def _parts(commands):
    """Commands of one datagram each."""
    parts, size = [], MTU
    for command in commands:
        size += len(command.encode())
        if size > MTU or len(parts[-1]) == MAX_COMMANDS:
            parts.append([])
            size = 4 + len(command.encode())
        parts[-1].append(command)
    return parts
