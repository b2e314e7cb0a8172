#!/bin/sh
# tables.sh ZONAL WORK MODULE: lets node run the library out of a page on files, and compares the tables that it makes with those
# that the command writes. Exit code 77 (skipped) without the module or node.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
zonal=$1
work=$2
[ -n "$3" ] || { echo "skipped: this build has no module for pages"; exit 77; }
command -v node >/dev/null || { echo "skipped: no node"; exit 77; }
mkdir -p "$work"
cd "$work"
# A sun, so that lights are extracted; a probe, which is no panorama; a fisheye, which shows a part; and broken ones.
"$zonal" sky daylight --size 200 -o sky.hdr --quiet
"$zonal" convert sky.hdr --to angular --size 150 -o probe.pfm --quiet
"$zonal" convert sky.hdr --to fisheye --size 150 -o fisheye.pfm --quiet
"$zonal" convert sky.hdr -o sky.exr --quiet
"$zonal" convert sky.hdr --to angular --size 9 -o nine.exr --quiet
for name in sky.hdr sky.exr probe.pfm fisheye.pfm; do
  "$zonal" view $name --html "$name.html" --isa baseline --quiet 2>log || { cat log; exit 1; }
done
node "$here/tables.mjs" sky.hdr sky.exr probe.pfm fisheye.pfm
