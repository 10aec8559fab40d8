# Sourced by bench.sh: decks of cubes, runs of them on one and two ranks, tables of what they cost.

# cube_deck SCENE N: a cube of N^3 particles, held three layers deep at both ends and pulled apart in z.
# elastic: by 1e-3 of its edge; crack: the same with a cut through half the section; plastic: by 3e-3 in one step,
# which makes about half of it yield; path: by 1e-2 in ten steps, which makes most of it yield.
cube_deck() {
  local scene=$1 n=$2 model=elastic pull=0.001 steps=1 more=
  case $scene in
    plastic) model='elastic-plastic, yield_stress: {shear: 117.3}' pull=0.003 ;;
    path) model='elastic-plastic, yield_stress: {shear: 117.3}' pull=0.01 steps=10 ;;
    crack)
      more=$(awk -v n="$n" 'BEGIN {
        printf "cracks: [{rectangle: {corner: [-1, -1, %g], edge1: [%g, 0, 0], edge2: [0, %g, 0]}}]",
          n / 2 + 0.01, n / 2 + 1, n + 2}')
      ;;
  esac
  cat <<DECK
title: $scene, $n^3
dimension: 3
body: [{name: cube, shape: {box: {min: [0, 0, 0], max: [$n, $n, $n]}}, spacing: 1, material: aluminium}]
horizon: {ratio: 3.015}
quadrature: whole
materials: {aluminium: {model: $model, bulk_modulus: 67.5e3, shear_modulus: 25.9e3}}
sets: {foot: {where: "z < 3"}, head: {where: "z > $((n - 3))"}}
boundary:
  - {set: foot, displacement: {x: 0, y: 0, z: 0}}
  - {set: head, displacement: {x: 0, y: 0, z: "$pull*$n*t"}}
steps: {end: 1, count: $steps}
solver: {newton: {tolerance: 1e-8}}
output: {every: 1000000000, fields: [displacement]}
history: [{name: pull, reaction: head, component: z}, {name: yielded, yielded: all}]
$more
DECK
}

# timed RANKS COMMAND ...: runs it and leaves "CPU seconds, wall seconds, peak memory in MB, CPU seconds without the
# system's" of all ranks, without mpirun's own, in $scratch/cost. The memory of ranks is summed.
timed() {
  local ranks=$1 launch=() begin
  shift
  [ "$ranks" -eq 1 ] || launch=(mpirun -np "$ranks" --oversubscribe)
  rm -f "$scratch/times"
  begin=$EPOCHREALTIME
  if [ "$gnu_time" ]; then
    "${launch[@]}" "$gnu_time" -a -o "$scratch/times" -f '%U %S %M' "$@" >"$scratch/said" 2>&1
  else
    local TIMEFORMAT='%U %S 0'
    { time "${launch[@]}" "$@" >"$scratch/said" 2>&1; } 2>"$scratch/times"
  fi || { cat "$scratch/said" >&2 && stop "this run failed: $*"; }
  awk -v wall="$(awk -v a="$begin" -v b="$EPOCHREALTIME" 'BEGIN {print b - a}')" '
    {cpu += $1 + $2; user += $1; memory += $3 * 1.024e-3}
    END {printf "%.2f\t%.2f\t%.0f\t%.2f\n", cpu, wall, memory, user}' \
    "$scratch/times" >"$scratch/cost"
}

# sums_of HISTORY: steps, Newton and linear iterations, products, seconds in product, preconditioner and halo, yielded.
sums_of() {
  awk -F , '
    NR == 1 {for (k = 1; k <= NF; ++k) column[$k] = k; next}
    function value(name) {return name in column ? $column[name] : 0}
    $column["step"] > 0 {
      ++steps
      newton += value("newton_iterations"); linear += value("linear_iterations"); products += value("products")
      product += value("seconds_product"); preconditioner += value("seconds_preconditioner")
      halo += value("seconds_halo"); yielded = value("yielded")
    }
    END {OFS = "\t"; print steps, newton, linear, products, product, preconditioner, halo, yielded}' "$1"
}

