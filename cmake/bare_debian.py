#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Installs a Debian package of touchstone in a bare Debian of its architecture, and asks the program there: bare_debian.py PACKAGE

The bare Debian is debootstrap's minbase of this machine's release, below build/bare, made once. For another architecture it is
run by qemu's static emulator, which the kernel is told about. It needs root, debootstrap and, for another architecture,
qemu-user-static."""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
EMULATORS = {"arm64": "qemu-aarch64"}
BINFMT = pathlib.Path("/proc/sys/fs/binfmt_misc")
ASKED = [
    "uname -m",
    "dpkg --install /touchstone.deb",
    "touchstone --version",
    """echo '{"p0":[0,0],"p1":[12,12],"p":[0.5,0.5000000000000001]}' | touchstone ask orientation""",
    """echo '{"a":[[0,0],[0.3,0.3]],"b":[[0.1,0.1],[2,2]]}' | touchstone ask segment_segment""",
    "touchstone vectors check /usr/share/touchstone/vectors --ops orientation,ray_triangle,aabb_obb,bounding_sphere",
    "touchstone soak orientation,segment_segment,swept_sphere_plane --cases 500 --jobs 1",
]


def output(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout.strip()


def mirror():
    """The mirror that this machine's packages come from."""
    for file in [pathlib.Path("/etc/apt/sources.list"), *pathlib.Path("/etc/apt/sources.list.d").glob("*")]:
        text = file.read_text(encoding="utf-8") if file.is_file() else ""
        if found := re.search(r"^(?:URIs:|deb(?: \[.*\])?)\s+(\S+/debian)/?\s", text, re.MULTILINE):
            return found[1]
    return "http://deb.debian.org/debian"


def emulate(architecture):
    """Tells the kernel which program runs those of the architecture, where it does not know."""
    if architecture == output("dpkg", "--print-architecture"):
        return
    emulator = EMULATORS.get(architecture) or sys.exit(f"bare_debian: no emulator is known for {architecture}")
    if not (BINFMT / "register").exists():
        subprocess.run(["mount", "-t", "binfmt_misc", "none", BINFMT], check=True)
    if not (BINFMT / emulator).exists():
        rule = pathlib.Path(f"/usr/lib/binfmt.d/{emulator}.conf")
        if not rule.exists():
            sys.exit(f"bare_debian: {rule} is missing (qemu-user-static)")
        (BINFMT / "register").write_bytes(rule.read_bytes())


def made(architecture):
    """The folder of the bare Debian."""
    to = ROOT / "build/bare" / architecture
    if not (to / "complete").exists():
        shutil.rmtree(to, ignore_errors=True)
        to.parent.mkdir(parents=True, exist_ok=True)
        release = re.search(r"^VERSION_CODENAME=(.*)$", pathlib.Path("/etc/os-release").read_text(encoding="utf-8"), re.MULTILINE)[1]
        log = to.parent / f"{architecture}.log"
        with log.open("w", encoding="utf-8") as file:
            if subprocess.run(["debootstrap", "--variant=minbase", f"--arch={architecture}", release, to, mirror()],
                              stdout=file, stderr=subprocess.STDOUT).returncode:
                sys.exit(f"bare_debian: debootstrap failed: {log}")
        (to / "complete").touch()
    return to


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("package", type=pathlib.Path, nargs="?")
    options.add_argument("--only-rights", action="store_true", help="only check that it runs as root")
    given = options.parse_args()
    if os.geteuid() != 0:
        sys.exit("bare_debian: it needs root")
    if given.only_rights:
        return
    package = given.package or options.error("expected a PACKAGE")
    if shutil.which("debootstrap") is None:
        sys.exit("bare_debian: it needs debootstrap")
    architecture = output("dpkg-deb", "-f", package, "Architecture")
    emulate(architecture)
    bare = made(architecture)
    shutil.copy(package, bare / "touchstone.deb")
    clean = ["env", "-i", "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "LC_ALL=C"]
    for command in ASKED:
        began = time.time()
        print("$", command, flush=True)
        if subprocess.run(["chroot", bare, *clean, "sh", "-c", command]).returncode:
            sys.exit("bare_debian: this failed")
        print(f"({time.time() - began:.1f} s)", flush=True)


if __name__ == "__main__":
    main()
