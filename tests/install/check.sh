#!/bin/sh
# check.sh BUILD WORK: installs the build into WORK, builds a program against it as a user would, and runs it.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$1
work=$2
rm -rf "$work"
cmake --install "$build" --prefix "$work/prefix" >"$work.log" 2>&1 || { cat "$work.log"; exit 1; }
"$work/prefix/bin/zonal" --version
cmake -S "$here" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/prefix" >"$work.log" 2>&1 || { cat "$work.log"; exit 1; }
cmake --build "$work/build" >"$work.log" 2>&1 || { cat "$work.log"; exit 1; }
"$work/build/everything"
"$work/build/coefficients"
