#!/usr/bin/env bash
# Builds and runs every test; in the release preset it checks the formatting too.
# Usage: tools/test.sh [--preset release|gcc|clang|debug|asan|tsan] [--werror]
# --werror, or CI=true in the environment, makes compiler warnings errors.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
    echo "usage: tools/test.sh [--preset release|gcc|clang|debug|asan|tsan] [--werror]" >&2
    exit 2
}

preset=release
warnings_as_errors=OFF
if [[ ${CI-} == true ]]; then warnings_as_errors=ON; fi
while (($#)); do
    case $1 in
        --preset)
            (($# > 1)) || usage
            preset=$2
            shift 2
            ;;
        --werror)
            warnings_as_errors=ON
            shift
            ;;
        *) usage ;;
    esac
done

# As these presets say: an option here would outdo them.
if [[ $preset == gcc || $preset == clang ]]; then warnings_as_errors=ON; fi
# GCC's flow warnings misfire on instrumented code, which its manual says of every sanitizer.
if [[ $preset == [at]san ]]; then warnings_as_errors=OFF; fi

tools/setup.sh
start=$SECONDS
tools/build.sh --in-batches "$preset" "-DCDR_WARNINGS_AS_ERRORS=$warnings_as_errors"
built=$SECONDS

# Before the tests but failing after them: both verdicts in one run, and CTest's summary last.
formatted=true
if [[ $preset == release ]]; then tools/format.sh --check || formatted=false; fi

launcher=()
if [[ $preset == tsan ]] && setarch --addr-no-randomize true 2>/dev/null; then
    # ThreadSanitizer's fixed shadow addresses collide with a strongly randomised address space. Containers may forbid
    # to switch that off, and then it does without.
    launcher=(setarch --addr-no-randomize)
fi
passed=true
# Four more than there are processors, since tests of ranks mostly wait for their launcher.
"${launcher[@]}" ctest --preset "$preset" --parallel "$(($(nproc) + 4))" || passed=false
echo "Seconds: $((built - start)) to build, $((SECONDS - built)) to test"
# CTest counts skipped entries, and an entry may be a whole suite.
grep --after-context=1 ': Skipped$' "build/$preset/Testing/Temporary/LastTest.log" | grep --invert-match -e ': Skipped$' -e '^--$' |
    sort | uniq --count | sed 's/^ *\([0-9]*\)/Skipped cases: \1,/' || true

if ! $formatted; then echo "tools/test.sh: tools/format.sh --check failed, see above; tools/format.sh mends what differs" >&2; fi
$passed && $formatted
