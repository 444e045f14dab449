#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks whether the one file that ./dev certify-file makes checks certificates where nothing else of the project is: it accepts
what certify.py accepts and refuses, with the same words, a claim with another answer."""
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]


def run(checker, text):
    return subprocess.run([sys.executable, "-I", checker, "-"], input=text, capture_output=True, text=True, cwd=checker.parent)


with tempfile.TemporaryDirectory() as folder:
    alone = pathlib.Path(folder, "certify.pyz")
    subprocess.run([ROOT / "dev", "certify-file", alone], check=True)
    vectors = (ROOT / "vectors/orientation.jsonl").read_text(encoding="utf-8").splitlines()
    claim = next(json.loads(line) for line in vectors if '"truth":{"side":"on"}' in line)
    wrong = json.dumps(claim | {"truth": {"side": "left"}})
    said = run(alone, "\n".join(vectors))
    assert said.returncode == 0 and " 0 refused" in said.stdout, said
    assert not said.stdout.startswith("0 "), said
    refused = run(alone, wrong)
    assert refused.returncode == 1 and "1 certificates, 1 refused" in refused.stdout, refused
    # -I leaves out the folder of the script, which certify.py needs; the archive brings its modules along.
    beside = subprocess.run([sys.executable, ROOT / "oracle/certificates/certify.py", "-"], input=wrong, capture_output=True, text=True)
    assert refused.stdout == beside.stdout, (refused.stdout, beside.stdout)
