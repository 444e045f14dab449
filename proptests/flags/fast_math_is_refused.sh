#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# fast_math_is_refused.sh COMPILER ROOT: no header of robust/ can be included under flags that take NaN or the order of operations away.
set -eu
cd "$2"
headers=$(find robust -name '*.h')
[ -n "$headers" ] || { echo "no headers in robust/"; exit 1; }
accepted=0
for flag in -ffast-math -Ofast -ffinite-math-only; do
  for header in $headers; do
    said=$("$1" -std=c++20 $flag -E -I . -x c++ "$header" 2>&1 >/dev/null) || true
    case $said in
      *"does not hold under"*) ;;
      *) echo "$header: accepted with $flag" && accepted=1 ;;
    esac
  done
done
exit $accepted
