#!/bin/sh
# run.sh ZONAL WORK: bakes a sky and looks at its page in a real browser. Exit code 77 (skipped) where Chromium, node, npm or the
# package cannot be had.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
zonal=$1
work=$2
. "$here/../browser.sh"
in_browser_folder "$work" "$here" "$here/check.mjs"
"$zonal" sky daylight --size 128 -o sky.exr --quiet
"$zonal" bake sky.exr -o out --size 64 --verify --quiet
node check.mjs "$browser" out/index.html
