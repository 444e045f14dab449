#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the pages hold.

  documentation.py --program PATH   the pages of the tree around this file
  documentation.py --self-check     small trees with one defect each: every defect must be found

Links lead to files that are there, and to headings. A block marked `console` shows commands (`$ ...`) with what they
print; each is run as it stands, with the program in place of build/release/touchstone, and a line `...` stands for any
lines. A block marked `console terminal` is run on a terminal, where `./dev audit` stands for the program's audit of as
many cases. Commands of ./dev and of touchstone that a page names exist. The version is the same in CMakeLists.txt,
CITATION.cff, CHANGELOG.md and the program. README.md shows the table of pairs of shapes of docs/operations.md. facts.py checks numbers."""
import argparse
import os
import pathlib
import pty
import re
import subprocess
import sys
import tempfile
import threading

LINK = re.compile(r"(?<!!)\[[^\]]*\]\(([^)\s]+)\)|!\[[^\]]*\]\(([^)\s]+)\)")
PROGRAM = "build/release/touchstone"


def pages(root):
    return sorted(path for pattern in ("*.md", "*/*.md", "*/*/*.md") for path in root.glob(pattern)
                  if path.relative_to(root).parts[0] != "build")


def text_outside_code(text):
    return re.sub(r"```.*?```|`[^`\n]*`", "", text, flags=re.DOTALL)


def anchor(heading):
    """As GitHub makes it."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def anchors(path):
    headings = re.findall(r"^#+ (.*)$", path.read_text(encoding="utf-8"), re.MULTILINE)
    return {anchor(heading) for heading in headings}


def links(root, page):
    for groups in LINK.findall(text_outside_code(page.read_text(encoding="utf-8"))):
        target = groups[0] or groups[1]
        if re.match(r"[a-z]+:", target):
            continue
        file, _, place = target.partition("#")
        path = (page.parent / file).resolve() if file else page
        if not path.exists():
            yield f"{page.relative_to(root)}: {target}: there is no such file"
        elif place and place not in anchors(path):
            yield f"{page.relative_to(root)}: {target}: there is no such heading"


def commands(root, page, usage, subcommands):
    text = page.read_text(encoding="utf-8")
    for name in re.findall(r"\./dev ([a-z]+)", text):
        if f"./dev {name}" not in usage:
            yield f"{page.relative_to(root)}: ./dev {name}: ./dev knows no such command"
    for name in re.findall(rf"{PROGRAM} ([a-z][a-z-]*)", text):
        if name not in subcommands:
            yield f"{page.relative_to(root)}: touchstone {name}: the program knows no such command"


def matches(shown, printed):
    if not shown:
        return not printed
    if shown[0] == "...":
        return any(matches(shown[1:], printed[i:]) for i in range(len(printed) + 1))
    return bool(printed) and shown[0] == printed[0] and matches(shown[1:], printed[1:])


def printed_on_terminal(command, root):
    """Writes a mark when the command has ended and reads up to it: some systems lose what is still on its way when
    the last writer closes a terminal."""
    terminal, side = pty.openpty()
    end, printed = b"\0", b""
    with subprocess.Popen(command, shell=True, cwd=root, stdout=side, stderr=subprocess.DEVNULL) as running:
        waiting = threading.Thread(target=lambda: (running.wait(), os.write(side, end)))
        waiting.start()
        while not printed.endswith(end):
            printed += os.read(terminal, 65536)
        waiting.join()
    os.close(side)
    os.close(terminal)
    return printed[:-len(end)].decode().splitlines()


