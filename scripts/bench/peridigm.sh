# Sourced by bench.sh: two scenes that Peridigm (2023-08, on Debian's Trilinos 13.2) was measured on, with its figures.
# A cube of edge 1 m, the three lowest layers held, the three highest moved in z only.
# B1: elastic, 1e-3 m in one step. B2: perfectly plastic, 203.1 MPa in tension, 1e-2 m in 20 steps.

# Scene, n, CPU seconds (user, median of three), peak MB, Newton iterations: without a matrix and without a
# preconditioner, its fastest setting; then with its full tangent, CG.
peridigm_figures() {
  cat <<'FIGURES'
B1	10	0.48	110	2	8.0	300	3
B1	16	1.15	130	2	64	1190	3
B1	22	4.9	165	3	over 200	-	-
B1	30	15.5	263	3	-	-	-
B2	10	2.4	120	42	101	300	80
B2	16	13	135	45	-	-	-
B2	22	47	181	40	-	-	-
FIGURES
}

# Scene, step, reaction of the moved end in z, N, n = 10; B2's to a tolerance of 1e-9.
peridigm_reactions() {
  cat <<'REACTIONS'
B1	1	1.505296333e8
B2	1	7.520676e7
B2	2	1.504913e8
B2	3	2.158671e8
B2	4	2.519932e8
B2	5	2.706318e8
B2	10	3.236076e8
B2	20	3.887843e8
REACTIONS
}

# peridigm_deck SCENE N TOLERANCE. That code stops by the residual alone, so the update has no say here either.
peridigm_deck() {
  local scene=$1 n=$2 model=elastic pull=1e-3 steps=1
  [ "$scene" = B1 ] || {
    model='elastic-plastic, yield_stress: {tension: 203.1e6}, yield_scaling: continuum' pull=1e-2 steps=20
  }
  awk -v n="$n" -v scene="$scene" -v model="$model" -v pull="$pull" -v steps="$steps" -v tolerance="$3" 'BEGIN {
    printf "title: %s, %d^3\ndimension: 3\n", scene, n
    printf "body: [{name: cube, shape: {box: {min: [0, 0, 0], max: [1, 1, 1]}}, spacing: %.17g, material: aluminium}]\n", 1 / n
    printf "horizon: {ratio: 3.015}\nquadrature: whole\n"
    printf "materials: {aluminium: {model: %s, bulk_modulus: 67.5e9, shear_modulus: 25.9e9}}\n", model
    printf "sets: {foot: {where: \"z < %.17g\"}, head: {where: \"z > %.17g\"}}\n", 3 / n, 1 - 3 / n
    printf "boundary:\n  - {set: foot, displacement: {x: 0, y: 0, z: 0}}\n"
    printf "  - {set: head, displacement: {x: 0, y: 0, z: \"%s*t\"}}\n", pull
    printf "steps: {end: 1, count: %d}\n", steps
    printf "solver: {newton: {tolerance: %s, update_tolerance: 1}}\n", tolerance
    printf "output: {every: 1000000000, fields: [displacement]}\n"
    printf "history: [{name: pull, reaction: head, component: z}, {name: yielded, yielded: all}]\n"
  }'
}

measure_peridigm_scenes() {
  local scene n k deck=$scratch/deck.yaml
  : >"$measured/peridigm.tsv"
  for scene in B1 B2; do
    for n in "${compared[@]}"; do
      peridigm_deck "$scene" "$n" 1e-6 >"$deck"
      for ((k = 0; k < repeats; ++k)); do one_run "$scene" "$n" 1 automatic "$deck"; done |
        sort -t $'\t' -k 16,16n | awk -v middle="$(((repeats + 1) / 2))" 'NR == middle' >>"$measured/peridigm.tsv"
    done
    peridigm_deck "$scene" 10 1e-9 >"$deck"
    rm -rf "$scratch/results"
    timed 1 "$build_dir/perinox" run "$deck" --output "$scratch/results"
    awk -F , -v scene="$scene" '
      NR == 1 {for (k = 1; k <= NF; ++k) column[$k] = k; next}
      $column["step"] > 0 {print scene "\t" $column["step"] "\t" $column["pull"]}' "$scratch/results/history.csv"
  done >"$measured/reactions.tsv"
}

peridigm_tables() {
  printf 'CPU seconds are those of the user, without the system, on both sides.\n\n'
  printf '| scene | n | Newton | linear | CPU, s | MB | Peridigm: Newton | CPU, s | MB | its CPU over ours | '
  printf 'full tangent: Newton | CPU, s | MB |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n'
  peridigm_figures | awk -F '\t' '
    FILENAME == "-" {cpu[$1, $2] = $3; memory[$1, $2] = $4; newton[$1, $2] = $5
                     full[$1, $2] = $8 " | " $6 " | " $7; next}
    {
      known = ($1, $2) in cpu
      printf "| %s | %s | %s | %s | %s | %s | %s | %s | %s | %s | %s |\n", $1, $2, $6, $7, $16,
        ($15 > 0 ? $15 : "not known"), (known ? newton[$1, $2] : "-"), (known ? cpu[$1, $2] : "-"),
        (known ? memory[$1, $2] : "-"), (known && $16 > 0 ? sprintf("%.1f", cpu[$1, $2] / $16) : "-"),
        (known ? full[$1, $2] : "- | - | -")
    }' - "$measured/peridigm.tsv"
  printf '\nReaction of the moved end, n = 10, ours to a tolerance of 1e-9:\n\n'
  printf '| scene | step | reaction, N | Peridigm | relative difference |\n|---|---|---|---|---|\n'
  peridigm_reactions | awk -F '\t' '
    function size(x) {return x < 0 ? -x : x}
    FILENAME == "-" {theirs[$1, $2] = $3; next}
    ($1, $2) in theirs {printf "| %s | %s | %.9e | %.9e | %.1e |\n", $1, $2, size($3), theirs[$1, $2],
                          size(size($3) / theirs[$1, $2] - 1)}' - "$measured/reactions.tsv"
}
