#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Proves the filters of robust/kernel and of arrays, and its enclosed numbers with Coq, from the C++ text as it stands.

  prove.py [--work DIR]          everything, in a fresh folder (build/proofs unless told)
  prove.py --reviewed           writes reviewed.txt: every proof was reviewed after the last change of its filter
  prove.py --only NAME           the theorems of one filter or part
  prove.py --share               a share of the theorems, for the tests; all filters' texts are compared all the same
  prove.py --mutants [FILTER]    each constant one unit smaller, or another comparison: refused by Coq
  prove.py --self-check          changed constants, open steps, axioms and caches are refused, without a run of Coq

A filter NAME has three theorems: NAME_right about real numbers where nothing overflows, NAME_binary64 about all numbers
of binary64, NAME_runs that there is such a run; a part NAME of enclosed.h or push.h, and a filter of OF_REALS, has
NAME_right. A filter of arrays is a function on all numbers of binary64: NAME_right says all of it.
Refused are: a filter whose text is not the one that reviewed.txt has, a filter without these theorems, a step left
open, an axiom but those of Coq's real numbers, compiled files beside the sources.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

sys.dont_write_bytecode = True
import enclosed
import extract
import lane_close
import lane_linear
import lane_shapes
import lane_solids
import lane_text
import lane_triangles
import mutants

SKIPPED = 77  # for CTest
SHARE = {"cross_sign", "orientation", "elevation", "plane"}
KINDS = ("right", "binary64", "runs")
OF_REALS = {"crossings"}  # not yet on all of binary64
OF_LANES = (lane_text.NAMES | lane_shapes.NAMES | lane_solids.NAMES | lane_triangles.NAMES | lane_linear.NAMES
            | lane_close.NAMES)
OTHERS = ["segments_meet", "ray_meets", "obb_axis_separates", "in_space", "point_in_obb_solid", "zero_is_positive",
          "rounds_to_nearest_right", "gradual_computes", "flushed_computes", "convex_ring_inside", "convex_ring_outside",
          "convex_solid_outside", "solid_counts"]
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
    lines = re.findall(r"From (?:Filters|Certificates) Require Import ([\w\s]+)\.", text)
    return [name for line in lines for name in line.split()]


class Proof:
    """A folder of Coq files."""

    def __init__(self, work, files, library="Filters"):
        self.work, self.files, self.library = work, files, library
        work.mkdir(parents=True)
        for name, text in files.items():
            (work / f"{name}.v").write_text(text, encoding="utf-8")

    def compile(self, name):
        run = subprocess.run(["coqc", "-Q", ".", self.library, f"{name}.v"], cwd=self.work, text=True,
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


def reviewed():
    return dict(line.split() for line in (HERE / "reviewed.txt").read_text(encoding="utf-8").splitlines())


def faults(files, filters, folder=HERE):
    """Yields what is refused before Coq is asked."""
    for path in folder.iterdir():
        if path.suffix in (".vo", ".vos", ".vok", ".glob", ".aux") or path.name.endswith(".cache"):
            yield f"{path.name} is here: proofs start from nothing"
    for name, text in files.items():
        for found in OPEN.finditer(bare(text)):
            yield f"{name}.v: {found[0]}"
    seen = reviewed()
    theorems = {t for text in files.values() for t in re.findall(r"^Theorem (\w+)", text, re.M)}
    for name, _, digest in filters:
        if seen.get(name) != digest:
            yield f"{name}: its text has changed. Look at its proof and its comment, then: ./dev proofs --reviewed"
        for theorem in theorems_of(name):
            if theorem not in theorems:
                yield f"{name}: no theorem {theorem}"
    for name in set(seen) - {name for name, _, _ in filters}:
        yield f"{name} is in reviewed.txt, but no filter"


def theorems_of(name):
    alone = enclosed.THEOREMS | OF_REALS | OF_LANES
    return [f"{name}_{kind}" for kind in (KINDS[:1] if name in alone else KINDS)]


def closure(names, files):
    """These, and the files that they need."""
    found = set()
    while names - found:
        found |= names
        names = names | {n for name in names for n in needed(files[name])}
    return found


def prove(work, jobs, chosen):
    """chosen: the names of some filters and parts; None: everything."""
    started = time.monotonic()
    made, filters = extract.all_of(ROOT)
    files = {**sources(), **made}
    found = list(faults(files, filters))
    if found:
        return found
    names = [name for name, _, _ in filters if chosen is None or name in chosen]
    groups = [[f"{name}_right"] for name in names if name not in enclosed.THEOREMS | OF_LANES]
    # all that rests on Flocq at once: Coq goes through the whole of it each time
    groups.append([theorem for name in names for theorem in theorems_of(name) if [theorem] not in groups]
                  + ["in_binary64", "growing_in_binary64"] + ([] if chosen else OTHERS))
    if chosen:
        parts = closure({proof_of(theorem, files) for group in groups for theorem in group}, files)
        files = {name: files[name] for name in parts}
    files["assumptions"] = f"From Filters Require Import {' '.join(sorted(files))}.\n" + "".join(
        f"Definition group{i} := ({', '.join(group)}).\nPrint Assumptions group{i}.\n"
        for i, group in enumerate(groups))
    shutil.rmtree(work, ignore_errors=True)
    proof = Proof(work, files)
    failed = proof.compile_all([n for n in files if n != "assumptions"], jobs)
    if failed:
        return [f"not proved: {failed[0]}.v", failed[1]]
    proved, said = proof.compile("assumptions")
    if not proved:
        return [said]
    parts = re.split(r"^(?:Axioms:|Closed under the global context)$", said, flags=re.M)[1:]
    if len(parts) != len(groups):
        return [f"{len(groups)} questions, but {len(parts)} lists of axioms", said]
    for group, part in zip(groups, parts):
        axioms = re.findall(r"^([\w.]+)\s*:", part, re.M)
        if set(axioms) - AXIOMS:
            return [f"{', '.join(group)}: rests on {', '.join(sorted(set(axioms) - AXIOMS))}"]
        print(f"{', '.join(group)}: proved. Axioms: {', '.join(axioms) or 'none'}")
    print(f"{sum(map(len, groups))} theorems about robust, {time.monotonic() - started:.0f} s from nothing")
    return []


def changed(filters, others):
    return [name for (name, before, _), (_, after, _) in zip(filters, others) if before != after]


def self_check():
    """Each fault alone is found."""
    made, filters = extract.all_of(ROOT)
    files = {**sources(), **made}
    wrong = list(faults(files, filters))
    names = {name for name, _, _ in filters}
    proved = 0
    for _, what, (_, others) in mutants.mutated(ROOT):
        if changed(filters, others):
            proved += 1
            if not any(name in names for name in changed(filters, others) if any(
                    line.startswith(f"{name}: its text has changed") for line in faults(files, others))):
                wrong.append(f"not refused: {what}")
    if proved < 3 * len(extract.FILTERS) // 2 + 10:
        wrong.append(f"only {proved} mutants")
    for fault in ("Admitted.", "Axiom x : False.", "Parameter x : nat.", "Unset Guard Checking."):
        if not any("plane.v" in line for line in faults({**files, "plane": files["plane"] + fault}, filters)):
            wrong.append(f"not refused: {fault}")
    if list(faults({**files, "plane": files["plane"] + "(* Admitted *)"}, filters)):
        wrong.append("refused: a comment")
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / ".nia.cache").touch()
        if not any(".nia.cache" in line for line in faults(files, filters, pathlib.Path(folder))):
            wrong.append("not refused: .nia.cache")
    for theorem in theorems_of("plane"):
        without = {name: text.replace(f"Theorem {theorem}", "Theorem plane_wrong") for name, text in files.items()}
        if not any(f"plane: no theorem {theorem}" in line for line in faults(without, filters)):
            wrong.append(f"not refused: a filter without {theorem}")
    print(f"{proved} mutants refused" if not wrong else "")
    return wrong


