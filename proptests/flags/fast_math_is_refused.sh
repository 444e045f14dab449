#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# fast_math_is_refused.sh COMPILER ROOT: no header of robust/ can be included under flags that take NaN or the order of operations away.
set -eu
cd "$2"
headers=$(find robust -name '*.h')
[ -n "$headers" ] || { echo "no headers in robust/"; exit 1; }
accepted=0

# refused FLAGS: under these every header is refused.
refused() {
  for header in $headers; do
    said=$("$compiler" -std=c++20 $1 -E -I . -x c++ "$header" 2>&1 >/dev/null) || true
    case $said in
      *"does not hold under"*) ;;
      *) echo "$header: accepted with $1" && accepted=1 ;;
    esac
  done
}

compiler=$1
for flags in -ffast-math -Ofast -ffinite-math-only; do refused "$flags"; done
for flags in -funsafe-math-optimizations "-fassociative-math -fno-signed-zeros -fno-trapping-math" -freciprocal-math; do
  # Not every compiler says that it was given these.
  if "$compiler" $flags -dM -E -x c++ /dev/null | grep -qE '__(ASSOCIATIVE|RECIPROCAL)_MATH__'; then refused "$flags"; fi
done
if "$compiler" --version | grep -q 'Free Software Foundation'; then
  "$compiler" -funsafe-math-optimizations -dM -E -x c++ /dev/null | grep -q __ASSOCIATIVE_MATH__ ||
    { echo "$compiler does not say that it reassociates"; accepted=1; }
fi
exit $accepted
