#!/usr/bin/env bash
# Makes promises.csv and the table in trust.md. They have what promises.json says that cdr promises, and how the tests of each
# promise end on each driver of tools/drivers.sh. Needs a release build. Ends with status 1 where a test fails.
# Usage: tests/results/promises.sh [DRIVER...]
# With arguments, such as swiftshader, only those are run, and other rows stay. `card` is the graphics card that cdr chooses on
# this machine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

file=tests/results/promises.csv

# Runs a command on a driver of tools/drivers.sh, or on the card.
on() { # DRIVER COMMAND...
    local driver=$1
    if [[ $driver == card ]]; then driver=system; fi
    tools/drivers.sh "$driver" "${@:2}"
}

# Version and sub-pixel bits. The version is that of the package where tools/drivers.sh took the driver from one.
device() { # DRIVER
    local version=
    on "$1" build/release/bin/cdr devices --json "$scratch/devices.json" >/dev/null
    if [[ -e .cache/drivers/$1/packages ]]; then version=$(head -1 ".cache/drivers/$1/packages"); fi
    # shellcheck disable=SC2016 # JavaScript expands it
    node -e '
        const [file, driver, version] = process.argv.slice(1);
        const [device] = JSON.parse(require("fs").readFileSync(file)).results;
        const name = driver === "card" ? `${device.name}: ${device.driver}` : version || device.driver;
        console.log(`${name},${device.sub_pixel_bits}`);
    ' "$scratch/devices.json" "$1" "$version"
}

# Each program runs once, with the filters of all promises.
run() { # DRIVER
    local programs program filter status
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
    node tests/results/promises.mjs rows "$1,$(device "$1")" "$scratch/$1" "$file"
}

main() { # whole before it runs, so that it may be edited meanwhile
    local drivers=("$@") driver
    scratch=$(mktemp -d)
    trap 'rm -r "$scratch"' EXIT
    failed=0
    if ((${#drivers[@]} == 0)); then drivers=(system mesa swiftshader); fi
    for driver in "${drivers[@]}"; do run "$driver"; done
    node tests/results/promises.mjs table "$file" tests/results/trust.md
    return "$failed"
}

main "$@"
exit
