#!/bin/sh
# run.sh WRITE_CASES WORK: runs every WGSL text in a real browser. Exit code 77 (skipped) where Chromium, its WebGPU, node, npm or the
# package cannot be had.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
write_cases=$1
work=$2
. "$here/../browser.sh"
in_browser_folder "$work" "$here/../page" "$here/check.mjs"
"$write_cases" cases.json
node check.mjs "$browser" cases.json
