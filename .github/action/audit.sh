#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Audits ENGINE with the options in ARGS. The table is in the log and, folded, on the page of the run; the exit code is the audit's.
set -euf
results=$RUNNER_TEMP/touchstone
mkdir -p "$results"
set -- --engine "$ENGINE" --json "$results/audit.json"
[ -z "$FAIL_ON" ] || set -- "$@" --fail-on "$FAIL_ON"
[ -z "$BASELINE" ] || set -- "$@" --baseline "$BASELINE"
[ -z "$SARIF" ] || set -- "$@" --sarif "$SARIF"
[ -z "$JUNIT" ] || set -- "$@" --junit "$JUNIT"
[ -z "$SOURCE" ] || set -- "$@" --source "$SOURCE"
[ -z "$REPORT" ] || set -- "$@" --report "$REPORT"
code=0
# shellcheck disable=SC2086  # words with spaces between them, as the input says
touchstone audit "$@" $ARGS >"$results/table.txt" || code=$?
cat "$results/table.txt"
{
  echo "json=$results/audit.json"
  echo "exit-code=$code"
} >>"$GITHUB_OUTPUT"
{
  echo "### touchstone audit"
  # The headline, and what the gate says, without the findings that it lists.
  awk -v RS= 'END { print }' "$results/table.txt" | grep -v '^  \|^report: ' || true
  printf '\n<details><summary>The whole table</summary>\n\n```text\n'
  head -c 900000 "$results/table.txt"
  printf '\n```\n\n</details>\n'
} >>"$GITHUB_STEP_SUMMARY"
exit $code
