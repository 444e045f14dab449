#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Packs the program for Windows: build/windows/packages/touchstone-VERSION-windows.zip, as ./dev package windows calls it.

It holds the program, the test vectors, the pages and examples, the notices of what is linked and a bill of materials;
SHA256SUMS is beside it. The same files give the same bytes: their date is that of the release.
"""
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

from bill_of_materials import bill, sources

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD, LIBRARIES = ROOT / "build/windows", ROOT / "build/libraries/windows"
PROGRAM, STRIP = BUILD / "touchstone.exe", "x86_64-w64-mingw32-strip"
FOLDERS, FILES = ["vectors", "docs", "examples"], ["LICENSE", "README.md", "CHANGELOG.md", "CITATION.cff"]
# Debian's packages of the runtime of g++ and of Windows' C library as MinGW-w64 has it.
RUNTIME = ["gcc-mingw-w64-base", "mingw-w64-common"]
LICENCE_OF_RUNTIME = pathlib.Path("/usr/share/common-licenses/GPL-3")
COPYRIGHT = """touchstone {version} is under the Apache License 2.0: LICENSE, in this folder.

touchstone.exe holds parts of these source packages of Debian; their notices are in the folder linked, and their sources
at https://snapshot.debian.org:
{linked}
Its integers and rounded numbers are our own: it holds nothing of GMP and MPFR.
"""


def linked_packages():
    """{source package: version}, {name: its notice}"""
    packages = dict(line.split() for line in (LIBRARIES / "sources.txt").read_text(encoding="utf-8").splitlines())
    notices = {package: LIBRARIES / "usr/share/doc" / package / "copyright" for package in packages}
    for archive in LIBRARIES.glob("*.deb"):  # of headers
        binary, version, _ = archive.stem.split("_")
        packages[binary.removesuffix("-dev").removeprefix("lib")] = version
        notices[binary] = LIBRARIES / "usr/share/doc" / binary / "copyright"
    for package in RUNTIME:
        packages |= sources([package])
        notices[package] = pathlib.Path("/usr/share/doc") / package / "copyright"
    if LICENCE_OF_RUNTIME.exists():
        notices["GPL-3"] = LICENCE_OF_RUNTIME
    return packages, notices


def released():
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    return (re.search(rf"^{field}: (.*)$", citation, re.MULTILINE)[1] for field in ("version", "date-released"))


def contents(version, date):
    """{name in the archive: bytes}"""
    packages, notices = linked_packages()
    with tempfile.TemporaryDirectory() as folder:
        stripped = pathlib.Path(folder) / PROGRAM.name
        subprocess.run([STRIP, "-o", stripped, PROGRAM], check=True)
        held = {PROGRAM.name: stripped.read_bytes()}
    for path in [ROOT / name for name in FILES] + [path for folder in FOLDERS for path in (ROOT / folder).rglob("*")]:
        if path.is_file() and not {"__pycache__", "node_modules"} & set(path.parts):
            held[path.relative_to(ROOT).as_posix()] = path.read_bytes()
    for name, notice in notices.items():
        held[f"linked/{name}.txt"] = notice.read_bytes()
    listed = "\n".join(f"  {name} {packages[name]}" for name in sorted(packages))
    held["copyright.txt"] = COPYRIGHT.format(version=version, linked=listed).encode()
    held["touchstone.spdx.json"] = (json.dumps(bill(version, date, packages), indent=1) + "\n").encode()
    return held


def main():
    if not PROGRAM.exists():
        sys.exit("package_windows: ./dev package windows builds the program")
    version, date = released()
    root, packed = f"touchstone-{version}-windows", BUILD / "packages"
    packed.mkdir(exist_ok=True)
    archive = packed / f"{root}.zip"
    day = tuple(int(part) for part in date.split("-"))
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as written:
        for name, content in sorted(contents(version, date).items()):
            entry = zipfile.ZipInfo(f"{root}/{name}", (*day, 0, 0, 0))
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            written.writestr(entry, content)
    sum_of = hashlib.sha256(archive.read_bytes()).hexdigest()
    (packed / "SHA256SUMS").write_text(f"{sum_of}  {archive.name}\n", encoding="utf-8")
    print(archive, packed / "SHA256SUMS", sep="\n")


if __name__ == "__main__":
    main()
