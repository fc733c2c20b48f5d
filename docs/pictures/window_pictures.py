"""Pictures of the program's window, for docs/playing.md: started without arguments, as a player does, on a virtual
display. The solid beside the menu stands still (reduced motion), so that they change only when the program does.
Those with times show a player who has reached the first levels.
"""

import os
import subprocess
from pathlib import Path

import seeded_times

SECONDS = 8  # until the window closes, which writes the picture
PICTURES = [
    {"name": "title.png", "keys": []},
    {"name": "levels.png", "keys": ["Down", "Return"] + 3 * ["Up"], "times": True},
    {"name": "settings.png", "keys": 7 * ["Down"] + ["Return"]},
]
SETTINGS = "reduced-motion on\nquality high\n"

# Presses the keys of $3 and on when the title is shown, and waits for the program.
PLAY = """
"$1" --seconds "$2" --screenshot "$3" >/dev/null &
client=$!
xdotool search --sync --onlyvisible --name '^Platon$' >/dev/null
sleep 3
for key in "${@:4}"; do
  xdotool key "$key"
  sleep 0.2
done
wait "$client"
"""


def draw(client, root, picture, folder):
    """Draws one picture to a file in an empty folder. Raises CalledProcessError or OSError."""
    file = Path(folder) / "whole.png"
    settings = Path(folder) / "platon" / "settings"
    settings.parent.mkdir()
    settings.write_text(SETTINGS, encoding="utf-8")
    if picture.get("times"):
        (settings.parent / "best_times").write_text(seeded_times.text(root), encoding="utf-8")
    own = {f"XDG_{name}_HOME": folder for name in ("CONFIG", "DATA", "CACHE")}
    display = root / "tests/client/gl/on_display.sh"
    words = [display, "bash", "-c", PLAY, "bash", client, SECONDS, file, *picture["keys"]]
    subprocess.run([str(word) for word in words], check=True, env={**os.environ, **own})
    return file
