# Sourced by bench.sh: the machine's own limits, the loops over bonds, and the two side by side.

# measure_machine WHEN. Twice, since the guests of a host share its memory: what it gives changes by the minute.
measure_machine() {
  say "memory and multiply-adds of this machine, $1"
  {
    printf 'when %s\n' "$1"
    "$build_dir/bench_triad"
    mpirun -np 2 "$build_dir/bench_triad"
  } >>"$measured/machine.txt"
}

# loop_rows FILTER SECONDS [COMMAND ...]: loop, n, plastic, cloud, ns a directed bond, bytes a particle, milliseconds;
# tabs between. COMMAND goes before the program.
loop_rows() {
  local filter=$1 seconds=$2
  shift 2
  "$@" "$build_dir/bench_mechanics" --benchmark_filter="$filter" --benchmark_min_time="$seconds" \
    --benchmark_repetitions=3 --benchmark_report_aggregates_only=true --benchmark_format=json 2>/dev/null |
    awk -F '[:,] *' '
      function flush() {if (name ~ /_median$/) print loop "\t" ns "\t" bytes "\t" time; name = ""}
      {gsub(/^ +/, "")}
      $1 == "\"name\"" {
        flush(); bytes = "-"
        name = $0; gsub(/^"name": "|",?$/, "", name)
        split(name, part, "/"); loop = part[1]
        for (k = 2; k <= 4; ++k) {gsub(/[^0-9]/, "", part[k]); loop = loop "\t" part[k]}
      }
      $1 == "\"real_time\"" {time = $2}
      $1 == "\"ns_per_bond\"" {ns = $2}
      $1 == "\"bytes_per_particle\"" {bytes = $2}
      END {flush()}'
}

measure_loops() {
  say "loops over bonds"
  loop_rows "/n:($loop_sizes)/" "$shortest" >"$measured/loops.tsv"
  say "products, two at once on two cores"
  : >"$measured/at-once.tsv"
  mkdir -p "$scratch/0" "$scratch/1" # the program writes its cloud into TMPDIR
  local filter plastic cloud first second
  for cloud in 0 1; do
    for plastic in 0 1; do
      filter="^product/n:$two_at_once/plastic:$plastic/cloud:$cloud"
      printf 'alone\t%s\n' "$(loop_rows "$filter" 1 taskset -c 0)" >>"$measured/at-once.tsv"
      loop_rows "$filter" 1 env TMPDIR="$scratch/0" taskset -c 0 >"$scratch/first" &
      first=$!
      loop_rows "$filter" 1 env TMPDIR="$scratch/1" taskset -c 1 >"$scratch/second" &
      second=$!
      wait "$first" "$second"
      printf 'first\t%s\nsecond\t%s\n' "$(cat "$scratch/first")" "$(cat "$scratch/second")" >>"$measured/at-once.tsv"
    done
  done
}

machine_table() {
  printf '| measured | ranks at once | triad, GB/s a rank | multiply-adds, GFlop/s a rank | doubles a vector |\n'
  printf '|---|---|---|---|---|\n'
  awk '/^when/ {moment = $0; sub(/^when /, "", moment)} /^ranks/ {ranks = $2 + 0; width = $5} $1 == "triad" {triad = $2}
       $1 == "multiply-adds" {print "| " moment " | " ranks " | " triad " | " $2 " | " width " |"}' "$measured/machine.txt"
}

