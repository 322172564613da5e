#!/usr/bin/env bash
# Measures this machine: bench/run.sh [--quick] | bench/run.sh --keep NAME
# Installs what is missing, builds, runs the benchmarks and writes out/bench/results.md, with
# results.json and size.png beside it; some 30 minutes, --quick (no large sizes, fewer repetitions)
# some two. Leave the machine alone meanwhile.
# --keep copies the last results to bench/results/NAME.{md,json,png}; it measures nothing.
source "$(dirname "${BASH_SOURCE[0]}")/../tests/lib.sh"

usage="usage: bench/run.sh [--quick] | bench/run.sh --keep NAME"
results=$rgimp_root/out/bench
report=$rgimp_root/bench/report.py

if [[ ${1:-} == --keep ]]; then
  (($# == 2)) && [[ $2 =~ ^[A-Za-z0-9._-]+$ ]] || fail "$usage"
  [[ -f $results/results.json ]] || fail "no results in $results: run bench/run.sh first"
  kept=$rgimp_root/bench/results/$2
  "$report" "$results/results.json" --page "$kept.md" --picture "$kept.png" --data "$kept.json"
  echo "Kept as $kept.md"
  exit 0
fi

step_options=()
kernel_options=()
size_options=()
if [[ ${1:-} == --quick ]]; then
  shift
  quick=(--benchmark_min_time=0.05 --benchmark_repetitions=3)
  step_options=("${quick[@]}" --benchmark_filter='-cells:(1000|64)/')
  kernel_options=("${quick[@]}")
  size_options=("${quick[@]}" --benchmark_filter='-cells:(910|1580)/')
fi
(($# == 0)) || fail "$usage"

step "Packages (tests/install_dependencies.sh)"
bash "$rgimp_root/tests/install_dependencies.sh"
build_release

# A benchmark that differs from the scalar reference is reported like the others, then fails the run.
commit=$(git -C "$rgimp_root" describe --always --dirty 2>/dev/null || echo unknown)
all_right=yes
measure() { # PROGRAM [OPTION...]
  step "Measure ($1)"
  "$rgimp_root/build/release/bench/$1" --benchmark_out="$results/$1.json" \
    --benchmark_context=commit="$commit" "${@:2}" || all_right=no
}
mkdir -p "$results"
rm -f "$results"/*
measure bench_step "${step_options[@]}"
measure bench_kernels "${kernel_options[@]}"
measure bench_size "${size_options[@]}"

step "Report (bench/report.py)"
"$report" "$results"/bench_{step,kernels,size}.json --page "$results/results.md" \
  --picture "$results/size.png" --data "$results/results.json"
cat "$results/results.md"
[[ $all_right == yes ]] || fail "a benchmark failed; $results/results.md says which"
echo "These results are in $results/results.md; keep them with bench/run.sh --keep NAME"
