#!/usr/bin/env bash
# Builds base and depth with their tests for Windows, by the cross compiler mingw-w64, and runs them under wine. The two are
# not a part of tools/setup.sh, since they take 1.1 GB: apt install g++-mingw-w64-x86-64-posix wine64 wine googletest.
# Without the compiler or GoogleTest's sources it says so and ends with status 3; without wine it compiles only, and says so.
# Usage: tools/windows.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

missing() {
    echo "tools/windows.sh: nothing was checked, there is no $1" >&2
    exit 3
}
compiler=$(command -v x86_64-w64-mingw32-g++-posix || command -v x86_64-w64-mingw32-g++) ||
    missing "mingw-w64 cross compiler (g++-mingw-w64-x86-64-posix)"
[[ -e /usr/src/googletest/googletest/src/gtest-all.cc ]] || missing "source of GoogleTest (googletest)"

cmake -G Ninja -S tests/package/windows -B build/windows -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_EXE_LINKER_FLAGS=-static -DCDR_WARNINGS_AS_ERRORS=ON -DCDR_UNITY_BUILD=ON
cmake --build build/windows
if ! command -v wine >/dev/null; then
    echo "tools/windows.sh: compiled, but not run: there is no wine (wine64, wine)"
    exit
fi
WINEDEBUG=-all WINEPREFIX=$PWD/build/windows/wine wine build/windows/test_windows.exe --gtest_brief=1 || exit 1 # 3, which a crash ends with, says that a tool is missing
echo "tools/windows.sh: compiled by $($compiler -dumpmachine) GCC $($compiler -dumpversion), run by $(wine --version 2>/dev/null)"
