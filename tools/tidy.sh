#!/usr/bin/env bash
# Runs clang-tidy (.clang-tidy) over src/, one file per process on every core. Any finding fails.
# Usage: tools/tidy.sh [FILE...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# The headers that the build generates, and compile commands without GCC's precompiled headers, which Clang cannot read.
tools/build.sh tidy

files=("$@")
if ((${#files[@]} == 0)); then
    found=$(git ls-files --cached --others --exclude-standard -- 'src/*.cpp') # first, so that its failure is one
    mapfile -t files <<<"$found"
fi
# Whether all that an example includes of its own is there: shaders that its own build compiles are not.
has_own_headers() {
    local name
    while read -r name; do [[ -e ${1%/*}/$name ]] || return 1; done < <(sed -n 's/^#include "\(.*\)"$/\1/p' "$1")
}
for i in "${!files[@]}"; do
    if [[ ${files[i]} == src/examples/* ]] && ! has_own_headers "${files[i]}"; then
        echo "clang-tidy: left out ${files[i]}, whose build generates headers"
        unset "files[i]"
    fi
done
if ((${#files[@]} == 0)); then exit 0; fi
echo "clang-tidy: ${#files[@]} files"
# Its compiler's own warnings are no matter of clang-tidy's, even where GCC's are errors (-Wno-error). On stderr it
# counts the warnings that it keeps to itself, those in other people's headers: no news.
printf '%s\0' "${files[@]}" |
    xargs --null --max-args=1 --max-procs="$(nproc)" clang-tidy -p build/tidy --quiet --extra-arg=-Wno-error \
        2> >(grep --invert-match --extended-regexp '^[0-9]+ warnings? generated\.$' >&2)
