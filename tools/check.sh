#!/usr/bin/env bash
# The long checks, before a release or after a large change. They take hours on two cores:
# - every test under the sanitizers, and those that need no driver under valgrind;
# - tests of a driver on other drivers, and under the newest validation layer;
# - clang-tidy and include-what-you-use over all sources, and every header compiled alone;
# - depth's tests for Windows, if a cross compiler and wine are installed;
# - all faults and kills, of which the suite takes a sample, and a minute of fuzzing for each parser;
# - ranks over MPICH, and the jobs for Slurm.
# Usage: tools/check.sh [--changed | --memory]
# --changed does what fits into a few minutes. It takes the sources that differ from origin/main, or from the parent commit if
# none do:
# - clang-tidy over these sources;
# - the tests of their rooms under AddressSanitizer, and those of threads without a driver under ThreadSanitizer;
# - a minute of fuzzing for each parser of these rooms.
# --memory does what runs under valgrind.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

check_all() {
    local driver
    tools/test.sh --preset asan
    tools/test.sh --preset tsan
    tools/build.sh --in-batches release
    if has_valgrind; then check_memory; fi
    for driver in mesa swiftshader; do
        tools/drivers.sh "$driver" ctest --preset release --parallel "$(nproc)" \
            --label-regex '^test_(gpu|render|experiments|cli)$'
    done
    check_barriers
    tools/tidy.sh
    tools/includes.sh
    cmake --build build/tidy --target all_verify_interface_header_sets
    local windows=0
    tools/windows.sh || windows=$?
    ((windows == 0 || windows == 3)) || return 1 # 3: it said what is missing
    CDR_ALL_CASES=1 build/release/bin/test_cli --gtest_brief=1 \
        --gtest_filter='*FaultSweep*:*FileFaults*:*NumericOptions*:Signals*:*Killed*'
    CDR_ALL_CASES=1 build/release/bin/test_render --gtest_brief=1 --gtest_filter='WorldTest.*:WorldSoakTest.*'
    CDR_ALL_CASES=1 ctest --preset release --tests-regex '^Documents$'
    tools/fuzz.sh
    check_mpich
    # Whose status for "cannot be started here" it has explained itself.
    tools/slurm/try.sh || (($? == 77))
}

# Tests of a driver under the newest validation layer, and whether it sees each barrier that is missing.
check_barriers() {
    local program
    for program in gpu render barriers; do
        tools/layers.sh "build/release/bin/test_$program" --gtest_brief=1
    done
    tools/layers.sh --shaders build/release/bin/test_barriers --gtest_brief=1
}

has_valgrind() {
    command -v valgrind >/dev/null ||
        { echo "tools/check.sh: no test ran under valgrind, which is missing (apt: valgrind)" >&2 && return 1; }
}

# Reads of what was never written, and leaks, in what needs no driver.
check_memory() {
    local programs=(test_base test_depth test_image test_scene test_visibility) program
    tools/build.sh --in-batches release -- --target "${programs[@]}"
    for program in "${programs[@]}"; do
        # Without the test that measures a process' memory: valgrind's own counts there.
        valgrind --quiet --error-exitcode=9 --leak-check=full "build/release/bin/$program" --gtest_brief=1 \
            --gtest_filter='-GltfLargeFile.IsNotInMemoryBesideItsScene'
    done
}

# What ranks run, over MPICH. Distributions install it beside Open MPI.
check_mpich() {
    if ! command -v mpicxx.mpich >/dev/null || ! command -v mpiexec.mpich >/dev/null; then
        echo "tools/check.sh: ranks were not tested over MPICH, mpich or libmpich-dev is missing" >&2
        return
    fi
    tools/build.sh --in-batches mpich
    build/mpich/bin/test_ranks --gtest_brief=1
    build/mpich/bin/test_cli --gtest_brief=1 --gtest_filter='Rank*:*/Rank*:CascadeMemory*:Devices.SayWhetherMpiIsIn'
}

