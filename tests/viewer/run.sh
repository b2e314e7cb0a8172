#!/bin/sh
# Runs a program in a display of its own. Exit code 77 (skipped) where there is none to be had, or where one of the programs
# named in NEEDS is missing.
for program in xvfb-run ${NEEDS:-}; do
  command -v "$program" >/dev/null || { echo "skipped: $program is not installed"; exit 77; }
done
exec xvfb-run -a -s "-screen 0 1800x1000x24" "$@"
