# SPDX-License-Identifier: Apache-2.0
"""The goals of the benchmarks, and whether the times of a run meet them."""
import math
import statistics

import tables

OF_ANGLES = {"parametric_circle", "interior_angles"}  # whose formulas call the library's cosine or arc tangent
TRIANGULATION = "triangulate_polygon_10000"
HULL, TENTH_OF_HULL = "convex_hull_1000000", "convex_hull_100000"
MESH = "polyhedron_complexity_100000/"
PAIRS = "all_pairs_"
PREPARED = "prepared_"
ARRAYS = "arrays_"
SETS = ["random", "near_degenerate", "small_integer_grid", "scale_2^1012", "scale_2^-1074"]


def written(value, unit=""):
    if value is None:
        return ""
    return f"{value:.2f}{unit}" if value < 9.95 else f"{value:.3g}{unit}" if value < 1000 else f"{value:.0f}{unit}"


def table(head, rows):
    return tables.Table(head, [[str(cell) for cell in row] for row in rows])


def goals_of_arrays(timed):
    """As `goals` lists them."""
    median, found = statistics.median, []

    def ratio(group, above, below, bound, sign):
        t = timed[group]
        if above in t.of and below in t.of:
            found.append((f"{group}: {above} / {below}", bound, sign, t.ratio(above, below), t.ratio(above, below, median)))

    for group in timed:
        data = group.split("/")[1]
        if data == "random":
            ratio(group, "avx512", "naive", 0.5, -1)
            ratio(group, "avx512", "naive_avx512", 1.05, -1)
            ratio(group, "avx2", "naive_avx2", 1.2, -1)
            ratio(group, "epick", "avx512", 20, 1)
        elif data == "one_in_a_hundred_near":
            ratio(group, "avx512", "naive_avx512", 1.3, -1)
        elif data == "near_degenerate":
            ratio(group, "epick", "avx512", 10, 1)
        elif data == "from_memory":  # of the rate at which the same memory is read
            ratio(group, "read", "avx512", 0.9, 1)
    return found


WORDS = {"avx512": "AVX-512", "avx2": "AVX2", "epick": "Epick", "naive": "naive", "naive_avx512": "naive in AVX-512",
         "naive_avx2": "naive in AVX2", "read": "reading the same memory"}


def table_of_arrays(timed):
    """A row for each goal: how many operations meet it, and by how much the others miss it."""
    rows = {}
    for what, bound, sign, least, _ in goals_of_arrays(timed):
        group, _, pair = what.partition(": ")
        operation, data = group.removeprefix(ARRAYS).split("/")
        above, below = (WORDS[name] for name in pair.split(" / "))
        met, missed = rows.setdefault((f"{above} {'at most' if sign < 0 else 'at least'} {written(bound)} of {below}", data), ([], []))
        (met if (least - bound) * sign >= 0 else missed).append(f"{operation} {written(least)}")
    return table(["goal of arrays", "rows", "operations that meet it", "that miss it"],
                 [[goal, data, len(met), ", ".join(missed)] for (goal, data), (met, missed) in rows.items()])


