#!/usr/bin/env bash
# The long checks, before a release or after a large change. They take hours on two cores:
# - every test under the sanitizers, and those that need no driver under valgrind;
# - tests of a driver on other drivers, and under the newest validation layer;
# - clang-tidy and include-what-you-use over all sources, and every header compiled alone;
# - depth's tests for Windows, if a cross compiler and wine are installed;
# - all faults and kills, of which the suite takes a sample, and a minute of fuzzing for each parser;
# - ranks over MPICH, and the jobs for Slurm.
# Usage: tools/check.sh [--changed [MINUTES] | --memory]
# --changed does what fits into 20 minutes, or MINUTES. It takes what tools/changed.sh lists, newest first, and says what there
# was no time for:
# - clang-tidy over sources, and include-what-you-use where it is installed;
# - the tests of their rooms under AddressSanitizer, and those of threads without a driver under ThreadSanitizer;
# - a minute of fuzzing for each parser of these rooms;
# - tests of base, depth and image under valgrind.
# --memory does what runs under valgrind.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
    echo "usage: tools/check.sh [--changed [MINUTES] | --memory]" >&2
    exit 2
}

check_all() {
    local driver status
    tools/test.sh --preset asan
    tools/test.sh --preset tsan
    tools/build.sh --in-batches release
    tools/build.sh release -- --target cdr_benchmarks
    if has_valgrind; then check_memory; fi
    for driver in mesa swiftshader; do
        status=0
        tools/drivers.sh "$driver" ctest --preset release --parallel "$(nproc)" \
            --label-regex '^test_(gpu|render|rivals|output|runs|experiments|report|cli)$' || status=$?
        ((status == 0 || status == 77)) || return 1 # 77: it said why the driver cannot be had
    done
    check_barriers
    tools/tidy.sh
    tools/includes.sh
    cmake --build build/tidy --target all_verify_interface_header_sets
    local windows=0
    tools/windows.sh || windows=$?
    ((windows == 0 || windows == 3)) || return 1 # 3: it said what is missing
    CDR_ALL_CASES=1 build/release/bin/test_cli --gtest_brief=1 \
        --gtest_filter='*FaultSweep*:*FileFaults*:*NumericOptions*:Signals*:*Killed*:RanksCommand.*:*RankState*:WholeReport.*'
    local filter='World*Test.*:SharedPipelinesTest.*:OcclusionCullingTest.*:ViewsTest.*:*ShadowsTest.*:DetailRenderTest.*'
    filter+=':AnchoredTargetsTest.*:LargeMeshesTest.*:MotionTest.RoomStays*'
    CDR_ALL_CASES=1 build/release/bin/test_render --gtest_brief=1 --gtest_filter="$filter"
    CDR_ALL_CASES=1 build/release/bin/test_ranks --gtest_brief=1
    CDR_ALL_CASES=1 build/release/bin/test_depth --gtest_brief=1 --gtest_filter='WholeRange.*'
    CDR_ALL_CASES=1 build/release/bin/test_measure --gtest_brief=1 --gtest_filter='*Certifier.*'
    CDR_ALL_CASES=1 build/release/bin/test_scene --gtest_brief=1 --gtest_filter='GltfLargeFile.*'
    [[ ! -e build/release/bin/test_viewer ]] ||
        CDR_ALL_CASES=1 build/release/bin/test_viewer --gtest_brief=1 --gtest_filter='Thumbnails.*'
    CDR_ALL_CASES=1 ctest --preset release --tests-regex '^(Documents|Package|PackageAdded|Fuzz[.].*)$'
    tools/fuzz.sh
    check_mpich
    # Whose status for "cannot be started here" it has explained itself.
    tools/slurm/try.sh || (($? == 77))
}

# Tests of a driver under the newest validation layer, and whether it sees each barrier that is missing.
check_barriers() {
    local program status=0
    tools/layers.sh build/release/bin/test_base --gtest_list_tests >/dev/null || status=$?
    if ((status == 77)); then return; fi # it has said why it cannot be had
    for program in gpu render barriers; do
        tools/layers.sh "build/release/bin/test_$program" --gtest_brief=1
    done
    tools/layers.sh --shaders build/release/bin/test_barriers --gtest_brief=1
}

valgrind_options=(--quiet --error-exitcode=9 --leak-check=full)

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
        valgrind "${valgrind_options[@]}" "build/release/bin/$program" --gtest_brief=1 \
            --gtest_filter='-GltfLargeFile.IsNotInMemoryBesideItsScene'
    done
}

