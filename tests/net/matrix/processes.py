"""platon-server and platon-bot as child processes."""

import json
import re
import signal
import subprocess
import threading
import time
from pathlib import Path

TIMEOUT_SECONDS = 60


class Failure(Exception):
    """A program failed, or did not answer in time."""


def exit_code_of(run):
    """Runs `run`, which returns a line for each limit that is exceeded, and prints them, or its Failure. Returns the exit
    code."""
    try:
        exceeded = run()
    except Failure as failure:
        print(f"failed: {failure}")
        return 1
    for line in exceeded:
        print(f"exceeded: {line}")
    return 1 if exceeded else 0


class Program:
    """A running program, killed on exit of the context."""

    def __init__(self, words, **streams):
        self._process = subprocess.Popen(words, text=True, **streams)

    def processor_seconds(self):
        """(seconds on a processor, seconds waiting for one) so far. schedstat counts nanoseconds, /proc/PID/stat only
        hundredths of a second."""
        used, waited = Path(f"/proc/{self._process.pid}/schedstat").read_text().split()[:2]
        return int(used) / 1e9, int(waited) / 1e9

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._process.poll() is None:
            self._process.kill()
            self._process.wait()


class Server(Program):
    """A platon-server on a free port of the loopback interface."""

    def __init__(self, programs, level, players=16, options=(), bind="127.0.0.1"):
        self._lines = []
        self._changed = threading.Condition()
        begun = time.monotonic()
        super().__init__(
            [programs / "platon-server", level, "--bind", bind, "--port", "0", "--max-players", str(players),
             *options],
            stderr=subprocess.PIPE)  # fmt: skip
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()
        self.address = self._wait_for(r"listening on (.*)").group(1)
        self.start_ms = (time.monotonic() - begun) * 1000

    def _read(self):
        for line in self._process.stderr:
            with self._changed:
                self._lines.append(line.rstrip("\n"))
                self._changed.notify_all()

    def find(self, pattern):
        with self._changed:
            return next((found for found in (re.fullmatch(pattern, line) for line in self._lines) if found), None)

    def _wait_for(self, pattern):
        end = time.monotonic() + TIMEOUT_SECONDS
        while not (found := self.find(pattern)):
            if self._process.poll() is not None or time.monotonic() > end:
                raise Failure(f"platon-server did not print '{pattern}', but {self._lines}")
            with self._changed:
                self._changed.wait(0.001)
        return found

    def memory_bytes(self):
        """The largest resident memory so far."""
        status = Path(f"/proc/{self._process.pid}/status").read_text()
        return int(re.search(r"VmHWM:\s*(\d+) kB", status).group(1)) * 1024

    def resident_bytes(self):
        """The resident memory now."""
        status = Path(f"/proc/{self._process.pid}/status").read_text()
        return int(re.search(r"VmRSS:\s*(\d+) kB", status).group(1)) * 1024

    def stop(self):
        """Stops the server. Returns the durations of its ticks: p50Us, p99Us, longestUs, ticks."""
        self._process.send_signal(signal.SIGTERM)
        code = self._process.wait(TIMEOUT_SECONDS)
        self._reader.join(TIMEOUT_SECONDS)
        ran = self.find(r"tick times (.*)")
        if code != 0 or not ran:
            raise Failure(f"platon-server exited with {code}: {self._lines[-3:]}")
        return {key: int(value) for key, value in (word.split("=") for word in ran.group(1).split())}


class Bots(Program):
    """A process of platon-bot."""

    def __init__(self, programs, server, cell, count, hollow, seed):
        options = {"--count": count, "--seconds": cell.seconds, "--settle": cell.settle, "--seed": seed}
        words = [str(word) for pair in options.items() for word in pair]
        words += ["--json", *cell.condition_options, *(["--hollow"] if hollow else [])]
        super().__init__([programs / "platon-bot", server.address, *words], stdout=subprocess.PIPE,
                         stderr=subprocess.PIPE)  # fmt: skip

    def result(self):
        """The JSON object that it printed, and `errors`, its error output."""
        output, errors = self._process.communicate(timeout=TIMEOUT_SECONDS * 2)
        try:
            return json.loads(output) | {"errors": errors.strip()}
        except json.JSONDecodeError as error:
            raise Failure(f"platon-bot printed no result: {output} {errors}") from error
