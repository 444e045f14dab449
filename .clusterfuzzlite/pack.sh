#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# pack.sh SOURCE PROGRAM OUT: a target for every operation, with its seeds, options and dictionary. The targets are one
# program under many names: it takes the operation from its name.
set -eu
source=$1 program=$2 out=$3
cp "$program" "$out/.program"
cp "$source/fuzz/driver/doubles.dict" "$out/doubles.dict"
for corpus in "$source"/fuzz/corpus/*/; do
  operation=$(basename "$corpus")
  ln -f "$out/.program" "$out/$operation"
  rm -f "$out/${operation}_seed_corpus.zip"
  zip -qj "$out/${operation}_seed_corpus.zip" "$corpus"*
  findings=$source/fuzz/findings/$operation
  [ ! -d "$findings" ] || zip -qj "$out/${operation}_seed_corpus.zip" "$findings"/* -x '*.md'
  printf '[libfuzzer]\nmax_len = 4096\ndict = doubles.dict\n' >"$out/$operation.options"
done
rm "$out/.program"
