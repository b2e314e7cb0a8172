#!/bin/sh
# kernels_share_nothing.sh OBJECT...
# A kernel is compiled for each instruction set. A function that it shares with other files (a weak symbol) could be linked in its
# strongest form everywhere, and fail on machines without it. So kernels must have none.
set -eu
[ $# -ge 6 ] || { echo "too few objects to mean anything: $#"; exit 1; }
shared=$(nm -C --defined-only "$@" | grep -E ' [VWu] ' || true)
[ -z "$shared" ] || { echo "kernels define shared code:"; echo "$shared"; exit 1; }
symbols=$(nm --defined-only "$@" | grep -cE ' [TtRrDdBb] ')
echo "$# kernel objects, $symbols symbols, none shared"
[ "$symbols" -gt 50 ]
