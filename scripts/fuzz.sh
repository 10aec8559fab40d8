#!/usr/bin/env bash
# Builds the libFuzzer harnesses with clang and runs each for a number of executions:
#   scripts/fuzz.sh [executions, default 20000] [harness ...]
# A crash, a hang (20 s), a leak or 3 GB of memory ends a harness; its input is kept in build-fuzz/found/ and belongs,
# once the defect is mended, into fuzz/corpus/<harness>/. The exit status is 1 if there is one. docs/testing.md.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

executions=${1:-20000}
shift || true
harnesses=("$@")
[ ${#harnesses[@]} -gt 0 ] || harnesses=(expression cloud table deck checkpoint)
build_dir=${PERINOX_BUILD_DIR:-$source_dir/build-fuzz}
packages+=(clang libclang-rt-14-dev)
install_packages
mpi_environment

say "building ${harnesses[*]} in $build_dir"
[ -f "$build_dir/CMakeCache.txt" ] ||
  cmake -S "$source_dir" -B "$build_dir" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER=clang++ \
    -DCMAKE_C_COMPILER=clang -DPERINOX_FUZZ=ON -DBUILD_TESTING=OFF -DPERINOX_WARNINGS_AS_ERRORS=OFF >/dev/null
nice -n 10 ninja -C "$build_dir" -j "${PERINOX_JOBS:-1}" "${harnesses[@]/#/fuzz_}" >/dev/null

work=$build_dir/found
mkdir -p "$work/decks"
cp "$source_dir"/inputs/*.yaml "$work/decks"
# Words that a deck may hold.
grep -o '"[a-z_-]*"' "$source_dir/docs/deck.schema.json" | sort -u >"$work/deck.dict"
export LSAN_OPTIONS=suppressions=$source_dir/fuzz/leaks.supp:print_suppressions=0
# Where memory was asked for is kept six calls deep, and 8 MB of freed memory are watched, that of ten executions.
export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1:malloc_context_size=6:quarantine_size_mb=8
ASAN_OPTIONS+=:allocator_release_to_os_interval_ms=-1
export UBSAN_OPTIONS=print_stacktrace=1

found=0
count() { find "$work" -maxdepth 1 -newer "$work/begin" -name "$1-$2-*" | wc -l; }
printf '%-12s %10s %8s %6s %6s %7s %8s %8s\n' harness executions crashes hangs leaks "> 3 GB" "peak MB" seconds
for harness in "${harnesses[@]}"; do
  options=(-max_len=2048)
  seeds=("$source_dir/fuzz/corpus/$harness")
  case $harness in
    expression) options=(-max_len=200) ;;
    deck) options+=("-dict=$work/deck.dict") seeds+=("$work/decks") ;;
  esac
  mkdir -p "$work/$harness"
  touch "$work/begin"
  log=$work/$harness.log
  began=$SECONDS
  # Without the entropic schedule, whose counting of features takes half the time of a deck.
  nice -n 10 "$build_dir/fuzz_$harness" "${options[@]}" -entropic=0 -artifact_prefix="$work/$harness-" -timeout=20 \
    -rss_limit_mb=3000 -runs="$executions" -print_final_stats=1 "$work/$harness" "${seeds[@]}" >"$log" 2>&1 || found=1
  done_executions=$(awk '/stat::number_of_executed_units/ {print $2}' "$log")
  peak=$(awk '/stat::peak_rss_mb/ {print $2}' "$log")
  printf '%-12s %10s %8s %6s %6s %7s %8s %8s\n' "$harness" "${done_executions:-?}" "$(count "$harness" crash)" \
    "$(count "$harness" timeout)" "$(count "$harness" leak)" "$(count "$harness" oom)" "${peak:-?}" $((SECONDS - began))
done
[ $found -eq 0 ] || stop "something was found: the inputs and the logs are in $work"