# The commit that the changes are counted from.
base_commit() {
    local base
    base=$(git merge-base HEAD origin/main 2>/dev/null) || base=
    if [[ -z $base || $base == "$(git rev-parse HEAD)" ]]; then base=$(git rev-parse --verify --quiet HEAD^) || true; fi
    echo "$base"
}

# Lines of stdin, at most COUNT of them, spread evenly.
at_most() { # COUNT
    awk -v count="$1" '{ line[NR] = $0 }
        END { step = NR > count ? NR / count : 1; for (i = 1; i < NR + 1; i += step) print line[int(i)] }'
}

check_changed() {
    local base sources rooms targets=() room
    base=$(base_commit)
    if [[ -z $base ]]; then
        echo "tools/check.sh: there is no commit to compare with, so nothing is checked"
        return
    fi
    # A header is checked by the source beside it. 30 sources take about five minutes on two cores.
    mapfile -t sources < <(git diff --name-only --diff-filter=d "$base" -- 'src/*.cpp' 'src/*.h' |
        sed 's/[.]h$/.cpp/' | sort --unique | while read -r file; do [[ ! -e $file ]] || echo "$file"; done | at_most 30)
    if ((${#sources[@]})); then tools/tidy.sh "${sources[@]}"; fi

    # A room is named by its folder. Tests that start programs or a window, or make a page, take too long for this.
    mapfile -t rooms < <(git diff --name-only "$base" -- src tests |
        sed -nE 's,^(src/cdr|src|tests)/([a-z]+)/.*,\2,p' | sort --unique)
    for room in "${rooms[@]}"; do
        if [[ -e tests/$room/CMakeLists.txt && ! $room =~ ^(cli|ranks|viewer|report)$ ]] &&
            grep --quiet "cdr_test(test_$room " "tests/$room/CMakeLists.txt"; then
            targets+=("test_$room")
        fi
    done
    test_under asan "AddressSanitizer" "${targets[@]}"
    # What works on several threads and needs no driver.
    targets=()
    for room in base host visibility; do
        if printf '%s\n' "${rooms[@]}" | grep --quiet --line-regexp "$room"; then targets=(test_host test_visibility); fi
    done
    test_under tsan "ThreadSanitizer" "${targets[@]}"
    local parsers=()
    for room in "${rooms[@]}"; do
        case $room in
            scene) parsers+=(gltf camera_path words) ;;
            image) parsers+=(image) ;;
            experiments) parsers+=(state unit_state) ;;
            scenes | visibility) parsers+=(words) ;;
            report) parsers+=(manifest) ;;
            viewer) parsers+=(script) ;;
            fuzz) parsers=(gltf camera_path words image state unit_state manifest script) && break ;;
        esac
    done
    if ((${#parsers[@]})); then
        mapfile -t parsers < <(printf '%s\n' "${parsers[@]}" | sort --unique)
        tools/fuzz.sh 60 "${parsers[@]}"
    fi
}

# Builds tests and runs them under a sanitizer.
test_under() { # PRESET NAME TARGET...
    local preset=$1 name=$2 log=build/$1/changed.log
    shift 2
    if (($# == 0)); then return; fi
    local targets=("$@")
    [[ $preset != asan ]] || targets+=(cdr_keep_loaded)
    tools/build.sh --in-batches "$preset" -- --target "${targets[@]}"
    ctest --preset "$preset" --parallel "$(nproc)" --quiet --output-log "$log" \
        --label-regex "^($(IFS='|' && echo "$*"))\$" || { cat "$log" && return 1; }
    echo "$name: $*: $(grep 'tests passed' "$log")"
}

case ${1-} in
    '') check_all ;;
    --changed) check_changed ;;
    --memory) has_valgrind && check_memory ;;
    *) echo "usage: tools/check.sh [--changed | --memory]" >&2 && exit 2 ;;
esac
