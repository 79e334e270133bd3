#!/usr/bin/env bash
# Adds cdr's folder to an engine's build, by add_subdirectory and by FetchContent: only the library is built, without exceptions
# too. Then configures cdr itself without what can be left out, and looks which programs remain.
# Usage: subproject_test.sh SOURCE_DIR
set -euo pipefail

source_dir=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export CCACHE_BASEDIR=$work
quiet() { "$@" >"$work/log" 2>&1 || { cat "$work/log" >&2 && echo "failed: $*" >&2 && exit 1; }; }
fail() {
    echo "$1" >&2
    exit 1
}

for by in add_subdirectory FetchContent; do
    quiet cmake -G Ninja -S "$source_dir/tests/package/subproject" -B "$work/$by" -DCMAKE_BUILD_TYPE=Debug \
        -DCMAKE_CXX_FLAGS_DEBUG= "-DCMAKE_CXX_FLAGS=-fno-exceptions -fno-rtti" "-DCDR_BY=$by" "-DCDR_SOURCE=$source_dir" \
        -DCDR_WARNINGS_AS_ERRORS=ON -DCDR_UNITY_BUILD=ON "-DCDR_INSTALL=$([[ $by == add_subdirectory ]] && echo OFF || echo ON)"
done
# CMake installs nothing of a folder with EXCLUDE_FROM_ALL, which FetchContent is without.
grep -q '/_deps/cdr-build/cmake_install.cmake"' "$work/FetchContent/cmake_install.cmake" ||
    fail "CDR_INSTALL=ON: an engine does not install cdr's folder"
grep -q 'file(INSTALL' "$work/FetchContent/_deps/cdr-build/cmake_install.cmake" || fail "CDR_INSTALL=ON: there are no install rules"
# An engine has some of the libraries already. All of them at once find whichever cdr makes again; CDR_ALL_CASES takes each alone too.
# Its own libraries are shared, which makes none of cdr's so.
libraries=(fmt glm nlohmann_json meshoptimizer draco)
has=("$(IFS=';' && echo "${libraries[*]}")")
if [[ -n ${CDR_ALL_CASES-} ]]; then has+=("${libraries[@]}"); fi
for some in "${has[@]}"; do
    quiet cmake -G Ninja -S "$source_dir/tests/package/subproject" -B "$work/has_${some//;/_}" "-DENGINE_HAS=$some" \
        -DCDR_BY=add_subdirectory "-DCDR_SOURCE=$source_dir" -DBUILD_SHARED_LIBS=ON
    steps=$(ninja -C "$work/has_${some//;/_}" -t commands)
    [[ $steps == *" -o engine "* ]] || fail "nothing builds the engine"
    ! grep --only-matching ' -o cdr/[^ ]*[.]so[^ ]* ' <<<"$steps" >&2 || fail "an engine that links cdr::depth also builds shared libraries"
done
# What the engine does not link is not built, and its own program lands where it says.
quiet cmake --build "$work/add_subdirectory"
printed=$("$work/add_subdirectory/engine")
[[ $printed == *": drawn in 2 cascades" ]] || fail "unexpected output of the engine"
built=$(cd "$work/add_subdirectory" && find . -name '*.a' -printf '%f\n' | sort | paste --serial --delimiters=' ')
[[ $built == "libcdr_base.a libcdr_depth.a" ]] || fail "an engine that links cdr::depth also built: $built"
echo "subproject: added by add_subdirectory and FetchContent, only the library is built"

# programs NAME [OPTION...]: those that this configuration would build, and whether all that they need is known.
programs() {
    local at=$work/$1
    shift
    quiet cmake -G Ninja -S "$source_dir" -B "$at" -DCMAKE_BUILD_TYPE=Release -DCDR_UNITY_BUILD=ON "$@"
    # Another name for the rules: ninja runs none of them where it would first make its own file anew.
    cp "$at/build.ninja" "$at/rules.ninja"
    quiet ninja -C "$at" -f rules.ninja -n
    ninja -C "$at" -t targets all | sed -nE 's,^bin/([a-z_-]+): CXX_EXECUTABLE_LINKER.*,\1,p'
}
# expect NAME PATTERN...: the programs' names, and !PATTERN for one that must not be there.
expect() {
    local name=$1 pattern
    shift
    for pattern in "$@"; do
        if [[ $pattern == !* ]]; then
            ! grep -qxE "${pattern#!}" <<<"$found" || fail "$name: builds ${pattern#!}"
        else
            grep -qxE "$pattern" <<<"$found" || fail "$name: does not build $pattern"
        fi
    done
}
found=$(programs no_viewer -DCDR_BUILD_VIEWER=OFF)
expect "CDR_BUILD_VIEWER=OFF" cdr test_render '!cdr-viewer.*' '!test_viewer'
found=$(programs no_report -DCDR_BUILD_REPORT=OFF)
expect "CDR_BUILD_REPORT=OFF" cdr test_report
! grep -rq 'page/build.mjs' "$work/no_report/build.ninja" || fail "CDR_BUILD_REPORT=OFF: bundles the page"
quiet cmake --build "$work/no_report" --target cdr_page_header
found=$(programs no_tests -DCDR_BUILD_TESTS=OFF -DCDR_INSTALL=OFF -DCMAKE_DISABLE_FIND_PACKAGE_GTest=TRUE \
    -DCMAKE_DISABLE_FIND_PACKAGE_benchmark=TRUE)
expect "CDR_BUILD_TESTS=OFF" cdr '!test_.*'
! grep -r --include=cmake_install.cmake 'file(INSTALL' "$work/no_tests" >&2 || fail "CDR_INSTALL=OFF: there are install rules"
found=$(programs no_tools -DCDR_BUILD_TOOLS=OFF -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=TRUE -DCMAKE_DISABLE_FIND_PACKAGE_OpenSSL=TRUE \
    -DCMAKE_DISABLE_FIND_PACKAGE_GTest=TRUE -DCMAKE_DISABLE_FIND_PACKAGE_benchmark=TRUE)
expect "CDR_BUILD_TOOLS=OFF" '!.+'
found=$(programs no_render -DCDR_BUILD_RENDER=OFF)
expect "CDR_BUILD_RENDER=OFF" '!.+'
echo "options: configured without the viewer, the page, the tests, the programs and the renderer"
