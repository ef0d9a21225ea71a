#!/bin/sh
# Fuzzes each target for a while, from generated seeds and what earlier runs have found.
#
#   test/fuzz/run.sh BUILD SECONDS [TARGET ...]
#
# BUILD is a build folder of the preset `fuzz`; corpora and findings are kept in BUILD/corpus. Exit status 1 at the first
# finding: a crash, an error of a sanitizer, ten seconds or 2 GB for one input. The same build starts the same way each
# time, so that a finding belongs to what was changed; a corpus from longer runs by hand leads further.
set -eu
[ $# -ge 2 ] || { sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2; }
build=$1 seconds=$2
shift 2
[ $# -gt 0 ] || set -- read headers options estimation

"$build/bin/fuzz_seeds" "$build/corpus"
for target in "$@"; do
  mkdir -p "$build/corpus/found"
  "$build/bin/fuzz_$target" -seed=1 -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=1024 -max_len=8192 \
    -print_final_stats=1 -verbosity=0 -artifact_prefix="$build/corpus/found/$target-" "$build/corpus/$target" 2>&1 |
    tee "$build/corpus/$target.log" | grep -v '^stat::\(slowest\|peak\)' || true
  if ls "$build/corpus/found/$target-"* >/dev/null 2>&1; then
    echo "findings in $build/corpus/found" >&2
    exit 1
  fi
done
