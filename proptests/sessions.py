# SPDX-License-Identifier: Apache-2.0
"""Holds sessions at a shell: commands, and what they print.

sessions.py --program PROGRAM FILE.txt: runs each command of the file by bash, in a folder that is empty at first, with
the program as `touchstone`, and compares what it prints with what stands below it.

    setup                          lines before the first case: functions and variables that every command has
    ## a sentence                  begins a case
    $ command                      a command; lines that begin with "> " continue it, "# " above it is a comment
    printed                        its standard output
    ! complained                   its standard error
    exit code 1                    stands where the exit code is not 0

"..." stands for any text within a line and, on a line of its own, for any lines. $SOURCE is the source folder. With
TOUCHSTONE_WRITE_GOLDEN=1 in the environment the file is written anew, to be looked at: a command that prints what is
expected of it keeps its text, every other gets what it prints now.
"""
import argparse
import difflib
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[1]


def parsed(text):
    """The setup, and the cases: [(sentence, [(command, lines expected)])]."""
    setup, *cases = re.split(r"^## ", text, flags=re.MULTILINE)
    step = re.compile(r"((?:# .*\n)*\$ .*\n(?:> .*\n)*)((?:(?!(?:# .*\n)*\$ |> ).*\n)*)")
    found = []
    for sentence, _, rest in (case.partition("\n") for case in cases):
        rest = rest.rstrip("\n") + "\n"
        steps = step.findall(rest)
        assert "".join(map("".join, steps)) == rest, f"{sentence}: a line belongs to no command"
        found.append((sentence, [(command, wanted.splitlines()) for command, wanted in steps]))
    return setup, found


def printed_by(command, folder, variables):
    run = subprocess.run(["bash", "-c", command], cwd=folder, env=variables, capture_output=True, timeout=600)
    out, complaints = (stream.decode(errors="backslashreplace").replace(str(SOURCE), "$SOURCE").replace("\r", "\\r")
                       .replace("\x1b", "\\e").splitlines() for stream in (run.stdout, run.stderr))
    return out + ["! " + line for line in complaints] + [f"exit code {run.returncode}"] * (run.returncode != 0)


def fits(wanted, printed):
    while printed and not printed[-1]:  # a line between cases is no output
        printed = printed[:-1]
    pattern = "".join("(?:.*\n)*" if line == "..." else ".*".join(map(re.escape, line.split("..."))) + "\n"
                      for line in wanted)
    return re.fullmatch(pattern, "".join(line + "\n" for line in printed)) is not None


def run(file, program):
    """Returns the complaints, and the file with what the program prints now."""
    setup, cases = parsed(file.read_text(encoding="utf-8"))
    wrong, anew = [], setup
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as programs:
        Path(programs, "touchstone").symlink_to(program)
        variables = {**os.environ, "PATH": programs + os.pathsep + os.environ["PATH"], "SOURCE": str(SOURCE)}
        for sentence, steps in cases:
            anew += f"## {sentence}\n"
            for command, wanted in steps:
                printed = printed_by(setup + re.sub("^[$>] ", "", command, flags=re.MULTILINE), folder, variables)
                if not fits(wanted, printed):
                    diff = difflib.unified_diff(wanted, printed, "expected", "printed", lineterm="", n=1)
                    wrong.append("\n".join([f"{file.name}: {sentence}", command.rstrip(), *diff]))
                    wanted = printed
                anew += command + "".join(line + "\n" for line in wanted)
            anew += "\n"
    return wrong, anew.rstrip("\n") + "\n"


def self_check():
    for wanted, printed, fitting in (
            (["a"], ["a"], True), (["a"], ["b"], False), (["a"], [], False), ([], ["a"], False),
            (["a...c"], ["abc"], True), (["a...c"], ["ab"], False), (["...", "b"], ["a", "a", "b"], True),
            (["...", "b"], ["b", "a"], False), (["a.c"], ["abc"], False), (["a", "..."], ["a"], True)):
        assert fits(wanted, printed) == fitting, (wanted, printed)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "x.txt")
        text = ("f() { echo \"f $1\"; }\n\n## one\n$ f 1\nf 1\n$ touchstone 3 >&2\n> exit 2\n! 3\nexit code 2\n\n"
                "## two\n$ f 2\n")
        for right, complaints in ((text + "f 2\n", 0), (text, 1), (text.replace("code 2", "code 1") + "f...\n", 1)):
            file.write_text(right)
            wrong, anew = run(file, "/bin/echo")
            assert len(wrong) == complaints, wrong
            assert anew == (right if complaints == 0 else text + ("f...\n" if "f..." in right else "f 2\n")), anew


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path)
    parser.add_argument("--self-check", action="store_true")
    parser.add_argument("files", nargs="*", type=Path)
    options = parser.parse_args()
    if options.self_check:
        self_check()
    complaints = []
    for file in options.files:
        wrong, anew = run(file, options.program.resolve())
        complaints += wrong
        if wrong and os.environ.get("TOUCHSTONE_WRITE_GOLDEN"):
            file.write_text(anew, encoding="utf-8")
    print("\n\n".join(complaints), end="\n" if complaints else "")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
