#!/usr/bin/env bash
# Installs what is missing, builds, runs every test, and the unit and MPI tests again under the sanitisers. The exit status
# tells: 0 means all passed.
# For a selection, once built: ctest --test-dir build -L unit -R output --output-on-failure
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

install_packages
mpi_environment
say "configuring, building and testing in $build_dir on $(parallel_jobs) cores"
PERINOX_BUILD_DIR=$build_dir PERINOX_JOBS=$(parallel_jobs) CTEST_OUTPUT_ON_FAILURE=1 \
  ctest -S "$source_dir/ctest/perinox.cmake" -V
# In a build folder of their own: docs/testing.md.
PERINOX_BUILD_DIR=$build_dir-sanitize PERINOX_JOBS=$(parallel_jobs) "$source_dir/scripts/sanitize.sh"
say "all tests passed"
