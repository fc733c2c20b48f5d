#!/usr/bin/env python3
"""Makes the pictures of README.md and docs/, the moving one and the stills, and the page of the levels. The plots come
from ./platon bench.

usage: make_pictures.py PLATON-CLIENT PLATON-LEVEL ROOT

Needs ImageMagick's convert, gifsicle, pngquant, Xvfb, openbox and xdotool. The game that is drawn has no clock, so a machine makes the same
frames each time; other versions of Mesa, of Cairo or of these tools may give other bytes.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import levels_page
import window_pictures

FOLDER = "docs/pictures"
FRAMES_PER_SECOND = 20
MAX_GIF_BYTES = 2_000_000

FILM = {"name": "crossing.gif", "level": "dodecahedron/19_the_wall_is_a_ramp", "from": 0.0, "seconds": 4.4, "width": 640, "zoom": 1.7}
STILLS = [
    {"name": "hexahedron.png", "level": "hexahedron/02_over_the_edge", "from": 8.0, "players": 2},
]
LEVEL_WIDTH = 1200
EDITED = "hexahedron/05_key_on_the_wall"
EDITOR_SECONDS = 120  # at most: the picture is drawn when the search has ended
ELEMENTS = "tests/levels/picture/elements.level"


class PictureError(Exception):
    """A picture could not be made."""


def run(*command):
    try:
        subprocess.run([str(word) for word in command], check=True)
    except OSError as error:
        raise PictureError(f"cannot run {command[0]}: {error.strerror}") from error
    except subprocess.CalledProcessError as error:
        raise PictureError(f"{command[0]} failed with exit code {error.returncode}") from error


def draw_frames(client, root, picture, folder, seconds):
    """The frames of a picture, in order."""
    options = ["--from", picture["from"], "--seconds", seconds, "--fps", FRAMES_PER_SECOND]
    options += ["--width", picture.get("width", 1280), "--zoom", picture.get("zoom", 1), "--players", picture.get("players", 1)]
    level = root / "levels/data" / (picture["level"] + ".level")
    run(client, "--offscreen", "--demo", "--level", level, "--frames", folder, *options)
    return sorted(Path(folder).glob("*.png"))


def make_film(client, root, picture):
    file = root / FOLDER / picture["name"]
    with tempfile.TemporaryDirectory() as folder:
        frames = draw_frames(client, root, picture, folder, picture["seconds"])
        whole = Path(folder) / "whole.gif"
        # The unit of -delay is a hundredth of a second. Dithering would change every pixel from frame to frame.
        run("convert", "-delay", 100 // FRAMES_PER_SECOND, "-loop", 0, *frames, "+dither", "-colors", 255, whole)
        run("gifsicle", "-O3", "--lossy=30", "--colors", 256, whole, "-o", file)
    if file.stat().st_size > MAX_GIF_BYTES:
        raise PictureError(f"{file} has {file.stat().st_size} bytes; {MAX_GIF_BYTES} are allowed")
    return file


def make_still(client, root, picture):
    file = root / FOLDER / picture["name"]
    with tempfile.TemporaryDirectory() as folder:
        frame = draw_frames(client, root, picture, folder, 0.1)[0]
        run("pngquant", "--speed", 1, "--strip", "--force", "--output", file, 256, frame)
    return file


def make_window_picture(client, root, picture):
    file = root / FOLDER / picture["name"]
    with tempfile.TemporaryDirectory() as folder:
        try:
            whole = window_pictures.draw(client, root, picture, folder)
        except (OSError, subprocess.CalledProcessError) as error:
            raise PictureError(f"cannot draw {file}: {error}") from error
        run("pngquant", "--speed", 1, "--strip", "--force", "--output", file, 256, whole)
    return file


def make_editor_picture(client, root):
    """The level editor, with what the search has found."""
    file = root / FOLDER / "editor.png"
    with tempfile.TemporaryDirectory() as folder:
        whole = Path(folder) / "whole.png"
        level = root / "levels/data" / (EDITED + ".level")
        run(client, "--edit", level, "--offscreen", "--seconds", EDITOR_SECONDS, "--screenshot", whole)
        run("pngquant", "--speed", 1, "--strip", "--force", "--output", file, 256, whole)
    return file


def make_level_picture(tool, root, level):
    """The picture of a level: its solid and its net."""
    file = root / FOLDER / f"level_{level.stem}.png"
    with tempfile.TemporaryDirectory() as folder:
        whole = Path(folder) / "whole.png"
        run(tool, "preview", level, "-o", whole, "--width", LEVEL_WIDTH)
        run("pngquant", "--speed", 1, "--strip", "--force", "--output", file, 128, whole)
    return file


def main(arguments):
    if len(arguments) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    client, tool, root = (Path(argument).resolve() for argument in arguments)
    try:
        print(make_film(client, root, FILM))
        for picture in STILLS:
            print(make_still(client, root, picture))
        for picture in window_pictures.PICTURES:
            print(make_window_picture(client, root, picture))
        print(make_editor_picture(client, root))
        for level in [*sorted(root.glob("levels/data/*/*.level"), key=lambda path: path.name), root / ELEMENTS]:
            print(make_level_picture(tool, root, level))
        print(levels_page.write(tool, root))
    except (PictureError, levels_page.PageError) as error:
        print(f"make_pictures.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
