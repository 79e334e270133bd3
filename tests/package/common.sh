# shellcheck shell=bash
# What the tests of the package share. Whoever reads it in has set source_dir.

: "${source_dir:?}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export CCACHE_BASEDIR=$work
quiet() { "$@" >"$work/log" 2>&1 || { cat "$work/log" >&2 && echo "failed: $*" >&2 && exit 1; }; }

# No package can be found, so none can be needed.
hidden=()
for package in Vulkan fmt glm nlohmann_json OpenSSL OpenEXR CLI11 meshoptimizer draco PkgConfig Threads GTest; do
    hidden+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=TRUE")
done
# Nor can a header of a package that this machine has be included unnoticed. These folders come first in the path of includes.
# In them each header of another package that cdr includes anywhere is an error, except those of C and POSIX.
poison=$work/poison
mapfile -t poisoned < <(grep -rhoE '^#include <[^>]+[.]hp*>' "$source_dir/src" | sed -E 's/^#include <(.*)>$/\1/' | sort -u |
    grep -vE '^(cdr|cli|experiments|options|output|program|ranks|report|rivals|runs|scenes|viewer|sys)/|^(fcntl|malloc|pthread|sched|spawn|stdbool|stddef|stdint|string|unistd)[.]h$')
for header in "${poisoned[@]}"; do
    mkdir -p "$poison/$(dirname "$header")"
    echo "#error \"cdr::depth includes <$header>\"" >"$poison/$header"
done
for header in vulkan/vulkan_core.h fmt/format.h glm/glm.hpp; do
    if c++ -std=c++20 -fsyntax-only "-I$poison" -x c++ - <<<"#include <$header>" 2>"$work/log" ||
        ! grep -qF "cdr::depth includes <$header>" "$work/log"; then
        echo "an include of <$header> would not be noticed" >&2
        exit 1
    fi
done

# install_cdr NAME COMPILER_FLAGS [CMAKE_ARGUMENT...]: cdr::depth to $work/NAME/prefix, and the example to $work/NAME/example.
# Nobody debugs them, so that debug builds are without -g, which follows the flags given here.
install_cdr() {
    local name=$1 at=$work/$1 flags="-DCMAKE_CXX_FLAGS=-I$poison $2"
    shift 2
    quiet cmake -G Ninja -S "$source_dir" -B "$at/build" -DCDR_BUILD_RENDER=OFF -DCDR_UNITY_BUILD=ON \
        -DCDR_WARNINGS_AS_ERRORS=ON -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG= "${hidden[@]}" "$flags" "$@"
    quiet cmake --build "$at/build"
    quiet cmake --install "$at/build" --prefix "$at/prefix"
    quiet cmake -G Ninja -S "$source_dir/src/examples/depth_only" -B "$at/example" -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON \
        -DCMAKE_PREFIX_PATH="$at/prefix" -DCMAKE_FIND_ROOT_PATH="$at/prefix" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "$flags" "$@"
    quiet cmake --build "$at/example"
    echo "$name: built and installed"
}

# printed EXAMPLE: what the examples' page says that it prints.
printed() {
    awk -v heading="## What \`$1\` prints" '
        $0 == heading { here = 1 } here && /^```$/ { exit } here && shown { print } here && /^```text$/ { shown = 1 }' \
        "$source_dir/src/examples/README.md" | grep .
}
# expect_output COMMAND...: it succeeds and prints what depth_only does.
expect_output() {
    local text
    text=$("$@")
    diff <(printed depth_only) <(tr -d '\r' <<<"$text") >&2 || { echo "unexpected output of depth_only" >&2 && exit 1; }
}
