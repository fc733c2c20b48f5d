"""A network namespace for attacks over IPv6. In it, every address of fd00::/16 is one of this machine."""

import ctypes
import os
import subprocess
from pathlib import Path

_CLONE_NEWNET = 0x40000000
_COMMANDS = ["ip link set lo up", "ip -6 route add local fd00::/16 dev lo"]
_SENDS_FROM_ANYWHERE = Path("/proc/sys/net/ipv6/ip_nonlocal_bind")


class Unavailable(Exception):
    """Says why there is no namespace."""


def enter():
    """Moves this process and all that it starts later into a new namespace, for good."""
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.unshare(_CLONE_NEWNET) != 0:
        raise Unavailable(f"no network namespace ({os.strerror(ctypes.get_errno())}); run it as root")
    try:
        for command in _COMMANDS:
            subprocess.run(command.split(), check=True, capture_output=True)
        _SENDS_FROM_ANYWHERE.write_text("1", encoding="ascii")
    except (OSError, subprocess.CalledProcessError) as error:
        raise Unavailable(f"no IPv6 in a network namespace ({error})") from error
