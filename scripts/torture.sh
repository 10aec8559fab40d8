#!/usr/bin/env bash
# Faults on purpose: runs are killed, stopped, starved of disk, and their checkpoints damaged; each must go on from its
# last checkpoint and end with the numbers of a run that nothing happened to.
#   scripts/torture.sh [KILLS [BINARY]]     KILLS: kill -9 at so many random moments (20); BINARY: build/perinox
# Prints a table; exit status 1 if a step was lost or an answer is wrong. Takes some minutes. Needs mpirun; the full disk
# needs the right to mount a tmpfs (root), and is left out without it.
set -u
cd "$(dirname "$0")/.." || exit 2
kills=${1:-20}
perinox=$(realpath "${2:-build/perinox}")
[ -x "$perinox" ] || { echo "$perinox is no program: build perinox first" >&2; exit 2; }
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
work=$(mktemp -d) || exit 2
mounted=""
finish() { [ -n "$mounted" ] && umount "$mounted"; rm -rf "$work"; }
trap finish EXIT
cd "$work" || exit 2

cat > block.yaml <<'DECK'
title: tortured block
dimension: 3
body: [{name: block, shape: {box: {min: [0, 0, 0], max: [7, 7, 16]}}, spacing: 1, material: metal}]
horizon: {ratio: 3.015}
materials: {metal: {model: elastic-plastic, bulk_modulus: 67.5e3, shear_modulus: 25.9e3, yield_stress: {tension: 203.1}}}
sets: {foot: {where: "z < 3"}, head: {where: "z > 13"}}
boundary:
  - {set: foot, displacement: {x: 0, y: 0, z: 0}}
  - {set: head, displacement: {x: "0.02*t", y: 0, z: "0.12*sin(4*t)"}}
steps: {end: 1, count: 40}
output: {fields: [displacement, force, plastic_multiplier], checkpoint_every: 1}
history: [{name: pull, reaction: head, component: z}, {name: plastic, yielded: all}]
DECK

# A bar that snaps: bonds break, 270 time steps until it is at rest in two pieces, then steps again.
cat > bar.yaml <<'DECK'
title: tortured bar
dimension: plane-stress
body: [{name: bar, shape: {box: {min: [0, 0], max: [60, 10]}}, spacing: 1, material: brittle}]
horizon: {ratio: 3.015}
cracks: [{segment: {start: [30, 0], end: [30, 3]}}]
materials: {brittle: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3, density: 1.0e-9, damage: {energy_release_rate: 0.05}}}
sets: {wall: {where: "x < 3"}, pulled: {where: "x > 57"}}
boundary:
  - {set: wall, displacement: {x: 0, y: 0}}
  - {set: pulled, force: {x: "60*t"}}
fracture: {unbreakable: [wall, pulled]}
steps: {end: 1, count: 20}
output: {fields: [displacement, damage], checkpoint_every: 1, checkpoint_seconds: 0.01}
history: [{name: stretch, displacement: pulled, component: x}]
DECK
# Blocks that collide, flow and break in time, in few rows of many time steps.
cat > blocks.yaml <<'DECK'
title: tortured blocks
dimension: 3
body:
  - {name: left, shape: {box: {min: [0, 0, 0], max: [12, 6, 6]}}, spacing: 1, material: steel}
  - {name: right, shape: {box: {min: [12.5, 0, 0], max: [24.5, 6, 6]}}, spacing: 1, material: steel}
bond_bodies: false
horizon: {ratio: 2.015}
materials: {steel: {model: elastic-plastic, young_modulus: 210e3, poisson_ratio: 0.3, density: 7.85e-9, yield_stress: {tension: 400}, damage: {critical_stretch: 0.02}}}
dynamics: explicit
explicit: {contact: {distance: 0.9}}
initial_velocity: [{set: left, velocity: {x: 1e5, z: 2e4}}, {set: right, velocity: {x: -1e5}}]
boundary: []
steps: {end: 6e-5, count: 4}
output: {fields: [displacement, velocity, damage], checkpoint_every: 1, checkpoint_seconds: 0.01}
history: [{name: left, displacement: left, component: x}]
DECK

deck=block
start() { # ranks, arguments
  local ranks=$1
  shift
  if [ "$ranks" -gt 1 ]; then mpirun --oversubscribe -np "$ranks" "$perinox" run $deck.yaml "$@"
  else "$perinox" run $deck.yaml "$@"; fi
}
numbers() { # without the times
  awk -F, 'NR == 1 {for (k = 1; k <= NF; ++k) keep[k] = $k !~ /^seconds/}
    {line = ""; for (k = 1; k <= NF; ++k) if (keep[k]) line = line "," $k; print line}' "$1/history.csv"
}
rows() { cat "$1/history.csv" 2> /dev/null | grep -c '^[1-9].*[0-9]$'; } # of steps; 0 is the start

