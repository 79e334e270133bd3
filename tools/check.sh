#!/usr/bin/env bash
# The long checks, before a release or after a large change: every test under the sanitizers, then clang-tidy.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

./tools/test.sh --preset asan
./tools/test.sh --preset tsan
./tools/tidy.sh
