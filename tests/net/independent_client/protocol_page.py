"""Reads the blocks of bytes of docs/protocol.md."""

import re
from pathlib import Path

import handshake
import messages
from failure import check


class Page:
    def __init__(self, path):
        found = re.findall(r"^```bytes (\S+)\n(.*?)^```$", Path(path).read_text(), re.MULTILINE | re.DOTALL)
        self._blocks = {name: _bytes(block) for name, block in found}

    def block(self, name):
        check(name in self._blocks, f"docs/protocol.md has no block of bytes '{name}'")
        return self._blocks[name]

    def names(self):
        return set(self._blocks)

    def protocol_version(self):
        return handshake.version_of(self.block("knock"))

    def rules_version(self):
        return messages.decode_hello(self.block("hello"))[0]


def _bytes(block):
    return bytes.fromhex(" ".join(line.split("#")[0] for line in block.splitlines()))
