#!/usr/bin/env bash
# Runs clang-tidy (.clang-tidy) over src/, one file per process on every core. Any finding fails.
# Usage: tools/tidy.sh [FILE...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# The headers that the build generates, and compile commands without GCC's precompiled headers, which Clang cannot read.
tools/build.sh tidy

files=("$@")
if ((${#files[@]} == 0)); then
    mapfile -t files < <(git ls-files --cached --others --exclude-standard -- 'src/*.cpp')
fi
echo "clang-tidy: ${#files[@]} files"
# Its compiler's own warnings are no matter of clang-tidy's, even where GCC's are errors (-Wno-error). On stderr it
# counts the warnings that it keeps to itself, those in other people's headers: no news.
printf '%s\0' "${files[@]}" |
    xargs --null --max-args=1 --max-procs="$(nproc)" clang-tidy -p build/tidy --quiet --extra-arg=-Wno-error \
        2> >(grep --invert-match --extended-regexp '^[0-9]+ warnings? generated\.$' >&2)
