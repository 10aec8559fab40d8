#!/usr/bin/env bash
# Runs the verification problems at every resolution and writes the tables of docs/verification.md between its marks; the
# prose stays.
#   scripts/verification.sh [--quick | --tables]
# --quick: the resolutions of the normal test run only. --tables: writes what was measured last once more. Builds in build,
# or in PERINOX_BUILD_DIR; what was measured stays there in verification/rows.csv, one line a row.
set -euo pipefail
export LC_ALL=C # a decimal point in every number
folder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$folder/setup.sh"

extent=full
failed=''
load=$(cut -d ' ' -f 1 /proc/loadavg) # before the build, which is a load itself
tables_only=''
case "${1:-}" in
  --quick) extent=quick ;;
  --tables) tables_only=yes ;;
  "") ;;
  *) stop "usage: scripts/verification.sh [--quick | --tables]" ;;
esac

page=$source_dir/docs/verification.md
measured=$build_dir/verification
rows=$measured/rows.csv

about() {
  local changed=''
  git -C "$source_dir" diff --quiet HEAD -- . ':!docs' 2>/dev/null || changed=' and changes'
  printf 'Measured on %s%s with %s%s, `%s`, one rank: %s, %s cores, %s; load of the machine before: %s.\n' "$(date -u +%Y-%m-%d)" \
    "$([ "$extent" = quick ] && echo ', in the quick form,')" \
    "$(git -C "$source_dir" rev-parse --short HEAD 2>/dev/null || echo 'an unknown state')" "$changed" \
    "$(awk -F = '/^CMAKE_BUILD_TYPE/ {print $2}' "$build_dir/CMakeCache.txt")" \
    "$(awk -F ': *' '/^model name/ {print $2; exit}' /proc/cpuinfo)" "$(env -u OMP_NUM_THREADS nproc)" \
    "$(awk '/^MemTotal/ {printf "%.0f GB", $2 / 1e6}' /proc/meminfo)" "$load"
}

if [ -z "$tables_only" ]; then
  install_packages
  configure_and_build --target test_verification
  mpi_environment
  mkdir -p "$measured"
  rm -f "$rows"
  about >"$measured/about.md"
  PERINOX_VERIFICATION=$extent PERINOX_VERIFICATION_ROWS=$rows "$build_dir/test_verification" || failed=yes
elif [ ! -f "$measured/about.md" ]; then
  stop "nothing was measured yet: there is no $measured/about.md"
fi

# A mark `<!-- table: NAME -->` is followed by the rows of table NAME, up to `<!-- end -->`; the table `about` is a line.
# One line a problem and resolution, the default quadrature first, `whole` beside it.
awk -F ';' -v rows="$rows" -v about="$measured/about.md" '
  function cells(key, quadrature) {
    return (key, quadrature) in cell ? cell[key, quadrature] : " | | |"
  }
  function table(name,   p, r, key) {
    print "| problem | exact answer | resolution | particles | error | order | CPU s | `whole`: error | order | CPU s |"
    print "|---|---|---|---|---|---|---|---|---|---|"
    for (p = 1; p <= problems[name]; ++p)
      for (r = 1; r <= resolutions[name, p]; ++r) {
        key = name SUBSEP p SUBSEP r
        print "| " problem[name, p] " | " source[name, p] " | " resolution[key] " | " particles[key] " |" \
          cells(key, "position-aware") cells(key, "whole")
      }
  }
  function percent(value) {
    return value < 1e-9 && value > -1e-9 ? sprintf("%.0e", value) : \
      value < 0.001 && value > -0.001 ? sprintf("%.3f %%", 100 * value) : \
      value < 0.01 && value > -0.01 ? sprintf("%.2f %%", 100 * value) : sprintf("%.1f %%", 100 * value)
  }
  BEGIN {
    while ((getline line < rows) > 0) {
      split(line, f, ";")
      name = f[1]
      if (!((name, f[2]) in number)) {
        number[name, f[2]] = ++problems[name]
        problem[name, problems[name]] = f[2]
        source[name, problems[name]] = f[3]
      }
      p = number[name, f[2]]
      if (!((name, p, f[5]) in place)) {
        place[name, p, f[5]] = ++resolutions[name, p]
        resolution[name, p, resolutions[name, p]] = f[5]
        particles[name, p, resolutions[name, p]] = f[6]
      }
      cell[name, p, place[name, p, f[5]], f[4]] = " " percent(f[7]) " | " f[8] " | " f[9] " |"
    }
  }
  /^<!-- table: .* -->$/ {
    name = substr($0, 13, length($0) - 16)
    print
    print ""
    if (name == "about") while ((getline line < about) > 0) print line
    else if (!(name in problems)) {print "verification.sh: no rows of the table " name | "cat >&2"; failed = 1}
    else table(name)
    print ""
    skipping = 1
  }
  /^<!-- end -->$/ {skipping = 0}
  !skipping
  END {exit failed}' "$page" >"$measured/page.md" || stop "the page was not written"
cp "$measured/page.md" "$page"
say "tables in $page"
[ -z "$failed" ] || stop "some tests failed, see above"