# one_run SCENE N RANKS WAY DECK [OPTION ...]: a row of runs.tsv: scene, n, ranks, way, steps, Newton, linear, products,
# seconds in product, preconditioner, halo, yielded, CPU seconds, wall seconds, MB, CPU seconds without the system's.
one_run() {
  local scene=$1 n=$2 ranks=$3 way=$4 deck=$5
  shift 5
  say "$scene, $n^3, $ranks ranks, $way" >&2
  rm -rf "$scratch/results"
  timed "$ranks" "$build_dir/perinox" run "$deck" --output "$scratch/results" "$@"
  grep -qE "[^0-9]$((n * n * n)) particles" "$scratch/said" || stop "$deck has not $n^3 particles"
  printf '%s\t%s\t%s\t%s\t%s\t%s\n' "$scene" "$n" "$ranks" "$way" "$(sums_of "$scratch/results/history.csv")" \
    "$(cat "$scratch/cost")"
}

measure_runs() {
  local scene n ranks deck=$scratch/deck.yaml
  for scene in elastic plastic path crack; do
    for n in "${sizes[@]}"; do
      [ "$scene" = path ] && [ "$n" -gt 32 ] && continue
      cube_deck "$scene" "$n" >"$deck"
      for ranks in 1 2; do
        one_run "$scene" "$n" "$ranks" two-level "$deck" --set solver.linear.preconditioner=two-level
        [ "$n" -gt 32 ] || one_run "$scene" "$n" "$ranks" block-jacobi "$deck" \
          --set solver.linear.preconditioner=block-jacobi
        # On two ranks the assembled tangent takes a minute even for one step: once is enough.
        [ "$n" -gt 16 ] || [ "$scene" = path ] || { [ "$ranks" -eq 2 ] && [ "$quick$scene" != elastic ]; } ||
          one_run "$scene" "$n" "$ranks" assembled "$deck" --set solver.tangent=assembled
      done
    done
  done >"$measured/runs.tsv"
}

run_table() {
  printf '| scene | n | ranks | solver | steps | yielded | Newton | linear | products | CPU, s | wall, s | '
  printf 'in products | preconditioner | halo | MB |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n'
  awk -F '\t' '{
    printf "| %s | %s | %s | %s | %s | %s | %s | %s | %s | %s | %s | %.2f | %.2f | %.2f | %s |\n",
      $1, $2, $3, $4, $5, ($1 ~ /^p/ ? sprintf("%.0f %%", 100 * $12) : ""), $6, $7, $8, $13, $14, $9, $10, $11,
      ($15 > 0 ? $15 : "not known")}' "$measured/runs.tsv"
}

growth_tables() {
  printf 'CPU microseconds a particle and load step, one rank, two-level; in brackets over that of 32³:\n\n'
  printf '| scene | n | µs a particle and step | bytes a particle beyond those of 16³ |\n|---|---|---|---|\n'
  awk -F '\t' '$3 == 1 && $4 == "two-level" && $1 != "path" {
      cost = 1e6 * $13 / $2 ^ 3 / $5
      if ($2 == 16) {fewest = $2 ^ 3; memory = $15}
      if ($2 == 32) reference = cost
      printf "| %s | %s | %.0f%s | %s |\n", $1, $2, cost, ($2 >= 32 ? sprintf(" (%.2f)", cost / reference) : ""),
        ($2 > 16 && $15 > 0 ? sprintf("%.0f", 1e6 * ($15 - memory) / ($2 ^ 3 - fewest)) : "")
    }' "$measured/runs.tsv"
  printf '\nTwo ranks against one, two-level:\n\n'
  printf '| scene | n | wall time of the run | of the products | CPU of two over one |\n|---|---|---|---|---|\n'
  awk -F '\t' '$4 == "two-level" {
      if ($3 == 1) {wall = $14; product = $9; cpu = $13}
      else printf "| %s | %s | %.2f | %.2f | %.2f |\n", $1, $2, wall / $14, product / ($9 > 0 ? $9 : 1e-9), $13 / cpu
    }' "$measured/runs.tsv"
}
