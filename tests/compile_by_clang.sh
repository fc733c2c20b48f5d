#!/bin/bash
# Compiles test code with clang, which takes half the time of GCC for it. Called with GCC's command; a launcher before the
# compiler stays there.
exec "${@/#*\/c++/clang++}" -Wno-unknown-warning-option -Wno-ignored-optimization-argument
