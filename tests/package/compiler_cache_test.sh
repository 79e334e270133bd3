#!/usr/bin/env bash
# tools/build.sh with a compiler cache, where a comment in a precompiled header changes. The cache must not return the old
# precompiled header, since GCC would then include the changed file a second time.
# Usage: compiler_cache_test.sh SOURCE_DIR   status 3, with the reason, where there is no ccache
set -euo pipefail
source_dir=$1
command -v ccache >/dev/null || { echo "there is no ccache" && exit 3; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export CCACHE_DIR=$work/cache
unset CCACHE_DISABLE CMAKE_CXX_COMPILER_LAUNCHER

mkdir "$work/tools"
cp "$source_dir/tools/build.sh" "$work/tools"
cat >"$work/CMakePresets.json" <<'PRESETS'
{
    "version": 3,
    "configurePresets": [{ "name": "small", "generator": "Ninja", "binaryDir": "${sourceDir}/build/small" }],
    "buildPresets": [{ "name": "small", "configurePreset": "small" }]
}
PRESETS
cat >"$work/CMakeLists.txt" <<'PROJECT'
cmake_minimum_required(VERSION 3.25)
project(small CXX)
add_library(small OBJECT small.cpp)
target_precompile_headers(small PRIVATE small.h)
PROJECT
printf '#pragma once\n// A comment.\nstruct Small {};\n' >"$work/small.h"
printf '#include "small.h"\nint first() { return 1; }\n' >"$work/small.cpp"

build() {
    rm -rf "$work/build"
    "$work/tools/build.sh" small >"$work/log" 2>&1 || { cat "$work/log" >&2 && echo "failed: $1" >&2 && exit 1; }
}
build "the first build"
printf '#pragma once\n// Another one.\nstruct Small {};\n' >"$work/small.h"
printf 'int second() { return 2; }\n' >>"$work/small.cpp"
build "a build after a comment changed"
build "the same build again"
ccache --print-stats | grep --quiet --extended-regexp '^direct_cache_hit.[1-9]' || { echo "nothing came from the cache" >&2 && exit 1; }
echo "a precompiled header is that of its files"
