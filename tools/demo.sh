#!/usr/bin/env bash
# Renders every technique's picture of every scene into out/, one sheet of them all included.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tools/setup.sh
tools/build.sh release -- --target cdr
build/release/bin/cdr pictures --out out
echo "Open $PWD/out/contact_sheet.png"
