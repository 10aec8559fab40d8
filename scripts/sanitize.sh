#!/usr/bin/env bash
# Builds unit tests with the address, undefined-behaviour and leak sanitisers (g++) and runs them:
#   scripts/sanitize.sh [room ...], by default core deck body bonds materials; "all": every room.
# The rooms' tests and those of the fuzzers' corpus. mechanics, solve and what comes after take hours on one core:
# docs/testing.md. Exit status 1 if anything is reported.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

rooms=("$@")
[ ${#rooms[@]} -gt 0 ] || rooms=(core deck body bonds materials)
tests=("${rooms[@]}")
wanted=$(IFS=';'; echo "${rooms[*]}")
if [ "${rooms[*]}" = all ]; then
  tests=(core deck body bonds materials mechanics solve output study)
  wanted=
fi
tests+=(fuzz)
build_dir=${PERINOX_BUILD_DIR:-$source_dir/build-sanitize}
install_packages
mpi_environment

say "building the tests of ${tests[*]} in $build_dir"
began=$SECONDS
(cd "$source_dir" && cmake --preset sanitize -B "$build_dir" "-DPERINOX_ROOMS=$wanted" >/dev/null)
nice -n 10 ninja -C "$build_dir" -j "${PERINOX_JOBS:-1}" "${tests[@]/#/test_}" >/dev/null
printf 'built in %d s\n' $((SECONDS - began))

export LSAN_OPTIONS=suppressions=$source_dir/fuzz/leaks.supp:print_suppressions=0
# tests/main.cpp looks for leaks before MPI_Finalize, which unloads the libraries that leaks.supp names.
export ASAN_OPTIONS=detect_leaks=1:leak_check_at_exit=0:detect_stack_use_after_return=1 UBSAN_OPTIONS=print_stacktrace=1
bad=0
printf '%-12s %8s %8s %8s\n' tests passed status seconds
for name in "${tests[@]}"; do
  log=$build_dir/$name.log
  began=$SECONDS
  status=0
  nice -n 10 "$build_dir/test_$name" >"$log" 2>&1 || status=$?
  [ $status -eq 0 ] || bad=1
  printf '%-12s %8s %8s %8s\n' "$name" "$(awk '/PASSED/ {print $4}' "$log")" $status $((SECONDS - began))
done
[ $bad -eq 0 ] || stop "a test failed or a sanitiser has reported something: see $build_dir/*.log"
