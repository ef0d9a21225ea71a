#!/bin/sh
# How often generated bodies end as "no symmetry", and with what confidence the rest: symmetric ones should never,
# asymmetric ones always.
#
#   performance/refusals.sh BUILD_FOLDER [SEEDS [FIRST_SEED [model program's options ...]]]
#   performance/refusals.sh build/release 10 11 --no-faces
set -eu
bin=$1/bin
seeds=${2:-10}
first=${3:-11}
shift "$(( $# < 3 ? $# : 3 ))"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Prints "status confidence" of one body.
run() {
  body=$1
  seed=$2
  shift 2
  "$bin"/pcl_symmetry_model "$folder/body.ply" --body "$body" --vertices 8000 --retriangulate --seed "$seed" --quiet "$@"
  status=0
  "$bin"/pcl_intrinsic_symmetry "$folder/body.ply" --quiet --report "$folder/report.json" > /dev/null || status=$?
  sed -n 's/^  "confidence": \([^,]*\),*$/\1/p' "$folder/report.json" | sed "s/^/$status /"
}

echo "body           refused  confidence: least, median, largest"
for body in human quadruped bird spider missing-arm third-arm missing-leg hand helix terrain; do
  seed=$first
  while [ "$seed" -lt "$((first + seeds))" ]; do
    run "$body" "$seed" "$@"
    seed=$((seed + 1))
  done | sort -k 2 -g | awk -v body="$body" '
    $1 == 3 { refused++ }
    { confidence[NR] = $2 }
    END {
      printf "%-12s %4d/%-4d  %.3f  %.3f  %.3f\n", body, refused, NR, confidence[1], confidence[int((NR + 1) / 2)],
             confidence[NR]
    }'
done
