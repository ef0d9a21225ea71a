#!/bin/sh
# Says whether two builds give the same bytes: map (partners, confidences), labelled surface, axis curve, sparse matches,
# status and confidence, of every surface under some folders, as mesh and as cloud, by both methods. For changes that are
# meant to leave results alone.
#
#   performance/compare_maps.sh BEFORE AFTER FOLDER ...
#   JOBS=4 performance/compare_maps.sh before.txt build/release data/
#
# BEFORE and AFTER are build folders, or files of digests: those of a build folder are kept in the current folder as
# before_digests.txt and after_digests.txt, so that a later comparison need not run it again. Exit status 1 if anything differs.
set -eu
export LC_ALL=C

# One line "surface input method exit-status status confidence digest" for one run; its arguments are those words.
if [ "${1:-}" = --run ]; then
  bin=$2 surface=$3 input=$4 method=$5
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  [ "$input" = cloud ] && as_cloud=--as-cloud || as_cloud=
  status=0
  # shellcheck disable=SC2086 # no argument, or one
  timeout 600 "$bin"/pcl_intrinsic_symmetry "$surface" --quiet --threads 1 --method "$method" $as_cloud --map "$folder/map.csv" \
    --output "$folder/labelled.ply" --axis "$folder/axis.ply" --correspondences "$folder/matches.csv" \
    --report "$folder/report.json" >/dev/null 2>&1 || status=$?
  outcome=$(sed -n 's/^  "\(status\|confidence\)": "*\([^",]*\)"*,*$/\2/p' "$folder/report.json" 2>/dev/null | tr '\n' ' ')
  digest=$(cd "$folder" && cat labelled.ply map.csv axis.ply matches.csv 2>/dev/null | sha256sum | cut -c 1-16)
  echo "$surface $input $method $status $outcome$digest"
  exit 0
fi

[ $# -ge 3 ] || { sed -n '2,10s/^# \{0,1\}//p' "$0" >&2; exit 2; }
before=$1 after=$2
shift 2

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
find "$@" -type f \( -name '*.off' -o -name '*.obj' -o -name '*.ply' -o -name '*.stl' -o -name '*.pcd' \) | sort |
  while read -r surface; do
    for input in mesh cloud; do
      for method in robust staged; do
        printf '%s\n' "$surface" "$input" "$method"
      done
    done
  done >"$folder/runs"

for side in before after; do
  eval "of=\$$side"
  if [ -d "$of" ]; then
    xargs -d '\n' -n 3 -P "${JOBS:-2}" "$0" --run "$of/bin" <"$folder/runs" | sort >"${side}_digests.txt"
    of=${side}_digests.txt
  fi
  awk 'NR == FNR { if (FNR % 3 == 1) surfaces[$0]; next } $1 in surfaces' "$folder/runs" "$of" >"$folder/$side"
done

echo "$(wc -l <"$folder/before") runs before, $(wc -l <"$folder/after") after, over $(($(wc -l <"$folder/runs") / 3 / 4)) surfaces"
diff "$folder/before" "$folder/after" && echo "same bytes"
