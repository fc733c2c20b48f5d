#!/usr/bin/env bash
# Records an easy way to the goal of each level file that is named, or of all levels, in levels/data/ways, and writes
# the times of all ways to levels/data/way_times, from which the medals follow. Needed after a change of a level or of the
# rules. Usage: tests/levels/record.sh [--times | LEVEL…]; --times records nothing.
set -euo pipefail
cd "$(dirname "$0")/../.."
tool=build/release/bin/platon-level
way() { echo "levels/data/ways/$(basename "$1" .level).recording"; }

if [[ ${1:-} != --times ]]; then
  [[ $# != 0 ]] || set -- levels/data/*/*.level
  for level; do
    printf '%s: ' "$level"
    "$tool" solve --press-cost 30 "$level" -o "$(way "$level")"
  done
fi

{
  echo '# Ticks of the recorded easy way to the goal of each level, made by tests/levels/record.sh --times.'
  for level in levels/data/*/*.level; do
    ticks=$("$tool" solve --recorded "$(way "$level")" --json "$level" | sed -E 's/.*"ticks":([0-9]+).*/\1/')
    echo "$(basename "$level" .level) $ticks"
  done | sort
} >levels/data/way_times
