#!/bin/bash
# Compiles test code with clang, which takes half the time of GCC for it. Called with GCC's command; a launcher before the
# compiler stays there.
set -eu

# A precompiled header that is there already would become a part of the new one.
command="$*"
if [[ $command == *' -x c++-header '* ]]; then
  output=${command##* -o }
  rm -f -- "${output%% -c *}"
fi
exec "${@/#*\/c++/clang++}" -Wno-unknown-warning-option -Wno-ignored-optimization-argument
