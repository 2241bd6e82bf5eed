#!/usr/bin/env bash
# Builds the libFuzzer targets into build-fuzz/ and runs each for SECONDS_EACH seconds (default 1800) or 10^7 executions,
# whichever comes first, starting from tests/fuzz/corpus and what make_corpus writes. Prints the executions of each and
# how many a second. Findings lie in build-fuzz/findings. The exit status is 1 if there are any, and if a target is too
# slow: below 10^5 executions in 1800 s, or that share of them in a shorter time.
# Usage: tests/fuzz/run_fuzzers.sh [SECONDS_EACH [READER...]]      READER: the name of a *_fuzzer.cpp without _fuzzer.cpp
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
build="$root/build-fuzz"
seconds_each=${1:-1800}
readers=("${@:2}")
if ((${#readers[@]} == 0)); then
  for source in "$root"/tests/fuzz/*_fuzzer.cpp; do
    readers+=("$(basename "$source" _fuzzer.cpp)")
  done
fi
most_executions=10000000
pocl=/etc/OpenCL/vendors/pocl.icd
least_executions=$((100000 * (seconds_each < 1800 ? seconds_each : 1800) / 1800))

launcher=()
if command -v ccache >/dev/null; then
  launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi
cmake -S "$root" -B "$build" -G Ninja "${launcher[@]}" \
  -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=RelWithDebInfo -DOFFING_BUILD_FUZZERS=ON \
  -DOFFING_SANITIZE=address,undefined,fuzzer-no-link \
  -DOFFING_BUILD_TESTS=OFF -DOFFING_BUILD_BENCH=OFF -DOFFING_BUILD_MESH_TOOLS=OFF -DOFFING_BUILD_VIEWER=OFF \
  -DOFFING_INSTALL=OFF >/dev/null
cmake --build "$build" --target fuzzers -- ${OFFING_JOBS:+-j "$OFFING_JOBS"}

# Files of readers that take a path are written here.
in_memory=/dev/shm
[[ -d "$in_memory" && -w "$in_memory" ]] || in_memory=${TMPDIR:-/tmp}
TMPDIR=$(mktemp -d -p "$in_memory" offing-fuzz.XXXXXX)
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT

seeds="$build/seeds"
rm -rf "$seeds"
"$build/fuzz/make_corpus" "$seeds" "$root/scenes"
if command -v vdb_tool >/dev/null; then  # Offing writes no compressed volumes
  cp "$seeds/vdb/single" "$TMPDIR/plain.vdb"
  vdb_tool -quiet -read "$TMPDIR/plain.vdb" -write codec=blosc "$TMPDIR/blosc.vdb"
  mv "$TMPDIR/blosc.vdb" "$seeds/vdb/blosc"
fi

status=0
mkdir -p "$build/findings"
for reader in "${readers[@]}"; do
  grown="$build/corpus/$reader"  # what this run finds; the corpus in the repository stays as it is
  corpora=("$grown")
  for folder in "$root/tests/fuzz/corpus/$reader" "$seeds/$reader"; do
    if [[ -d "$folder" ]]; then corpora+=("$folder"); fi
  done
  if ((${#corpora[@]} < 2)); then
    echo "fuzz: $reader: NO CORPUS in $root/tests/fuzz/corpus or $seeds"
    status=1
    continue
  fi
  mkdir -p "$grown"
  longest=8192 memory_mb=2048 block_mb=1536 most_of_a_process=$most_executions
  drivers=()
  case "$reader" in
    c)  # PoCL alone: the sanitizer cannot name leaks of other drivers, which the loader unloads
      if [[ -f "$pocl" ]]; then drivers=(OCL_ICD_VENDORS="$pocl"); fi
      ;;
    exr) block_mb=65536 ;;  # OpenEXR reserves memory that it does not touch before it reads
    raster) memory_mb=4096 block_mb=65536 ;;  # the largest map has 2 GB
    vdb) longest=32768 most_of_a_process=8000 ;;  # the smallest volume has 10 kB; OpenVDB leaks nodes of what it refuses
  esac
  log="$build/$reader.log"
  : >"$log"
  start=$SECONDS executions=0 has_finding=false
  while ((executions < most_executions && SECONDS - start < seconds_each)); do
    if ! env "${drivers[@]}" OFFING_CACHE_DIR="$build/kernel_cache" UBSAN_OPTIONS=print_stacktrace=1 \
      LSAN_OPTIONS="suppressions=$root/tests/house/leaks_of_drivers.txt:print_suppressions=0" \
      "$build/fuzz/${reader}_fuzzer" "${corpora[@]}" \
      -max_total_time="$((seconds_each - (SECONDS - start)))" -runs="$most_of_a_process" -max_len="$longest" \
      -timeout=20 -rss_limit_mb="$memory_mb" -malloc_limit_mb="$block_mb" \
      -artifact_prefix="$build/findings/$reader-" -print_final_stats=1 -verbosity=0 2>>"$log"; then
      has_finding=true
      break
    fi
    executions=$((executions + $(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -n 1)))
  done
  if $has_finding; then
    status=1
    echo "fuzz: $reader: FINDING after $executions executions, see $log and $build/findings"
    tail -n 40 "$log"
    continue
  fi
  echo "fuzz: $reader: $executions executions, $((executions / (SECONDS - start > 0 ? SECONDS - start : 1)))/s, no finding"
  if ((executions < least_executions)); then
    status=1
    echo "fuzz: $reader: TOO SLOW, expected $least_executions executions or more"
  fi
done
exit "$status"
