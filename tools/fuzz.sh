#!/usr/bin/env bash
# Fuzzes every parser of files and words with libFuzzer, under AddressSanitizer and UndefinedBehaviorSanitizer, one after
# another. What it finds stays in build/fuzz/corpus for the next time; an input that breaks a parser stays in build/fuzz.
# Usage: tools/fuzz.sh [SECONDS]   each, 60 where it is not given
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

seconds=${1-60}
[[ $seconds =~ ^[0-9]+$ ]] || { echo "usage: tools/fuzz.sh [SECONDS]" >&2 && exit 2; }
if ! command -v clang++ >/dev/null; then
    echo "tools/fuzz.sh: nothing was fuzzed, clang++ is missing (packages clang and libclang-rt-14-dev)" >&2
    exit 1
fi

tools/build.sh --in-batches fuzz
for fuzzer in build/fuzz/bin/*_fuzzer; do
    name=$(basename "$fuzzer" _fuzzer)
    corpus=build/fuzz/corpus/$name
    mkdir -p "$corpus"
    options=(-max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 -print_final_stats=1)
    [[ ! -e tests/fuzz/$name.dict ]] || options+=(-dict="tests/fuzz/$name.dict")
    log=build/fuzz/$name.log
    "$fuzzer" "${options[@]}" -artifact_prefix="build/fuzz/$name-" "$corpus" "tests/fuzz/seeds/$name" &>"$log" ||
        { tail --lines=60 "$log" >&2 && echo "tools/fuzz.sh: $name failed, see $log" >&2 && exit 1; }
    awk -v name="$name" '/number_of_executed_units/ { runs = $2 } /peak_rss_mb/ { rss = $2 }
        END { printf "%s: %s runs, %s MiB at most\n", name, runs, rss }' "$log"
done
