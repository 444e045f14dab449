#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# fast_math_is_refused.sh COMPILER ROOT: no header of robust/ can be included under flags that take NaN or the order of operations away.
set -eu
compiler=$1
cd "$2"
headers=$(find robust -name '*.h')
[ -n "$headers" ] || { echo "no headers in robust/"; exit 1; }
accepted=0

# refused FLAGS HEADER...: under these flags each of these headers is refused.
refused() {
  flags=$1
  shift
  for header in "$@"; do
    said=$("$compiler" -std=c++20 $flags -E -I . -x c++ "$header" 2>&1 >/dev/null) || true
    case $said in
      *"does not hold under"*) ;;
      *) echo "$header: accepted with $flags" && accepted=1 ;;
    esac
  done
}

refused -ffast-math $headers
# So they all include what refuses; whatever else it refuses is asked of that alone.
for flags in -Ofast -ffinite-math-only; do refused "$flags" robust/kernel/filters/strict_math.h; done
for flags in -funsafe-math-optimizations "-fassociative-math -fno-signed-zeros -fno-trapping-math" -freciprocal-math; do
  # Not every compiler says that it was given these.
  if "$compiler" $flags -dM -E -x c++ /dev/null | grep -qE '__(ASSOCIATIVE|RECIPROCAL)_MATH__'; then
    refused "$flags" robust/kernel/filters/strict_math.h
  fi
done
if "$compiler" --version | grep -q 'Free Software Foundation'; then
  "$compiler" -funsafe-math-optimizations -dM -E -x c++ /dev/null | grep -q __ASSOCIATIVE_MATH__ ||
    { echo "$compiler does not say that it reassociates"; accepted=1; }
fi
exit $accepted
