#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Where touchstone is installed to, and the name under which that is cached: another one where sources, system or compiler change.
set -eu
cd "$GITHUB_ACTION_PATH"
key=$({ find . -name build -prune -o -name .git -prune -o -type f -print | LC_ALL=C sort | tr '\n' '\0' | xargs -0 sha256sum
  cat /etc/os-release
  c++ --version 2>/dev/null || true
} | sha256sum | cut -c 1-32)
{
  echo "prefix=${TOUCHSTONE_PREFIX:-$HOME/.touchstone}"
  echo "key=$key"
} >>"$GITHUB_OUTPUT"
