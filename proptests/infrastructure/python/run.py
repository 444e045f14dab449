#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs a file of tests with pytest; exit code 77, with a word, where what it needs is not installed."""
import importlib.util
import sys

missing = [name for name in ("pytest", "hypothesis", "numpy") if importlib.util.find_spec(name) is None]
if missing:
    print("skipped: not installed for", sys.executable + ":", ", ".join(missing))
    sys.exit(77)

import pytest  # noqa: E402

sys.exit(pytest.main(["-q", "-p", "no:cacheprovider", *sys.argv[1:]]))
