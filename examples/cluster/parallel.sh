#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# N shards with GNU parallel, as many at a time as there are processors:
#   ./parallel.sh 100 exhaust segment_segment --grid 16 --decisions
#   touchstone merge results/*.json
# The same line again runs what did not end well, and goes on where it was.
set -eu
export TOUCHSTONE_SHARDS="$1"
shift
mkdir -p "${RESULTS:=results}"
seq "$TOUCHSTONE_SHARDS" | parallel --resume-failed --joblog "$RESULTS/joblog" --env TOUCHSTONE_SHARDS \
  "${TOUCHSTONE:-touchstone}" "$@" --jobs 1 --json "$RESULTS/{}.json"
