#!/bin/sh
# run.sh ZONAL WORK: writes the viewer's page, draws each technique on the desktop path from the same maps, and lets a real
# browser compare, click and type. Exit code 77 (skipped) where Chromium, node, npm or the package cannot be had.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
zonal=$1
work=$2
. "$here/../browser.sh"
in_browser_folder "$work" "$here" "$here"/*.mjs
# Light without symmetry, so that a mirrored or turned lookup shows.
"$zonal" testcard --size 256 -o sky.exr --quiet
"$zonal" view sky.exr --html page.html --quiet 2>log || { cat log; exit 1; }
# A small sun makes few bands ring below zero.
"$zonal" sky sun --contrast 1000000 --diameter 4 --azimuth 0 --elevation 30 --size 256 -o sun.exr --quiet
"$zonal" view sun.exr --html sun.html --quiet 2>log || { cat log; exit 1; }
# A highlight from a file, and a file that is no picture.
"$zonal" testcard --size 128 -o card.png --quiet
echo "no picture" >text.png
"$zonal" view sky.exr --highlight card.png --html own.html --quiet 2>log || { cat log; exit 1; }
rm -rf desktop own.png
"$zonal" view sky.exr --highlight card.png --html again.html --set yaw=30 --size 320x240 --screenshot own.png --quiet 2>log || cat log
mkdir desktop
node states.mjs | while read -r name size state; do
  "$zonal" view sky.exr --html again.html --set "$state" --size "$size" --screenshot "desktop/$name.png" --quiet >"desktop/$name.txt" 2>log ||
    { cat log; break; }
done
node check.mjs "$browser" page.html desktop
