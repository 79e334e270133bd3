#!/usr/bin/env bash
# Makes drivers.csv and the table in README.md: the test programs that need a driver, on each driver of tools/drivers.sh. Needs
# a release build. Ends with status 1 where a test fails.
# Usage: tests/results/drivers.sh [DRIVER[/PROGRAM]...]
# With arguments, such as mesa or swiftshader/gpu, only those are run, and other rows stay. `card` is the graphics card that cdr
# chooses on this machine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# shellcheck source=tests/results/on_driver.sh
source tests/results/on_driver.sh
programs=(gpu render rivals output runs experiments report cli)
file=tests/results/drivers.csv

# The last number that GoogleTest prints behind a word, 0 where it prints none.
count() { # WORD LOG
    sed -nE "s/^\[ *$1 *\] ([0-9]+) tests?[ .,].*/\1/p" "$2" | tail -1 | grep . || echo 0
}

run() { # DRIVER PROGRAM
    local log=$scratch/$1.$2 facts
    facts=$(device "$1")
    on "$1" "build/release/bin/test_$2" >"$log" 2>&1 || failed=1
    sed -n '/^\[  FAILED  \]/p' "$log" >&2
    local row
    row="$1,$facts,$2,$(count '=+' "$log"),$(count PASSED "$log"),$(count SKIPPED "$log"),$(count FAILED "$log")"
    echo "$row"
    # Read again, since another run may have written meanwhile.
    { grep --invert-match "^$1,.*,$2,[0-9,]*$" "$file" || true; } >"$scratch/drivers.csv"
    echo "$row" >>"$scratch/drivers.csv"
    { head -1 "$file" && tail -n +2 "$scratch/drivers.csv" | sort; } >"$scratch/sorted.csv"
    cp "$scratch/sorted.csv" "$file"
}

write_table() {
    # shellcheck disable=SC2016 # JavaScript expands it
    node -e '
        const fs = require("fs");
        const [file, page, ...all] = process.argv.slice(1);
        const rows = fs.readFileSync(file, "utf8").trim().split("\n").slice(1).map((row) => row.split(","));
        const programs = all.filter((name) => rows.some((row) => row[5] === name));
        const cell = (row) => row === undefined ? "" : `${row[6]} run` +
            (row[8] > 0 ? `, ${row[8]} left out` : "") + (row[9] > 0 ? `, ${row[9]} failed` : "");
        const lines = [["driver", "depth formats", "sub-pixel bits", "gpu-driven", ...programs.map((name) => `tests of ${name}`)]];
        const titles = { system: "", mesa: "lavapipe: ", swiftshader: "SwiftShader: ", card: "" };
        for (const name of Object.keys(titles)) {
            const its = rows.filter(([driver]) => driver === name);
            if (its.length > 0) {
                const cells = programs.map((program) => cell(its.find((row) => row[5] === program)));
                lines.push([titles[name] + its[0][1], ...its[0].slice(2, 5), ...cells]);
            }
        }
        const texts = lines.map((line) => `| ${line.join(" | ")} |`);
        texts.splice(1, 0, `|${"---|".repeat(lines[0].length)}`);
        const parts = /(<!-- drivers.sh writes this table -->\n)[^]*?(<!-- end -->)/;
        const text = fs.readFileSync(page, "utf8").replace(parts, `$1\n${texts.join("\n")}\n\n$2`);
        fs.writeFileSync(page, text);
    ' "$file" tests/results/README.md "${programs[@]}"
}

main() { # whole before it runs, so that it may be edited meanwhile
    local pairs=("$@") pair program
    failed=0
    if ((${#pairs[@]} == 0)); then pairs=(system mesa swiftshader); fi
    if [[ ! -e $file ]]; then
        echo "driver,version,depth formats,sub-pixel bits,gpu-driven,tests of,run,passed,left out,failed" >"$file"
    fi
    for pair in "${pairs[@]}"; do
        if [[ $pair == */* ]]; then
            run "${pair%/*}" "${pair#*/}"
        else
            for program in "${programs[@]}"; do run "$pair" "$program"; done
        fi
    done
    write_table
    return "$failed"
}

main "$@"
exit
