#!/usr/bin/env bash
# A picture of a run: the curve of history.csv, and damage or plastic zone in the deformed body at the last step written.
#   scripts/picture.sh RESULTS_DIR [OUT]        OUT ends in .png (default RESULTS_DIR/picture.png) or .svg; an .svg of a large
#                                               body is large too: 4 kB a particle
# The curve: the first history entry across and the second one up; t across if there is one only, and the energy released by
# broken bonds (or the stored energy) up if there is none. The body: coloured by damage, else equivalent_plastic_strain, else
# plastic_multiplier, else the length of the displacement; 3-D seen obliquely from above, 2-D as a map; displacements are
# enlarged so that the largest is 4 % of the body.
set -euo pipefail

stop() {
  printf 'picture.sh: %s\n' "$*" >&2
  exit 1
}
[ $# -ge 1 ] || stop "usage: scripts/picture.sh RESULTS_DIR [OUT.png | OUT.svg]"
results=$1
picture=${2:-$results/picture.png}
h5=$results/results.h5
[ -f "$h5" ] || stop "$h5 is not there: is $results the directory of a run?"
for program in gnuplot h5dump h5ls; do
  command -v $program >/dev/null || stop "$program is missing: install gnuplot-nox and hdf5-tools"
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# columns DATASET COUNT: the dataset as text, COUNT numbers a line.
columns() {
  h5dump -y -w 0 -m '%.10g' -d "$1" -o "$work/raw" "$h5" >/dev/null
  tr -s ' ,\n' '\n' <"$work/raw" | sed '/^$/d' | paste -d' ' $(printf ' -%.0s' $(seq "$2"))
}

step=$(h5ls "$h5/steps" | awk '{print $1}' | sort -n | tail -1)
[ -n "$step" ] || stop "$h5 holds no step yet"
has() { h5ls "$h5/steps/$step" | grep -q "^$1 "; }
t=$(h5dump -a "/steps/$step/t" "$h5" | awk '/\(0\):/ {print $2}')
if has damage; then
  field=damage label="damage"
elif has equivalent_plastic_strain; then
  field=equivalent_plastic_strain label="equivalent plastic strain"
elif has plastic_multiplier; then
  field=plastic_multiplier label="plastic multiplier"
else
  field="" label="displacement, length"
fi

columns /particles/reference 3 >"$work/reference"
columns "/steps/$step/displacement" 3 >"$work/displacement"
columns /particles/volume 1 >"$work/volume"
if [ -n "$field" ]; then
  columns "/steps/$step/$field" 1 >"$work/field"
else
  awk '{print sqrt($1*$1 + $2*$2 + $3*$3)}' "$work/displacement" >"$work/field"
fi

# Projection of the deformed particles onto the picture's plane, the farthest first. Out: across, up, radius, value.
paste -d' ' "$work/reference" "$work/displacement" "$work/volume" "$work/field" | awk -v facts="$work/facts" '
  function widen(k, v) { if (NR == 1 || v < low[k]) low[k] = v; if (NR == 1 || v > high[k]) high[k] = v }
  { for (k = 1; k <= 8; ++k) value[NR, k] = $k
    for (k = 1; k <= 3; ++k) widen(k, $k)
    u = $4*$4 + $5*$5 + $6*$6; if (u > most) most = u
    if ($8 > top) top = $8 }
  END {
    flat = high[3] == low[3]
    for (k = 1; k <= 3; ++k) if (high[k] - low[k] > size) size = high[k] - low[k]
    scale = most > 0 ? 0.04 * size / sqrt(most) : 1
    if (scale > 3) { digits = 10 ^ int(log(scale) / log(10)); scale = int(scale / digits + 0.5) * digits } else scale = 1
    azimuth = -0.42; rise = 0.85                       # of the eye, radians
    ca = cos(azimuth); sa = sin(azimuth); cr = cos(rise); sr = sin(rise)
    for (i = 1; i <= NR; ++i) {
      x = value[i,1] + scale*value[i,4]; y = value[i,2] + scale*value[i,5]; z = value[i,3] + scale*value[i,6]
      if (flat) { across = x; up = y; near = 0; radius = 0.5 * sqrt(value[i,7]) }
      else {
        across = ca*x - sa*y; deep = sa*x + ca*y       # the eye looks along +deep, from above
        up = cr*z + sr*deep; near = sr*z - cr*deep; radius = 0.62 * value[i,7] ^ (1/3)
      }
      if (i == 1 || across - radius < left) left = across - radius
      if (i == 1 || across + radius > right) right = across + radius
      if (i == 1 || up - radius < below) below = up - radius
      if (i == 1 || up + radius > above) above = up + radius
      printf "%.8g %.8g %.8g %.8g %.8g\n", near, across, up, radius, value[i,8]
    }
    edge = 0.01 * size
    printf "%d %.3g %d %.6g %.8g:%.8g %.8g:%.8g\n", flat, scale, NR, (top > 0 ? top : 1), left - edge, right + edge,
           below - edge, above + edge > facts
  }' | sort -g -k1,1 | cut -d' ' -f2- >"$work/body"
read -r flat scale count top range_across range_up <"$work/facts"

# The curve: names from the CSV's header; history entries stand between t and stored_energy.
IFS=, read -ra header <"$results/history.csv"
column() { printf '%s\n' "${header[@]}" | awk -v name="$1" '$1 == name {print NR}'; }
entries=$(($(column stored_energy) - 3))
across=2 up=3
[ "$entries" -lt 2 ] || across=3 up=4
[ "$entries" -gt 0 ] || [ -z "$(column released_energy)" ] || up=$(column released_energy)
across_name=${header[across - 1]//_/ } up_name=${header[up - 1]//_/ }
awk -F, -v a=$across -v u=$up 'NR > 1 {print $a, $u}' "$results/history.csv" >"$work/curve"
title=$(h5dump -a /title "$h5" | sed -n 's/^ *(0): "\(.*\)"$/\1/p')
t_short=$(awk -v t="$t" 'BEGIN {printf "%.4g", t}')
enlarged=$([ "$scale" = 1 ] || echo ", displacements × $scale")

draw() { # draw TERMINAL FILE
  LC_ALL=C.UTF-8 gnuplot <<END
set terminal $1
set output "$2"
set encoding utf8
set multiplot
set label 1 "$title" at screen 0.5, 0.955 center font ",17" noenhanced
set border lc rgb "#505050"
set tics textcolor rgb "#303030" nomirror out scale 0.6

# left: the curve
set lmargin at screen 0.085
set rmargin at screen 0.40
set bmargin at screen 0.14
set tmargin at screen 0.87
set border 3
set grid lc rgb "#e0e0e0" lt 1
set xlabel "$across_name" noenhanced
set ylabel "$up_name" noenhanced
set format "%g"
set xtics autofreq $(awk -F, -v a=$across 'NR > 1 && ($a < 0 ? -$a : $a) > most {most = $a < 0 ? -$a : $a}
  END {print (most > 0 && (most < 1e-3 || most >= 1e6) ? "rotate by -35" : "norotate")}' "$results/history.csv")
plot "$work/curve" using 1:2 with linespoints lw 2.5 pt 7 ps 0.75 lc rgb "#1f4e79" notitle

# right: the body
unset label 1
unset grid
unset xlabel
unset ylabel
set lmargin at screen $([ "$flat" = 1 ] && echo 0.47 || echo 0.43)
set rmargin at screen 0.90
set bmargin at screen 0.08
set tmargin at screen 0.83
set size ratio -1
if ($flat) { set border 3; set format "%g"; set tics; set xlabel "x"; set ylabel "y"; set bmargin at screen 0.14 } else { unset border; unset xtics; unset ytics }
if ($flat) { set xtics norotate }
set label 2 "$label at t = $t_short$enlarged" at screen 0.67, 0.87 center noenhanced
set palette defined (0 "#e9edf0", 0.12 "#fee8b8", 0.35 "#fdb863", 0.6 "#e8743b", 0.8 "#b8262c", 1 "#5c0a2e")
set cbrange [0:$top]
set cbtics font ",11" scale 0.4
set colorbox user origin screen 0.915, screen 0.2 size screen 0.014, screen 0.5
set style fill solid 1.0 $([ "$count" -gt 10000 ] && echo noborder || echo 'border lc rgb "#8a9096"')
set xrange [$range_across]
set yrange [$range_up]
# A darker rim sets each particle off from those behind it.
plot "$work/body" using 1:2:3:4 with circles lc palette lw 0.4 notitle
unset multiplot
END
}

case $picture in
  *.svg) draw 'svg size 1500,640 font "DejaVu Sans,13" background "white"' "$picture" ;;
  *)
    if LC_ALL=C.UTF-8 gnuplot -e 'set terminal pngcairo' 2>/dev/null; then
      draw 'pngcairo size 1500,640 font "DejaVu Sans,13" linewidth 1.3 background "white"' "$picture"
    else
      draw 'png size 1500,640 font "DejaVuSans,13" linewidth 1.3' "$picture"
    fi
    ;;
esac
echo "$picture: $count particles, step $step"
