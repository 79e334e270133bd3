#!/usr/bin/env bash
# Builds cdr::depth for Windows by the cross compiler mingw-w64: its tests, then the package and the example outside the source
# tree that uses it. Runs them where there is wine, and says so where there is none.
# Without the compiler it says what is missing and ends with status 3.
# Usage: windows_test.sh SOURCE_DIR
set -euo pipefail

source_dir=$(cd "$1" && pwd)
"$source_dir/tools/windows.sh"
# shellcheck source=tests/package/common.sh
source "$source_dir/tests/package/common.sh"

cross=$(command -v x86_64-w64-mingw32-g++-posix || command -v x86_64-w64-mingw32-g++)
install_cdr windows "" -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_CXX_COMPILER="$cross" -DCMAKE_EXE_LINKER_FLAGS=-static
if ! command -v wine >/dev/null; then
    echo "windows: not run, there is no wine"
    exit
fi
expect_output env WINEDEBUG=-all "WINEPREFIX=$work/wine" wine "$work/windows/example/depth_only.exe"
echo "windows: run"
