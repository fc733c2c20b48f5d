#!/usr/bin/env python3
"""Plays platon-client without a window, in steps, from many commands of a shell.

usage: step.py start FOLDER CLIENT [OPTION…]   starts the game as a new player, with OPTIONs of platon-client
       step.py do FOLDER COMMAND…              gives it commands, one argument each, and prints an answer for each
       step.py stop FOLDER                     ends it

FOLDER holds all that the game keeps: settings, reached levels, best times. An existing one goes on with them. The
commands are those of `platon-client --offscreen --step`, such as 'tap enter', 'press d', 'wait 0.5', 'shot 1.png'. The
time of the game passes only in `tap`, `click`, `wait` and `type`. Pictures go to the present folder; they are 960
pixels wide unless --width says something else. A game that gets no command for two hours ends.
"""

import os
import socket
import subprocess
import sys
import time
from pathlib import Path

IDLE_SECONDS = 2 * 60 * 60
START_SECONDS = 120
ENDED = "error: the game has ended"
KEPT = {"XDG_CONFIG_HOME": "config", "XDG_DATA_HOME": "data", "XDG_CACHE_HOME": "cache", "XDG_STATE_HOME": "state",
        "XDG_PICTURES_DIR": "pictures"}


def fail(text):
    sys.exit(f"step.py: {text}")


class Address:
    """The socket of a game. Its path may be longer than the system takes, so it is named from its folder."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.path = self.folder / "socket"

    def __enter__(self):
        self.before = os.open(".", os.O_RDONLY)
        os.chdir(self.folder)
        return "socket"

    def __exit__(self, *_):
        os.fchdir(self.before)
        os.close(self.before)


def connect(folder):
    connection = socket.socket(socket.AF_UNIX)
    with Address(folder) as name:
        connection.connect(name)
    return connection


def environment(folder):
    variables = dict(os.environ, HOME=str(folder))
    for name, below in KEPT.items():
        variables[name] = str(folder / below)
    return variables


def serve(folder, client, options):
    """Runs the game, and hands it what comes over the socket."""
    folder = Path(folder)
    width = [] if "--width" in options else ["--width", "960"]
    command = [client, "--offscreen", "--step", *width, *options]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment(folder)) as game:
        if game.stdout.readline() != "ready\n":
            return
        listener = socket.socket(socket.AF_UNIX)
        with Address(folder) as name:
            listener.bind(name)
        listener.listen()
        listener.settimeout(IDLE_SECONDS)
        try:
            while game.poll() is None:
                with listener.accept()[0] as connection:
                    answer(connection, game)
        except TimeoutError:
            pass
        finally:
            (folder / "socket").unlink()
            game.stdin.close()


def answer(connection, game):
    with connection.makefile("rw") as lines:
        for line in lines:
            try:
                game.stdin.write(line)
                game.stdin.flush()
                reply = game.stdout.readline()
            except BrokenPipeError:
                reply = ""
            lines.write(reply or ENDED + "\n")
            lines.flush()
            if not reply or line.split() == ["quit"]:
                return game.wait()


def start(folder, client, options):
    folder = Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    try:
        connect(folder).close()
        fail(f"a game is running in {folder}; end it with: step.py stop {folder}")
    except (FileNotFoundError, ConnectionRefusedError):
        (folder / "socket").unlink(missing_ok=True)
    with (folder / "log").open("w") as log:
        server = subprocess.Popen([sys.executable, "-B", __file__, "serve", str(folder), client, *options],
                                  stdin=subprocess.DEVNULL, stdout=log, stderr=log, start_new_session=True)
    for _ in range(START_SECONDS * 20):
        if (folder / "socket").exists():
            return print("ok")
        if server.poll() is not None:
            fail(f"the game does not start: {(folder / 'log').read_text().strip()}")
        time.sleep(0.05)
    server.terminate()
    fail(f"the game does not start within {START_SECONDS} s")


def absolute(command):
    """A picture goes to the folder of the caller, not to that of the game."""
    words = command.split(maxsplit=1)
    return f"shot {Path(words[1]).absolute()}" if len(words) == 2 and words[0] == "shot" else command


def ask(lines, command):
    """Returns the answer; nothing if the game has ended."""
    try:
        lines.write(command + "\n")
        lines.flush()
        return lines.readline()
    except (BrokenPipeError, ConnectionResetError):
        return ""


def do(folder, commands):
    try:
        connection = connect(folder)
    except (FileNotFoundError, ConnectionRefusedError):
        fail(f"no game is running in {folder}; start one with: step.py start {folder} CLIENT")
    failed = False
    with connection, connection.makefile("rw") as lines:
        for command in commands:
            reply = ask(lines, absolute(command.replace("\n", " "))) or ENDED
            failed = failed or not reply.startswith("ok")
            print(f"{command}: {reply.strip()}")
    return not failed


def stop(folder):
    """Returns when the game has ended, and its folder is free for the next one."""
    done = do(folder, ["quit"])
    while (Path(folder) / "socket").exists():
        time.sleep(0.02)
    return done


def main(arguments):
    match arguments:
        case ["start", folder, client, *options]:
            start(folder, str(Path(client).resolve()), options)
        case ["serve", folder, client, *options]:
            serve(folder, client, options)
        case ["do", folder, *commands] if commands:
            sys.exit(0 if do(folder, commands) else 1)
        case ["stop", folder]:
            sys.exit(0 if stop(folder) else 1)
        case _:
            sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
