#!/usr/bin/env bash
# Reports includes that nothing in their file needs, after include-what-you-use (package iwyu). What it would add is left
# out: it names headers inside libraries, and what a room's own header promises to bring along. Nor does it ask for forward
# declarations, nor to leave out fmt/ranges.h, of which newer versions of fmt need more. Any finding fails.
# Usage: tools/includes.sh [FILE...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

command -v iwyu_tool >/dev/null || {
    echo "tools/includes.sh: skipped, include-what-you-use is missing (package iwyu)" >&2
    exit 0
}
tools/build.sh tidy >/dev/null

files=("$@")
if ((${#files[@]} == 0)); then
    found=$(git ls-files --cached --others --exclude-standard -- 'src/*.cpp') # first, so that its failure is one
    mapfile -t files <<<"$found"
fi
echo "include-what-you-use: ${#files[@]} files"
log=build/tidy/includes.log
iwyu_tool -p build/tidy -j "$(nproc)" "${files[@]}" -- \
    -w -Xiwyu --no_fwd_decls -Xiwyu --mapping_file="$PWD/tools/includes.imp" >"$log" 2>&1 ||
    { tail -20 "$log" >&2 && echo "tools/includes.sh: iwyu_tool failed, see $log" >&2 && exit 1; }
findings=$(awk -v root="$PWD/" '
    / should remove these lines:$/ { file = $1; sub(root, "", file); removing = 1; next }
    /^$/ { removing = 0 }
    removing && /^- #include/ && !/fmt\/ranges.h/ { sub(/^- /, ""); sub(/ *\/\/ lines /, " line "); sub(/-[0-9]+$/, ""); print file ": " $0 }' "$log" |
    sort --unique)
if [[ -n $findings ]]; then
    echo "$findings"
    exit 1
fi
