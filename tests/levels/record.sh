#!/usr/bin/env bash
# Records an easy way to the goal of each level file that is named, or of all levels, in tests/levels/ways. Needed after
# a change of a level or of the rules. Usage: tests/levels/record.sh [LEVEL…]
set -euo pipefail
cd "$(dirname "$0")/../.."

[[ $# != 0 ]] || set -- levels/*/*.level
for level; do
  printf '%s: ' "$level"
  build/release/bin/platon-level solve --press-cost 30 "$level" -o "tests/levels/ways/$(basename "$level" .level).recording"
done
