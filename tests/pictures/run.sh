#!/bin/sh
# run.sh ZONAL WORK [--take]: draws the pictures that README.md and docs/ show and compares them with docs/images; --take puts them
# there. Exit code 77 (skipped) where Chromium, node, npm, OpenGL or the panorama cannot be had.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../..
zonal=$(realpath "$1")
work=$2
sky=$root/../shared/data/equirect/blender_sunset.exr # "Venice Sunset" by Greg Zaal, HDRI Haven, CC0
[ -e "$sky" ] || { echo "skipped: no panorama to show"; exit 77; }
sky=$(realpath "$sky")
. "$here/../browser.sh"
in_browser_folder "$work" "$here/../page" "$here/shots.mjs"
rm -rf pictures baked
mkdir pictures
seen="mesh=torus-knot&yaw=-100&pitch=14"
"$zonal" view "$sky" --set "$seen" --sheet techniques.svg --quiet 2>log || {
  grep -q "OpenGL\|no viewer" log || { cat log; exit 1; }
  echo "skipped: no OpenGL"
  exit 77
}
"$zonal" view "$sky" --html view.html --quiet 2>log || { cat log; exit 1; }
"$zonal" bake "$sky" -o baked --no-timings --quiet 2>log || { cat log; exit 1; }
node shots.mjs "$browser" "$seen"
if [ "${3:-}" = --take ]; then
  cp pictures/*.png "$root/docs/images"
  exit 0
fi
same=0
for picture in pictures/*.png; do
  # Letters and edges may differ a little from machine to machine; a picture of something else differs by much more.
  "$zonal" compare --flat --max-error 0.05 "$picture" "$root/docs/images/${picture#pictures/}" --quiet || {
    echo "docs/images/${picture#pictures/} is not what is drawn now: look at $work/$picture, then: run.sh ZONAL WORK --take"
    exit 1
  }
  same=$((same + 1))
done
echo "$same pictures are what the docs show"
[ "$same" -eq 3 ]