loop_tables() {
  printf 'ns of CPU time a directed bond, one rank; median of three.\n\n'
  printf '| loop | n | lattice, elastic | lattice, plastic | cloud, elastic | cloud, plastic |\n|---|---|---|---|---|---|\n'
  awk -F '\t' '
    $1 !~ /assembl/ {key = $1 " | " $2; if (!(key in seen)) order[++count] = key; seen[key] = 1; ns[key, $4, $3] = $5}
    function cell(key, c, p) {return (key, c, p) in ns ? sprintf("%.2f", ns[key, c, p]) : ""}
    END {
      for (k = 1; k <= count; ++k) {
        name = order[k]; gsub(/_/, " ", name)
        print "| " name " | " cell(order[k], 0, 0) " | " cell(order[k], 0, 1) " | " cell(order[k], 1, 0) " | " \
          cell(order[k], 1, 1) " |"
      }
    }' "$measured/loops.tsv"
  printf '\nAgainst the assembled tangent, 16³, lattice, same run:\n\n'
  printf '| | elastic | plastic |\n|---|---|---|\n'
  awk -F '\t' '$2 == 16 && $4 == 0 {ns[$1, $3] = $5; bytes[$1, $3] = $6}
    function row(name, e, p) {print "| " name " | " e " | " p " |"}
    function f(x) {return sprintf("%.1f", x)}
    END {
      row("sparse product, ns a directed bond", f(ns["assembled_product", 0]), f(ns["assembled_product", 1]))
      row("sparse product over matrix-free product", f(ns["assembled_product", 0] / ns["product", 0]), \
          f(ns["assembled_product", 1] / ns["product", 1]))
      row("filling the values once, in matrix-free products", f(ns["assembly", 0] / ns["product", 0]), \
          f(ns["assembly", 1] / ns["product", 1]))
      row("matrix, bytes a particle", int(bytes["assembly", 0]), int(bytes["assembly", 1]))
      row("arrays of the matrix-free product, bytes a particle", int(bytes["linearise", 0]), int(bytes["linearise", 1]))
    }' "$measured/loops.tsv"
  printf '\nTwo products at once, n = %s, each pinned to a core of its own, ns of CPU time a directed bond:\n\n' "$(awk -F '\t' 'NR == 1 {print $3}' "$measured/at-once.tsv")"
  printf '| body | alone | two at once | slower by |\n|---|---|---|---|\n'
  awk -F '\t' '{body = ($5 == 0 ? "lattice" : "cloud") ", " ($4 == 0 ? "elastic" : "plastic")}
    $1 == "alone" {alone = $6} $1 == "first" {first = $6}
    $1 == "second" {printf "| %s | %.2f | %.2f, %.2f | %.2f |\n", body, alone, first, $6, (first + $6) / 2 / alone}' \
    "$measured/at-once.tsv"
}

# Operations and bytes a directed bond of one product as docs/performance.md counts them, against the machine's limits.
roofline_table() {
  printf '| product | n | ns | flops | GFlop/s | of the peak | bytes | GB/s | of the triad | ns at the peak | ns at the triad |\n'
  printf '|---|---|---|---|---|---|---|---|---|---|---|\n'
  awk -F '\t' '
    FILENAME ~ /machine/ {  # the best of the moments
      split($0, word, " ")
      if (word[1] == "ranks") alone = word[2] + 0 == 1
      if (alone && word[2] > limit[word[1]]) limit[word[1]] = word[2] + 0
      next
    }
    BEGIN {
      flops["00"] = 52.5; flops["10"] = 61.5; flops["01"] = 60; flops["11"] = 72.5  # plastic, cloud
      bytes["00"] = 3; bytes["10"] = 19; bytes["01"] = 15; bytes["11"] = 31
    }
    $1 == "product" {
      kind = $3 $4
      printf "| %s, %s | %s | %.2f | %.1f | %.1f | %.0f %% | %d | %.1f | %.0f %% | %.2f | %.2f |\n",
        ($4 == 0 ? "lattice" : "cloud"), ($3 == 0 ? "elastic" : "plastic"), $2, $5, flops[kind], flops[kind] / $5,
        100 * flops[kind] / $5 / limit["multiply-adds"], bytes[kind], bytes[kind] / $5,
        100 * bytes[kind] / $5 / limit["triad"], flops[kind] / limit["multiply-adds"], bytes[kind] / limit["triad"]
    }' "$measured/machine.txt" "$measured/loops.tsv"
}
