#!/bin/bash -eu
# SPDX-License-Identifier: Apache-2.0
# Called by ClusterFuzzLite and OSS-Fuzz: compiles with $CXX $CXXFLAGS, links with $LIB_FUZZING_ENGINE, fills $OUT.
here=$(pwd)
# libFuzzer watches robust and the verdict, as in ./dev fuzz; a report of coverage shows all.
[ "$SANITIZER" = coverage ] || CXXFLAGS="$CXXFLAGS -fsanitize-coverage-allowlist=$here/fuzz/driver/instrumented.txt"
export CXXFLAGS
cmake -S "$here" -B "$WORK/build" -G Ninja -DCMAKE_BUILD_TYPE=None -DTOUCHSTONE_STATIC=ON -DTOUCHSTONE_TESTS=OFF \
  -DTOUCHSTONE_FUZZING_ENGINE="$LIB_FUZZING_ENGINE" -DTOUCHSTONE_INSTALL=OFF -DTOUCHSTONE_PCH=OFF
cmake --build "$WORK/build" --target fuzz
"$here/.clusterfuzzlite/pack.sh" "$here" "$WORK/build/fuzz/fuzz" "$OUT"
