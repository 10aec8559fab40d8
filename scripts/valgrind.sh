#!/usr/bin/env bash
# Small runs of the program under valgrind's memcheck: an implicit one (yielding, a crack, breaking bonds, results and
# checkpoints), its restart, and an explicit one (breaking, contact), on one rank and on two. Some minutes.
#   scripts/valgrind.sh [BINARY]      by default build/perinox, brought up to date first
# Prints a table; exit status 1 if memcheck reports anything (invalid or uninitialised memory, a leak) that
# tests/data/valgrind/libraries.supp does not name, or if a run fails. docs/testing.md.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

packages+=(valgrind)
install_packages
mpi_environment
binary=$(realpath "${1:-$build_dir/perinox}")
[ $# -gt 0 ] || configure_and_build --target perinox >/dev/null
[ -x "$binary" ] || stop "$binary is no program"
decks=$source_dir/tests/data/valgrind
work=${PERINOX_VALGRIND_DIR:-$source_dir/build-valgrind}
rm -rf "$work"
mkdir -p "$work"

# Sets of instructions beyond AVX2 are unknown to valgrind; perinox and OpenBLAS see that by themselves.
memcheck=(valgrind --leak-check=full --errors-for-leak-kinds=definite,possible --show-leak-kinds=definite,possible
  --keep-debuginfo=yes --num-callers=40 --error-exitcode=97
  --suppressions=/usr/share/openmpi/openmpi-valgrind.supp "--suppressions=$decks/libraries.supp")
bad=0
check() { # name ranks arguments
  local name=$1 ranks=$2 began=$SECONDS status=0 reports
  shift 2
  # gathered from every rank's last line; a rank that did not come that far counts as one
  (cd "$decks" && mpirun -np "$ranks" "${memcheck[@]}" --log-file="$work/$name.%q{OMPI_COMM_WORLD_RANK}.memcheck" \
    "$binary" run "$@" --quiet) >"$work/$name.log" 2>&1 || status=$?
  reports=$({ cat "$work/$name".*.memcheck 2>/dev/null || true; } | awk '/ERROR SUMMARY/ {sum += $4; ++ranks} END {print sum + '"$ranks"' - ranks}')
  printf '%-16s %6s %8s %8s %8s\n' "$name" "$ranks" $status "$reports" $((SECONDS - began))
  if [ $status -ne 0 ] || [ "$reports" != 0 ]; then bad=1; fi
}

printf '%-16s %6s %8s %8s %8s\n' run ranks status reports seconds
for ranks in 1 2; do
  check "implicit_$ranks" $ranks implicit.yaml --output "$work/implicit_$ranks"
  check "restart_$ranks" $ranks implicit.yaml --restart "$work/implicit_$ranks" --set steps.end=1.5 --output "$work/restart_$ranks"
  check "explicit_$ranks" $ranks explicit.yaml --output "$work/explicit_$ranks"
done
[ $bad -eq 0 ] || stop "memcheck has reported something, or a run has failed: see $work/*.memcheck and $work/*.log"
