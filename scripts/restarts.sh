#!/usr/bin/env bash
# Every deck of inputs/, broken off after every step (and once within each step that goes through time) and gone on with
# from its own checkpoint: the same rows and the same end, to the last bit.
#   scripts/restarts.sh [DECK ...]     names as in inputs/, without .yaml; all of them where none is given
# Builds in build, or in PERINOX_BUILD_DIR. Prints a line a deck; exit status 1 if one ends otherwise. docs/restart.md.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

install_packages
configure_and_build --target test_golden >/dev/null
mpi_environment
filter='Inputs/Restarted.*'
if [ $# -gt 0 ]; then
  filter=$(printf 'Inputs/Restarted.AfterEveryStep/%s:' "$@")
fi
PERINOX_RESTARTS=all "$build_dir/test_golden" --gtest_filter="$filter" --gtest_brief=0
