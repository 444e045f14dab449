#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds static libraries of the program from Debian's sources: libraries_from_source.py TRIPLE FOLDER [LIBRARY...]

For a processor or system of which the release has no packages: zlib, libpng, Expat and {fmt} by the cross compiler
TRIPLE-g++, installed below FOLDER/usr as the packages would be, and the headers of nlohmann-json and CLI11, which are
packages of every architecture. Nothing is installed elsewhere. FOLDER/sources.txt names the source packages with their
versions; their copyright notices are in FOLDER/usr/share/doc. Needs dpkg-dev, cmake, ninja and the compiler of C.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

# Source package, folder in it, and options of its CMake project. zlib comes first: libpng needs it.
LIBRARIES = {
    "zlib": ("zlib", ".", []),
    "libpng": ("libpng1.6", ".", ["-DPNG_SHARED=OFF", "-DPNG_TESTS=OFF", "-DPNG_EXECUTABLES=OFF"]),
    "expat": ("expat", "expat", ["-DEXPAT_SHARED_LIBS=OFF", "-DEXPAT_BUILD_TOOLS=OFF", "-DEXPAT_BUILD_TESTS=OFF",
                                 "-DEXPAT_BUILD_EXAMPLES=OFF", "-DEXPAT_BUILD_DOCS=OFF"]),
    "fmt": ("fmtlib", ".", ["-DFMT_TEST=OFF", "-DFMT_DOC=OFF"]),
}
HEADERS = ["nlohmann-json3-dev", "libcli11-dev"]


def quietly(command, **options):
    """Runs a command. Returns if it succeeded, and its output."""
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **options)
    return run.returncode == 0, run.stdout


