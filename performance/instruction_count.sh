#!/bin/sh
# Counts the instructions of a default run on a small generated body and compares them with the recorded figure: more
# than 15 % above it is a failure. Unlike seconds the count is the same on a busy machine. Needs valgrind; takes about
# 15 seconds. The baseline's kernels are counted, which every machine has.
#
#   performance/instruction_count.sh BUILD_FOLDER            compare
#   performance/instruction_count.sh BUILD_FOLDER --record   write the figure down after a change that is meant
set -eu
bin=$1/bin
recorded=$(dirname "$0")/instruction_count.txt

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$bin"/pcl_symmetry_model "$folder/body.ply" --vertices 3000 --seed 4 --quiet
PCL_SYMMETRY_INSTRUCTION_SET=baseline valgrind --tool=callgrind --callgrind-out-file="$folder/profile" \
  "$bin"/pcl_intrinsic_symmetry "$folder/body.ply" --threads 1 --quiet >"$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
count=$(awk '/^(summary|totals):/ { print $2; exit }' "$folder/profile")

if [ "${2:-}" = --record ]; then
  echo "$count" >"$recorded"
fi
limit=$(awk '{ printf "%.0f", 1.15 * $1 }' "$recorded")
echo "instructions: $count, recorded: $(cat "$recorded"), limit: $limit"
[ "$count" -le "$limit" ] || { echo "the default run costs over 15 % more instructions than recorded" >&2; exit 1; }
