#!/usr/bin/env bash
# Prints how large the code is at a commit: files, lines and folders, as a table. Code is what a compiler, a browser or a shell
# reads; pages, pictures and measured files do not count.
# Usage: tools/code_numbers.sh [COMMIT]
set -euo pipefail
export LC_ALL=C # wc translates "total"
cd "$(git rev-parse --show-toplevel)"
commit=$(git rev-parse --verify --quiet "${1-HEAD}^{commit}") || {
    echo "tools/code_numbers.sh: '$1' is no commit of this repository" >&2
    exit 2
}
folder=$(mktemp --directory)
trap 'rm -r "$folder"' EXIT
git archive "$commit" src shaders tests | tar --extract --directory "$folder"
cd "$folder"

# The lines of each file below some folders, ascending.
lines_of() { # FOLDER...
    find "$@" -type f -regextype posix-extended \
        -regex '.*(\.(cpp|h|in|glsl|hlsl|vert|frag|comp|js|mjs|css|html|py|sh)|/CMakeLists\.txt)' -print0 |
        xargs --null wc --lines | awk '$2 != "total" { print $1 }' | sort --numeric-sort
}

row() { # NAME FOLDER...
    local name=$1
    shift
    lines_of "$@" | awk -v name="$name" '
        { lines[NR] = $1; sum += $1 }
        END { printf "| %s | %d | %d | %d | %d |\n", name, NR, sum, lines[int((NR + 1) / 2)], lines[NR] }'
}

echo "| at $(git -C "$OLDPWD" log -1 --format='%h of %cs' "$commit") | files | lines | median file | longest file |"
echo "|---|---|---|---|---|"
row "src, shaders" src shaders
row tests tests
for room in src/cdr/scene src/cdr/render src/viewer src/experiments src/cdr/measure; do
    row "$room" "$room"
done
find src shaders -type f -printf '%h\n' | sort | uniq --count | sort --numeric-sort --reverse | awk '
    NR == 1 { most = $1; name = $2 }
    END { printf "src and shaders have %d folders with files. Most, %d, are in %s.\n", NR, most, name }'