# The same of rooms that take 1.5 minutes together, without depth's tests of the whole range, which take minutes more.
check_memory_of() { # PROGRAM...
    local status
    tools/build.sh --in-batches release -- --target "$@"
    while (($#)); do
        status=0
        within 100 valgrind "${valgrind_options[@]}" "build/release/bin/$1" --gtest_brief=1 --gtest_filter='-WholeRange.*' || status=$?
        if ((status == 124)); then
            left_out valgrind "$@"
            return
        fi
        ((status == 0)) || return 1
        echo "valgrind: $1 passed"
        shift
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

# Runs a command for at most what is left of PERCENT of the time for changes. Status 124 where that is too little.
within() { # PERCENT COMMAND...
    local left=$((limit_seconds * $1 / 100 - SECONDS))
    shift
    ((left > 0)) || return 124
    timeout --kill-after=10 "$left" "$@"
}

left_out() { # WHAT NAME...
    echo "tools/check.sh: no time was left for $1: ${*:2}"
}

check_changed() {
    local changed sources rooms targets=() room
    changed=$(tools/changed.sh) # first, so that its failure is one
    # A room is named by its folder. Tests that start programs or a window, or make a page, take too long for this.
    mapfile -t rooms < <(sed -nE 's,^(src/cdr|src|tests)/([a-z]+)/.*,\2,p' <<<"$changed" | awk '!seen[$0]++')
    # A header is checked by the source beside it.
    mapfile -t sources < <(sed -nE 's,^(src/.*)[.](cpp|h)$,\1.cpp,p' <<<"$changed" | awk '!seen[$0]++' |
        while read -r file; do [[ ! -e $file ]] || echo "$file"; done)
    check_some 40 clang-tidy tools/tidy.sh "${sources[@]}"
    if command -v iwyu_tool >/dev/null; then
        check_some 50 include-what-you-use tools/includes.sh "${sources[@]}"
    else
        echo "tools/check.sh: include-what-you-use is not installed, so includes are not checked" >&2
    fi
    for room in "${rooms[@]}"; do
        if [[ -e tests/$room/CMakeLists.txt && ! $room =~ ^(cli|ranks|viewer|report)$ ]] &&
            grep --quiet "cdr_test(test_$room " "tests/$room/CMakeLists.txt"; then
            targets+=("test_$room")
        fi
    done
    test_under 70 asan "AddressSanitizer" "${targets[@]}"
    # What works on several threads and needs no driver.
    targets=()
    if printf '%s\n' "${rooms[@]}" | grep --quiet --line-regexp --extended-regexp 'base|platform|visibility'; then
        targets=(test_platform test_visibility)
    fi
    test_under 80 tsan "ThreadSanitizer" "${targets[@]}"
    fuzz_rooms "${rooms[@]}"
    targets=()
    for room in "${rooms[@]}"; do
        if [[ $room =~ ^(base|depth|image)$ ]]; then targets+=("test_$room"); fi
    done
    if ((${#targets[@]})) && has_valgrind; then check_memory_of "${targets[@]}"; fi
}

# A check of sources, a few at a time while there is time.
check_some() { # PERCENT NAME SCRIPT FILE...
    local percent=$1 name=$2 script=$3 status few
    shift 3
    few=$((2 * $(nproc)))
    while (($#)); do
        status=0
        within "$percent" "$script" "${@:1:few}" || status=$?
        if ((status == 124)); then
            left_out "$name" "$@"
            return
        fi
        ((status == 0)) || return 1
        shift $(($# < few ? $# : few))
    done
}

# A minute of fuzzing for each parser of some rooms.
fuzz_rooms() { # ROOM...
    local parsers=() room status=0
    for room; do
        case $room in
            platform) parsers+=(gltf) ;;
            scene) parsers+=(gltf camera_path) ;;
            image) parsers+=(image) ;;
            runs) parsers+=(unit_state) ;;
            experiments) parsers+=(timing) ;;
            depth | options | scenes | visibility) parsers+=(words) ;;
            report) parsers+=(manifest) ;;
            viewer) parsers+=(script) ;;
            fuzz) parsers=(gltf camera_path words image unit_state timing manifest script) && break ;;
        esac
    done
    if ((${#parsers[@]})); then
        mapfile -t parsers < <(printf '%s\n' "${parsers[@]}" | sort --unique)
        within 100 tools/fuzz.sh 60 "${parsers[@]}" || status=$?
        if ((status == 124)); then left_out "all of the fuzzing of" "${parsers[@]}"; fi
        ((status == 0 || status == 124)) || return 1
    fi
}

# Builds tests and runs them under a sanitizer, those of one room after those of another.
test_under() { # PERCENT PRESET NAME TARGET...
    local percent=$1 preset=$2 name=$3 log=build/$2/changed.log status target keep=()
    shift 3
    [[ $preset != asan ]] || keep=(cdr_keep_loaded)
    for target; do
        rm -f "$log" # of the target before
        status=0
        within "$percent" tools/build.sh --in-batches "$preset" -- --target "$target" "${keep[@]}" || status=$?
        if ((status == 0)); then
            within "$percent" ctest --preset "$preset" --parallel "$(nproc)" --quiet --output-log "$log" \
                --label-regex "^$target\$" || status=$?
        fi
        if ((status == 124)); then
            left_out "$name" "$@"
            return
        fi
        if ((status != 0)); then
            [[ ! -e $log ]] || cat "$log"
            return 1
        fi
        echo "$name: $target: $(grep 'tests passed' "$log")"
        shift
    done
}

case ${1-} in
    '') check_all ;;
    --changed)
        [[ ${2-20} =~ ^[0-9]{1,4}$ ]] || usage
        limit_seconds=$((10#${2-20} * 60))
        check_changed
        ;;
    --memory) has_valgrind && check_memory ;;
    *) usage ;;
esac