def apt_with_sources(lists):
    """The command apt-get with lists of its own: those of this machine, and the sources of the same releases."""
    (lists / "partial").mkdir(parents=True, exist_ok=True)
    (lists / "cache/archives/partial").mkdir(parents=True, exist_ok=True)
    targets = ["apt-get", "indextargets", "--format", "$(SITE) $(RELEASE) $(COMPONENT)", "Created-By: Packages"]
    known = subprocess.run(targets, stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()
    of_release = sorted({line for line in known if "debian" in line.split()[0] or "ubuntu" in line.split()[0]})
    sources = lists / "cache/sources.list"  # an update removes what it does not know from the lists themselves
    sources.write_text("".join(f"deb {line}\ndeb-src {line}\n" for line in of_release), encoding="utf-8")
    apt = ["apt-get", "-qq", "-o", f"Dir::State::Lists={lists}", "-o", f"Dir::Cache={lists}/cache",
           "-o", "Acquire::Retries=3", "-o", f"Dir::Etc::SourceList={sources}", "-o", "Dir::Etc::SourceParts=/dev/null"]
    return apt + (["-o", "APT::Sandbox::User=root"] if os.geteuid() == 0 else [])


def toolchain(triple, folder):
    """The file that tells CMake the compiler, and that nothing of this machine is to be found."""
    windows = "mingw" in triple
    compiler = f"{triple}-{{}}-posix" if windows else f"{triple}-{{}}"
    file = folder / "toolchain.cmake"
    file.write_text(f"""set(CMAKE_SYSTEM_NAME {"Windows" if windows else "Linux"})
set(CMAKE_SYSTEM_PROCESSOR {triple.split("-")[0]})
set(CMAKE_C_COMPILER {compiler.format("gcc")})
set(CMAKE_CXX_COMPILER {compiler.format("g++")})
set(CMAKE_RC_COMPILER {triple}-windres)
set(CMAKE_FIND_ROOT_PATH {folder})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${{kind}} ONLY)
endforeach()
""", encoding="utf-8")
    return file


def fetch(package, to, apt):
    """Unpacks the newest sources that can be had, and says so if there are newer ones; why there are none, or empty."""
    versions = quietly(["apt-cache", *apt[2:], "showsrc", package])[1].splitlines()
    for choice in [package, *(f"{package}={line.split()[1]}" for line in versions if line.startswith("Version:"))]:
        shutil.rmtree(to, ignore_errors=True)
        to.mkdir(parents=True)
        fetched, output = quietly([*apt, "source", choice], cwd=to)
        if fetched:
            if choice != package:
                print(f"libraries_from_source: the newest {package} cannot be had; taken: {choice}", file=sys.stderr)
            return ""
    return f"no sources of {package}: {output.strip()}"


def mend(tree, name):
    """Debian does not build these two by CMake: it left a file out of the one, and broke a definition of the other."""
    if name == "zlib":
        (tree / "win32").mkdir(exist_ok=True)
        (tree / "win32/zlib1.rc").touch()
    elif name == "expat":
        file = tree / "expat/expat_config.h.cmake"
        file.write_text(file.read_text(encoding="utf-8").replace("#cmakedefine XML_DTD\n", "#cmakedefine XML_DTD 1\n"),
                        encoding="utf-8")


def build(name, triple, folder, apt):
    """Why it is not built; empty if it is."""
    package, inner, options = LIBRARIES[name]
    sources = folder / "sources" / name
    if missing := fetch(package, sources, apt):
        return missing
    (tree,) = (each for each in sources.iterdir() if each.is_dir())
    mend(tree, name)
    built = sources / "build"
    targets = ["--target", "zlibstatic"] if name == "zlib" else []  # its shared library needs a file that is not there
    commands = [["cmake", "-S", tree / inner, "-B", built, "-G", "Ninja",
                 f"-DCMAKE_TOOLCHAIN_FILE={folder}/toolchain.cmake", "-DCMAKE_BUILD_TYPE=Release",
                 "-DBUILD_SHARED_LIBS=OFF", "-DCMAKE_POSITION_INDEPENDENT_CODE=ON",
                 f"-DCMAKE_INSTALL_PREFIX={folder}/usr", "-DCMAKE_INSTALL_LIBDIR=lib", *options],
                ["cmake", "--build", built, "-j", "1", *targets]]
    if name != "zlib":
        commands.append(["cmake", "--install", built])
    for command in commands:
        done, output = quietly(command)
        if not done:
            (folder / f"{name}.log").write_text(output, encoding="utf-8")
            return f"{name} does not build: {folder}/{name}.log"
    notices = folder / "usr/share/doc" / package
    notices.mkdir(parents=True, exist_ok=True)
    shutil.copy(tree / "debian/copyright", notices / "copyright")
    if name == "zlib":
        (folder / "usr/lib").mkdir(parents=True, exist_ok=True)
        (archive,) = built.glob("lib*.a")
        shutil.copy(archive, folder / "usr/lib/libz.a")
        for header in (tree / "zlib.h", built / "zconf.h"):
            shutil.copy(header, folder / "usr/include")
    (description,) = sources.glob("*.dsc")
    version = re.search(r"^Version: (.*)$", description.read_text(encoding="utf-8"), re.MULTILINE)[1]
    with (folder / "sources.txt").open("a", encoding="utf-8") as written:
        written.write(f"{package} {version}\n")
    return ""


def libraries_from_source(triple, folder, names=tuple(LIBRARIES)):
    """Why something is missing; empty if all is there. A folder that is complete is left as it is."""
    folder = pathlib.Path(folder).resolve()
    if (folder / "complete").exists():
        return ""
    for program in ("dpkg-source", "cmake", "ninja", f"{triple}-gcc", f"{triple}-g++"):
        if shutil.which(program) is None:
            return f"no {program}"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    apt = apt_with_sources(folder.parent / f"{folder.name}_lists")
    quietly([*apt, "update"])
    toolchain(triple, folder)
    fetched, output = quietly([*apt, "download", *HEADERS], cwd=folder)
    if not fetched:
        return f"no {' or '.join(HEADERS)}: {output.strip()}"
    for package in folder.glob("*.deb"):
        subprocess.run(["dpkg-deb", "-x", package, folder], check=True)
    for name in names:
        if missing := build(name, triple, folder, apt):
            return missing
    (folder / "complete").touch()
    return ""


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("triple", metavar="TRIPLE")
    options.add_argument("folder", metavar="FOLDER")
    options.add_argument("libraries", nargs="*", metavar="LIBRARY", help=f"of {', '.join(LIBRARIES)}; all by default")
    given = options.parse_args()
    if missing := libraries_from_source(given.triple, given.folder, given.libraries or tuple(LIBRARIES)):
        sys.exit(f"libraries_from_source: {missing}")


if __name__ == "__main__":
    main()