# The run of the deck that nothing happens to, and the seconds it takes.
undisturbed() {
  local begun
  begun=$(date +%s.%N)
  for ranks in 1 2; do
    rm -rf "whole$ranks"
    start $ranks --output "whole$ranks" --quiet || { echo "the run that nothing happens to fails" >&2; exit 2; }
  done
  took=$(echo "$(date +%s.%N) $begun" | awk '{print ($1 - $2) / 2}')
}

declare -A tried resumed anew redone lost wrong
order=()
case_of() { [ -n "${tried[$1]:-}" ] || { order+=("$1"); tried[$1]=0 resumed[$1]=0 anew[$1]=0 redone[$1]=0 lost[$1]=0 wrong[$1]=0; }; }

# Goes on with what a fault has left in a directory, to the end, and compares: fault, directory, ranks.
go_on() {
  local fault=$1 directory=$2 ranks=$3
  local had text from arguments=()
  had=$(rows "$directory")
  if [ -f "$directory/checkpoint.h5" ]; then
    arguments=(--restart "$directory/checkpoint.h5")
  else
    arguments=(--output "$directory")
    anew[$fault]=$((${anew[$fault]} + 1))
    # The first step may be on its way to the disk; another must not be there without a checkpoint.
    [ "$had" -gt 1 ] && lost[$fault]=$((${lost[$fault]} + had - 1))
  fi
  if ! text=$(start "$ranks" "${arguments[@]}" 2>&1); then
    echo "$fault: $text" | tail -3 >&2
    wrong[$fault]=$((${wrong[$fault]} + 1))
    return
  fi
  if [ "${arguments[0]}" = --restart ]; then
    resumed[$fault]=$((${resumed[$fault]} + 1))
    from=$(echo "$text" | sed -n 's/^restart after step \([0-9]*\),.*/\1/p')
    # Within a step nothing that was written is done again.
    [ -n "$from" ] || from=$(($(echo "$text" | sed -n 's/^restart within step \([0-9]*\),.*/\1/p') - 1))
    # A row is written before its checkpoint: the last one may have to be done again.
    redone[$fault]=$((${redone[$fault]} + (had > from ? had - from : 0)))
    [ $((had - from)) -gt 1 ] && lost[$fault]=$((${lost[$fault]} + had - from - 1))
  fi
  if ! cmp -s <(numbers "$directory") <(numbers "whole$ranks"); then
    echo "$fault: another history than that of the run that nothing happened to" >&2
    wrong[$fault]=$((${wrong[$fault]} + 1))
  elif command -v h5diff > /dev/null && ! h5diff "$directory/results.h5" "whole$ranks/results.h5" > /dev/null; then
    echo "$fault: other fields than those of the run that nothing happened to" >&2
    h5diff "$directory/results.h5" "whole$ranks/results.h5" 2>&1 | tail -3 >&2
    echo "$text" | grep -i "results.h5" >&2
    wrong[$fault]=$((${wrong[$fault]} + 1))
  fi
}

moment() { awk -v seed=$RANDOM$RANDOM -v most="$took" -v begin="$1" 'BEGIN {srand(seed); print begin + rand() * most}'; }

hit() { # fault, ranks, signal
  case_of "$1"
  tried[$1]=$((${tried[$1]} + 1))
  rm -rf hit
  start "$2" --output "$work/hit" --quiet > /dev/null 2>&1 &
  local run=$!
  sleep "$(moment "$([ "$2" -gt 1 ] && echo 0.8 || echo 0.15)")"
  # The program itself, or one of the ranks under mpirun; the directory's name is this script's alone.
  local whom
  whom=$(pgrep -f "^$perinox run $deck.yaml --output $work/hit" | shuf -n 1)
  [ -n "$whom" ] && kill -"$3" "$whom" 2> /dev/null
  wait $run 2> /dev/null
  go_on "$1" hit "$2"
}

for deck in bar blocks block; do
  undisturbed
  [ $deck = block ] && break
  for ((k = 0; k < (kills + 1) / 2; ++k)); do hit "kill -9, $deck" 1 KILL; done
  for ((k = 0; k < (kills + 7) / 8; ++k)); do hit "kill -9 of a rank of 2, $deck" 2 KILL; done
  for ((k = 0; k < (kills + 7) / 8; ++k)); do hit "SIGTERM, $deck" 1 TERM; done
  for ((k = 0; k < (kills + 7) / 8; ++k)); do hit "SIGUSR1 on 2 ranks, $deck" 2 USR1; done
