#!/bin/sh
# Runs a program in a display of its own. Exit code 77 (skipped) where there is none to be had.
if ! command -v xvfb-run >/dev/null; then
  echo "skipped: xvfb-run is not installed"
  exit 77
fi
exec xvfb-run -a -s "-screen 0 1800x1000x24" "$@"
