#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the time of a call from Python with that of the same call from C and of numpy's naive formula, in one run.

  arrays_python.py BUILD [COUNT]   BUILD: a build directory that holds touchstone_python and touchstone_robust; 100000 questions

Each time is processor time of the thread, the least of several rounds, in which the three take turns and each is first in a
third, so that all of them see the same load of the machine.
"""
import ctypes
import pathlib
import subprocess
import sys
import tempfile
import time

BUILD = pathlib.Path(sys.argv[1])
COUNT = int(sys.argv[2]) if len(sys.argv) > 2 else 100_000
ROUNDS = 90
sys.path.insert(0, str(BUILD / "python"))
import numpy  # noqa: E402
import touchstone  # noqa: E402

# The C caller: it times its own call, so that ctypes is not in the time.
CALLER = """
#include <time.h>
#include <touchstone_robust.h>
static double now(void) { struct timespec t; clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t); return t.tv_sec + 1e-9 * t.tv_nsec; }
double orientation(const double* p0, const double* p1, const double* p, size_t count, uint8_t* answers) {
  touchstone_error error;
  const double start = now();
  const int code = touchstone_orientation(touchstone_points2_rows(p0, 2), touchstone_points2_rows(p1, 2),
                                          touchstone_points2_rows(p, 2), count, answers, &error);
  return code == TOUCHSTONE_OK ? now() - start : -1;
}
double segment_segment(const double* a, const double* b, size_t count, uint8_t* answers) {
  touchstone_error error;
  const double start = now();
  const int code = touchstone_segment_segment(touchstone_segments2_rows(a, 4), touchstone_segments2_rows(b, 4), count,
                                              answers, &error);
  return code == TOUCHSTONE_OK ? now() - start : -1;
}
double sphere_sphere(const double* a, const double* b, size_t count, uint8_t* answers) {
  touchstone_error error;
  const double start = now();
  const int code = touchstone_sphere_sphere_3(touchstone_spheres3_rows(a, 4), touchstone_spheres3_rows(b, 4), count,
                                              answers, &error);
  return code == TOUCHSTONE_OK ? now() - start : -1;
}
"""


def side(p, q, r):
    return (q[:, 0] - p[:, 0]) * (r[:, 1] - p[:, 1]) - (q[:, 1] - p[:, 1]) * (r[:, 0] - p[:, 0])


def naive_segments(a, b):
    """Returns whether they meet, if no three ends are on one line."""
    return ((side(a[:, 0], a[:, 1], b[:, 0]) * side(a[:, 0], a[:, 1], b[:, 1]) <= 0) &
            (side(b[:, 0], b[:, 1], a[:, 0]) * side(b[:, 0], b[:, 1], a[:, 1]) <= 0))


def naive_spheres(a, b):
    return ((a[:, :3] - b[:, :3])**2).sum(axis=1) <= (a[:, 3] + b[:, 3])**2


def timed(ask):
    def took():
        start = time.thread_time()
        ask()
        return time.thread_time() - start

    return took


def compiled(folder):
    source, library = folder / "caller.c", folder / "caller.so"
    source.write_text(CALLER)
    subprocess.run(["gcc", "-shared", "-fPIC", "-O2", "-I", BUILD / "generated", source, BUILD / "libtouchstone_robust.a",
                    "-lstdc++", "-lmpfr", "-lgmp", "-lm", "-o", library], check=True)
    return ctypes.CDLL(str(library))


def main():
    rng = numpy.random.default_rng(1)
    points = [rng.random((COUNT, 2)) for _ in range(3)]
    segments = [rng.random((COUNT, 2, 2)) for _ in range(2)]
    spheres = [numpy.ascontiguousarray(rng.random((COUNT, 4)) * (1, 1, 1, 0.5)) for _ in range(2)]
    cases = [("orientation", points, lambda p0, p1, p: numpy.sign(side(p0, p1, p))),
             ("segment_segment", segments, naive_segments), ("sphere_sphere", spheres, naive_spheres)]
    with tempfile.TemporaryDirectory() as folder:
        library = compiled(pathlib.Path(folder))
        print(f"{COUNT} questions, uniform in the unit square or cube; the least of {ROUNDS} rounds, microseconds of the processor")
        print(f"{'':16}{'C':>9}{'Python':>9}{'numpy':>9}{'Python/C':>10}{'numpy/Python':>14}")
        for name, operands, naive in cases:
            by_c, by_python = (numpy.empty(COUNT, dtype=numpy.uint8) for _ in range(2))
            call = getattr(library, name)
            call.restype = ctypes.c_double
            pointers = [ctypes.c_void_p(array.ctypes.data) for array in (*operands, by_c)]
            pointers.insert(-1, ctypes.c_size_t(COUNT))
            decide, least = getattr(touchstone, name), [float("inf")] * 3
            asks = [lambda: call(*pointers), timed(lambda: decide(*operands, out=by_python)), timed(lambda: naive(*operands))]
            for turn in range(ROUNDS):
                for place in range(3):
                    which = (turn + place) % 3
                    took = asks[which]()
                    assert took >= 0
                    least[which] = min(least[which], took)
            assert (by_c == by_python).all()
            c, python, numpys = (1e6 * seconds for seconds in least)
            print(f"{name:16}{c:9.0f}{python:9.0f}{numpys:9.0f}{python / c:10.2f}{numpys / python:14.2f}")


main()
