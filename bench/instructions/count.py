#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Counts the instructions a row of decisions over arrays, with each instruction set, and compares the answers.

  count.py [--rows N] [--compared N]

rows.cpp is linked with the library of build/release, and for 64-bit Arm with that of build/aarch64 (./dev platforms aarch64).
x86 is stepped through by ptrace, Arm is executed by qemu, which logs every instruction: times under an emulator mean nothing,
these counts do. Every set has to give the same answers to COMPARED rows, byte for byte; otherwise it exits with 1."""
import argparse
import ctypes
import os
import pathlib
import signal
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "cmake"))
import platforms
TO = ROOT / "build/instructions"
FLAGS = ["-std=c++20", "-O2", "-ffp-contract=off", f"-I{ROOT}", str(ROOT / "bench/instructions/rows.cpp")]
OPERATIONS = ["orientation", "point_on_segment", "segment_segment", "point_plane", "aabb_aabb", "sphere_sphere", "sphere_aabb",
              "ray_aabb", "ray_triangle", "segment_triangle", "triangle_triangle"]
CASES = ["random", "grid"]
# The column of the table: where it runs, and the set that the program asks for.
SETS = {"SSE2": ("x86", "portable"), "AVX2": ("x86", "avx2"), "AVX-512": ("x86", "avx512"),
        "one double": ("arm", "portable"), "NEON": ("arm", "neon"), "SVE, 256 bits": ("arm", "sve")}
EMULATOR = platforms.emulator_of("aarch64-linux-gnu")
PTRACE_TRACEME, PTRACE_CONT, PTRACE_SINGLESTEP = 0, 7, 9
ptrace = ctypes.CDLL(None, use_errno=True).ptrace
ptrace.argtypes = [ctypes.c_long, ctypes.c_long, ctypes.c_void_p, ctypes.c_void_p]


def built():
    """{where: its program}."""
    TO.mkdir(parents=True, exist_ok=True)
    subprocess.run(["g++", *FLAGS, ROOT / "build/release/libtouchstone_robust.a", "-lmpfr", "-lgmpxx", "-lgmp", "-o", TO / "x86"],
                   check=True)
    programs = {"x86": [TO / "x86"]}
    library = ROOT / "build/aarch64/libtouchstone_robust.a"
    if library.exists():
        libraries = ROOT / "build/libraries/arm64/usr/lib/aarch64-linux-gnu"
        headers = ROOT / "build/libraries/arm64/usr/include"
        subprocess.run(["aarch64-linux-gnu-g++", *FLAGS, f"-I{headers}", f"-I{headers}/aarch64-linux-gnu", "-static", library,
                        f"-L{libraries}", "-lmpfr", "-lgmpxx", "-lgmp", "-o", TO / "arm"], check=True)
        programs["arm"] = [*EMULATOR, TO / "arm"]
    return programs


def stepped(command):
    """The instructions between the two signals, one by one."""
    child = os.fork()
    if child == 0:
        ptrace(PTRACE_TRACEME, 0, None, None)
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        os.execv(command[0], [str(word) for word in command])
    count, seen, request, passed_on = 0, 0, PTRACE_CONT, 0
    os.waitpid(child, 0)  # it has been loaded
    while True:
        ptrace(request, child, None, passed_on)
        _, status = os.waitpid(child, 0)
        if os.WIFEXITED(status):
            assert seen == 2 and os.WEXITSTATUS(status) == 0, (seen, status)
            return count
        passed_on = None
        if os.WSTOPSIG(status) == signal.SIGUSR1:
            seen += 1
            request = PTRACE_SINGLESTEP if seen == 1 else PTRACE_CONT
        elif os.WSTOPSIG(status) == signal.SIGTRAP:
            count += 1
        else:
            passed_on = os.WSTOPSIG(status)


def logged(command):
    """The same of a program that qemu executes, an instruction a block."""
    program = command[len(EMULATOR):]
    run = subprocess.Popen([*EMULATOR, "-singlestep", "-d", "nochain,exec,strace", *program], stdout=subprocess.DEVNULL,
                           stderr=subprocess.PIPE)
    counted = subprocess.run(["awk", "/kill\\(/ { seen++ } /^Trace/ && seen == 1 { count++ } END { print seen, count + 0 }"],
                             stdin=run.stderr, stdout=subprocess.PIPE, text=True, check=True)
    seen, count = counted.stdout.split()
    assert seen == "2" and run.wait() == 0, counted.stdout
    return int(count)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--rows", type=int, default=1024)
    options.add_argument("--compared", type=int, default=100000)
    given = options.parse_args()
    programs, same = built(), True
    sets = {name: (programs[where], where, set_of) for name, (where, set_of) in SETS.items() if where in programs}
    print("| decision | " + " | ".join(sets) + " | answers |\n|---|" + "--:|" * len(sets) + "---|")
    for operation in OPERATIONS:
        for cases in CASES:
            counts, answers = [], set()
            for command, where, set_of in sets.values():
                asked = [operation, set_of, cases]
                count = (stepped if where == "x86" else logged)([*command, *asked, str(given.rows), "marked"])
                counts.append(f"{count / given.rows:.1f}")
                answers.add(subprocess.run([*command, *asked, str(given.compared), "plain"], stdout=subprocess.PIPE, text=True,
                                           check=True).stdout.strip())
            same &= len(answers) == 1
            print("| " + " | ".join([f"{operation}, {cases}", *counts, " differs from ".join(sorted(answers))]) + " |", flush=True)
    sys.exit(0 if same else 1)


if __name__ == "__main__":
    main()
