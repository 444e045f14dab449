#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Proves with Coq that certificates prove their truths, and builds the program that checks them with what is proved.

  kinds.py                     proves everything, from nothing, and prints the axioms that it rests on
  kinds.py --build             builds certify_proved from the formulas; it extracts and compiles, and proves nothing
  kinds.py --weakened [SHARE]  each condition of weakened.jsonl weakened: a proof has to fail; of SHARE one in so many
  kinds.py --self-check        open steps, axioms and missing theorems are refused, without a run of Coq

--work DIR is where it works, build/kinds unless told; --build leaves DIR/certify_proved.

A formula check_OPERATION of formulas_*.v has two theorems. OPERATION_sound: if the formula holds of an input, a truth
and a certificate, the truth holds of the input, as ../spec says it. OPERATION_unique: of one input, no two different
truths hold. So have the formulas rounds_WHERE of formulas_rounding.v, which say that a double is a number rounded;
rounds_as_flocq says that the nearest double is what Flocq rounds to.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
SPEC = HERE.parent / "spec"
sys.path.insert(0, str(ROOT / "robust/proofs"))
sys.dont_write_bytecode = True
import prove

LONGEST_SPECIFICATION = 480  # an hour of reading: 450 lines for the truths of operations, the rest for what rounding means


MISSING = "skipped: no coqc or no ocamlfind (Debian: coq libcoq-flocq ocaml ocaml-findlib libzarith-ocaml-dev)"


def installed():
    return shutil.which("coqc") and shutil.which("ocamlfind")


def sources():
    paths = [path for folder in (SPEC, HERE) for path in sorted(folder.glob("*.v"))]
    return {path.stem: path.read_text(encoding="utf-8") for path in paths}


def operations(files):
    return [name for file, text in sorted(files.items()) if file.startswith("formulas_")
            for name in re.findall(r"^Definition check_(\w+)", text, re.M)]


def roundings(files):
    return re.findall(r"^Definition (rounds_\w+)", files["formulas_rounding"], re.M)


def theorems(files):
    named = [f"{name}_{what}" for name in operations(files) + roundings(files) for what in ("sound", "unique")]
    return named + ["rounds_as_flocq"]


def refused(files):
    """Yields what is refused before Coq is asked."""
    for folder in (SPEC, HERE):
        for path in folder.iterdir():
            if path.suffix in (".vo", ".vos", ".vok", ".glob", ".aux") or path.name.endswith(".cache"):
                yield f"{path.name} is here: proofs start from nothing"
    for name, text in files.items():
        for found in prove.OPEN.finditer(prove.bare(text)):
            yield f"{name}.v: {found[0]}"
    stated = {theorem for text in files.values() for theorem in re.findall(r"^Theorem (\w+)", text, re.M)}
    for theorem in theorems(files):
        if theorem not in stated:
            yield f"no theorem {theorem}"
    lines = sum(len(path.read_text(encoding="utf-8").splitlines()) for path in SPEC.glob("*.v"))
    if lines > LONGEST_SPECIFICATION:
        yield f"the specification has {lines} lines, more than {LONGEST_SPECIFICATION}"


def not_stated(files):
    """Yields what docs/proofs.md does not say."""
    page = (ROOT / "docs/proofs.md").read_text(encoding="utf-8").partition("## Certificates that are proved to prove")[2]
    told = set(re.findall(r"`(\w+)`", "".join(line for line in page.splitlines() if line.startswith("|"))))
    yield from (f"docs/proofs.md: no row names {name}" for name in operations(files) if name not in told)
    lines = sum(len(path.read_text(encoding="utf-8").splitlines()) for path in SPEC.glob("*.v"))
    if f"{lines} lines that speak" not in page.replace("\n", " "):
        yield f"docs/proofs.md: the specification has {lines} lines"


def fresh(work, files):
    shutil.rmtree(work, ignore_errors=True)
    return prove.Proof(work, files, "Certificates")


def prove_all(work, jobs):
    started = time.monotonic()
    files = sources()
    found = list(refused(files))
    if found:
        return found
    files.pop("extraction")
    groups = {what: [theorem for theorem in theorems(files) if theorem.endswith(what)]
              for what in ("sound", "unique", "flocq")}
    files["assumptions"] = f"From Certificates Require Import {' '.join(sorted(files))}.\n" + "".join(
        f"Definition all_{what} := ({', '.join(group)}).\nPrint Assumptions all_{what}.\n"
        for what, group in groups.items())
    proof = fresh(work, files)
    failed = proof.compile_all(list(files), jobs)
    if failed:
        return [f"not proved: {failed[0]}.v", failed[1]]
    said = proof.compile("assumptions")[1]
    parts = re.split(r"^(?:Axioms:|Closed under the global context)$", said, flags=re.M)[1:]
    if len(parts) != len(groups):
        return [f"{len(groups)} questions, but {len(parts)} lists of axioms", said]
    for group, part in zip(groups.values(), parts):
        axioms = re.findall(r"^([\w.]+)\s*:?$|^([\w.]+)\s*:", part, re.M)
        axioms = [one or other for one, other in axioms]
        if set(axioms) - prove.AXIOMS:
            return [f"rests on {', '.join(sorted(set(axioms) - prove.AXIOMS))}"]
        print(f"{', '.join(group)}: proved. Axioms: {', '.join(axioms) or 'none'}")
    count = sum(map(len, groups.values()))
    seconds = time.monotonic() - started
    print(f"{count} theorems about certificates of {len(operations(files))} operations, and about rounding, "
          f"{seconds:.0f} s from nothing")
    return []


