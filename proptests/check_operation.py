#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""All about one operation: check_operation.py OP [--jobs N]

Builds what is missing, then asks its tests, its part of every derived test, its vectors and fuzz inputs, its mutants in
every way, the proofs of the filters that it includes, and its line of the benchmarks. Its claims and its second truth
are asked by test_oracle, with those of all operations. A line each; exit code 1 if one fails."""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import time

from status import filters_of

ROOT = pathlib.Path(__file__).resolve().parent.parent
RELEASE, CLANG, BENCH = (ROOT / "build" / preset for preset in ("release", "clang", "bench"))


def run(command, **environment):
    return subprocess.run([str(word) for word in command], cwd=ROOT, env=os.environ | environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def build(preset, jobs, options, targets):
    folder = ROOT / "build" / preset
    for command in (["cmake", "--preset", preset, *options], ["cmake", "--build", folder, "-j", jobs, "--target", *targets]):
        done = run(command)
        if done.returncode != 0:
            sys.exit(done.stdout)


def proofs_of(operation, chapter):
    """The filters with theorems that it may ask."""
    return [cell.strip("`") for cell in filters_of(chapter, operation) if re.fullmatch(r"`\w+`", cell)]


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("operation")
    arguments.add_argument("--jobs", default="2")
    options = arguments.parse_args()
    op, jobs = options.operation, options.jobs
    build("release", jobs, ["-DTOUCHSTONE_TESTS=REQUIRED"], ["touchstone"])
    listed = {o["name"]: o for o in json.loads(run([RELEASE / "touchstone", "ops", "--json"]).stdout)}
    if op not in listed:
        sys.exit(f"{op}: no operation has this name (touchstone ops)")
    chapter = listed[op]["chapter"]
    build("release", jobs, [], ["fuzz", "test_agreement", f"test_{chapter}"])
    build("clang", jobs, [], ["mutants"])
    build("bench", jobs, [], ["bench_operations"])
    fuzz_inputs = [folder for folder in (ROOT / f"fuzz/corpus/{op}", ROOT / f"fuzz/findings/{op}") if folder.is_dir()]
    steps = [
        ("its own tests", ["ctest", "--test-dir", RELEASE, "-R", f"^{chapter}/{op}$", "--no-tests=error"]),
        ("derived tests", [RELEASE / "tests/test_agreement", f"{op}:*"]),
        ("vectors", [RELEASE / "touchstone", "vectors", "check", ROOT / "vectors", "--ops", op]),
        ("fuzz inputs", [RELEASE / "fuzz/fuzz", op, *fuzz_inputs]),
        ("mutants", [sys.executable, ROOT / "proptests/mutation/kill.py", CLANG / "proptests/mutation", ROOT / "vectors",
                     ROOT / "build/mutants.txt", "--only", op]),
        *((f"proof of {name}", [sys.executable, ROOT / "robust/proofs/prove.py", "--only", name])
          for name in proofs_of(op, chapter)),
        ("benchmark", [ROOT / "bench/ratios.py", "--ops", op, "--repetitions", "5"]),
    ]
    failed = False
    for what, command in steps:
        started = time.monotonic()
        done = run(command)
        lines = [line for line in done.stdout.splitlines() if line.strip()]
        wrong = done.returncode != 0 or "No tests ran" in done.stdout
        failed |= wrong
        print(f"{what}: {'FAILED' if wrong else 'passed'}, {time.monotonic() - started:.1f} s", flush=True)
        for line in lines if wrong or what == "benchmark" else lines[-1:]:
            print("  " + line)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
