# shellcheck shell=bash
# The command `./platon test`, sourced by ./platon, which sets root and the lists of packages:
# shellcheck disable=SC2154

# Options of ctest: those followed by a value, and those without one.
ctest_value_options=' -R --tests-regex -E --exclude-regex -L --label-regex -LE --label-exclude -FA --fixture-exclude-any
  -FS --fixture-exclude-setup -FC --fixture-exclude-cleanup -I --tests-information -j --parallel -O --output-log
  --output-junit --repeat --stop-time --test-load --timeout '
ctest_flags=' -V --verbose -VV --extra-verbose --output-on-failure --stop-on-failure --progress -Q --quiet -N --show-only
  --rerun-failed --schedule-random -U --union --print-labels '

# test_program NAME: prints the target of a test file, which may be given with its path, with .cpp or without _test.
test_program() {
  local name
  name=$(basename -- "$1" .cpp)
  [[ $name == *_test ]] || name+=_test
  [[ -n $(find "$root/tests" -name "$name.cpp" -print -quit) ]] ||
    die "no test file $name.cpp in tests/; a test without a file of its own is run by -R '^NAME\$'" 2
  printf '%s\n' "$name"
}

# parse_test_options ARGUMENT…: sets the variables of run_tests.
parse_test_options() {
  local word
  while [[ $# != 0 ]]; do
    word=$1
    shift
    case $word in
      --debug | --tsan | --clang) preset=${word#--} ;;
      --asan) preset=asan-ubsan ;;
      --long) long=ON ;;
      --quick | --all | --release) lane=${word#--} ;;
      --fuzz)
        lane=fuzz
        [[ ! ${1-} =~ ^[1-9][0-9]*$ ]] || { seconds=$1 && shift; }
        ;;
      -*)
        if [[ $ctest_value_options == *[[:space:]]"$word"[[:space:]]* ]]; then
          [[ $# != 0 ]] || die "test: ctest's option $word needs a value" 2
          ctest_options+=("$word" "$1")
          shift
        elif [[ $ctest_flags == *[[:space:]]"$word"[[:space:]]* ]]; then
          ctest_options+=("$word")
        else
          die "test has no option '$word', nor has ctest; see ./platon help" 2
        fi
        ;;
      *)
        word=$(test_program "$word")
        programs+=("$word")
        ;;
    esac
  done
}

refuse_contradictions() {
  [[ $lane == '' || ${#programs[@]} == 0 ]] || die "test --$lane runs a fixed set of tests: name no test files with it" 2
  [[ $lane != all && $lane != release || $preset == release ]] ||
    die "test --$lane chooses the presets itself: name none with it" 2
  [[ $lane != fuzz || $preset == release ]] || die 'test --fuzz builds with clang and sanitizers: name no preset with it' 2
}

# run_ctest PRESET OPTION…: with every change, tests repeat less than before a release (tests/support/run/repetitions.h).
run_ctest() {
  local preset=$1 jobs
  shift
  unset PLATON_BRIEF
  [[ $long == ON || ($lane != all && $lane != quick) ]] || export PLATON_BRIEF=1
  jobs=$(nproc)
  # Many tests wait, so more are run. With sanitizers they calculate for so long that programs would be late.
  case $preset in
    tsan) ;;
    asan-ubsan) jobs=$((jobs + 1)) ;;
    *) jobs=$((jobs + 3)) ;;
  esac
  (cd "$root" && ctest --preset "$preset" --parallel "$jobs" "$@") || return 1
}

# summary_of LOG: the line in which ctest counts tests, for example "98% tests passed, 2 tests failed out of 100".
summary_of() { grep -E '^[0-9]+% tests passed, [0-9]+ tests failed out of [0-9]+' "$1" | tail -n 1; }

