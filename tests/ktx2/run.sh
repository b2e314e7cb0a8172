#!/bin/sh
# run.sh KTX2_SAMPLES WORK
# Writes sample files with the program KTX2_SAMPLES and reads them with ktx-parse, in the folder WORK.
# Exit code 77 (skipped) where node, npm or the package cannot be had.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
samples=$1
work=$2
for program in node npm; do
  command -v $program > /dev/null || { echo "skipped: no $program"; exit 77; }
done
mkdir -p "$work"
cp "$here/package.json" "$here/package-lock.json" "$here/facts.mjs" "$work"
cd "$work"
if [ ! -d node_modules/ktx-parse ]; then
  npm ci --ignore-scripts --no-audit --no-fund > npm.log 2>&1 || {
    echo "skipped: npm ci failed, see $work/npm.log"
    exit 77
  }
fi
rm -rf samples
"$samples" samples
node facts.mjs --expect samples/*.json