def shown_output(root, page, program):
    text = page.read_text(encoding="utf-8")
    for terminal, block in re.findall(r"^```console( terminal)?\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        for part in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
            command, *shown = part.rstrip("\n").split("\n")
            run = command.replace(PROGRAM, str(program))
            if terminal:
                printed = printed_on_terminal(run.replace("./dev audit", f"{program} audit --cases 2000 --by-cost"), root)
            else:
                printed = subprocess.run(run, shell=True, cwd=root, text=True, stdout=subprocess.PIPE,
                                         stderr=subprocess.STDOUT).stdout.splitlines()
            if not matches(shown, printed):
                yield f"{page.relative_to(root)}: $ {command}: it prints\n" + "\n".join(printed[:40])


def versions(root, told):
    """The version and its date. told: what the program says of itself."""
    release = r"([\d.]+)%s(\d{4}-\d\d-\d\d)"
    texts = {file: (root / file).read_text(encoding="utf-8") for file in ("CMakeLists.txt", "CITATION.cff", "CHANGELOG.md")}
    found = {place: re.search(pattern, text, re.MULTILINE | re.DOTALL) for place, text, pattern in (
        ("--version", told, r"\Atouchstone " + release % r" \(" + r"\)$"),
        ("CMakeLists.txt", texts["CMakeLists.txt"], r"^project\(touchstone VERSION " + release % r" .*^set\(TOUCHSTONE_RELEASE_DATE "),
        ("CITATION.cff", texts["CITATION.cff"], "^version: " + release % "\ndate-released: " + "$"),
        ("CHANGELOG.md", texts["CHANGELOG.md"], "^## " + release % " - " + "$"))}
    found = {place: " of ".join(match.groups()) if match else "none" for place, match in found.items()}
    if len(set(found.values())) > 1:
        yield "versions differ: " + ", ".join(f"{place} {version}" for place, version in found.items())


def shape_pairs(root):
    """README.md shows the table of two shapes in space that docs/operations.md has."""
    text = (root / "docs/operations.md").read_text(encoding="utf-8")
    for row in re.search(r"^\| In space .*?\n\n", text + "\n\n", re.MULTILINE | re.DOTALL)[0].splitlines():
        if row and row.replace("(#", "(docs/operations.md#") not in (root / "README.md").read_text(encoding="utf-8"):
            yield f"README.md: shape against shape: docs/operations.md has {row}"


def defects(root, program, usage, subcommands, told):
    for page in pages(root):
        yield from links(root, page)
        yield from commands(root, page, usage, subcommands)
        yield from shown_output(root, page, program)
    yield from shape_pairs(root)
    yield from versions(root, told)


RIGHT = {
    "README.md": "# A\n[there](docs/page.md#two-words) ![](picture.png) `[no](link.md)`\n```console\n"
                 f"$ echo 1; echo 2; echo 3\n1\n...\n3\n$ {PROGRAM} ask\nasked\n```\n./dev test\n"
                 "```console terminal\n$ ./dev audit; test -t 1 && echo yes\nasked\nyes\n```\n"
                 "| In space |\n| [touch](docs/operations.md#lines) |\n",
    "docs/page.md": "# Two `words`\n[up](../README.md) [out](https://example.org)\n",
    "docs/operations.md": "| In space |\n| [touch](#lines) |\n\n## lines\n",
    "picture.png": "",
    "CMakeLists.txt": "project(touchstone VERSION 1.2.3 LANGUAGES CXX)\nset(TOUCHSTONE_RELEASE_DATE 2026-01-31)\n",
    "CITATION.cff": "version: 1.2.3\ndate-released: 2026-01-31\n",
    "CHANGELOG.md": "## Unreleased\n## 1.2.3 - 2026-01-31\n## 1.2.2 - 2025-01-31\n",
    "program": "#!/bin/sh\necho asked\n",
}
WRONG = [
    ("README.md", "docs/page.md#", "docs/pages.md#", "docs/pages.md#two-words: there is no such file"),
    ("README.md", "#two-words", "#two", "docs/page.md#two: there is no such heading"),
    ("README.md", "picture.png", "pictures.png", "pictures.png: there is no such file"),
    ("README.md", "\n3\n", "\n4\n", "$ echo 1; echo 2; echo 3: it prints"),
    ("README.md", "asked", "refused", f"$ {PROGRAM} ask: it prints"),
    ("README.md", "\nyes", "\nno", "test -t 1 && echo yes: it prints"),
    ("README.md", "./dev test", "./dev tset", "./dev tset: ./dev knows no such command"),
    ("README.md", f"{PROGRAM} ask\nasked", f"{PROGRAM} aks\nasked", "touchstone aks: the program knows no"),
    ("README.md", "[touch]", "[touches]", "shape against shape: docs/operations.md has | [touch](#lines) |"),
    ("docs/page.md", "../README.md", "README.md", "README.md: there is no such file"),
    ("CITATION.cff", "1.2.3", "1.2.4", "versions differ"),
    ("CITATION.cff", "-31", "-30", "versions differ"),
    ("CMakeLists.txt", "1.2.3", "1.2", "versions differ"),
    ("CHANGELOG.md", "1.2.3", "1.2.5", "versions differ"),
]


def self_check():
    for file, before, after, wanted in [("README.md", "", "", None), *WRONG]:
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            for name, text in RIGHT.items():
                (root / name).parent.mkdir(exist_ok=True)
                changed = text.replace(before, after, 1) if name == file and before else text
                (root / name).write_text(changed, encoding="utf-8")
            (root / "program").chmod(0o755)
            found = list(defects(root, root / "program", "./dev test   build\n./dev audit   ask", {"ask"}, "touchstone 1.2.3 (2026-01-31)\nelse"))
        if wanted is None and found:
            yield f"the right tree: {found}"
        if wanted is not None and not (len(found) == 1 and wanted in found[0]):
            yield f"{file}: {after}: found {found}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path)
    parser.add_argument("--self-check", action="store_true")
    options = parser.parse_args()
    if options.self_check:
        found = list(self_check())
    else:
        root = pathlib.Path(__file__).resolve().parent.parent
        usage = subprocess.run([root / "dev", "help"], check=True, text=True, stdout=subprocess.PIPE).stdout
        help_text, version = (subprocess.run([options.program, option], check=True, text=True, stdout=subprocess.PIPE).stdout
                              for option in ("--help", "--version"))
        subcommands = set(re.findall(r"^  ([a-z][a-z-]*)  ", help_text, re.MULTILINE))
        found = list(defects(root, options.program.resolve(), usage, subcommands, version))
    print("\n".join(found) or "the pages hold")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