def proof_of(theorem, files):
    return next(file for file, text in files.items() if re.search(rf"^Theorem {theorem}\b", text, re.M))


def try_mutants(work, jobs, only):
    """Coq's own word on each mutant, its text taken as looked at. A proof names the constants that it shows to be
    enough, so it fails with any other."""
    made, filters = extract.all_of(ROOT)
    files = {**sources(), **made}
    shutil.rmtree(work, ignore_errors=True)
    proof, wrong = Proof(work, files), []
    proved = {proof_of(f"{name}_right", files) for name, _, _ in filters if only in (None, name)}
    failed = proof.compile_all([name for name in closure(proved, files)], jobs)
    if failed:
        return [f"not proved: {failed[0]}.v", failed[1]]

    def proved_from(definitions, file):
        """With these files of definitions, and all compiled again that rests on those that differ."""
        new = {name for name in made if (work / f"{name}.v").read_text(encoding="utf-8") != definitions[name]}
        for name in new:
            (work / f"{name}.v").write_text(definitions[name], encoding="utf-8")
        return not proof.compile_all([n for n in closure({file}, files) if new & closure({n}, files)], jobs)

    for _, what, (other, others) in mutants.mutated(ROOT):
        names = [n for n in changed(filters, others) if only in (None, n)]
        held = []
        for file in sorted({proof_of(f"{n}_right", files) for n in names}):
            if proved_from(other, file):
                held.append(file)
            if not proved_from(made, file):  # else what fails with the mutant may fail for another reason
                wrong.append(f"not proved without a mutant: {file}.v")
        if names:
            said = f"proved all the same: {', '.join(held)}" if held else "not proved"
            print(f"{what}: changed text; {said}", flush=True)
        if held:
            wrong.append(f"{what} is proved")
    return wrong


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "proofs")
    options.add_argument("--jobs", type=int, default=2)
    options.add_argument("--reviewed", action="store_true")
    options.add_argument("--share", action="store_true")
    options.add_argument("--only", metavar="NAME")
    options.add_argument("--self-check", action="store_true")
    options.add_argument("--mutants", nargs="?", const="", metavar="FILTER")
    given = options.parse_args()
    if given.reviewed:
        lines = [f"{name} {digest}\n" for name, _, digest in extract.all_of(ROOT)[1]]
        (HERE / "reviewed.txt").write_text("".join(lines), encoding="utf-8")
        return 0
    if given.self_check:
        found = self_check()
    elif not shutil.which("coqc"):
        print("skipped: no coqc (Debian: coq libcoq-flocq)")
        return SKIPPED
    elif given.mutants is not None:
        found = try_mutants(given.work, given.jobs, given.mutants or None)
    else:
        found = prove(given.work, given.jobs, SHARE if given.share else {given.only} if given.only else None)
    for line in found:
        print(line, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
