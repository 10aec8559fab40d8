#!/usr/bin/env bash
# Runs the invariance suite whole: all random scenes and all shipped decks, each described in other ways that must not
# matter, restarted after every step and on 1 to 4 ranks (docs/testing.md). The exit status tells: 0 means every answer
# was the same. Prints the table of kinds, scenes and largest deviations, which stays in build/invariance/table.md.
#   scripts/invariance.sh [--quick] [--scenes "7 17"] [--decks "cyclic_cube"] [gtest options]
# --quick: the sample of the normal test run. Builds in build, or in PERINOX_BUILD_DIR.
set -euo pipefail
export LC_ALL=C # a decimal point in every number
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

extent=full
while [ $# -gt 0 ]; do
  case "$1" in
    --quick) extent=quick ;;
    --scenes) export PERINOX_INVARIANCE_SCENES=${2:?"--scenes takes the numbers of scenes"} && shift ;;
    --decks) export PERINOX_INVARIANCE_DECKS=${2:?"--decks takes the names of decks"} && shift ;;
    --gtest_*) break ;;
    *) stop "usage: scripts/invariance.sh [--quick] [--scenes \"NUMBERS\"] [--decks \"NAMES\"] [gtest options]" ;;
  esac
  shift
done

install_packages
configure_and_build --target test_invariance
mpi_environment
measured=$build_dir/invariance
mkdir -p "$measured"
rm -f "$measured/rows.csv"
failed=''
PERINOX_INVARIANCE=$extent PERINOX_INVARIANCE_ROWS=$measured/rows.csv \
  mpirun -np 4 --oversubscribe "$build_dir/test_invariance" "$@" || failed=yes
[ -f "$measured/rows.csv" ] || stop "nothing was compared"
awk -F ';' '
  BEGIN {
    print "| what | described otherwise | scenes | largest deviation | bound | of | in |"
    print "|---|---|---|---|---|---|---|"
  }
  {printf "| %s | %s | %s | %s | %s | %s | %s |\n", $1, $2, $3, $4, $5, $6, $7}' "$measured/rows.csv" |
  tee "$measured/table.md"
[ -z "$failed" ] || stop "some answers were not the same, see above"
