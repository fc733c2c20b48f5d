#!/usr/bin/env bash
# Draws the golden pictures of the client again, after a change of what it draws. Look at them before you commit them.
# Usage: tests/client/gl/golden/draw.sh
set -euo pipefail
cd "$(dirname "$0")/../../../.."
tests=(hud_pictures_test menu_pictures_test mode_pictures_test moment_pictures_test quality_pictures_test solid_pictures_test)
cmake --build --preset release --target "${tests[@]}"
for test in "${tests[@]}"; do PLATON_DRAW_GOLDEN=1 "build/release/tests/bin/$test"; done
git status --short tests/client/gl/golden
