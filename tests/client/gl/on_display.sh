#!/usr/bin/env bash
# usage: on_display.sh PROGRAM [ARGUMENT…]
# Runs a program on a virtual X display of 1280 × 1024 pixels with a window manager, and exits with its exit code.
set -euo pipefail

timeout=60 # seconds for the display and for the window manager to start
folder=$(mktemp -d)
started=()

stop() {
  for process in "${started[@]}"; do
    kill "$process" 2>/dev/null || true
    wait "$process" 2>/dev/null || true
  done
  rm -rf "$folder"
}
trap stop EXIT

fail() {
  echo "on_display.sh: $1" >&2
  cat "$folder"/*.log >&2
  exit 1
}

mkfifo "$folder/display" "$folder/manager"

# Xvfb chooses a free display and writes its number when it accepts clients.
Xvfb -displayfd 3 -screen 0 1280x1024x24 -nolisten tcp 3>"$folder/display" >"$folder/xvfb.log" 2>&1 &
started=($!)
read -r -t "$timeout" number <"$folder/display" || fail "Xvfb does not start"
export DISPLAY=:$number
unset WAYLAND_DISPLAY

# openbox runs the startup command when it manages the display, in its own folder.
(cd "$folder" && HOME=$folder exec openbox --sm-disable --startup "sh -c 'echo ready >manager'") >"$folder/openbox.log" 2>&1 &
started=($! "${started[@]}")
read -r -t "$timeout" _ <"$folder/manager" || fail "openbox does not start"

"$@"
