#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the installed package holds what users need, nothing else, and headers that name each other as <touchstone/...>.

  package_holds.py SOURCE PREFIX   the package installed below PREFIX from the sources in SOURCE
  package_holds.py --self-check    listings with one defect each: every defect must be found
"""
import pathlib
import re
import subprocess
import sys

COMPONENTS = "geometry|reference|robust|oracle|certify|judge|audit|testing|c"
LIB = r"lib(/[\w.-]+)?"
ROWS = pathlib.Path(__file__).resolve().parents[2] / "catalogue/rows"
CHAPTER = "({})".format("|".join(sorted(folder.name for folder in ROWS.iterdir())))
# Every installed file is one of these, and each of these is there.
HELD = [
    r"bin/touchstone",
    rf"{LIB}/libtouchstone_(robust|oracle|certify|c|module_(catalogue|judge|audit|simulate|report|program))\.a",
    rf"{LIB}/cmake/touchstone/touchstone-config(-version)?\.cmake",
    rf"{LIB}/cmake/touchstone/touchstone-({COMPONENTS})(-\w+)?\.cmake",
    rf"{LIB}/cmake/touchstone/(components|touchstone_add_(audit|engine)|FindGMP|FindMPFR)\.cmake",
    rf"{LIB}/pkgconfig/touchstone-({COMPONENTS})\.pc",
    r"include/touchstone(_robust|_record(_log)?)?\.h",
    r"include/touchstone/record\.h",
    r"include/touchstone/geometry/\w+\.h",
    rf"include/touchstone/(reference|robust|oracle|catalogue/signatures)/{CHAPTER}/\w+\.h",
    r"include/touchstone/reference/standard/\w+\.h",
    r"include/touchstone/robust/(masked_exceptions|(kernel(/\w+){1,2}|batch|batch/isa|prepared|structures)/\w+)\.h",
    r"include/touchstone/oracle/(truth|(exact/\w+|rings)/\w+|certificates/(certificate|check))\.h",
    r"include/touchstone/catalogue/((shape|numbers|codec|draw|families(/\w+)?|judge|operation(/\w+)?)/)?\w+\.h",
    r"include/touchstone/catalogue/signatures/(all|signature)\.h",
    r"include/touchstone/audit/([\w/]+/)?\w+\.h",
    r"include/touchstone/program/(engine_main|terminal/uses)\.h",
    r"include/touchstone/testing/(rapidcheck|catch2|fuzzed_data)\.h",
    r"include/touchstone/testing/\w+\.h",
    r"share/touchstone/vectors/[a-z_0-9]+\.jsonl",
    r"share/touchstone/vectors/(schemas?|meshes)[./].*",
    r"share/touchstone/certify/certify\.py",
    r"share/touchstone/certify/certify_\w+\.py",
    r"share/doc/touchstone/LICENSE",
    r"share/doc/touchstone/(README|CHANGELOG)\.md",
    r"share/doc/touchstone/CITATION\.cff",
    r"share/doc/touchstone/docs/.+\.md",
    r"share/doc/touchstone/examples/my_engine/(CMakeLists\.txt|main\.cpp|my_engine\.h)",
    r"share/doc/touchstone/examples/engine\.(py|mjs)",
]
# May be there: what comes with a part that not every tree has.
ALLOWED = [
    r"share/touchstone/vectors/[^/]+",
    r"share/doc/touchstone/(docs|examples)/.+",
    r"share/(man/man1/touchstone\.1|bash-completion/completions/touchstone|zsh/\S+|fish/\S+)",
]
NEVER = r"include/touchstone/(report|engines|robust/(rings|hulls|pairs)|proptests)/|__pycache__|node_modules"
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(["<])([^">]+)[">]', re.MULTILINE)


def defects_of_listing(files):
    for pattern in HELD:
        if not any(re.fullmatch(pattern, file) for file in files):
            yield f"nothing is installed as {pattern}"
    for file in files:
        if re.search(NEVER, file):
            yield f"{file}: not for users"
        elif not any(re.fullmatch(pattern, file) for pattern in HELD + ALLOWED):
            yield f"{file}: why is it installed?"


def defects_of_header(file, text, files):
    for quote, target in INCLUDE.findall(text):
        if quote == '"':
            yield f'{file}: includes "{target}", which may be a file of the user\'s'
        elif target.startswith("touchstone/") and f"include/{target}" not in files:
            yield f"{file}: includes <{target}>, which is not installed"


def defects(source, prefix):
    files = {p.relative_to(prefix).as_posix() for p in prefix.rglob("*") if p.is_file()}
    yield from defects_of_listing(sorted(files))
    for file in sorted(files):
        if file.startswith("include/"):
            yield from defects_of_header(file, (prefix / file).read_text(encoding="utf-8"), files)
    # So that it can be moved, and no one else's paths are in it.
    for file in sorted(files):
        text = (prefix / file).read_bytes() if file.startswith("lib") and file.endswith((".cmake", ".pc")) else b""
        for place in (source, prefix):
            if str(place.resolve()).encode() in text:
                yield f"{file}: holds the path {place}"
    for vectors in sorted((source / "vectors").glob("*.jsonl")):
        if f"share/touchstone/vectors/{vectors.name}" not in files:
            yield f"{vectors.name}: test vectors that are not installed"
    # The checker in Python works from where it is, on the vectors that are beside it.
    share = prefix / "share/touchstone"
    checked = subprocess.run([sys.executable, "-B", share / "certify/certify.py", share / "vectors/orientation.jsonl"],
                             capture_output=True, text=True)
    if checked.returncode != 0 or not re.search(r"^[1-9]\d* certificates, 0 refused\b", checked.stdout, re.MULTILINE):
        yield f"certify.py: exit code {checked.returncode}: {checked.stdout[-300:]}{checked.stderr[-300:]}"


def right_listing():
    config = "touchstone-config.cmake touchstone-robust-release.cmake components.cmake".split()
    include = """record.h geometry/points.h reference/lines/touch.h robust/kernel/filters/staged.h oracle/truth.h catalogue/operation/row.h
        reference/standard/slabs.h catalogue/signatures/all.h audit/engines/fuzz.h program/engine_main.h testing/rapidcheck.h""".split()
    doc = """LICENSE README.md CITATION.cff docs/engines.md examples/my_engine/main.cpp examples/engine.py""".split()
    return (["bin/touchstone", "lib/libtouchstone_robust.a", "lib/pkgconfig/touchstone-robust.pc"] +
            [f"lib/cmake/touchstone/{file}" for file in config] + ["include/touchstone_robust.h"] + [f"include/touchstone/{file}" for file in include] +
            ["share/touchstone/vectors/touch.jsonl", "share/touchstone/vectors/schema.json"] +
            ["share/touchstone/certify/certify.py", "share/touchstone/certify/certify_lines.py"] +
            [f"share/doc/touchstone/{file}" for file in doc])


def self_check():
    right = right_listing()
    wrong = [f"a right listing was blamed: {defect}" for defect in defects_of_listing(right)]
    for file in ("include/touchstone/report/html.h", "include/touchstone/engines/one_hit.h",
                 "include/touchstone/robust/rings/touch.h", "include/geometry/points.h",
                 "include/touchstone/robust/lines/touch.cpp", "share/doc/touchstone/examples/__pycache__/a.pyc"):
        if not list(defects_of_listing(right + [file])):
            wrong.append(f"{file} was not noticed")
    for file in right:
        if not list(defects_of_listing([other for other in right if other != file])):
            wrong.append(f"that {file} is missing was not noticed")
    files = {"include/touchstone/geometry/points.h"}
    for text, count in (("#include <touchstone/geometry/points.h>\n#include <vector>\n", 0), ('#include "geometry/points.h"\n', 1),
                        ("#include <touchstone/report/pages/html.h>\n", 1)):
        if len(list(defects_of_header("here.h", text, files))) != count:
            wrong.append(f"{text.strip()}: another number of defects than {count}")
    return wrong


def main():
    if sys.argv[1:] == ["--self-check"]:
        found = self_check()
    elif len(sys.argv) == 3:
        found = list(defects(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
    else:
        sys.exit(__doc__)
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
