#!/usr/bin/env bash
# Records the golden games again after an intended change of the rules. Raise kRulesVersion in
# shared/include/platon/game/game.h with it. Usage: tests/determinism/golden/record.sh [FOLDER OF platon-sim]
set -euo pipefail
cd "$(dirname "$0")/../../.."
sim=${1:-build/release/bin}/platon-sim

for level in tests/determinism/golden/levels/*.level; do
  "$sim" run "$level" --drive churn --players 8 --ticks 1800 --seed 1 \
    --record "tests/determinism/golden/$(basename "$level" .level).recording" | grep -E '^(level|hash)'
done
