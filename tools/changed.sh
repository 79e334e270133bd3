#!/usr/bin/env bash
# Prints the files that changed, those of the newest commits first; files that are gone, too. On a branch that is every change
# since origin/main. On main itself nothing says where a landing began. So it is what the last 20 commits changed, and all of
# the day before the newest.
# Usage: tools/changed.sh
set -euo pipefail
top=$(git rev-parse --show-toplevel)
cd "$top"
fewest_commits=20
seconds=86400

# The commit that changes are counted from; empty where there is none before HEAD.
base_commit() {
    local base
    base=$(git merge-base HEAD origin/main 2>/dev/null) || base=
    if [[ -n $base && $base != "$(git rev-parse HEAD)" ]]; then
        echo "$base"
        return
    fi
    git log --first-parent --format='%H %ct' | awk -v fewest="$fewest_commits" -v seconds="$seconds" '
        NR == 1 { newest = $2 }
        NR > 1 && !found { base = $1; found = NR > fewest && $2 < newest - seconds }
        END { print base }'
}

base=$(base_commit)
if [[ -z $base ]]; then
    echo "tools/changed.sh: there is no commit to compare with" >&2
    exit
fi
echo "tools/changed.sh: $(git rev-list --count "$base"..HEAD) commits after $(git log -1 --format='%h of %ci' "$base")" >&2
{
    git diff --name-only HEAD
    git log --format= --name-only "$base"..HEAD
    git diff --name-only "$base" # merges, which have no names above
} | awk 'NF && !seen[$0]++'
