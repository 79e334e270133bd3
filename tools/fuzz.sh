#!/usr/bin/env bash
# Fuzzes parsers of files and words with libFuzzer, under AddressSanitizer and UndefinedBehaviorSanitizer, as many at a time
# as there are processors. What it finds stays in build/fuzz/corpus for the next time; an input that breaks a parser stays in
# build/fuzz.
# Usage: tools/fuzz.sh [SECONDS [PARSER...]]   by default 60 seconds each and all parsers
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
    echo "usage: tools/fuzz.sh [SECONDS [PARSER...]]" >&2
    exit 2
}

all=()
for source in tests/fuzz/*_fuzzer.cpp; do all+=("$(basename "$source" _fuzzer.cpp)"); done
seconds=${1-60}
[[ $seconds =~ ^[1-9][0-9]*$ ]] || usage # libFuzzer takes 0 for no limit
parsers=("${@:2}")
((${#parsers[@]})) || parsers=("${all[@]}")
for name in "${parsers[@]}"; do
    [[ " ${all[*]} " == *" $name "* ]] || { echo "tools/fuzz.sh: there is no parser $name, only ${all[*]}" >&2 && exit 2; }
done
if ! command -v clang++ >/dev/null; then
    echo "tools/fuzz.sh: nothing was fuzzed, clang++ is missing (packages clang and libclang-rt-dev)" >&2
    exit 1
fi

tools/build.sh --in-batches fuzz -- --target "${parsers[@]/%/_fuzzer}"

fuzz() { # PARSER
    local name=$1 corpus=build/fuzz/corpus/$1 log=build/fuzz/$1.log
    if [[ ! -x build/fuzz/bin/${name}_fuzzer ]]; then
        echo "$name: not fuzzed, for what it needs is missing" >&2
        return
    fi
    local options=(-max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 -print_final_stats=1)
    mkdir -p "$corpus"
    [[ ! -e tests/fuzz/$name.dict ]] || options+=(-dict="tests/fuzz/$name.dict")
    "build/fuzz/bin/${name}_fuzzer" "${options[@]}" -artifact_prefix="build/fuzz/$name-" "$corpus" "tests/fuzz/seeds/$name" \
        &>"$log" ||
        { tail --lines=60 "$log" >&2 && echo "tools/fuzz.sh: $name failed, see $log" >&2 && return 1; }
    awk -v name="$name" '/number_of_executed_units/ { runs = $2 } /peak_rss_mb/ { rss = $2 }
        END { printf "%s: %s runs, %s MiB at most\n", name, runs, rss }' "$log"
}
export -f fuzz
export seconds
printf '%s\n' "${parsers[@]}" | xargs --max-procs="$(nproc)" --replace bash -c 'fuzz "$1"' _ {}
