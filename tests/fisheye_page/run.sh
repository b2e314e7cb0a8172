#!/bin/sh
# run.sh ZONAL WORK: makes maps of a fisheye photograph and uses their page in a real browser. Exit code 77 (skipped) where
# Chromium, node, npm or the package cannot be had.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
zonal=$1
work=$2
. "$here/../browser.sh"
in_browser_folder "$work" "$here/../page" "$here"/*.mjs
# A sky without symmetry, its circle not in the middle, its name one that a shell must be told about.
"$zonal" testcard --size 128 -o sky.exr --quiet
"$zonal" convert sky.exr --to fisheye --size 240 -o "a sky.png" --quiet
for mode in corrected published; do
  rm -rf $mode
  "$zonal" fisheye "a sky.png" --mode $mode --center 110,130 --radius 100 --shininess 20 --size 41 --outside published -o $mode --quiet 2>log ||
    { cat log; exit 1; }
done
node check.mjs "$browser" "$zonal"
