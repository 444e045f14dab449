#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds the program for other platforms and compares what it prints: platforms.py [NAME...]

A NAME is a preset that inherits `platform`, or `native` for this processor; without one, all are built. The libraries of a
platform are Debian's, unpacked below build/libraries, or built from its sources there; nothing is installed. Each check runs
there, under an emulator where one is needed, and with the program of build/release; the outputs have to be the same, byte for
byte. Tests of robust and of agreement with the oracle run, too, where they can be built. A platform is skipped where its
compiler, emulator or libraries are missing.

  --build TARGETS NAME  builds these and asks nothing
"""
import argparse
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

from libraries_from_source import libraries_from_source

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"
LIBRARIES = ["libgmp-dev", "libmpfr-dev", "libpng-dev", "zlib1g-dev", "libexpat1-dev", "libfmt-dev"]
OF_TESTS = ["catch2", "librapidcheck-dev"]  # without them the tests are left out
HEADERS = ["nlohmann-json3-dev", "libcli11-dev"]  # of every architecture
# What is asked of the program.
CHECKS = {
    "vectors": ["vectors", "check", "build/vectors_share", "--ops", "{operations}"],
    "soak": ["soak", "all", "--cases", "{cases}", "--json", "-"],
    "exhaust": ["exhaust", "segment_segment", "--grid", "8", "--decisions", "--json", "-"],
}

# Flags of its vectors say how exact the textbook formula is. The sine and cosine of MinGW-w64 are less exact than those
# of Linux: they are x87's, which know 66 binary digits of pi.
WITHOUT_ON_WINDOWS = {"parametric_circle"}

# Programs of tests, the share of their cases (TOUCHSTONE_CASES), and which tests: not those that take minutes with any share. That
# robust agrees with the oracle is asked by the soak.
TESTS = {
    "test_robust": (0.02, ["~ring_defect: the defect of a very long ring is named", "~*polyhedr*: every rounding mode*"]),
    "test_agreement": (0.005, ["--filenames-as-tags",
                               "[#arrays]~point_in_convex_polyhedron*,[#arrays_by_hand],[#draws],[#refusals]"]),
}


def platforms():
    """Name, triple and folder of libraries of each; for this processor the compiler instead of the triple, and no folder."""
    presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))["configurePresets"]
    known = {}
    for p in presets:
        variables = p.get("cacheVariables", {})
        if p.get("inherits") == "platform":
            libraries = variables["TOUCHSTONE_LIBRARIES"].replace("${sourceDir}", str(ROOT))
            known[p["name"]] = (variables["TOUCHSTONE_TRIPLE"], pathlib.Path(libraries))
        elif p.get("inherits") == "native":
            known[p["name"]] = (variables["CMAKE_CXX_COMPILER"], None)
    return known


def is_windows(triple):
    return "mingw" in triple


def compiler_of(triple):
    return f"{triple}-g++{'-posix' if is_windows(triple) else ''}" if "-" in triple else triple


def program_of(name, triple, program="touchstone"):
    return BUILD / name / (program + (".exe" if is_windows(triple) else ""))


def emulator_of(triple):
    """The command; for a processor, with the C library of the compiler. Empty for this processor."""
    if "-" not in triple:
        return []
    if is_windows(triple):
        return ["wine"]
    processor = triple.split("-")[0]
    loader = f"/usr/{triple}/lib/ld-linux.so.2"
    if processor == "i686" and shutil.which(loader) and subprocess.run([loader, "--version"], stdout=subprocess.DEVNULL,
                                                                       check=False).returncode == 0:
        return [loader, "--library-path", f"/usr/{triple}/lib"]  # this processor runs it
    cpu = {"aarch64": ["-cpu", "max,sve-default-vector-length=32"]}  # so that each instruction set of arrays is chosen
    return ["qemu-" + {"i686": "i386", "powerpc64le": "ppc64le"}.get(processor, processor), *cpu.get(processor, []), "-L",
            f"/usr/{triple}"]


def run_by(triple):
    emulator = emulator_of(triple)
    return emulator[0] if emulator and "/" not in emulator[0] else "this processor"


def unpack_libraries(triple, folder):
    """Why they are missing; empty if they are there."""
    if (folder / "complete").exists():
        return ""
    if is_windows(triple):
        return libraries_from_source(triple, folder)
    lists = folder.parent / f"{folder.name}_lists"
    for each in (folder, lists / "partial", lists / "cache/archives/partial"):
        each.mkdir(parents=True, exist_ok=True)
    apt = ["apt-get", "-qq", "-o", f"Dir::State::Lists={lists}", "-o", f"Dir::Cache={lists}/cache",
           "-o", f"APT::Architectures::={folder.name}", "-o", "Acquire::Retries=3"]
    if os.geteuid() == 0:
        apt += ["-o", "APT::Sandbox::User=root"]

    def download(names):
        return subprocess.run([*apt, "download", *names], cwd=folder, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL).returncode == 0

    subprocess.run([*apt, "update"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    if not download([f"{name}:{folder.name}" for name in LIBRARIES] + HEADERS):
        return libraries_from_source(triple, folder)
    for name in OF_TESTS:
        download([f"{name}:{folder.name}"])
    # The configuration of {fmt} wants the shared library to be there too.
    wanted = subprocess.run(["dpkg-deb", "-f", *folder.glob("libfmt-dev_*.deb"), "Depends"], stdout=subprocess.PIPE,
                            text=True, check=True).stdout
    download([f"{wanted.split()[0]}:{folder.name}"])
    for package in folder.glob("*.deb"):
        subprocess.run(["dpkg-deb", "-x", package, folder], check=True)
    (folder / "complete").touch()
    return ""


def build(name, triple, libraries, jobs, targets):
    """Why it is skipped; empty if the targets are built, or the program and its tests."""
    for program in (compiler_of(triple), *emulator_of(triple)[:1]):
        if shutil.which(program) is None:
            return f"no {program}"
    if libraries and (missing := unpack_libraries(triple, libraries)):
        return missing
    subprocess.run(["cmake", "--preset", name], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    if not targets:
        known = subprocess.run(["ninja", "-C", BUILD / name, "-t", "targets", "all"], stdout=subprocess.PIPE, text=True, check=True)
        targets = ["touchstone", *(test for test in TESTS if f"\n{test}: phony" in known.stdout)]
    subprocess.run(["cmake", "--build", BUILD / name, "-j", str(jobs), "--target", *targets], check=True)
    return ""


def share_of_vectors(share):
    """Writes every share-th vector of each operation; the operations."""
    to = BUILD / "vectors_share"
    shutil.rmtree(to, ignore_errors=True)
    to.mkdir(parents=True)
    shutil.copytree(ROOT / "vectors/meshes", to / "meshes")
    files = sorted((ROOT / "vectors").glob("*.jsonl"))
    for file in files:
        lines = file.read_text(encoding="utf-8").splitlines(keepends=True)
        (to / file.name).write_text("".join(lines[::share]), encoding="utf-8")
    return [file.stem for file in files]


def run(command, folder=ROOT, **variables):
    """The exit code and both outputs with the ends of lines that the program wrote. Wine keeps to build/."""
    wine = {"WINEPREFIX": str(BUILD / "wine"), "WINEDEBUG": "-all"}
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False,
                          env=os.environ | wine | variables)
    return done.returncode, done.stdout.decode(), done.stderr.decode()


def printed(command):
    code, output, errors = run(command)
    return f"exit {code}\n{output}{errors if code else ''}"


def shown(text):
    """The output of a run where it is a few words, otherwise the first digits of its SHA-256."""
    output = text.partition("\n")[2]
    return output.strip() if len(output) < 40 else hashlib.sha256(output.encode()).hexdigest()[:16]


def tested(name, triple):
    """The number of tests that passed, or the programs that did not; whether none failed."""
    if not all((BUILD / name / "tests" / program).exists() for program in TESTS):
        return "not built", True
    runs = []
    for program, (cases, which) in TESTS.items():  # side by side
        with (BUILD / name / f"{program}.txt").open("w", encoding="utf-8") as log:
            runs.append(subprocess.Popen([*emulator_of(triple), BUILD / name / "tests" / program, *which], cwd=ROOT, stdout=log,
                                         stderr=subprocess.STDOUT, env=os.environ | {"TOUCHSTONE_CASES": str(cases)}))
    passed, failed = 0, []
    for program, process in zip(TESTS, runs):
        log = BUILD / name / f"{program}.txt"
        failure = process.wait()
        all_of = re.search(r"All tests passed \(\d+ assertions? in (\d+) test cases?\)", log.read_text(encoding="utf-8"))
        if failure or not all_of:
            failed.append(str(log.relative_to(ROOT)))
        else:
            passed += int(all_of[1])
    return (f"failed: {', '.join(failed)}", False) if failed else (f"{passed} passed", True)


def ask(name, triple, native, given, operations):
    """Prints a row of the table; whether all is the same as here."""
    row, same, began = [name, compiler_of(triple), run_by(triple)], True, time.time()
    operations = [each for each in operations if not (is_windows(triple) and each in WITHOUT_ON_WINDOWS)]
    for check, arguments in CHECKS.items():
        arguments = [part.format(cases=given.cases, operations=",".join(operations)) for part in arguments]
        asked = " ".join(arguments)
        if asked not in native:
            native[asked] = printed([BUILD / "release/touchstone", *arguments])
        here = printed([*emulator_of(triple), program_of(name, triple), *arguments])
        row.append(shown(here) + ("" if here == native[asked] else " differs"))
        if here != native[asked] or not here.startswith("exit 0\n"):
            same = False
            (BUILD / name / f"{check}.txt").write_text(here, encoding="utf-8")
            (BUILD / name / f"{check}.native.txt").write_text(native[asked], encoding="utf-8")
            print(f"{name}: compare build/{name}/{check}.txt with {check}.native.txt", file=sys.stderr)
    tests, passed = tested(name, triple)
    row, same = [*row, tests], same and passed
    print("| " + " | ".join([*row, f"{time.time() - began:.0f} s"]) + " |", flush=True)
    return same


def example_holds(name, triple):
    """Runs the example of docs/platforms.md, an engine built for two processors; whether it prints what the page says."""
    page = (ROOT / "docs/platforms.md").read_text(encoding="utf-8")
    commands = re.search(rf"```sh\n([^`]*\n{re.escape(triple)}-g\+\+ [^`]*)```\n\n```\n([^`]*)```", page)
    if commands is None:  # no example for this platform
        return True
    script = re.sub(r"(?<= )(?:\./)?engine_|(?<=\")\./engine_", f"build/{name}/engine_", commands[1])
    done = subprocess.run(["sh", "-ec", script], cwd=ROOT, stdout=subprocess.PIPE, text=True)
    missing = [line for line in commands[2].splitlines() if line not in done.stdout.splitlines()]
    print(f"{name}: the example of two processors {'does not print' if missing else 'prints what the page says'}", *missing,
          sep="\n")
    return not missing


def pipes_hold(name, triple):
    """Has an engine for Windows audited, and the same engine for this machine, by commands of the same words; whether
    both audits print the same and write the same report."""
    if not is_windows(triple):
        return True
    of_both, found = BUILD / name / "pipes", {}
    shutil.rmtree(of_both, ignore_errors=True)
    of_both.mkdir()
    (of_both / "touchstone.exe").symlink_to(BUILD / "release/touchstone")
    searched_here = {"PATH": f"{of_both}:{os.environ['PATH']}"}
    searched_there = {"WINEPATH": f"Z:{BUILD / name}".replace("/", "\\")}
    for compiler, command, variables in (
            (["g++"], ["touchstone.exe"], searched_here),
            ([compiler_of(triple), "-static"], [*emulator_of(triple), "cmd", "/c", "touchstone.exe"], searched_there)):
        folder = of_both / compiler[0]
        folder.mkdir()
        engine = [ROOT / "examples/two_processors/engine.cpp", "-o", folder / "engine.exe"]
        subprocess.run([*compiler, "-std=c++20", "-O2", *engine], check=True)
        audit = ["audit", "--engine", "./engine.exe", "--cases", "2000", "--report", "report", "--json", "audit.json"]
        code, screen, _ = run([*command, *audit], folder, **variables)
        (folder / "screen.txt").write_text(screen, encoding="utf-8")
        # A page ends with compiler and libraries.
        written = {each.relative_to(folder): re.sub(rb"<p>touchstone [0-9.]+, [^<]*", b"<p>", each.read_bytes())
                   for each in [folder / "audit.json", *sorted((folder / "report").rglob("*"))] if each.is_file()}
        found[compiler[0]] = code, screen, written
    (here, there), files = found.values(), len(written)
    same = here == there and code == 1 and files > 2
    what = f"prints and writes the same, {files} files" if same else f"differs: compare the folders in build/{name}/pipes"
    print(f"{name}: an audit through pipes {what}", flush=True)
    return same


def scene_holds(name, triple):
    """Simulates a scene on Windows and here; whether float, double and robust move alike."""
    if not is_windows(triple):
        return True
    scene = ["simulate", "simulate/scenes/ball_on_stairs.json", "--trajectory", "-"]
    here = printed([BUILD / "release/touchstone", *scene])
    there = printed([*emulator_of(triple), program_of(name, triple), *scene])
    same = here == there and here.startswith("exit 0\n")
    print(f"{name}: a simulation {'takes the same steps' if same else 'takes other steps'} ({shown(there)})", flush=True)
    return same


def log_holds(name, triple):
    """Records the calls of examples/record/game.c on Windows and here; whether both logs have the same calls."""
    if not is_windows(triple):
        return True
    folder, logs = BUILD / name / "recorded", []
    folder.mkdir(exist_ok=True)
    for compiler, emulator in ((["gcc"], []), ([f"{triple}-gcc-posix", "-static"], emulator_of(triple))):
        game = folder / f"{compiler[0]}.exe"
        source = ["-std=c99", "-I", ROOT / "c", ROOT / "examples/record/game.c", "-lm", "-o", game]
        subprocess.run([*compiler, *source], check=True)
        log, lines = folder / f"{compiler[0]}.log", folder / f"{compiler[0]}.jsonl"
        if run([*emulator, game, log.name], folder)[0] != 0:
            return False
        subprocess.run([BUILD / "release/touchstone", "log", "convert", log, lines], check=True, stdout=subprocess.DEVNULL)
        logs.append(sorted(lines.read_text(encoding="utf-8").splitlines()))  # its two threads run in any order
    same = logs[0] == logs[1] and len(logs[0]) > 20_000
    print(f"{name}: a program that records its calls {'writes the same' if same else 'does not write the same'}")
    return same


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("names", nargs="*", metavar="NAME")
    options.add_argument("--build", metavar="TARGETS", default="", help="names with commas between them")
    options.add_argument("--only-names", action="store_true", help="only tell a name that is wrong")
    options.add_argument("--jobs", type=int, default=os.cpu_count())
    options.add_argument("--cases", type=int, default=200, help="questions of each operation in the soak")
    options.add_argument("--share", type=int, default=16, help="every SHARE-th vector is checked")
    given = options.parse_args()
    known, native, right = platforms(), {}, True
    for name in given.names:
        if name not in known:
            sys.exit(f"platforms: {name} is none of {', '.join(known)}")
    if given.only_names:
        return
    names = given.names or list(known)
    if given.build:
        for name in names:
            if skipped := build(name, *known[name], given.jobs, given.build.split(",")):
                sys.exit(f"platforms: {name}: {skipped}")
        return
    operations = share_of_vectors(given.share)
    columns = ["platform", "compiler", "run by", *CHECKS, "tests", "time"]
    print("| " + " | ".join(columns) + " |\n|" + "---|" * len(columns))
    for name in names:
        triple, libraries = known[name]
        skipped = build(name, triple, libraries, given.jobs, [])
        if skipped:
            print(f"| {name} | skipped: {skipped} |", flush=True)
        else:
            right &= ask(name, triple, native, given, operations)
            right &= example_holds(name, triple)
            right &= pipes_hold(name, triple)
            right &= scene_holds(name, triple)
            right &= log_holds(name, triple)
    sys.exit(0 if right else 1)


if __name__ == "__main__":
    main()
