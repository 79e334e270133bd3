#!/usr/bin/env bash
# What tools/changed.sh lists and tools/check.sh does with it, in a repository of its own whose tools do nothing.
# Usage: changed_test.sh SOURCE_FOLDER
set -euo pipefail
source=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@b GIT_COMMITTER_NAME=a
export GIT_COMMITTER_EMAIL=a@b
now=1700000000

fail() {
    echo "$1: expected '$2', not '$3'" >&2
    exit 1
}

# commit HOURS_AGO FILE...
commit() {
    local file hours=$1
    for file in "${@:2}"; do
        mkdir -p "$(dirname "$file")"
        echo "$hours $RANDOM" >>"$file"
    done
    git add --all
    GIT_COMMITTER_DATE="$((now - hours * 3600)) +0000" git commit --quiet --message "$hours"
}

listed() { # WHAT EXPECTED
    local found
    found=$(tools/changed.sh 2>/dev/null | tr '\n' ' ')
    [[ $found == "$2" ]] || fail "$1" "$2" "$found"
}

git init --quiet --initial-branch=main "$work/repository"
cd "$work/repository"
mkdir tools
cp "$source/tools/changed.sh" "$source/tools/check.sh" tools
commit 2000 root
listed "a first commit" ""
commit 1000 old
listed "two commits" "old "
for i in 1 2 3; do commit $((500 - i)) "older$i"; done
for i in {1..19}; do commit $((100 - i)) many; done
commit 0 newest
listed "20 commits, though they are old" "newest many "
for i in 1 2 3; do commit 0 "b$i"; done
listed "20 commits of which few are of today" "b3 b2 b1 newest many "
for i in {1..30}; do commit 20 today; done
commit 0 last
listed "all of a day" "last today b3 b2 b1 newest "

# A branch, in a clone.
git clone --quiet . "$work/clone"
cd "$work/clone"
listed "a fresh clone" "last today b3 b2 b1 newest "
git checkout --quiet -b branch
commit 0 mine
echo more >>root
listed "a branch and what is not committed" "root mine "
git checkout --quiet root

# The rooms and sources of a commit reach the tools, and those for which no time is left are named.
log=$work/log
stub() { # STATUS FILE...
    local file
    for file in "${@:2}"; do
        mkdir -p "$(dirname "$file")"
        printf '#!/bin/sh\necho "%s $*" >>"%s"\nexit %s\n' "${file#"$work/bin/"}" "$log" "$1" >"$file"
        chmod +x "$file"
    done
}
stub 0 tools/{build,tidy,includes,fuzz}.sh "$work"/bin/{valgrind,ctest,iwyu_tool}
printf '#!/bin/sh\necho 2\n' >"$work/bin/nproc" # what is checked at a time depends on it
chmod +x "$work/bin/nproc"
mkdir -p build/asan build/tsan
for room in depth scene; do
    mkdir -p "tests/$room"
    echo "cdr_test(test_$room LIBRARIES x)" >"tests/$room/CMakeLists.txt"
done
commit 0 src/cdr/depth/source{1..9}.cpp src/cdr/depth/source{10..12}.cpp src/cdr/scene/a.cpp src/cdr/scene/b.h src/cdr/scene/b.cpp
output=$(PATH=$work/bin:$PATH tools/check.sh --changed 2>/dev/null)
has() { # TEXT
    grep --quiet --fixed-strings -- "$1" "$log" || fail "what was run" "$1" "$(cat "$log")"
}
has "valgrind --quiet --error-exitcode=9 --leak-check=full build/release/bin/test_depth"
has "tools/tidy.sh src/cdr/depth/source1.cpp"
has "tools/tidy.sh src/cdr/scene/a.cpp src/cdr/scene/b.cpp"
has "tools/includes.sh src/cdr/scene/a.cpp src/cdr/scene/b.cpp"
has "tools/build.sh --in-batches asan -- --target test_scene cdr_keep_loaded"
has "ctest --preset asan"
has "tools/fuzz.sh 60 camera_path gltf words"
[[ $output != *"no time"* ]] || fail "what was left out" "" "$output"
rm "$log"
output=$(PATH=$work/bin:$PATH tools/check.sh --changed 0 2>/dev/null)
for what in "clang-tidy: src/cdr" "AddressSanitizer: test_" "fuzzing of: camera_path gltf words" "valgrind: test_depth"; do
    [[ $output == *"no time was left for"*"$what"* ]] || fail "what was left out" "$what" "$output"
done
[[ $(wc --lines <"$log") == 1 ]] || fail "what is run without time" "the build for valgrind" "$(cat "$log")"
fails() { # COMMAND...
    ! PATH=$work/bin:$PATH "$@" >"$work/output" 2>&1 || fail "$* without $tool" "a failure" "$(cat "$work/output")"
}
# Whichever check fails, the whole does.
for tool in tools/build.sh tools/tidy.sh tools/includes.sh tools/fuzz.sh "$work/bin/valgrind" "$work/bin/ctest"; do
    mv "$tool" "$work/stub"
    stub 1 "$tool"
    echo "100% tests passed" | tee build/asan/changed.log >build/tsan/changed.log
    fails tools/check.sh --changed
    ! grep "tests passed" "$work/output" || fail "$tool fails" "no log of a run before" "$(cat "$work/output")"
    mv "$work/stub" "$tool"
done
# What cannot be had on a machine ends no check of all: another driver, newer layers, wine or Slurm.
stub 77 tools/drivers.sh tools/slurm/try.sh
stub 3 tools/windows.sh
stub 0 tools/test.sh "$work/bin/cmake" build/{release,mpich}/bin/test_{base,cli,render,ranks,depth,measure,scene,viewer}
cp "$source/tools/layers.sh" tools
mkdir third_party
echo 'private_apt_open() { fail "only Debian has them" 77; }' >third_party/private_apt.sh
PATH=$work/bin:$PATH tools/check.sh >"$work/output" 2>&1 || fail "all checks" "no failure" "$(cat "$work/output")"
grep --quiet "only Debian has them" "$work/output" || fail "newer layers" "only Debian has them" "$(cat "$work/output")"
has "tools/slurm/try.sh"
# Where git fails, nothing was checked, and that is said by the status.
tool=git
cp "$source/tools/tidy.sh" "$source/tools/includes.sh" "$work"
printf '#!/bin/sh\nexit 128\n' >"$work/bin/git"
chmod +x "$work/bin/git"
fails tools/check.sh --changed
mkdir build/tidy # where includes.sh has its log
for script in tidy includes; do
    cp "$work/$script.sh" tools
    fails "tools/$script.sh"
done
printf '#!/bin/sh\necho no database\nexit 1\n' >"$work/bin/iwyu_tool"
fails tools/includes.sh a.cpp
grep --quiet "no database" "$work/output" || fail "includes.sh where iwyu_tool fails" "no database" "$(cat "$work/output")"
echo "changes of a day are listed and checked, newest first"
