#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that .clusterfuzzlite keeps the contract of ClusterFuzzLite and OSS-Fuzz, without their images: build.sh configures and
packs with clang and libFuzzer; every target starts alone in an empty folder and accepts its seeds; a mutant is found.
In place of compiling everything once more, the targets are linked from what this build compiled, with one mutant.
usage: fuzzing_service.py SOURCE BUILD OBJECT...      77: not here, with the reason
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import zipfile

SOURCE, BUILD = map(pathlib.Path, sys.argv[1:3])
OBJECTS = [name for name in sys.argv[3:] if name.endswith(".o")]  # and not a precompiled header
sys.path.insert(0, str(SOURCE / "proptests" / "mutation"))
from instrument import mutated  # noqa: E402
from mutants import listed  # noqa: E402

BUG = next((number, mutant) for number, mutant in listed() if mutant["id"] == "orientation/1")
FLAGS = ["-O1", "-fno-omit-frame-pointer", "-gline-tables-only", "-DFUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION"]
ENGINE = "-fsanitize=fuzzer"
ENGINE_OF_SERVICE = ENGINE + " -Wl,--no-as-needed,-lpthread"  # several words, with commas
# The image that runs the targets has these.
THERE = ("linux-vdso", "libc.", "libm.", "libgcc_s", "libstdc++", "/lib")


def run(*words, **options):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", check=False, **options)
    return done.returncode, done.stdout


def must(*words, **options):
    code, output = run(*words, **options)
    if code != 0:
        sys.exit(f"{output[-3000:]}\n{' '.join(map(str, words))[:500]}: ended with {code}")
    return output


def linked(work):
    """The program of all targets, with one mutant."""
    file = BUG[1]["file"]
    (work / "mutated.cpp").write_text(mutated((SOURCE / file).read_text(encoding="utf-8"), file, [BUG]), encoding="utf-8")
    compile_ = ["clang++", "-std=c++20", *FLAGS, "-ffp-contract=off", "-frounding-math", "-w", f"-I{SOURCE}", "-c"]
    must(*compile_, "-fsanitize=fuzzer-no-link", "-include", SOURCE / "proptests/mutation/mutant.h", "-o", work / "mutated.o",
         work / "mutated.cpp")
    must(*compile_, "-o", work / "mutant.o", SOURCE / "proptests/mutation/mutant.cpp")
    must(*compile_, "-o", work / "fmt.o", BUILD / "fmt.cpp")
    libraries = [f"-l:lib{name}.a" for name in ("mpfr", "gmp", "png16", "z")]
    # What is first, the mutant, is taken: the library holds the file it is of too, in the unit of its chapter.
    must("clang++", ENGINE, "-Wl,-z,muldefs", *(work / f"{name}.o" for name in ("mutated", "mutant", "fmt")), *OBJECTS,
         "-Wl,--start-group", *sorted(BUILD.glob("libtouchstone_*.a")), "-Wl,--end-group", *libraries, "-o", work / "program")
    return work / "program"


def built(work, program):
    """build.sh as a service calls it; what cmake would build is there already."""
    for folder in ("bin", "out", "work"):
        (work / folder).mkdir()
    cmake = work / "bin" / "cmake"
    cmake.write_text(f"""#!/bin/sh
case $1 in
  --build) mkdir -p "$2/fuzz" && cp {program} "$2/fuzz/fuzz" ;;
  *) exec {shutil.which('cmake')} "$@" ;;
esac
""")
    cmake.chmod(0o755)
    environment = dict(os.environ, PATH=f"{work}/bin:{os.environ['PATH']}", OUT=str(work / "out"), WORK=str(work / "work"),
                       CC="clang", CXX="clang++", SANITIZER="address", LIB_FUZZING_ENGINE=ENGINE_OF_SERVICE,
                       CXXFLAGS=" ".join([*FLAGS, "-fsanitize=address,fuzzer-no-link"]))
    must("bash", "-eu", SOURCE / ".clusterfuzzlite/build.sh", cwd=SOURCE, env=environment)
    link = must("ninja", "-C", work / "work/build", "-t", "commands", "fuzz").splitlines()[-1]
    for library in ("libgmp", "libmpfr", "libpng"):
        assert f"{library}.a" in link and f"{library}.so" not in link, library
    assert "libfmt" not in link and all(word in link.split() for word in ENGINE_OF_SERVICE.split()), link
    must("ninja", "-C", work / "work/build", "CMakeFiles/touchstone_robust.dir/Unity/unity_lines_cxx.cxx.o")


def checked(out, alone):
    operations = sorted(path.name for path in (SOURCE / "fuzz/corpus").iterdir())
    for operation in operations:
        target = out / operation
        assert "LLVMFuzzerTestOneInput" in target.read_bytes().decode("latin-1"), operation
        with zipfile.ZipFile(out / f"{operation}_seed_corpus.zip") as seeds:
            seeds.extractall(alone / "seeds" / operation)
            count = len(seeds.namelist())
        assert count >= len(list((SOURCE / "fuzz/corpus" / operation).iterdir())) > 0
        options = dict(line.split(" = ") for line in (out / f"{operation}.options").read_text().splitlines()[1:])
        said = must(target, "-runs=0", f"-dict={out / options['dict']}", f"-max_len={options['max_len']}",
                    alone / "seeds" / operation, cwd=alone, env={})
        assert f"seed corpus: files: {count}" in said, said[-1000:]
    needs = [line.split()[0] for line in must("ldd", out / operations[0]).splitlines()]
    assert all(name.startswith(THERE) for name in needs), needs
    return len(operations)


def main():
    for tool in ("clang++", "ninja", "zip", "ldd"):
        if not shutil.which(tool):
            print(f"skipped: {tool} is not installed")
            sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        (work / "alone").mkdir()
        built(work, linked(work))
        targets = checked(work / "out", work / "alone")
        hunt = [work / "out/orientation", "-seed=1", "-runs=200000", "-max_total_time=30", work / "alone/seeds/orientation"]
        code, said = run(*hunt, cwd=work / "alone", env={"TOUCHSTONE_MUTANT": str(BUG[0])})
        assert code != 0 and "robust and oracle" in said, said[-1000:]
        must(work / "out/orientation", "-seed=1", "-runs=2000", work / "alone/seeds/orientation", cwd=work / "alone", env={})
    print(f"{targets} targets start alone and accept their seeds, and the planted bug is found")


if __name__ == "__main__":
    main()