def goals_of_pairs(timed):
    """As `goals` lists them."""
    median, found = statistics.median, []
    bounds = [("uniform", 15), ("clustered", 12), ("six_orders", 15), ("nine_orders", 15), ("one_huge", 8), ("lattice", 5), ("nested", 5)]
    for data, bound, n in [*((data, bound, 1000000) for data, bound in bounds), ("sticks", 3, 100000)]:
        t, smaller = (timed.get(f"{PAIRS}{size}/{data}") for size in (n, n // 10))
        if not t or not smaller:
            continue
        both = lambda value: (value(min), value(median))
        what = f"{PAIRS}{n}/{data}: "
        found.append((what + "CGAL / robust", bound, 1, *both(lambda of: t.ratio("cgal", "robust", of))))
        found.append((what + "exponent of n", 1.1, -1,
                      *both(lambda of: math.log10(of(t.of["robust"]) / of(smaller.of["robust"])))))
        found.append((what + "bytes a box of the certificate", 16, -1, *[float(t.labels["certificate"])] * 2))
        found.append((what + "check of the certificate, s", 0.5, -1, *both(lambda of: of(t.of["check"]) / 1e9)))
        if "tree_moved" in t.of:
            found.append((what + "a tenth moved / anew", 0.5, -1, *both(lambda of: t.ratio("tree_moved", "tree_anew", of))))
    return found


def goals(lines, oracle, more):
    """(what, bound, sign, measured by least times, by medians): sign -1 for "at most"; and `more` of them."""
    median, found = statistics.median, []

    def ratio(what, group, above, below, bound, sign):
        t = lines.get(group)
        if t and above in t.of and below in t.of:
            found.append((what, bound, sign, t.ratio(above, below), t.ratio(above, below, median)))

    def rate(what, group, name, bound):
        t = oracle.get(group)
        if t and name in t.of:
            found.append((what, bound, 1, 1e3 / min(t.of[name]), 1e3 / median(t.of[name])))

    ratio("orientation, random: robust / naive", "orientation/random", "robust", "naive", 1.3, -1)
    ratio("orientation, random: Epick / robust", "orientation/random", "epick", "robust", 7, 1)
    ratio("segment_segment, random: robust / naive", "segment_segment/random", "robust", "naive", 1.2, -1)
    ratio("segment_segment, random: Epick / robust", "segment_segment/random", "epick", "robust", 2.5, 1)
    for op in ["orientation", "segment_segment"]:
        for data, bound in [("near_degenerate", 3), ("small_integer_grid", 1), ("scale_2^1012", 1), ("scale_2^-1074", 1)]:
            ratio(f"{op}, {data}: Epick / robust", f"{op}/{data}", "epick", "robust", bound, 1)
    for size in [16, 1000]:
        group = f"point_in_polygon_{size}"
        ratio(f"{group}, random: robust / naive", f"{group}/random", "robust", "naive", 1.1, -1)
        for data in SETS:
            ratio(f"{group}, {data}: Epick / robust", f"{group}/{data}", "epick", "robust", 1, 1)
    ratio("point_plane, random: robust / naive", "point_plane/random", "robust", "naive", 1.3, -1)
    for op, bound in [("ray_triangle", 1.2), ("segment_triangle", 1.2), ("ray_aabb", 1.1), ("segment_aabb", 1.1),
                      ("ray_sphere", 1.5), ("segment_sphere", 1.5)]:
        ratio(f"{op}, random: robust / naive", f"{op}/random", "robust", "naive", bound, -1)
        ratio(f"{op}, random: Epick / robust", f"{op}/random", "epick", "robust", 2.5, 1)
    for group, t in lines.items():
        op, data = group.split("/", 1)
        if data == "random" and t.labels.get("robust_answer") == "numbers":
            bound = 20 if op in OF_ANGLES else 10
            ratio(f"{op}, random: robust's answer / slide's", group, "robust_answer", "slide_answer", bound, -1)
    ratio("bounding_sphere, random: robust's answer / miniball", "bounding_sphere/random", "robust_answer", "miniball", 3, -1)
    for group in lines:
        if group.startswith(TRIANGULATION):
            ratio(f"{group}: robust / earcut", group, "robust", "earcut", 1, -1)
    for data, epick, qhull in [("ball", 40, 10), ("grid", 40, 10), ("clusters", 40, 10), ("sphere", 10, 5)]:
        ratio(f"{HULL}/{data}: Epick / robust", f"{HULL}/{data}", "epick", "robust", epick, 1)
        ratio(f"{HULL}/{data}: qhull / robust", f"{HULL}/{data}", "qhull", "robust", qhull, 1)
    for group, t in lines.items():
        if group.startswith(HULL) and t.labels.get("qhull", "0") != "0" and group.split("/")[1] not in (
                "ball", "grid", "clusters", "sphere"):
            ratio(f"{group}: qhull / robust", group, "qhull", "robust", 0.5, 1)
    for group in lines:
        tenth = lines.get(group.replace(HULL, TENTH_OF_HULL))
        if group.startswith(HULL) and tenth:
            times = [of(lines[group].of["robust"]) / of(tenth.of["robust"]) for of in (min, median)]
            found.append((f"{group}: robust, to a tenth of the points", 10 ** 1.25, -1, *times))
    for grid in [3, 4, 10]:
        rate(f"segment_segment, exhaustive on the {grid}-grid, million a second", f"segment_segment/grid_{grid}",
             "exhaust", 20)
    rate("segment_segment, oracle's decision on random cases, million a second", "segment_segment/random", "decision", 2)
    rate("segment_segment, oracle's truth on random cases, million a second", "segment_segment/random", "truth", 2)
    return table(["goal", "bound", "measured", "by medians", ""],
                 [[what, ("at most " if sign < 0 else "at least ") + written(bound), written(least), written(by_median),
                   "met" if (least - bound) * sign >= 0 else "MISSED"] for what, bound, sign, least, by_median in found + more])
