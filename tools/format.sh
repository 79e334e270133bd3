#!/usr/bin/env bash
# Formats every C++ file of the repository in place; with --check it changes nothing and fails where it would.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case ${1-} in
    '') arguments=(-i) ;;
    --check) arguments=(--dry-run --Werror) ;;
    *) echo "usage: tools/format.sh [--check]" >&2 && exit 2 ;;
esac

# Releases of clang-format differ in detail, so one is the reference: the one of Debian 12, the oldest we support.
reference=14
clang_format=$(command -v "clang-format-$reference" || command -v clang-format) || {
    echo "tools/format.sh: needs clang-format; tools/setup.sh installs it" >&2
    exit 1
}
found=$("$clang_format" --version | sed -E 's/.*version ([0-9]+).*/\1/')
if [[ $found != "$reference" ]]; then
    echo "tools/format.sh: skipped, this code follows clang-format $reference and $found differs" >&2
    exit 0
fi

if [[ ! -e .git ]]; then
    echo "tools/format.sh: skipped, no git" >&2
    exit 0
fi
# Tracked or new, but neither ignored nor deleted.
git ls-files -z --cached --others --exclude-standard -- '*.h' '*.cpp' |
    while IFS= read -r -d '' file; do [[ ! -e $file ]] || printf '%s\0' "$file"; done |
    xargs --null --no-run-if-empty "$clang_format" "${arguments[@]}"
