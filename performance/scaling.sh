#!/bin/sh
# Seconds per step and peak memory of the program on generated humans of growing size, medians of several runs; then the
# exponent with which time grows, and a plot if a file for it is given.
#
#   performance/scaling.sh BUILD_FOLDER [RUNS [PLOT.svg] [program's options ...]]
set -eu
bin=$1/bin
runs=${2:-3}
shift "$(( $# < 2 ? $# : 2 ))"
plot=
case ${1:-} in
*.svg)
  plot=$1
  shift
  ;;
esac
tools=$(dirname "$0")

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for vertices in 12500 27000 50000 60000 100000 200000 500000 1000000; do
  "$bin"/pcl_symmetry_model "$folder/body.ply" --vertices "$vertices" --seed 4 --quiet
  for run in $(seq "$runs"); do
    python3 "$tools/scaling.py" run "$folder/$vertices.$run.json" "$bin/pcl_intrinsic_symmetry" "$folder/body.ply" --quiet "$@"
  done
  python3 "$tools/scaling.py" row "$vertices" "$folder/$vertices".*.json | tee -a "$folder/rows"
done
python3 "$tools/scaling.py" fit "$folder/rows" $plot
