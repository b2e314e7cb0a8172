#!/bin/sh
# run.sh WRITE_CASES WORK: runs every WGSL text in a real browser. Exit code 77 (skipped) where Chromium, its WebGPU, node, npm or the
# package cannot be had.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
write_cases=$1
work=$2
browser=$(command -v chromium || command -v chromium-browser || true)
[ -n "$browser" ] || { echo "skipped: no chromium"; exit 77; }
for program in node npm; do
  command -v $program >/dev/null || { echo "skipped: no $program"; exit 77; }
done
mkdir -p "$work"
cp "$here/../page/package.json" "$here/../page/package-lock.json" "$here/check.mjs" "$work"
cd "$work"
if [ ! -d node_modules/playwright-core ]; then
  npm ci --ignore-scripts --no-audit --no-fund >npm.log 2>&1 || { echo "skipped: npm ci failed, see $work/npm.log"; exit 77; }
fi
"$write_cases" cases.json
node check.mjs "$browser" cases.json
