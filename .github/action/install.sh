#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs touchstone below PREFIX, unless the cache had it, and tells the steps that follow where it is.
set -eu
if [ -x "$PREFIX/bin/touchstone" ]; then
  "$GITHUB_ACTION_PATH/dev" packages
else
  "$GITHUB_ACTION_PATH/dev" install "$PREFIX"
fi
echo "$PREFIX/bin" >>"$GITHUB_PATH"
{
  echo "CMAKE_PREFIX_PATH=$PREFIX${CMAKE_PREFIX_PATH:+:$CMAKE_PREFIX_PATH}"
  echo "PKG_CONFIG_PATH=$PREFIX/lib/pkgconfig${PKG_CONFIG_PATH:+:$PKG_CONFIG_PATH}"
} >>"$GITHUB_ENV"
