#!/usr/bin/env bash
# Fuzzes a reader: tests/fuzz/run.sh case|checkpoint SECONDS. Builds the preset fuzz (clang).
# Starts from the corpus committed here; what it finds goes to out/fuzz/TARGET, and an input that
# breaks a promise to out/fuzz/TARGET-failures, when it ends with an error. Before a commit:
#   build/fuzz/tests/fuzz/fuzz_TARGET -set_cover_merge=1 -use_counters=0 NEW_CORPUS out/fuzz/TARGET
source "$(dirname "${BASH_SOURCE[0]}")/../lib.sh"

target=${1:?case or checkpoint}
seconds=${2:?how long}
here=$rgimp_root/tests/fuzz
found=$rgimp_root/out/fuzz/$target

cd "$rgimp_root"
step "Build the fuzzer (cmake --build --preset fuzz)"
cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --target "fuzz_$target"
mkdir -p "$found" "$found-failures"
step "Fuzz the reader of ${target}s for $seconds s; a failing input is kept in $found-failures"
"build/fuzz/tests/fuzz/fuzz_$target" -dict="$here/$target.dict" -max_len=24000 -timeout=10 \
  -malloc_limit_mb=500 -max_total_time="$seconds" -print_final_stats=1 \
  -artifact_prefix="$found-failures/" "$found" "$here/corpus/$target" >"$found.log" 2>&1 ||
  { tail -40 "$found.log" && fail "the fuzzer stopped early; the whole story is in $found.log"; }
grep -E "DONE|^stat::number_of_executed_units" "$found.log"
