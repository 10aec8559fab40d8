#!/usr/bin/env bash
# Builds unit tests with clang's address, undefined-behaviour and leak sanitisers and runs them:
#   scripts/sanitize.sh [tests ...]   folders of tests/: rooms, fuzz (the fuzzers' corpus), mpi (on 2 ranks). Default: all
#                                     of these
# PERINOX_JOBS: compilers and tests at a time (1). Prints what ran; exit status 1 if a test fails, reports or ends before
# its last line. docs/testing.md.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

every=(stepping mechanics motion fracture mpi equilibrium loads linear study output materials grid medium fuzz bonds body deck core) # the longest first

tests=("$@")
[ $# -gt 0 ] || tests=("${every[@]}")
jobs=${PERINOX_JOBS:-1}
build_dir=${PERINOX_BUILD_DIR:-$source_dir/build-sanitize}
packages+=(clang libclang-rt-14-dev lld)
install_packages
mpi_environment

say "building the tests of ${tests[*]} with sanitisers in $build_dir, $jobs at a time"
began=$SECONDS
(cd "$source_dir" && cmake --preset sanitize -B "$build_dir" >"$build_dir.log" 2>&1) || {
  cat "$build_dir.log" >&2
  stop "the configuration failed, see above"
}
nice -n 10 ninja -C "$build_dir" -j "$jobs" "${tests[@]/#/test_}" >"$build_dir.log" 2>&1 || {
  grep -A 20 '^FAILED' "$build_dir.log" >&2
  stop "the build failed, see above"
}
rm -f "$build_dir.log"
printf 'built in %d s\n' $((SECONDS - began))

# The sweeps that every machine can run have all checks; those of the other instruction sets run against the stored bonds.
export PERINOX_INSTRUCTIONS=baseline
programs=("${tests[@]}")
case " ${tests[*]} " in *" mechanics "*) programs+=(mechanics_avx2 mechanics_avx512) ;; esac
export LSAN_OPTIONS=suppressions=$source_dir/fuzz/leaks.supp:print_suppressions=0
# tests/main.cpp looks for leaks before MPI_Finalize, which unloads the libraries that leaks.supp names.
export ASAN_OPTIONS=detect_leaks=1:leak_check_at_exit=0:detect_stack_use_after_return=1 UBSAN_OPTIONS=print_stacktrace=1
run_one() { # name: its log and, in .row, its line of the table
  local name=$1 log=$build_dir/$1.log began=$SECONDS status=0 launcher=() filter=* passed attempt
  case $name in
    mpi) launcher=(mpirun -np 2) ;;
    mechanics_*) filter='*Layouts*/?0:*Layouts*/?5' launcher=(env "PERINOX_INSTRUCTIONS=${name#*_}") ;;
  esac
  # LeakSanitizer's own thread can crash where a thread of Open MPI's ends while it looks. It says so, and then has looked
  # at nothing: the program is run again.
  for attempt in 1 2 3; do
    status=0
    nice -n 10 "${launcher[@]}" "$build_dir/test_${name%_*}" --gtest_color=no "--gtest_filter=$filter" >"$log" 2>&1 || status=$?
    grep -q 'LeakSanitizer has encountered a fatal error' "$log" || break
    printf '%-16s the leak sanitiser crashed, attempt %d\n' "$name" $attempt
  done
  passed=$(awk '/\[  PASSED  \]/ {print $4}' "$log")
  # a program that ends well without having said what passed has not run its tests
  [ $status -ne 0 ] || [ "${passed:-0}" -gt 0 ] || status=none
  printf '%-16s %8s %8s %8s\n' "$name" "${passed:-0}" $status $((SECONDS - began)) | tee "$build_dir/$name.row"
}
printf '%-16s %8s %8s %8s\n' tests passed status seconds
rm -f "$build_dir"/*.row
for name in "${programs[@]}"; do
  while [ "$(jobs -rp | wc -l)" -ge "$jobs" ]; do wait -n || true; done
  run_one "$name" &
done
wait

bad=0
for name in "${programs[@]}"; do
  read -r _ _ status _ <"$build_dir/$name.row" || status=none
  [ "$status" = 0 ] && continue
  bad=1
  printf '\n-- %s: what it reported\n' "$name" >&2
  grep -m 3 -A 25 -E 'ERROR: |runtime error|FAILED  |SUMMARY: ' "$build_dir/$name.log" >&2 || tail -25 "$build_dir/$name.log" >&2
done
[ $bad -eq 0 ] || stop "a test failed or a sanitiser has reported something: see $build_dir/*.log"
