#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes what the carried program is linked with as an SPDX 2.3 bill of materials, in JSON.

  bill_of_materials.py VERSION DATE FILE PACKAGE...   PACKAGE: a Debian package of which the program holds parts, by its name if it
                                                      is installed, otherwise its file; prints source packages and versions
  bill_of_materials.py --self-check                   checks the bill of made-up packages

The same packages give the same bytes: DATE is that of the release, not of the build."""
import hashlib
import json
import re
import subprocess
import sys
import urllib.parse

# As the packages' copyright files have them, in SPDX's identifiers.
LICENSES = {
    "gmp": "LGPL-3.0-or-later OR GPL-2.0-or-later",
    "mpfr4": "LGPL-3.0-or-later",
    "libpng1.6": "libpng-2.0",
    "zlib": "Zlib",
    "expat": "MIT",
    "fmtlib": "MIT",
    "nlohmann-json3": "MIT",
    "cli11": "BSD-3-Clause",
    "gcc": "GPL-3.0-or-later WITH GCC-exception-3.1",
    "gcc-mingw-w64": "GPL-3.0-or-later WITH GCC-exception-3.1",
    "mingw-w64": "ZPL-2.1 AND MIT AND BSD-3-Clause",  # crt and winpthreads
}
NONE = "NOASSERTION"


def sources(packages):
    """{source package: its version}, as dpkg knows them."""
    form, asked = "--showformat=${source:Package} ${source:Version}\\n", ""
    installed = [one for one in packages if not one.endswith(".deb")]
    commands = [["dpkg-query", "-W", form, *installed]] if installed else []
    commands += [["dpkg-deb", "-W", form, one] for one in packages if one.endswith(".deb")]  # it takes one file
    for command in commands:
        asked += subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return dict(line.split() for line in asked.splitlines())


def package(name, version, license_of, place):
    return {"SPDXID": "SPDXRef-" + re.sub("[^A-Za-z0-9.]", "-", name), "name": name, "versionInfo": version,
            "downloadLocation": place, "filesAnalyzed": False, "licenseConcluded": license_of, "licenseDeclared": license_of,
            "copyrightText": NONE}


def bill(version, date, linked):
    ours = package("touchstone", version, "Apache-2.0", NONE)
    # Debian names the compiler's runtime by its version: gcc-12, gcc-12-cross.
    of = lambda name: LICENSES.get(re.sub(r"^gcc-\d+(-cross)?$", "gcc", name), NONE)
    place = lambda name: f"https://snapshot.debian.org/package/{name}/{urllib.parse.quote(linked[name])}/"
    theirs = [package(name, linked[name], of(name), place(name)) for name in sorted(linked)]
    relations = [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": ours["SPDXID"]}]
    relations += [{"spdxElementId": ours["SPDXID"], "relationshipType": "STATIC_LINK", "relatedSpdxElement": one["SPDXID"]}
                  for one in theirs]
    number = hashlib.sha256(json.dumps([version, date, theirs]).encode()).hexdigest()[:32]
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"touchstone-{version}",
            "documentNamespace": f"https://spdx.org/spdxdocs/touchstone-{version}-{number}",
            "creationInfo": {"created": f"{date}T00:00:00Z", "creators": ["Organization: The touchstone authors"]},
            "packages": [ours, *theirs], "relationships": relations}


def self_check():
    made = bill("1.0", "2030-01-02", {"zlib": "1.3", "gcc-12": "12.2", "stranger": "1"})
    licenses = {one["name"]: one["licenseDeclared"] for one in made["packages"]}
    named = {one["SPDXID"] for one in made["packages"]} | {"SPDXRef-DOCUMENT"}
    checks = {
        "every package is listed": list(licenses) == ["touchstone", "gcc-12", "stranger", "zlib"],
        "licences are those of the table": licenses["gcc-12"].endswith("GCC-exception-3.1") and licenses["zlib"] == "Zlib",
        "of a stranger nothing is said": licenses["stranger"] == NONE,
        "relations are between listed elements": all({one["spdxElementId"], one["relatedSpdxElement"]} <= named
                                                     for one in made["relationships"]) and len(made["relationships"]) == 4,
        "identifiers have SPDX's letters": all(re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", one) for one in named),
        "another version has another namespace":
            made["documentNamespace"] != bill("1.0", "2030-01-02", {"zlib": "1.4"})["documentNamespace"],
    }
    return [f"not so: {what}" for what, holds in checks.items() if not holds]


def main():
    if sys.argv[1:] == ["--self-check"]:
        found = self_check()
        print("\n".join(found), end="\n" if found else "")
        return 1 if found else 0
    version, date, file, *packages = sys.argv[1:]
    linked = sources(packages)
    with open(file, "w", encoding="utf-8") as out:
        out.write(json.dumps(bill(version, date, linked), indent=1) + "\n")
    for name in sorted(linked):
        print(f"  {name} {linked[name]}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
