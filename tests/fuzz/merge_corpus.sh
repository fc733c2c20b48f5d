#!/usr/bin/env bash
# Removes inputs from the corpora until each program reaches the same with those that are left, but not with fewer. Inputs
# with a name of their own stay; the others are named after their content, as libFuzzer names what it finds.
#
# usage: merge_corpus.sh CORPORA TARGET=PROGRAM…; CORPORA has a folder for each TARGET, whose inputs PROGRAM takes.
set -euo pipefail

corpora=$1
shift
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# is_found INPUT: whether it has the name that libFuzzer gives it.
is_found() {
  local sum
  sum=$(sha1sum "$1")
  [[ ${1##*/} == "${sum%% *}" ]]
}

for merger in "$@"; do
  target=${merger%%=*}
  kept=$scratch/$target
  mkdir "$kept"
  inputs=("$corpora/$target"/*)
  for input in "${inputs[@]}"; do
    is_found "$input" || cp "$input" "$kept"
  done
  if ! "${merger#*=}" -set_cover_merge=1 -use_counters=0 "$kept" "$corpora/$target" 2>"$scratch/log"; then
    cat "$scratch/log" >&2
    exit 1
  fi
  for input in "${inputs[@]}"; do
    [[ -e $kept/${input##*/} ]] || rm "$input"
  done
  left=("$corpora/$target"/*)
  echo "$target: ${#left[@]} of ${#inputs[@]} inputs"
done
