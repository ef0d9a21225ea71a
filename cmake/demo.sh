#!/bin/sh
# All set-up on a bare Debian 12, then the main job: installs what is missing, builds the programs, grows a human body in
# a strong pose, finds its symmetry and compares it with the true one.
set -eu
cd "$(dirname "$0")/.."

cmake/install_packages.sh
cmake --preset release
cmake --build --preset release --target pcl_symmetry_model pcl_intrinsic_symmetry pcl_symmetry_benchmark

bin=build/release/bin
results=build/demo
mkdir -p "$results"

echo
echo "== A body and its true mirror partners"
$bin/pcl_symmetry_model "$results/body.ply" --body human --vertices 12500 --bend 1 --seed 11 --truth "$results/truth.txt"

echo
echo "== Its symmetry, found from the triangles alone"
$bin/pcl_intrinsic_symmetry "$results/body.ply" --output "$results/labelled.ply" --map "$results/map.csv" \
  --correspondences "$results/correspondences.csv" --axis "$results/axis.ply" --report "$results/report.json" \
  --picture "$results/picture.png"

echo
echo "== Compared with the truth"
$bin/pcl_symmetry_benchmark --score "$results/map.csv" --mesh "$results/body.ply" --truth "$results/truth.txt"

echo
echo "The results are in $PWD/$results:"
while read -r file content; do
  printf '  %-20s %s\n' "$file" "$content"
done <<END
picture.png front and back: sides, axis, partner lines
labelled.ply the body with colour, label, partner, confidence and region per point
axis.ply the curve between the two sides
map.csv the partner of every point
correspondences.csv the sparse matches
report.json status, confidence, parameters, seconds per step
body.ply the input
truth.txt its true partners, counted from 1
END
