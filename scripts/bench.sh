#!/usr/bin/env bash
# Measures what docs/performance.md quotes and writes the tables there, between its two marks; the prose stays.
#   scripts/bench.sh [--quick | --tables]
# --quick: bodies of 16^3 and 32^3 particles, everything once. Without it: up to 100^3, the short runs three times.
# --tables: writes what was measured last once more. Nothing else should run meanwhile. Builds in build-bench, or in
# PERINOX_BUILD_DIR; what was measured stays there in measured/, one line a run. Peak memory needs GNU time.
set -euo pipefail
export LC_ALL=C # a decimal point in every number
folder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
: "${PERINOX_BUILD_DIR:=$folder/../build-bench}"
source "$folder/setup.sh"
source "$folder/bench/kernels.sh"
source "$folder/bench/runs.sh"
source "$folder/bench/peridigm.sh"

quick=''
tables_only=''
case "${1:-}" in
  --quick) quick=yes ;;
  --tables) tables_only=yes ;;
  "") ;;
  *) stop "usage: scripts/bench.sh [--quick | --tables]" ;;
esac
page=$source_dir/docs/performance.md
begin='<!-- measured: begin -->'
end='<!-- measured: end -->'
[ "$(grep -cxF -e "$begin" -e "$end" "$page")" -eq 2 ] || stop "$page has not the two marks: $begin and $end"

if [ "$quick" ]; then
  sizes=(16 32) loop_sizes='16|32' two_at_once=32 compared=(10 16 22) repeats=1 shortest=0.2
else
  sizes=(16 32 64 100) loop_sizes='16|32|64|100' two_at_once=64 compared=(10 16 22 30) repeats=3 shortest=0.5
fi

measured=$build_dir/measured
scratch=$(mktemp -d)
export TMPDIR=$scratch
trap 'rm -rf "$scratch"' EXIT

load=$(cut -d ' ' -f 1 /proc/loadavg) # before the build, which is a load itself
about() {
  local changed=''
  git -C "$source_dir" diff --quiet HEAD -- . ':!docs' 2>/dev/null || changed=' and changes'
  printf 'Measured on %s%s with %s%s, `%s`: %s, %s cores, %s; load of the machine before: %s.\n' \
    "$(date -u +%Y-%m-%d)" "$([ "$quick" ] && echo ', in the quick form,')" \
    "$(git -C "$source_dir" rev-parse --short HEAD 2>/dev/null || echo 'an unknown state')" "$changed" \
    "$(awk -F = '/^CMAKE_BUILD_TYPE/ {print $2}' "$build_dir/CMakeCache.txt")" \
    "$(awk -F ': *' '/^model name/ {print $2; exit}' /proc/cpuinfo)" "$(env -u OMP_NUM_THREADS nproc)" \
    "$(awk '/^MemTotal/ {printf "%.0f GB", $2 / 1e6}' /proc/meminfo)" "$load"
  awk -v load="$load" 'BEGIN {if (load > 0.7) print "\n**The machine was busy: every time below is provisional.**"}'
}

measure() {
  install_packages
  configure_options=(-DPERINOX_BENCHMARKS=ON)
  configure_and_build --target perinox bench_mechanics bench_triad
  mpi_environment
  gnu_time=$(type -P time || true)
  rm -rf "$measured"
  mkdir -p "$measured"
  about >"$measured/about.md"
  measure_machine "before the loops"
  measure_loops
  measure_machine "after the loops"
  measure_runs
  measure_peridigm_scenes
}

if [ -z "$tables_only" ]; then
  measure
elif [ ! -f "$measured/about.md" ]; then
  stop "nothing was measured yet: there is no $measured/about.md"
fi

{
  printf '%s\n\n' "$begin"
  cat "$measured/about.md"
  printf '\n### The machine\n\n'
  machine_table
  printf '\n### Loops over bonds\n\n'
  loop_tables
  printf '\n### Against the roofline\n\n'
  roofline_table
  printf '\n### Whole runs\n\n'
  run_table
  printf '\n### Growth, speed-up and memory\n\n'
  growth_tables
  printf '\n### Beside Peridigm\n\n'
  peridigm_tables
  printf '\n%s\n' "$end"
} >"$measured/tables.md"

awk -v begin="$begin" -v end="$end" -v tables="$measured/tables.md" '
  $0 == begin {while ((getline line < tables) > 0) print line; skipping = 1}
  !skipping
  $0 == end {skipping = 0}' "$page" >"$scratch/page.md"
cp "$scratch/page.md" "$page"
say "tables in $page"
