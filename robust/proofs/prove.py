#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Proves the filters of robust/kernel with Coq, from the C++ text as it stands.

  prove.py [--work DIR]          everything, in a fresh folder (build/proofs unless told)
  prove.py --looked-at           writes looked_at.txt: every proof was looked at after the last change of its filter

A filter NAME has a theorem NAME_right. Refused are: a filter whose text is not the one that looked_at.txt has, a filter
without theorem, a step left open, an axiom but those of Coq's real numbers, compiled files beside the sources.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

sys.dont_write_bytecode = True
import extract

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
AXIOMS = {  # of the classical real numbers of Coq's standard library
    "ClassicalDedekindReals.sig_not_dec", "ClassicalDedekindReals.sig_forall_dec",
    "FunctionalExtensionality.functional_extensionality_dep", "Classical_Prop.classic"}
OPEN = re.compile(
    r"\b(Admitted|Axioms?|Parameters?|Conjectures?|Abort|admit|give_up|bypass_check|Unset)\b|type-in-type")


def sources():
    return {path.stem: path.read_text(encoding="utf-8") for path in sorted(HERE.glob("*.v"))}


def bare(text):
    """Without comments."""
    return re.sub(r"\(\*.*?\*\)", "", text, flags=re.S)


def needed(text):
    return [name for line in re.findall(r"From Filters Require Import ([\w ]+)\.", text) for name in line.split()]


class Proof:
    """A folder of Coq files."""

    def __init__(self, work, files):
        self.work, self.files = work, files
        work.mkdir(parents=True)
        for name, text in files.items():
            (work / f"{name}.v").write_text(text, encoding="utf-8")

    def compile(self, name):
        run = subprocess.run(["coqc", "-Q", ".", "Filters", f"{name}.v"], cwd=self.work, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return run.returncode == 0, run.stdout

    def compile_all(self, names, jobs):
        """Each after those that it needs. The first that fails, with Coq's message, or None."""
        done, left, running = set(self.files) - set(names), set(names), {}
        with ThreadPoolExecutor(jobs) as pool:
            while left or running:
                for name in sorted(left):
                    if len(running) < jobs and all(n in done for n in needed(self.files[name])):
                        running[name] = pool.submit(self.compile, name)
                        left.discard(name)
                if not running:
                    return "a circle of files: " + " ".join(sorted(left)), ""
                while not any(future.done() for future in running.values()):
                    time.sleep(0.01)
                for name in [n for n, future in running.items() if future.done()]:
                    proved, said = running.pop(name).result()
                    if not proved:
                        return name, said
                    done.add(name)
        return None


def generated(defined, filters):
    head = extract.HEAD.replace("Import model.", "Import model constants.")
    return {"constants": defined, "filters": head + "\n".join(d for _, d, _ in filters) + "\n"}


def looked_at():
    return dict(line.split() for line in (HERE / "looked_at.txt").read_text(encoding="utf-8").splitlines())


def faults(files, filters):
    """What is refused before Coq is asked."""
    for path in HERE.iterdir():
        if path.suffix in (".vo", ".vos", ".vok", ".glob", ".aux") or path.name.endswith(".cache"):
            yield f"{path.name} is here: proofs start from nothing"
    for name, text in files.items():
        for found in OPEN.finditer(bare(text)):
            yield f"{name}.v: {found[0]}"
    seen = looked_at()
    theorems = {t for text in files.values() for t in re.findall(r"^Theorem (\w+)", text, re.M)}
    for name, _, digest in filters:
        if seen.get(name) != digest:
            yield f"{name}: its text has changed. Look at its proof and its comment, then: ./dev proofs --looked-at"
        if f"{name}_right" not in theorems:
            yield f"{name}: no theorem {name}_right"
    for name in set(seen) - {name for name, _, _ in filters}:
        yield f"{name} is in looked_at.txt, but no filter"


def prove(work, jobs):
    started = time.monotonic()
    defined, filters = extract.all_of(ROOT)
    files = {**sources(), **generated(defined, filters)}
    found = list(faults(files, filters))
    if found:
        return found
    theorems = [f"{name}_right" for name, _, _ in filters] + ["in_binary64"] * ("format" in files)
    files["assumptions"] = f"From Filters Require Import {' '.join(sorted(files))}.\n" + "".join(
        f"Print Assumptions {t}.\n" for t in theorems)
    shutil.rmtree(work, ignore_errors=True)
    proof = Proof(work, files)
    failed = proof.compile_all([n for n in files if n != "assumptions"], jobs)
    if failed:
        return [f"not proved: {failed[0]}.v", failed[1]]
    proved, said = proof.compile("assumptions")
    if not proved:
        return [said]
    parts = re.split(r"^(?:Axioms:|Closed under the global context)$", said, flags=re.M)[1:]
    if len(parts) != len(theorems):
        return [f"{len(theorems)} theorems, but {len(parts)} lists of axioms", said]
    for theorem, part in zip(theorems, parts):
        axioms = re.findall(r"^([\w.]+)\s*:", part, re.M)
        if set(axioms) - AXIOMS:
            return [f"{theorem} rests on {', '.join(sorted(set(axioms) - AXIOMS))}"]
        print(f"{theorem}: proved. Axioms: {', '.join(axioms) or 'none'}")
    print(f"{len(theorems)} theorems about robust/kernel, {time.monotonic() - started:.0f} s from nothing")
    return []


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "proofs")
    options.add_argument("--jobs", type=int, default=2)
    options.add_argument("--looked-at", action="store_true")
    given = options.parse_args()
    if given.looked_at:
        lines = [f"{name} {digest}\n" for name, _, digest in extract.all_of(ROOT)[1]]
        (HERE / "looked_at.txt").write_text("".join(lines), encoding="utf-8")
        return 0
    found = prove(given.work, given.jobs)
    for line in found:
        print(line, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
