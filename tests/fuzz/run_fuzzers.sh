#!/usr/bin/env bash
# Builds the libFuzzer targets into build-fuzz/ and runs each for SECONDS_EACH seconds (default 300), starting from
# tests/fuzz/corpus. Findings lie in build-fuzz/findings; the exit status is 1 if there are any.
# Usage: tests/fuzz/run_fuzzers.sh [SECONDS_EACH [READER...]]      READER: datawell ndbc netcdf swan ww3 gltf obj off ply stl
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
build="$root/build-fuzz"
seconds_each=${1:-300}
readers=("${@:2}")
if ((${#readers[@]} == 0)); then
  readers=(datawell ndbc netcdf swan ww3 gltf obj off ply stl)
fi

cmake -S "$root" -B "$build" -G Ninja \
  -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=RelWithDebInfo -DOFFING_BUILD_FUZZERS=ON \
  -DOFFING_SANITIZE=address,undefined,fuzzer-no-link \
  -DOFFING_BUILD_TESTS=OFF -DOFFING_BUILD_BENCH=OFF -DOFFING_BUILD_MESH_TOOLS=OFF -DOFFING_INSTALL=OFF >/dev/null
cmake --build "$build" --target fuzzers

status=0
mkdir -p "$build/findings"
for reader in "${readers[@]}"; do
  grown="$build/corpus/$reader"  # what this run finds; the corpus in the repository stays as it is
  mkdir -p "$grown"
  echo "fuzz: $reader, $seconds_each s"
  if ! "$build/fuzz/${reader}_fuzzer" "$grown" "$root/tests/fuzz/corpus/$reader" \
    -max_total_time="$seconds_each" -max_len=8192 -timeout=20 -rss_limit_mb=2048 -malloc_limit_mb=1536 \
    -artifact_prefix="$build/findings/$reader-" -print_final_stats=1 -verbosity=0 2>"$build/$reader.log"; then
    status=1
    echo "fuzz: $reader: FINDING, see $build/$reader.log and $build/findings"
    tail -n 40 "$build/$reader.log"
  else
    grep -E "number_of_executed_units|average_exec_per_sec" "$build/$reader.log" || true
  fi
done
exit "$status"
