#!/usr/bin/env bash
# Renders every technique's picture of every scene into out/, one sheet of them all included.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tools/setup.sh --demo
start=$SECONDS
tools/build.sh --in-batches release -- --target cdr
built=$SECONDS
build/release/bin/cdr pictures --out out
echo "Open $PWD/out/contact_sheet.png"
echo "Seconds: $((built - start)) to build, $((SECONDS - built)) to render"