def extracted(files, wanted):
    """extraction.v, told what to extract; of the files only those are wanted that formulas need."""
    checks = " ".join([f"check_{operation}" for operation in operations(files)] + roundings(files))
    return (f"From Certificates Require Import {' '.join(sorted(wanted))}.\n"
            + files["extraction"] + f'\nExtraction "proved.ml" decide {checks}.\n')


def build(work, jobs):
    """certify_proved; returns what went wrong."""
    files = sources()
    wanted = prove.closure({name for name in files if name.startswith("formulas_")}, files)
    proof = fresh(work, {**{name: files[name] for name in wanted}, "extraction": extracted(files, wanted)})
    failed = proof.compile_all([name for name in proof.files], jobs)
    if failed:
        return [f"not extracted: {failed[0]}.v", failed[1]]
    for path in HERE.glob("*.ml"):
        shutil.copy(path, work)
    modules = [path.name for path in sorted(work.iterdir()) if path.suffix in (".ml", ".mli")]
    order = subprocess.run(["ocamlfind", "ocamldep", "-sort", *modules], cwd=work, check=True, text=True,
                           stdout=subprocess.PIPE).stdout.split()
    compiler = ["ocamlfind", "ocamlopt", "-O3", "-w", "-a", "-package", "zarith", "-linkpkg"]
    run = subprocess.run([*compiler, *order, "-o", "certify_proved"], cwd=work, text=True, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT)
    if run.returncode:
        return ["certify_proved: not compiled", run.stdout]
    return []


def weakened(work, jobs, share):
    """Each line: a condition `find` of `file`, what it is weakened to, and the file whose proof has to fail. Without any
    change that file has to be proved, else it may fail for another reason."""
    files, wrong = sources(), []
    lines = [json.loads(line) for line in (HERE / "weakened.jsonl").read_text(encoding="utf-8").splitlines()]
    chosen = lines[::share]
    proof = fresh(work, files)
    proofs = prove.closure({line["proof"] for line in chosen}, files)
    failed = proof.compile_all(list(proofs), jobs)
    if failed:
        return [f"not proved: {failed[0]}.v", failed[1]]
    compiled = {path: path.read_bytes() for path in work.glob("*.vo")}
    for line in chosen:
        file, text = line["file"], files[line["file"]]
        change = f"{file}.v: {line['find']} -> {line['plant']}"
        if text.count(line["find"]) != 1:
            wrong.append(f"{change}: it is there {text.count(line['find'])} times")
            continue
        (work / f"{file}.v").write_text(text.replace(line["find"], line["plant"]), encoding="utf-8")
        rests = [n for n in prove.closure({line["proof"]}, files) if file in prove.closure({n}, files)]
        failed = proof.compile_all(rests, jobs)
        if failed is None:
            wrong.append(f"{change}: still proved")
        elif failed[0] == file:
            wrong.append(f"{change}: this is no formula: {failed[1]}")
        else:
            print(f"{change}: {failed[0]}.v fails", flush=True)
        (work / f"{file}.v").write_text(text, encoding="utf-8")
        for path, held in compiled.items():
            path.write_bytes(held)
    print(f"{len(chosen)} of {len(lines)} conditions weakened")
    return wrong


def self_check():
    files, wrong = sources(), [*refused(sources()), *not_stated(sources())]
    for defect in ("Admitted.", "Axiom x : False.", "Parameter x : nat.", "Unset Guard Checking."):
        with_defect = {**files, "sound_plane": files["sound_plane"] + defect}
        if not any("sound_plane.v" in line for line in refused(with_defect)):
            wrong.append(f"not refused: {defect}")
    for theorem in theorems(files):
        without = {name: text.replace(f"Theorem {theorem} ", "Theorem another ") for name, text in files.items()}
        if f"no theorem {theorem}" not in list(refused(without)):
            wrong.append(f"not refused: no theorem {theorem}")
    return wrong


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--work", type=pathlib.Path, default=ROOT / "build/kinds")
    options.add_argument("--jobs", type=int, default=2)
    options.add_argument("--build", action="store_true")
    options.add_argument("--weakened", type=int, nargs="?", const=1, metavar="SHARE")
    options.add_argument("--self-check", action="store_true")
    given = options.parse_args()
    given.work.parent.mkdir(parents=True, exist_ok=True)
    if given.self_check:
        found = self_check()
    elif not installed():
        print(MISSING)
        return prove.SKIPPED
    elif given.build:
        found = build(given.work, given.jobs)
    elif given.weakened:
        found = weakened(given.work, given.jobs, given.weakened)
    else:
        found = prove_all(given.work, given.jobs)
    for line in found:
        print(line, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
