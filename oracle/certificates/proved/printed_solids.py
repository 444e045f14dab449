# SPDX-License-Identifier: Apache-2.0
"""The formulas that Coq has proved, printed by print_python.ml: do not edit.

(operation, word of the truth, kind, dimension, axis of the certificate), None where it is asked for none, and the
condition on i, t, c: input, truth and certificate, with their numbers as fractions. A number p + q sqrt(r) is
(p, q, r).
"""

FORMULAS = {
    ("sphere_sphere", "disjoint", "distance", 2, None): lambda i, t, c: (
        0 <= i['a']['radius'] and 0 <= i['b']['radius'] and c['squared_distance'][0] == (i['a']['center'][0] -
        i['b']['center'][0]) * (i['a']['center'][0] - i['b']['center'][0]) + (i['a']['center'][1] -
        i['b']['center'][1]) * (i['a']['center'][1] - i['b']['center'][1]) and (i['a']['radius'] + i['b']['radius']) *
        (i['a']['radius'] + i['b']['radius']) < c['squared_distance'][0]
    ),
    ("sphere_sphere", "disjoint", "distance", 3, None): lambda i, t, c: (
        0 <= i['a']['radius'] and 0 <= i['b']['radius'] and c['squared_distance'][0] == (i['a']['center'][0] -
        i['b']['center'][0]) * (i['a']['center'][0] - i['b']['center'][0]) + (i['a']['center'][1] -
        i['b']['center'][1]) * (i['a']['center'][1] - i['b']['center'][1]) + (i['a']['center'][2] -
        i['b']['center'][2]) * (i['a']['center'][2] - i['b']['center'][2]) and (i['a']['radius'] + i['b']['radius']) *
        (i['a']['radius'] + i['b']['radius']) < c['squared_distance'][0]
    ),
    ("sphere_sphere", "touching", "tangent", 2, None): lambda i, t, c: (
        0 <= i['a']['radius'] and 0 <= i['b']['radius'] and (i['a']['center'][0] - c['point'][0]) *
        (i['a']['center'][0] - c['point'][0]) + (i['a']['center'][1] - c['point'][1]) * (i['a']['center'][1] -
        c['point'][1]) <= i['a']['radius'] * i['a']['radius'] and (i['b']['center'][0] - c['point'][0]) *
        (i['b']['center'][0] - c['point'][0]) + (i['b']['center'][1] - c['point'][1]) * (i['b']['center'][1] -
        c['point'][1]) <= i['b']['radius'] * i['b']['radius'] and (i['a']['center'][0] - i['b']['center'][0]) *
        (i['a']['center'][0] - i['b']['center'][0]) + (i['a']['center'][1] - i['b']['center'][1]) *
        (i['a']['center'][1] - i['b']['center'][1]) == (i['a']['radius'] + i['b']['radius']) * (i['a']['radius'] +
        i['b']['radius'])
    ),
    ("sphere_sphere", "touching", "tangent", 3, None): lambda i, t, c: (
        0 <= i['a']['radius'] and 0 <= i['b']['radius'] and (i['a']['center'][0] - c['point'][0]) *
        (i['a']['center'][0] - c['point'][0]) + (i['a']['center'][1] - c['point'][1]) * (i['a']['center'][1] -
        c['point'][1]) + (i['a']['center'][2] - c['point'][2]) * (i['a']['center'][2] - c['point'][2]) <=
        i['a']['radius'] * i['a']['radius'] and (i['b']['center'][0] - c['point'][0]) * (i['b']['center'][0] -
        c['point'][0]) + (i['b']['center'][1] - c['point'][1]) * (i['b']['center'][1] - c['point'][1]) +
        (i['b']['center'][2] - c['point'][2]) * (i['b']['center'][2] - c['point'][2]) <= i['b']['radius'] *
        i['b']['radius'] and (i['a']['center'][0] - i['b']['center'][0]) * (i['a']['center'][0] - i['b']['center'][0])
        + (i['a']['center'][1] - i['b']['center'][1]) * (i['a']['center'][1] - i['b']['center'][1]) +
        (i['a']['center'][2] - i['b']['center'][2]) * (i['a']['center'][2] - i['b']['center'][2]) == (i['a']['radius']
        + i['b']['radius']) * (i['a']['radius'] + i['b']['radius'])
    ),
    ("sphere_sphere", "touching", "no_interior", 2, None): lambda i, t, c: (
        0 <= i['a']['radius'] and 0 <= i['b']['radius'] and (i['a']['center'][0] - c['point'][0]) *
        (i['a']['center'][0] - c['point'][0]) + (i['a']['center'][1] - c['point'][1]) * (i['a']['center'][1] -
        c['point'][1]) <= i['a']['radius'] * i['a']['radius'] and (i['b']['center'][0] - c['point'][0]) *
        (i['b']['center'][0] - c['point'][0]) + (i['b']['center'][1] - c['point'][1]) * (i['b']['center'][1] -
        c['point'][1]) <= i['b']['radius'] * i['b']['radius'] and (i['a']['radius'] == 0 or i['b']['radius'] == 0)
    ),
    ("sphere_sphere", "touching", "no_interior", 3, None): lambda i, t, c: (
        0 <= i['a']['radius'] and 0 <= i['b']['radius'] and (i['a']['center'][0] - c['point'][0]) *
        (i['a']['center'][0] - c['point'][0]) + (i['a']['center'][1] - c['point'][1]) * (i['a']['center'][1] -
        c['point'][1]) + (i['a']['center'][2] - c['point'][2]) * (i['a']['center'][2] - c['point'][2]) <=
        i['a']['radius'] * i['a']['radius'] and (i['b']['center'][0] - c['point'][0]) * (i['b']['center'][0] -
        c['point'][0]) + (i['b']['center'][1] - c['point'][1]) * (i['b']['center'][1] - c['point'][1]) +
        (i['b']['center'][2] - c['point'][2]) * (i['b']['center'][2] - c['point'][2]) <= i['b']['radius'] *
        i['b']['radius'] and (i['a']['radius'] == 0 or i['b']['radius'] == 0)
    ),
    ("sphere_sphere", "overlapping", "common_interior_point", 2, None): lambda i, t, c: (
        0 <= i['a']['radius'] and 0 <= i['b']['radius'] and (i['a']['center'][0] - c['point'][0]) *
        (i['a']['center'][0] - c['point'][0]) + (i['a']['center'][1] - c['point'][1]) * (i['a']['center'][1] -
        c['point'][1]) < i['a']['radius'] * i['a']['radius'] and (i['b']['center'][0] - c['point'][0]) *
        (i['b']['center'][0] - c['point'][0]) + (i['b']['center'][1] - c['point'][1]) * (i['b']['center'][1] -
        c['point'][1]) < i['b']['radius'] * i['b']['radius']
    ),
    ("sphere_sphere", "overlapping", "common_interior_point", 3, None): lambda i, t, c: (
        0 <= i['a']['radius'] and 0 <= i['b']['radius'] and (i['a']['center'][0] - c['point'][0]) *
        (i['a']['center'][0] - c['point'][0]) + (i['a']['center'][1] - c['point'][1]) * (i['a']['center'][1] -
        c['point'][1]) + (i['a']['center'][2] - c['point'][2]) * (i['a']['center'][2] - c['point'][2]) <
        i['a']['radius'] * i['a']['radius'] and (i['b']['center'][0] - c['point'][0]) * (i['b']['center'][0] -
        c['point'][0]) + (i['b']['center'][1] - c['point'][1]) * (i['b']['center'][1] - c['point'][1]) +
        (i['b']['center'][2] - c['point'][2]) * (i['b']['center'][2] - c['point'][2]) < i['b']['radius'] *
        i['b']['radius']
    ),
    ("aabb_aabb", "disjoint", "separating_axis", 2, 0): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['b']['min'][0] <=
        i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and ((i['a']['max'][0] < c['value'][0] and
        c['value'][0] < i['b']['min'][0]) or (i['b']['max'][0] < c['value'][0] and c['value'][0] < i['a']['min'][0]))
    ),
    ("aabb_aabb", "disjoint", "separating_axis", 2, 1): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['b']['min'][0] <=
        i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and ((i['a']['max'][1] < c['value'][0] and
        c['value'][0] < i['b']['min'][1]) or (i['b']['max'][1] < c['value'][0] and c['value'][0] < i['a']['min'][1]))
    ),
    ("aabb_aabb", "disjoint", "separating_axis", 3, 0): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['a']['min'][2] <=
        i['a']['max'][2] and i['b']['min'][0] <= i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and
        i['b']['min'][2] <= i['b']['max'][2] and ((i['a']['max'][0] < c['value'][0] and c['value'][0] <
        i['b']['min'][0]) or (i['b']['max'][0] < c['value'][0] and c['value'][0] < i['a']['min'][0]))
    ),
    ("aabb_aabb", "disjoint", "separating_axis", 3, 1): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['a']['min'][2] <=
        i['a']['max'][2] and i['b']['min'][0] <= i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and
        i['b']['min'][2] <= i['b']['max'][2] and ((i['a']['max'][1] < c['value'][0] and c['value'][0] <
        i['b']['min'][1]) or (i['b']['max'][1] < c['value'][0] and c['value'][0] < i['a']['min'][1]))
    ),
    ("aabb_aabb", "disjoint", "separating_axis", 3, 2): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['a']['min'][2] <=
        i['a']['max'][2] and i['b']['min'][0] <= i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and
        i['b']['min'][2] <= i['b']['max'][2] and ((i['a']['max'][2] < c['value'][0] and c['value'][0] <
        i['b']['min'][2]) or (i['b']['max'][2] < c['value'][0] and c['value'][0] < i['a']['min'][2]))
    ),
    ("aabb_aabb", "touching", "supporting_axis", 2, 0): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['b']['min'][0] <=
        i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and i['a']['min'][0] <= c['point'][0] and
        c['point'][0] <= i['a']['max'][0] and i['a']['min'][1] <= c['point'][1] and c['point'][1] <= i['a']['max'][1]
        and i['b']['min'][0] <= c['point'][0] and c['point'][0] <= i['b']['max'][0] and i['b']['min'][1] <=
        c['point'][1] and c['point'][1] <= i['b']['max'][1] and ((i['a']['max'][0] <= c['point'][0] and c['point'][0]
        <= i['b']['min'][0]) or (i['b']['max'][0] <= c['point'][0] and c['point'][0] <= i['a']['min'][0]))
    ),
    ("aabb_aabb", "touching", "supporting_axis", 2, 1): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['b']['min'][0] <=
        i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and i['a']['min'][0] <= c['point'][0] and
        c['point'][0] <= i['a']['max'][0] and i['a']['min'][1] <= c['point'][1] and c['point'][1] <= i['a']['max'][1]
        and i['b']['min'][0] <= c['point'][0] and c['point'][0] <= i['b']['max'][0] and i['b']['min'][1] <=
        c['point'][1] and c['point'][1] <= i['b']['max'][1] and ((i['a']['max'][1] <= c['point'][1] and c['point'][1]
        <= i['b']['min'][1]) or (i['b']['max'][1] <= c['point'][1] and c['point'][1] <= i['a']['min'][1]))
    ),
    ("aabb_aabb", "touching", "supporting_axis", 3, 0): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['a']['min'][2] <=
        i['a']['max'][2] and i['b']['min'][0] <= i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and
        i['b']['min'][2] <= i['b']['max'][2] and i['a']['min'][0] <= c['point'][0] and c['point'][0] <=
        i['a']['max'][0] and i['a']['min'][1] <= c['point'][1] and c['point'][1] <= i['a']['max'][1] and
        i['a']['min'][2] <= c['point'][2] and c['point'][2] <= i['a']['max'][2] and i['b']['min'][0] <= c['point'][0]
        and c['point'][0] <= i['b']['max'][0] and i['b']['min'][1] <= c['point'][1] and c['point'][1] <=
        i['b']['max'][1] and i['b']['min'][2] <= c['point'][2] and c['point'][2] <= i['b']['max'][2] and
        ((i['a']['max'][0] <= c['point'][0] and c['point'][0] <= i['b']['min'][0]) or (i['b']['max'][0] <=
        c['point'][0] and c['point'][0] <= i['a']['min'][0]))
    ),
    ("aabb_aabb", "touching", "supporting_axis", 3, 1): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['a']['min'][2] <=
        i['a']['max'][2] and i['b']['min'][0] <= i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and
        i['b']['min'][2] <= i['b']['max'][2] and i['a']['min'][0] <= c['point'][0] and c['point'][0] <=
        i['a']['max'][0] and i['a']['min'][1] <= c['point'][1] and c['point'][1] <= i['a']['max'][1] and
        i['a']['min'][2] <= c['point'][2] and c['point'][2] <= i['a']['max'][2] and i['b']['min'][0] <= c['point'][0]
        and c['point'][0] <= i['b']['max'][0] and i['b']['min'][1] <= c['point'][1] and c['point'][1] <=
        i['b']['max'][1] and i['b']['min'][2] <= c['point'][2] and c['point'][2] <= i['b']['max'][2] and
        ((i['a']['max'][1] <= c['point'][1] and c['point'][1] <= i['b']['min'][1]) or (i['b']['max'][1] <=
        c['point'][1] and c['point'][1] <= i['a']['min'][1]))
    ),
    ("aabb_aabb", "touching", "supporting_axis", 3, 2): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['a']['min'][2] <=
        i['a']['max'][2] and i['b']['min'][0] <= i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and
        i['b']['min'][2] <= i['b']['max'][2] and i['a']['min'][0] <= c['point'][0] and c['point'][0] <=
        i['a']['max'][0] and i['a']['min'][1] <= c['point'][1] and c['point'][1] <= i['a']['max'][1] and
        i['a']['min'][2] <= c['point'][2] and c['point'][2] <= i['a']['max'][2] and i['b']['min'][0] <= c['point'][0]
        and c['point'][0] <= i['b']['max'][0] and i['b']['min'][1] <= c['point'][1] and c['point'][1] <=
        i['b']['max'][1] and i['b']['min'][2] <= c['point'][2] and c['point'][2] <= i['b']['max'][2] and
        ((i['a']['max'][2] <= c['point'][2] and c['point'][2] <= i['b']['min'][2]) or (i['b']['max'][2] <=
        c['point'][2] and c['point'][2] <= i['a']['min'][2]))
    ),
    ("aabb_aabb", "touching", "flat_axis", 2, 0): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['b']['min'][0] <=
        i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and i['a']['min'][0] <= c['point'][0] and
        c['point'][0] <= i['a']['max'][0] and i['a']['min'][1] <= c['point'][1] and c['point'][1] <= i['a']['max'][1]
        and i['b']['min'][0] <= c['point'][0] and c['point'][0] <= i['b']['max'][0] and i['b']['min'][1] <=
        c['point'][1] and c['point'][1] <= i['b']['max'][1] and (i['a']['min'][0] == i['a']['max'][0] or
        i['b']['min'][0] == i['b']['max'][0])
    ),
    ("aabb_aabb", "touching", "flat_axis", 2, 1): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['b']['min'][0] <=
        i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and i['a']['min'][0] <= c['point'][0] and
        c['point'][0] <= i['a']['max'][0] and i['a']['min'][1] <= c['point'][1] and c['point'][1] <= i['a']['max'][1]
        and i['b']['min'][0] <= c['point'][0] and c['point'][0] <= i['b']['max'][0] and i['b']['min'][1] <=
        c['point'][1] and c['point'][1] <= i['b']['max'][1] and (i['a']['min'][1] == i['a']['max'][1] or
        i['b']['min'][1] == i['b']['max'][1])
    ),
    ("aabb_aabb", "touching", "flat_axis", 3, 0): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['a']['min'][2] <=
        i['a']['max'][2] and i['b']['min'][0] <= i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and
        i['b']['min'][2] <= i['b']['max'][2] and i['a']['min'][0] <= c['point'][0] and c['point'][0] <=
        i['a']['max'][0] and i['a']['min'][1] <= c['point'][1] and c['point'][1] <= i['a']['max'][1] and
        i['a']['min'][2] <= c['point'][2] and c['point'][2] <= i['a']['max'][2] and i['b']['min'][0] <= c['point'][0]
        and c['point'][0] <= i['b']['max'][0] and i['b']['min'][1] <= c['point'][1] and c['point'][1] <=
        i['b']['max'][1] and i['b']['min'][2] <= c['point'][2] and c['point'][2] <= i['b']['max'][2] and
        (i['a']['min'][0] == i['a']['max'][0] or i['b']['min'][0] == i['b']['max'][0])
    ),
    ("aabb_aabb", "touching", "flat_axis", 3, 1): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['a']['min'][2] <=
        i['a']['max'][2] and i['b']['min'][0] <= i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and
        i['b']['min'][2] <= i['b']['max'][2] and i['a']['min'][0] <= c['point'][0] and c['point'][0] <=
        i['a']['max'][0] and i['a']['min'][1] <= c['point'][1] and c['point'][1] <= i['a']['max'][1] and
        i['a']['min'][2] <= c['point'][2] and c['point'][2] <= i['a']['max'][2] and i['b']['min'][0] <= c['point'][0]
        and c['point'][0] <= i['b']['max'][0] and i['b']['min'][1] <= c['point'][1] and c['point'][1] <=
        i['b']['max'][1] and i['b']['min'][2] <= c['point'][2] and c['point'][2] <= i['b']['max'][2] and
        (i['a']['min'][1] == i['a']['max'][1] or i['b']['min'][1] == i['b']['max'][1])
    ),
    ("aabb_aabb", "touching", "flat_axis", 3, 2): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['a']['min'][2] <=
        i['a']['max'][2] and i['b']['min'][0] <= i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and
        i['b']['min'][2] <= i['b']['max'][2] and i['a']['min'][0] <= c['point'][0] and c['point'][0] <=
        i['a']['max'][0] and i['a']['min'][1] <= c['point'][1] and c['point'][1] <= i['a']['max'][1] and
        i['a']['min'][2] <= c['point'][2] and c['point'][2] <= i['a']['max'][2] and i['b']['min'][0] <= c['point'][0]
        and c['point'][0] <= i['b']['max'][0] and i['b']['min'][1] <= c['point'][1] and c['point'][1] <=
        i['b']['max'][1] and i['b']['min'][2] <= c['point'][2] and c['point'][2] <= i['b']['max'][2] and
        (i['a']['min'][2] == i['a']['max'][2] or i['b']['min'][2] == i['b']['max'][2])
    ),
    ("aabb_aabb", "overlapping", "common_interior_point", 2, None): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['b']['min'][0] <=
        i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and i['a']['min'][0] < c['point'][0] and
        c['point'][0] < i['a']['max'][0] and i['a']['min'][1] < c['point'][1] and c['point'][1] < i['a']['max'][1] and
        i['b']['min'][0] < c['point'][0] and c['point'][0] < i['b']['max'][0] and i['b']['min'][1] < c['point'][1] and
        c['point'][1] < i['b']['max'][1]
    ),
    ("aabb_aabb", "overlapping", "common_interior_point", 3, None): lambda i, t, c: (
        i['a']['min'][0] <= i['a']['max'][0] and i['a']['min'][1] <= i['a']['max'][1] and i['a']['min'][2] <=
        i['a']['max'][2] and i['b']['min'][0] <= i['b']['max'][0] and i['b']['min'][1] <= i['b']['max'][1] and
        i['b']['min'][2] <= i['b']['max'][2] and i['a']['min'][0] < c['point'][0] and c['point'][0] < i['a']['max'][0]
        and i['a']['min'][1] < c['point'][1] and c['point'][1] < i['a']['max'][1] and i['a']['min'][2] < c['point'][2]
        and c['point'][2] < i['a']['max'][2] and i['b']['min'][0] < c['point'][0] and c['point'][0] < i['b']['max'][0]
        and i['b']['min'][1] < c['point'][1] and c['point'][1] < i['b']['max'][1] and i['b']['min'][2] < c['point'][2]
        and c['point'][2] < i['b']['max'][2]
    ),
    ("sphere_aabb", "disjoint", "nearest_point", 2, None): lambda i, t, c: (
        0 <= i['sphere']['radius'] and i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][0] <= c['point'][0] and c['point'][0] <= i['aabb']['max'][0] and
        i['aabb']['min'][1] <= c['point'][1] and c['point'][1] <= i['aabb']['max'][1] and (c['point'][0] <=
        i['sphere']['center'][0] or c['point'][0] == i['aabb']['min'][0]) and (i['sphere']['center'][0] <=
        c['point'][0] or c['point'][0] == i['aabb']['max'][0]) and (c['point'][1] <= i['sphere']['center'][1] or
        c['point'][1] == i['aabb']['min'][1]) and (i['sphere']['center'][1] <= c['point'][1] or c['point'][1] ==
        i['aabb']['max'][1]) and i['sphere']['radius'] * i['sphere']['radius'] < (i['sphere']['center'][0] -
        c['point'][0]) * (i['sphere']['center'][0] - c['point'][0]) + (i['sphere']['center'][1] - c['point'][1]) *
        (i['sphere']['center'][1] - c['point'][1])
    ),
    ("sphere_aabb", "disjoint", "nearest_point", 3, None): lambda i, t, c: (
        0 <= i['sphere']['radius'] and i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][2] <= i['aabb']['max'][2] and i['aabb']['min'][0] <= c['point'][0] and
        c['point'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <= c['point'][1] and c['point'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][2] <= c['point'][2] and c['point'][2] <= i['aabb']['max'][2] and
        (c['point'][0] <= i['sphere']['center'][0] or c['point'][0] == i['aabb']['min'][0]) and
        (i['sphere']['center'][0] <= c['point'][0] or c['point'][0] == i['aabb']['max'][0]) and (c['point'][1] <=
        i['sphere']['center'][1] or c['point'][1] == i['aabb']['min'][1]) and (i['sphere']['center'][1] <=
        c['point'][1] or c['point'][1] == i['aabb']['max'][1]) and (c['point'][2] <= i['sphere']['center'][2] or
        c['point'][2] == i['aabb']['min'][2]) and (i['sphere']['center'][2] <= c['point'][2] or c['point'][2] ==
        i['aabb']['max'][2]) and i['sphere']['radius'] * i['sphere']['radius'] < (i['sphere']['center'][0] -
        c['point'][0]) * (i['sphere']['center'][0] - c['point'][0]) + (i['sphere']['center'][1] - c['point'][1]) *
        (i['sphere']['center'][1] - c['point'][1]) + (i['sphere']['center'][2] - c['point'][2]) *
        (i['sphere']['center'][2] - c['point'][2])
    ),
    ("sphere_aabb", "touching", "tangent", 2, None): lambda i, t, c: (
        0 <= i['sphere']['radius'] and i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][0] <= c['point'][0] and c['point'][0] <= i['aabb']['max'][0] and
        i['aabb']['min'][1] <= c['point'][1] and c['point'][1] <= i['aabb']['max'][1] and (c['point'][0] <=
        i['sphere']['center'][0] or c['point'][0] == i['aabb']['min'][0]) and (i['sphere']['center'][0] <=
        c['point'][0] or c['point'][0] == i['aabb']['max'][0]) and (c['point'][1] <= i['sphere']['center'][1] or
        c['point'][1] == i['aabb']['min'][1]) and (i['sphere']['center'][1] <= c['point'][1] or c['point'][1] ==
        i['aabb']['max'][1]) and (i['sphere']['center'][0] - c['point'][0]) * (i['sphere']['center'][0] -
        c['point'][0]) + (i['sphere']['center'][1] - c['point'][1]) * (i['sphere']['center'][1] - c['point'][1]) ==
        i['sphere']['radius'] * i['sphere']['radius']
    ),
    ("sphere_aabb", "touching", "tangent", 3, None): lambda i, t, c: (
        0 <= i['sphere']['radius'] and i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][2] <= i['aabb']['max'][2] and i['aabb']['min'][0] <= c['point'][0] and
        c['point'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <= c['point'][1] and c['point'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][2] <= c['point'][2] and c['point'][2] <= i['aabb']['max'][2] and
        (c['point'][0] <= i['sphere']['center'][0] or c['point'][0] == i['aabb']['min'][0]) and
        (i['sphere']['center'][0] <= c['point'][0] or c['point'][0] == i['aabb']['max'][0]) and (c['point'][1] <=
        i['sphere']['center'][1] or c['point'][1] == i['aabb']['min'][1]) and (i['sphere']['center'][1] <=
        c['point'][1] or c['point'][1] == i['aabb']['max'][1]) and (c['point'][2] <= i['sphere']['center'][2] or
        c['point'][2] == i['aabb']['min'][2]) and (i['sphere']['center'][2] <= c['point'][2] or c['point'][2] ==
        i['aabb']['max'][2]) and (i['sphere']['center'][0] - c['point'][0]) * (i['sphere']['center'][0] -
        c['point'][0]) + (i['sphere']['center'][1] - c['point'][1]) * (i['sphere']['center'][1] - c['point'][1]) +
        (i['sphere']['center'][2] - c['point'][2]) * (i['sphere']['center'][2] - c['point'][2]) ==
        i['sphere']['radius'] * i['sphere']['radius']
    ),
    ("sphere_aabb", "touching", "flat_axis", 2, 0): lambda i, t, c: (
        0 <= i['sphere']['radius'] and i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][0] <= c['point'][0] and c['point'][0] <= i['aabb']['max'][0] and
        i['aabb']['min'][1] <= c['point'][1] and c['point'][1] <= i['aabb']['max'][1] and (i['sphere']['center'][0] -
        c['point'][0]) * (i['sphere']['center'][0] - c['point'][0]) + (i['sphere']['center'][1] - c['point'][1]) *
        (i['sphere']['center'][1] - c['point'][1]) <= i['sphere']['radius'] * i['sphere']['radius'] and
        i['aabb']['min'][0] == i['aabb']['max'][0]
    ),
    ("sphere_aabb", "touching", "flat_axis", 2, 1): lambda i, t, c: (
        0 <= i['sphere']['radius'] and i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][0] <= c['point'][0] and c['point'][0] <= i['aabb']['max'][0] and
        i['aabb']['min'][1] <= c['point'][1] and c['point'][1] <= i['aabb']['max'][1] and (i['sphere']['center'][0] -
        c['point'][0]) * (i['sphere']['center'][0] - c['point'][0]) + (i['sphere']['center'][1] - c['point'][1]) *
        (i['sphere']['center'][1] - c['point'][1]) <= i['sphere']['radius'] * i['sphere']['radius'] and
        i['aabb']['min'][1] == i['aabb']['max'][1]
    ),
    ("sphere_aabb", "touching", "flat_axis", 3, 0): lambda i, t, c: (
        0 <= i['sphere']['radius'] and i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][2] <= i['aabb']['max'][2] and i['aabb']['min'][0] <= c['point'][0] and
        c['point'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <= c['point'][1] and c['point'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][2] <= c['point'][2] and c['point'][2] <= i['aabb']['max'][2] and
        (i['sphere']['center'][0] - c['point'][0]) * (i['sphere']['center'][0] - c['point'][0]) +
        (i['sphere']['center'][1] - c['point'][1]) * (i['sphere']['center'][1] - c['point'][1]) +
        (i['sphere']['center'][2] - c['point'][2]) * (i['sphere']['center'][2] - c['point'][2]) <=
        i['sphere']['radius'] * i['sphere']['radius'] and i['aabb']['min'][0] == i['aabb']['max'][0]
    ),
    ("sphere_aabb", "touching", "flat_axis", 3, 1): lambda i, t, c: (
        0 <= i['sphere']['radius'] and i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][2] <= i['aabb']['max'][2] and i['aabb']['min'][0] <= c['point'][0] and
        c['point'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <= c['point'][1] and c['point'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][2] <= c['point'][2] and c['point'][2] <= i['aabb']['max'][2] and
        (i['sphere']['center'][0] - c['point'][0]) * (i['sphere']['center'][0] - c['point'][0]) +
        (i['sphere']['center'][1] - c['point'][1]) * (i['sphere']['center'][1] - c['point'][1]) +
        (i['sphere']['center'][2] - c['point'][2]) * (i['sphere']['center'][2] - c['point'][2]) <=
        i['sphere']['radius'] * i['sphere']['radius'] and i['aabb']['min'][1] == i['aabb']['max'][1]
    ),
    ("sphere_aabb", "touching", "flat_axis", 3, 2): lambda i, t, c: (
        0 <= i['sphere']['radius'] and i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][2] <= i['aabb']['max'][2] and i['aabb']['min'][0] <= c['point'][0] and
        c['point'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <= c['point'][1] and c['point'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][2] <= c['point'][2] and c['point'][2] <= i['aabb']['max'][2] and
        (i['sphere']['center'][0] - c['point'][0]) * (i['sphere']['center'][0] - c['point'][0]) +
        (i['sphere']['center'][1] - c['point'][1]) * (i['sphere']['center'][1] - c['point'][1]) +
        (i['sphere']['center'][2] - c['point'][2]) * (i['sphere']['center'][2] - c['point'][2]) <=
        i['sphere']['radius'] * i['sphere']['radius'] and i['aabb']['min'][2] == i['aabb']['max'][2]
    ),
    ("sphere_aabb", "overlapping", "common_interior_point", 2, None): lambda i, t, c: (
        0 <= i['sphere']['radius'] and i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][0] < c['point'][0] and c['point'][0] < i['aabb']['max'][0] and
        i['aabb']['min'][1] < c['point'][1] and c['point'][1] < i['aabb']['max'][1] and (i['sphere']['center'][0] -
        c['point'][0]) * (i['sphere']['center'][0] - c['point'][0]) + (i['sphere']['center'][1] - c['point'][1]) *
        (i['sphere']['center'][1] - c['point'][1]) < i['sphere']['radius'] * i['sphere']['radius']
    ),
    ("sphere_aabb", "overlapping", "common_interior_point", 3, None): lambda i, t, c: (
        0 <= i['sphere']['radius'] and i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <=
        i['aabb']['max'][1] and i['aabb']['min'][2] <= i['aabb']['max'][2] and i['aabb']['min'][0] < c['point'][0] and
        c['point'][0] < i['aabb']['max'][0] and i['aabb']['min'][1] < c['point'][1] and c['point'][1] <
        i['aabb']['max'][1] and i['aabb']['min'][2] < c['point'][2] and c['point'][2] < i['aabb']['max'][2] and
        (i['sphere']['center'][0] - c['point'][0]) * (i['sphere']['center'][0] - c['point'][0]) +
        (i['sphere']['center'][1] - c['point'][1]) * (i['sphere']['center'][1] - c['point'][1]) +
        (i['sphere']['center'][2] - c['point'][2]) * (i['sphere']['center'][2] - c['point'][2]) < i['sphere']['radius']
        * i['sphere']['radius']
    ),
    ("implicit_circle", "inside", "squares", None, None): lambda i, t, c: (
        0 <= i['circle']['radius'] and c['squared_distance'][0] == (i['circle']['center'][0] - i['point'][0]) *
        (i['circle']['center'][0] - i['point'][0]) + (i['circle']['center'][1] - i['point'][1]) *
        (i['circle']['center'][1] - i['point'][1]) and c['squared_radius'][0] == i['circle']['radius'] *
        i['circle']['radius'] and c['squared_distance'][0] < c['squared_radius'][0]
    ),
    ("implicit_circle", "boundary", "squares", None, None): lambda i, t, c: (
        0 <= i['circle']['radius'] and c['squared_distance'][0] == (i['circle']['center'][0] - i['point'][0]) *
        (i['circle']['center'][0] - i['point'][0]) + (i['circle']['center'][1] - i['point'][1]) *
        (i['circle']['center'][1] - i['point'][1]) and c['squared_radius'][0] == i['circle']['radius'] *
        i['circle']['radius'] and c['squared_distance'][0] == c['squared_radius'][0]
    ),
    ("implicit_circle", "outside", "squares", None, None): lambda i, t, c: (
        0 <= i['circle']['radius'] and c['squared_distance'][0] == (i['circle']['center'][0] - i['point'][0]) *
        (i['circle']['center'][0] - i['point'][0]) + (i['circle']['center'][1] - i['point'][1]) *
        (i['circle']['center'][1] - i['point'][1]) and c['squared_radius'][0] == i['circle']['radius'] *
        i['circle']['radius'] and c['squared_radius'][0] < c['squared_distance'][0]
    ),
    ("closest_point_on_aabb", "", "multipliers", 2, None): lambda i, t, c: (
        i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <= i['aabb']['max'][1] and
        i['aabb']['min'][0] <= t['point'][0] and t['point'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <=
        t['point'][1] and t['point'][1] <= i['aabb']['max'][1] and 0 <= c['lower'][0] and 0 <= c['upper'][0] and
        (c['lower'][0] == 0 or t['point'][0] == i['aabb']['min'][0]) and (c['upper'][0] == 0 or t['point'][0] ==
        i['aabb']['max'][0]) and t['point'][0] - i['point'][0] == c['lower'][0] - c['upper'][0] and 0 <= c['lower'][1]
        and 0 <= c['upper'][1] and (c['lower'][1] == 0 or t['point'][1] == i['aabb']['min'][1]) and (c['upper'][1] == 0
        or t['point'][1] == i['aabb']['max'][1]) and t['point'][1] - i['point'][1] == c['lower'][1] - c['upper'][1]
    ),
    ("closest_point_on_aabb", "", "multipliers", 3, None): lambda i, t, c: (
        i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <= i['aabb']['max'][1] and
        i['aabb']['min'][2] <= i['aabb']['max'][2] and i['aabb']['min'][0] <= t['point'][0] and t['point'][0] <=
        i['aabb']['max'][0] and i['aabb']['min'][1] <= t['point'][1] and t['point'][1] <= i['aabb']['max'][1] and
        i['aabb']['min'][2] <= t['point'][2] and t['point'][2] <= i['aabb']['max'][2] and 0 <= c['lower'][0] and 0 <=
        c['upper'][0] and (c['lower'][0] == 0 or t['point'][0] == i['aabb']['min'][0]) and (c['upper'][0] == 0 or
        t['point'][0] == i['aabb']['max'][0]) and t['point'][0] - i['point'][0] == c['lower'][0] - c['upper'][0] and 0
        <= c['lower'][1] and 0 <= c['upper'][1] and (c['lower'][1] == 0 or t['point'][1] == i['aabb']['min'][1]) and
        (c['upper'][1] == 0 or t['point'][1] == i['aabb']['max'][1]) and t['point'][1] - i['point'][1] == c['lower'][1]
        - c['upper'][1] and 0 <= c['lower'][2] and 0 <= c['upper'][2] and (c['lower'][2] == 0 or t['point'][2] ==
        i['aabb']['min'][2]) and (c['upper'][2] == 0 or t['point'][2] == i['aabb']['max'][2]) and t['point'][2] -
        i['point'][2] == c['lower'][2] - c['upper'][2]
    ),
}
