#!/usr/bin/env bash
# What ParaView shows against what results.h5 holds: every component of every field of every step, by its name and its values,
# through the three XDMF readers of ParaView.
#   scripts/paraview.sh [BINARY]      BINARY: build/perinox
# Installs python3-paraview (apt, some 900 MB with what it needs) and python3-h5py where they are missing; needs the rights
# for that. Exit status 1 if a name or a value differs.
set -euo pipefail
cd "$(dirname "$0")/.."
perinox=$(realpath "${1:-build/perinox}")
[ -x "$perinox" ] || { echo "$perinox is no program: build perinox first" >&2; exit 2; }
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
if ! dpkg -s python3-paraview python3-h5py > /dev/null 2>&1; then
  apt-get update -q
  DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends python3-paraview python3-h5py
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Every tensor component another number: sheared and stretched bodies, in space and in both plane states.
deck() { # dimension, end of the box, displacement
  cat << DECK
dimension: $1
body: [{name: b, shape: {box: {min: [0, 0$2], max: [5, 5$3]}}, spacing: 1, material: m}]
horizon: {ratio: 2.015}
materials: {m: {model: elastic-plastic, young_modulus: 1000, poisson_ratio: 0.3, yield_stress: {tension: 8}, damage: {critical_stretch: 0.5}}}
boundary: [{set: all, displacement: {$4}}]
steps: {end: 1, count: 2}
output: {fields: [displacement, force, dilatation, stress, strain, von_mises_stress, damage, plastic_multiplier]}
DECK
}
deck 3 ", 0" ", 5" 'x: "(0.01*x + 0.02*y + 0.03*z)*t", y: "(0.004*y + 0.005*z + 1e-3*x*x)*t", z: "0.006*z*t"' > "$work/space.yaml"
deck plane-strain "" "" 'x: "(0.01*x + 0.02*y)*t", y: "(0.004*y + 1e-3*x*x)*t"' > "$work/strain.yaml"
deck plane-stress "" "" 'x: "(0.01*x + 0.02*y)*t", y: "(0.004*y + 1e-3*x*x)*t"' > "$work/stress.yaml"
for name in space strain stress; do
  "$perinox" run "$work/$name.yaml" --output "$work/$name" --quiet
done
/usr/bin/python3 scripts/paraview/compare.py "$work"/{space,strain,stress}
