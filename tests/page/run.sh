#!/bin/sh
# run.sh ZONAL WORK: bakes a sky and looks at its page in a real browser. Exit code 77 (skipped) where Chromium, node, npm or the
# package cannot be had.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
zonal=$1
work=$2
browser=$(command -v chromium || command -v chromium-browser || true)
[ -n "$browser" ] || { echo "skipped: no chromium"; exit 77; }
for program in node npm; do
  command -v $program >/dev/null || { echo "skipped: no $program"; exit 77; }
done
mkdir -p "$work"
cp "$here/package.json" "$here/package-lock.json" "$here/check.mjs" "$work"
cd "$work"
if [ ! -d node_modules/playwright-core ]; then
  npm ci --ignore-scripts --no-audit --no-fund >npm.log 2>&1 || { echo "skipped: npm ci failed, see $work/npm.log"; exit 77; }
fi
"$zonal" sky daylight --size 128 -o sky.exr --quiet
"$zonal" bake sky.exr -o out --size 64 --verify --quiet
node check.mjs "$browser" out/index.html