# run_lane NAME PRESET [LABEL]: runs the tests of a lane (tests/test_functions.cmake), without a label every test. Adds a
# line to `lines` and to the counts of run_lanes.
run_lane() {
  local name=$1 preset=$2 label=${3-} log begin=$SECONDS summary='' selection=()
  log=$(mktemp)
  say "lane $name"
  [[ -z $label ]] || selection=(-L "^$label\$")
  if configure "$preset" "${configuration[@]}" && build "$preset" ${label:+"${label}_tests"}; then
    run_ctest "$preset" "${selection[@]}" "${ctest_options[@]}" 2>&1 | tee "$log" || true
    summary=$(summary_of "$log") || summary='0% tests passed, 1 tests failed out of 1: ctest gave no summary'
  else
    summary='0% tests passed, 1 tests failed out of 1: the build failed'
  fi
  rm -f "$log"
  [[ $summary =~ ,\ ([0-9]+)\ tests\ failed\ out\ of\ ([0-9]+) ]]
  failed=$((failed + BASH_REMATCH[1]))
  total=$((total + BASH_REMATCH[2]))
  lines+=("lane $name: $summary, in $((SECONDS - begin)) s")
}

# run_lanes all|release: runs every lane even if one fails. The last line has the form of ctest's and counts the tests of
# all lanes.
run_lanes() {
  local lines=() failed=0 total=0
  if [[ $1 == all ]]; then
    run_lane release release all
    run_lane address-and-undefined asan-ubsan outside
  else
    local drawn=$root/build/release/drawn_faults.txt
    rm -f "$drawn"
    run_lane release release
    lines+=("drawn faults, $(cat "$drawn" 2>/dev/null || printf 'none tried')")
    run_lane address-and-undefined asan-ubsan sanitized
  fi
  run_lane threads tsan threads
  printf '\n'
  printf '%s\n' "${lines[@]}"
  printf '%d%% tests passed, %d tests failed out of %d\n' $(((total - failed) * 100 / total)) "$failed" "$total"
  [[ $failed == 0 ]]
}

compare_machines() {
  local arguments=() word
  for word in "$@"; do
    [[ $word == --machines ]] || arguments+=("$word")
  done
  need "$to_compare"
  exec python3 -B "$root/tests/determinism/machines/compare.py" "${arguments[@]}"
}

check_proof() {
  local seed=1
  [[ ${2-} =~ ^[0-9]+$ ]] && seed=$2 && set -- "$1"
  [[ $# == 1 ]] || die 'test --proof checks the whole proof: give nothing with it but a seed' 2
  need "$to_test"
  configure release -DBUILD_TESTING=ON || exit 1
  build release platon-sweep-queries || exit 1
  exec python3 -B "$root/tests/proof/check_proof.py" "$root" "$bin/platon-sweep-queries" "$seed"
}

run_tests() {
  local preset=release long=OFF lane='' seconds='' programs=() ctest_options=() configuration
  [[ " $* " != *' --machines '* ]] || compare_machines "$@"
  [[ " $* " != *' --proof '* ]] || check_proof "$@"
  parse_test_options "$@"
  refuse_contradictions
  need "$to_test"
  [[ $lane != fuzz ]] || seconds=${seconds:-60}
  configuration=(-DBUILD_TESTING=ON "-DPLATON_LONG=$long" "-DPLATON_FUZZ_SECONDS=${seconds:-0}")
  if [[ $lane == all || $lane == release ]]; then
    run_lanes "$lane"
    return
  fi
  # Without a word about which tests: those of the first lane of --all.
  [[ $lane != '' || $long == ON || $preset != release || ${#programs[@]} != 0 || ${#ctest_options[@]} != 0 ]] || lane=all
  configure "$preset" "${configuration[@]}"
  case $lane in
    quick | all)
      build "$preset" "${lane}_tests"
      run_ctest "$preset" -L "^$lane\$" "${ctest_options[@]}"
      ;;
    fuzz) run_ctest "$preset" -L '^fuzz$' "${ctest_options[@]}" ;;
    *)
      build "$preset" "${programs[@]}"
      [[ ${#programs[@]} == 0 ]] || ctest_options+=(-R "^($(IFS='|' && printf '%s' "${programs[*]}"))\$")
      run_ctest "$preset" "${ctest_options[@]}"
      ;;
  esac
}
