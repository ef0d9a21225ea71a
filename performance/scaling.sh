#!/bin/sh
# Seconds per step and peak memory of the program on generated humans of growing size, medians of several runs.
#
#   performance/scaling.sh BUILD_FOLDER [RUNS [program's options ...]]
set -eu
bin=$1/bin
runs=${2:-3}
shift "$(( $# < 2 ? $# : 2 ))"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for vertices in 3000 12500 27000 50000 60000 100000 200000; do
  "$bin"/pcl_symmetry_model "$folder/body.ply" --vertices "$vertices" --seed 4 --quiet
  for run in $(seq "$runs"); do
    python3 - "$folder/$run.json" "$bin/pcl_intrinsic_symmetry" "$folder/body.ply" --quiet "$@" <<'END'
import json, resource, subprocess, sys
report, command = sys.argv[1], sys.argv[2:]
subprocess.run(command + ["--report", report], check=True, stdout=subprocess.DEVNULL)
result = json.load(open(report))
result["peak"] = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
json.dump(result, open(report, "w"))
END
  done
  python3 - "$vertices" "$folder" "$runs" <<'END'
import json, statistics, sys
vertices, folder, runs = int(sys.argv[1]), sys.argv[2], int(sys.argv[3])
reports = [json.load(open(f"{folder}/{run + 1}.json")) for run in range(runs)]
steps = {s: statistics.median(r["seconds"].get(s, 0) for r in reports) for s in reports[0]["seconds"]}
work = statistics.median(r["seconds"]["total"] - r["seconds"].get("read", 0) - r["seconds"].get("write", 0) for r in reports)
peak = statistics.median(r["peak"] for r in reports)
print(f"{vertices:7d} vertices  {work:6.3f} s without reading and writing  {peak:4.0f} MB  "
      + "  ".join(f"{name} {seconds:.3f}" for name, seconds in steps.items() if name != "total"), flush=True)
END
done
