#!/usr/bin/env bash
# From a fresh Debian 12 machine to the first picture: installs what is missing, builds, runs inputs/tension_block.yaml
# on 2 MPI ranks, draws it. A second call only does what has changed; --again runs the job in any case.
#   scripts/quickstart.sh [--again]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

deck=$source_dir/inputs/tension_block.yaml
results=$source_dir/results/tension_block
binary=$build_dir/perinox

install_packages
configure_and_build --target perinox
mpi_environment

picture=$results/picture.png
if [ "${1:-}" = --again ] || [ ! "$picture" -nt "$binary" ] || [ ! "$picture" -nt "$deck" ]; then
  say "running $deck on 2 ranks"
  mpirun -np 2 "$binary" run "$deck" --output "$results"
  "$source_dir/scripts/picture.sh" "$results"
else
  say "neither the program nor the deck has changed since the last run (--again runs it all the same)"
fi

as_root_too=$([ "$(id -u)" -ne 0 ] || echo " --allow-run-as-root")
say "done"
cat <<END
  picture             $picture
  load-displacement   $results/history.csv
  all fields          $results/results.xdmf (open it in ParaView), data in results.h5
  Newton's progress   $results/convergence.csv
  the deck            $deck; change it and run
                      mpirun$as_root_too -np 2 $binary run $deck --output results/mine
END
