#!/usr/bin/env bash
# Checks the shape of the repository. A folder has at most 45 files, and a file at most 500 lines. bash can parse
# each shell script. CTest runs it as Rooms.
# That each folder has its line in ARCHITECTURE.md or on its room's page is checked by the test Documents.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=C # wc translates "total"

most_files=45
most_lines=500
findings=0
finding() {
    echo "tools/rooms.sh: $1" >&2
    findings=$((findings + 1))
}

sources() { # what is written here, not what is fetched or made
    find src shaders tests tools third_party -name node_modules -prune -o -type f -print
}

while read -r count folder; do
    ((count <= most_files)) || finding "$folder holds $count files, $most_files are the most"
done < <(sources | sed 's,/[^/]*$,,' | sort | uniq --count)

while read -r lines file; do
    ((lines <= most_lines)) || finding "$file has $lines lines, $most_lines are the most"
done < <(sources | grep -E '[.](h|cpp|glsl|vert|frag|comp|js|mjs|css|html|py|sh|cmake|txt|md)$' |
    xargs -d '\n' wc --lines | grep -v ' total$')

while read -r script; do
    bash -n "$script" || finding "$script is no script that bash can parse"
done < <(sources | grep -E '[.]sh$')

((findings == 0)) || exit 1
