#!/bin/sh
# browser.sh ZONAL WORK MODULE: drops panoramas into a page in a real browser and compares its pictures with those of pages that
# were written for the same files. Exit code 77 (skipped) without the module, Chromium, node, npm or the package.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
zonal=$1
work=$2
[ -n "$3" ] || { echo "skipped: this build has no module for pages"; exit 77; }
. "$here/../browser.sh"
in_browser_folder "$work" "$here/../view_page" "$here/check.mjs" "$here/../view_page/page.mjs"
# Light without symmetry, so that a mirrored or turned picture shows.
"$zonal" testcard --size 256 -o card.hdr --quiet
"$zonal" convert card.hdr -o card.exr --quiet
"$zonal" testcard --size 256 -o card.png --quiet
"$zonal" convert card.hdr --to angular --size 200 -o disc.pfm --quiet
"$zonal" sky daylight --size 1024 -o large.hdr --quiet
"$zonal" view --html day.html --quiet 2>log || { cat log; exit 1; }
node check.mjs "$browser" "$zonal" day.html