done
for ((k = 0; k < kills; ++k)); do hit "kill -9" 1 KILL; done
for ((k = 0; k < (kills + 3) / 4; ++k)); do hit "kill -9 of a rank of 2" 2 KILL; done
for ((k = 0; k < (kills + 3) / 4; ++k)); do hit "SIGTERM" 1 TERM; done
for ((k = 0; k < (kills + 3) / 4; ++k)); do hit "SIGINT" 1 INT; done
for ((k = 0; k < (kills + 7) / 8; ++k)); do hit "SIGUSR1 on 2 ranks" 2 USR1; done

# A checkpoint of some step, to be damaged.
rm -rf base
start 1 --output base --quiet --set steps.time_limit=0.5 > /dev/null 2>&1
refuse() { # fault, how the copy is damaged
  case_of "$1"
  tried[$1]=$((${tried[$1]} + 1))
  rm -rf hit
  cp -r base hit
  eval "$2"
  start 1 --restart hit/checkpoint.h5 --quiet > said 2>&1
  if [ $? -ne 2 ] || ! grep -q "checkpoint" said; then
    echo "$1: not refused: $(tail -1 said)" >&2
    wrong[$1]=$((${wrong[$1]} + 1))
  fi
  cp base/checkpoint.h5 hit/checkpoint.h5
  go_on "$1" hit 1
}
bytes=$(stat -c %s base/checkpoint.h5)
for ((k = 0; k < (kills + 3) / 4; ++k)); do
  refuse "checkpoint truncated" "truncate -s $(awk -v n="$bytes" -v seed=$RANDOM 'BEGIN {srand(seed); print int(rand() * n)}') hit/checkpoint.h5"
  refuse "checkpoint, a bit flipped" "flip=$(awk -v n="$bytes" -v seed=$RANDOM 'BEGIN {srand(seed); print int(rand() * n)}')
    old=\$(od -An -tu1 -j \$flip -N1 hit/checkpoint.h5)
    printf \"\\\\x\$(printf %02x \$((old ^ (1 << (RANDOM % 8)))))\" | dd of=hit/checkpoint.h5 bs=1 seek=\$flip conv=notrunc status=none"
done

# A directory that cannot be written to is refused before anything runs.
fault="directory is read-only"
case_of "$fault"
tried[$fault]=1
rm -rf hit
cp -r base hit
if [ "$(id -u)" -eq 0 ] && mount --bind hit hit 2> /dev/null; then
  mounted=$work/hit
  mount -o remount,ro,bind hit
  start 1 --restart hit/checkpoint.h5 --quiet > said 2>&1
  status=$?
  umount hit
  mounted=""
else
  chmod a-w hit
  start 1 --restart hit/checkpoint.h5 --quiet > said 2>&1
  status=$?
  chmod u+w hit
fi
if [ $status -ne 2 ]; then
  echo "$fault: exit status $status: $(tail -1 said)" >&2
  wrong[$fault]=1
fi
go_on "$fault" hit 1

# A disk that fills up in the middle of the run.
fault="disk full"
mkdir -p full
if mount -t tmpfs -o size=4m tmpfs full 2> /dev/null; then
  mounted=$work/full
  for size in 900k 1200k 1600k 2000k 2400k; do
    case_of "$fault"
    tried[$fault]=$((${tried[$fault]} + 1))
    rm -rf full/run
    mount -o remount,size=$size full
    start 1 --output full/run --quiet > said 2>&1
    status=$?
    if [ $status -ne 1 ] || ! grep -q "No space left" said; then
      echo "$fault: exit status $status: $(tail -1 said)" >&2
      wrong[$fault]=$((${wrong[$fault]} + 1))
    fi
    mount -o remount,size=64m full
    go_on "$fault" full/run 1
  done
  umount full
  mounted=""
fi

printf '\n%-31s %6s %8s %10s %12s %11s %14s\n' fault tried resumed "begun anew" "steps redone" "steps lost" "wrong answers"
bad=0
for fault in "${order[@]}"; do
  printf '%-31s %6d %8d %10d %12d %11d %14d\n' "$fault" "${tried[$fault]}" "${resumed[$fault]}" "${anew[$fault]}" \
    "${redone[$fault]}" "${lost[$fault]}" "${wrong[$fault]}"
  bad=$((bad + ${lost[$fault]} + ${wrong[$fault]}))
done
[ $bad -eq 0 ]
