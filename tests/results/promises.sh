#!/usr/bin/env bash
# Makes promises.csv and the table in trust.md. They have what promises.json says that cdr promises, and how the tests of each
# promise end on each driver of tools/drivers.sh. Needs a release build. Ends with status 1 where a test fails.
# Usage: tests/results/promises.sh [DRIVER...]
# With arguments, such as swiftshader, only those are run, and other rows stay. `card` is the graphics card that cdr chooses on
# this machine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# shellcheck source=tests/results/on_driver.sh
source tests/results/on_driver.sh
file=tests/results/promises.csv

# Each program runs once, with the filters of all promises.
run() { # DRIVER
    local programs program filter status version bits
    mapfile -t programs < <(node tests/results/promises.mjs programs)
    for program in "${programs[@]}"; do
        filter=$(node tests/results/promises.mjs filter "$program")
        status=0
        on "$1" "build/release/bin/test_$program" --gtest_brief=1 --gtest_filter="$filter" \
            --gtest_output="json:$scratch/$1.$program.json" >"$scratch/log" 2>&1 || status=$?
        if ((status != 0)); then
            sed -n '/^\[  FAILED  \]/p' "$scratch/log" >&2
            failed=1
        fi
    done
    IFS=, read -r version _ bits _ < <(device "$1")
    node tests/results/promises.mjs rows "$1,$version,$bits" "$scratch/$1" "$file"
}

main() { # whole before it runs, so that it may be edited meanwhile
    local drivers=("$@") driver
    failed=0
    if ((${#drivers[@]} == 0)); then drivers=(system mesa swiftshader); fi
    for driver in "${drivers[@]}"; do run "$driver"; done
    node tests/results/promises.mjs table "$file" tests/results/trust.md
    return "$failed"
}

main "$@"
exit
