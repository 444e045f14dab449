#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A question on which the ray test of textbooks errs: is a point in a ball of triangles, of which some edges lie on the ray?
examples/ball.py RINGS | touchstone reduce point_in_polyhedron"""
import json
import math
import sys

rings = int(sys.argv[1])


def vertex(ring, k):
    """sin 0 is 0: the vertices k = 0 lie in the plane y = 0, as the point does."""
    down, around = math.pi * ring / (rings + 1), 2 * math.pi * k / rings
    return [math.sin(down) * math.cos(around), math.sin(down) * math.sin(around), math.cos(down)]


def at(ring, k):
    return 1 + (ring - 1) * rings + k % rings


last = rings * rings + 1
vertices = [[0, 0, 1], *(vertex(ring, k) for ring in range(1, rings + 1) for k in range(rings)), [0, 0, -1]]
faces = []
for k in range(rings):
    faces += [[0, at(1, k), at(1, k + 1)], [last, at(rings, k + 1), at(rings, k)]]
    for ring in range(1, rings):
        faces += [[at(ring, k), at(ring + 1, k), at(ring, k + 1)], [at(ring, k + 1), at(ring + 1, k), at(ring + 1, k + 1)]]
print(json.dumps({"mesh": {"vertices": vertices, "faces": faces}, "point": [0.25, 0, 0.1]}))
