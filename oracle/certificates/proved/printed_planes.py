# SPDX-License-Identifier: Apache-2.0
"""The formulas that Coq has proved, printed by print_python.ml: do not edit.

(operation, word of the truth, kind, dimension, axis of the certificate), None where it is asked for none, and the
condition on i, t, c: input, truth and certificate, with their numbers as fractions. A number p + q sqrt(r) is
(p, q, r).
"""

FORMULAS = {
    ("explicit_line", "above", "height", None, None): lambda i, t, c: (
        c['height'][0] == i['point'][1] - (i['slope'] * i['point'][0] + i['intercept']) and 0 < c['height'][0]
    ),
    ("explicit_line", "on", "height", None, None): lambda i, t, c: (
        c['height'][0] == i['point'][1] - (i['slope'] * i['point'][0] + i['intercept']) and c['height'][0] == 0
    ),
    ("explicit_line", "below", "height", None, None): lambda i, t, c: (
        c['height'][0] == i['point'][1] - (i['slope'] * i['point'][0] + i['intercept']) and c['height'][0] < 0
    ),
    ("point_ground_plane", "above", "height", None, None): lambda i, t, c: (
        c['height'][0] == i['point'][1] and 0 < c['height'][0]
    ),
    ("point_ground_plane", "on", "height", None, None): lambda i, t, c: (
        c['height'][0] == i['point'][1] and c['height'][0] == 0
    ),
    ("point_ground_plane", "below", "height", None, None): lambda i, t, c: (
        c['height'][0] == i['point'][1] and c['height'][0] < 0
    ),
    ("point_plane", "front", "root", None, None): lambda i, t, c: (
        not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        t['signed_distance'] * t['signed_distance'] * (i['plane']['normal'][0] * i['plane']['normal'][0] +
        i['plane']['normal'][1] * i['plane']['normal'][1] + i['plane']['normal'][2] * i['plane']['normal'][2]) ==
        (i['plane']['normal'][0] * i['point'][0] + i['plane']['normal'][1] * i['point'][1] + i['plane']['normal'][2] *
        i['point'][2] + i['plane']['offset']) * (i['plane']['normal'][0] * i['point'][0] + i['plane']['normal'][1] *
        i['point'][1] + i['plane']['normal'][2] * i['point'][2] + i['plane']['offset']) and 0 < i['plane']['normal'][0]
        * i['point'][0] + i['plane']['normal'][1] * i['point'][1] + i['plane']['normal'][2] * i['point'][2] +
        i['plane']['offset'] and 0 < t['signed_distance']
    ),
    ("point_plane", "on", "root", None, None): lambda i, t, c: (
        not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        t['signed_distance'] * t['signed_distance'] * (i['plane']['normal'][0] * i['plane']['normal'][0] +
        i['plane']['normal'][1] * i['plane']['normal'][1] + i['plane']['normal'][2] * i['plane']['normal'][2]) ==
        (i['plane']['normal'][0] * i['point'][0] + i['plane']['normal'][1] * i['point'][1] + i['plane']['normal'][2] *
        i['point'][2] + i['plane']['offset']) * (i['plane']['normal'][0] * i['point'][0] + i['plane']['normal'][1] *
        i['point'][1] + i['plane']['normal'][2] * i['point'][2] + i['plane']['offset']) and i['plane']['normal'][0] *
        i['point'][0] + i['plane']['normal'][1] * i['point'][1] + i['plane']['normal'][2] * i['point'][2] +
        i['plane']['offset'] == 0 and t['signed_distance'] == 0
    ),
    ("point_plane", "back", "root", None, None): lambda i, t, c: (
        not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        t['signed_distance'] * t['signed_distance'] * (i['plane']['normal'][0] * i['plane']['normal'][0] +
        i['plane']['normal'][1] * i['plane']['normal'][1] + i['plane']['normal'][2] * i['plane']['normal'][2]) ==
        (i['plane']['normal'][0] * i['point'][0] + i['plane']['normal'][1] * i['point'][1] + i['plane']['normal'][2] *
        i['point'][2] + i['plane']['offset']) * (i['plane']['normal'][0] * i['point'][0] + i['plane']['normal'][1] *
        i['point'][1] + i['plane']['normal'][2] * i['point'][2] + i['plane']['offset']) and i['plane']['normal'][0] *
        i['point'][0] + i['plane']['normal'][1] * i['point'][1] + i['plane']['normal'][2] * i['point'][2] +
        i['plane']['offset'] < 0 and t['signed_distance'] < 0
    ),
    ("ray_plane", "none", "heights", None, None): lambda i, t, c: (
        not (i['ray']['direction'][0] == 0 and i['ray']['direction'][1] == 0 and i['ray']['direction'][2] == 0) and not
        (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        c['heights'][0] == i['plane']['normal'][0] * i['ray']['origin'][0] + i['plane']['normal'][1] *
        i['ray']['origin'][1] + i['plane']['normal'][2] * i['ray']['origin'][2] + i['plane']['offset'] and
        c['heights'][1] - c['heights'][0] == i['plane']['normal'][0] * i['ray']['direction'][0] +
        i['plane']['normal'][1] * i['ray']['direction'][1] + i['plane']['normal'][2] * i['ray']['direction'][2] and not
        (c['heights'][0] == 0) and 0 <= c['heights'][0] * (c['heights'][1] - c['heights'][0])
    ),
    ("ray_plane", "inside", "heights", None, None): lambda i, t, c: (
        not (i['ray']['direction'][0] == 0 and i['ray']['direction'][1] == 0 and i['ray']['direction'][2] == 0) and not
        (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        c['heights'][0] == i['plane']['normal'][0] * i['ray']['origin'][0] + i['plane']['normal'][1] *
        i['ray']['origin'][1] + i['plane']['normal'][2] * i['ray']['origin'][2] + i['plane']['offset'] and
        c['heights'][1] - c['heights'][0] == i['plane']['normal'][0] * i['ray']['direction'][0] +
        i['plane']['normal'][1] * i['ray']['direction'][1] + i['plane']['normal'][2] * i['ray']['direction'][2] and
        c['heights'][0] == 0 and c['heights'][1] == 0
    ),
    ("ray_plane", "point", "heights", None, None): lambda i, t, c: (
        not (i['ray']['direction'][0] == 0 and i['ray']['direction'][1] == 0 and i['ray']['direction'][2] == 0) and not
        (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        c['heights'][0] == i['plane']['normal'][0] * i['ray']['origin'][0] + i['plane']['normal'][1] *
        i['ray']['origin'][1] + i['plane']['normal'][2] * i['ray']['origin'][2] + i['plane']['offset'] and
        c['heights'][1] - c['heights'][0] == i['plane']['normal'][0] * i['ray']['direction'][0] +
        i['plane']['normal'][1] * i['ray']['direction'][1] + i['plane']['normal'][2] * i['ray']['direction'][2] and not
        (c['heights'][1] - c['heights'][0] == 0) and 0 <= t['t'] and c['heights'][0] + t['t'] * (c['heights'][1] -
        c['heights'][0]) == 0 and t['point'][0] == i['ray']['origin'][0] + t['t'] * i['ray']['direction'][0] and
        t['point'][1] == i['ray']['origin'][1] + t['t'] * i['ray']['direction'][1] and t['point'][2] ==
        i['ray']['origin'][2] + t['t'] * i['ray']['direction'][2]
    ),
    ("segment_plane", "none", "heights", None, None): lambda i, t, c: (
        not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        c['heights'][0] == i['plane']['normal'][0] * i['segment'][0][0] + i['plane']['normal'][1] * i['segment'][0][1]
        + i['plane']['normal'][2] * i['segment'][0][2] + i['plane']['offset'] and c['heights'][1] - c['heights'][0] ==
        i['plane']['normal'][0] * (i['segment'][1][0] - i['segment'][0][0]) + i['plane']['normal'][1] *
        (i['segment'][1][1] - i['segment'][0][1]) + i['plane']['normal'][2] * (i['segment'][1][2] - i['segment'][0][2])
        and 0 < c['heights'][0] * c['heights'][1]
    ),
    ("segment_plane", "inside", "heights", None, None): lambda i, t, c: (
        not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        c['heights'][0] == i['plane']['normal'][0] * i['segment'][0][0] + i['plane']['normal'][1] * i['segment'][0][1]
        + i['plane']['normal'][2] * i['segment'][0][2] + i['plane']['offset'] and c['heights'][1] - c['heights'][0] ==
        i['plane']['normal'][0] * (i['segment'][1][0] - i['segment'][0][0]) + i['plane']['normal'][1] *
        (i['segment'][1][1] - i['segment'][0][1]) + i['plane']['normal'][2] * (i['segment'][1][2] - i['segment'][0][2])
        and c['heights'][0] == 0 and c['heights'][1] == 0
    ),
    ("segment_plane", "point", "heights", None, None): lambda i, t, c: (
        not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        c['heights'][0] == i['plane']['normal'][0] * i['segment'][0][0] + i['plane']['normal'][1] * i['segment'][0][1]
        + i['plane']['normal'][2] * i['segment'][0][2] + i['plane']['offset'] and c['heights'][1] - c['heights'][0] ==
        i['plane']['normal'][0] * (i['segment'][1][0] - i['segment'][0][0]) + i['plane']['normal'][1] *
        (i['segment'][1][1] - i['segment'][0][1]) + i['plane']['normal'][2] * (i['segment'][1][2] - i['segment'][0][2])
        and not (c['heights'][1] - c['heights'][0] == 0) and 0 <= t['t'] and t['t'] <= 1 and c['heights'][0] + t['t'] *
        (c['heights'][1] - c['heights'][0]) == 0 and t['point'][0] == i['segment'][0][0] + t['t'] * (i['segment'][1][0]
        - i['segment'][0][0]) and t['point'][1] == i['segment'][0][1] + t['t'] * (i['segment'][1][1] -
        i['segment'][0][1]) and t['point'][2] == i['segment'][0][2] + t['t'] * (i['segment'][1][2] -
        i['segment'][0][2])
    ),
    ("sphere_plane", "disjoint", "nearest_point", None, None): lambda i, t, c: (
        0 <= i['sphere']['radius'] and not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and
        i['plane']['normal'][2] == 0) and i['plane']['normal'][0] * c['point'][0] + i['plane']['normal'][1] *
        c['point'][1] + i['plane']['normal'][2] * c['point'][2] + i['plane']['offset'] <= 0 and 0 <=
        i['plane']['normal'][0] * (i['sphere']['center'][0] - c['point'][0]) + i['plane']['normal'][1] *
        (i['sphere']['center'][1] - c['point'][1]) + i['plane']['normal'][2] * (i['sphere']['center'][2] -
        c['point'][2]) and (i['plane']['normal'][0] * (i['sphere']['center'][0] - c['point'][0]) +
        i['plane']['normal'][1] * (i['sphere']['center'][1] - c['point'][1]) + i['plane']['normal'][2] *
        (i['sphere']['center'][2] - c['point'][2])) * (i['plane']['normal'][0] * c['point'][0] +
        i['plane']['normal'][1] * c['point'][1] + i['plane']['normal'][2] * c['point'][2] + i['plane']['offset']) == 0
        and (i['plane']['normal'][0] * (i['sphere']['center'][0] - c['point'][0]) + i['plane']['normal'][1] *
        (i['sphere']['center'][1] - c['point'][1]) + i['plane']['normal'][2] * (i['sphere']['center'][2] -
        c['point'][2])) * (i['plane']['normal'][0] * (i['sphere']['center'][0] - c['point'][0]) +
        i['plane']['normal'][1] * (i['sphere']['center'][1] - c['point'][1]) + i['plane']['normal'][2] *
        (i['sphere']['center'][2] - c['point'][2])) == ((i['sphere']['center'][0] - c['point'][0]) *
        (i['sphere']['center'][0] - c['point'][0]) + (i['sphere']['center'][1] - c['point'][1]) *
        (i['sphere']['center'][1] - c['point'][1]) + (i['sphere']['center'][2] - c['point'][2]) *
        (i['sphere']['center'][2] - c['point'][2])) * (i['plane']['normal'][0] * i['plane']['normal'][0] +
        i['plane']['normal'][1] * i['plane']['normal'][1] + i['plane']['normal'][2] * i['plane']['normal'][2]) and
        i['sphere']['radius'] * i['sphere']['radius'] < (i['sphere']['center'][0] - c['point'][0]) *
        (i['sphere']['center'][0] - c['point'][0]) + (i['sphere']['center'][1] - c['point'][1]) *
        (i['sphere']['center'][1] - c['point'][1]) + (i['sphere']['center'][2] - c['point'][2]) *
        (i['sphere']['center'][2] - c['point'][2])
    ),
    ("sphere_plane", "touching", "tangent", None, None): lambda i, t, c: (
        0 <= i['sphere']['radius'] and not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and
        i['plane']['normal'][2] == 0) and i['plane']['normal'][0] * c['point'][0] + i['plane']['normal'][1] *
        c['point'][1] + i['plane']['normal'][2] * c['point'][2] + i['plane']['offset'] <= 0 and 0 <=
        i['plane']['normal'][0] * (i['sphere']['center'][0] - c['point'][0]) + i['plane']['normal'][1] *
        (i['sphere']['center'][1] - c['point'][1]) + i['plane']['normal'][2] * (i['sphere']['center'][2] -
        c['point'][2]) and (i['plane']['normal'][0] * (i['sphere']['center'][0] - c['point'][0]) +
        i['plane']['normal'][1] * (i['sphere']['center'][1] - c['point'][1]) + i['plane']['normal'][2] *
        (i['sphere']['center'][2] - c['point'][2])) * (i['plane']['normal'][0] * c['point'][0] +
        i['plane']['normal'][1] * c['point'][1] + i['plane']['normal'][2] * c['point'][2] + i['plane']['offset']) == 0
        and (i['plane']['normal'][0] * (i['sphere']['center'][0] - c['point'][0]) + i['plane']['normal'][1] *
        (i['sphere']['center'][1] - c['point'][1]) + i['plane']['normal'][2] * (i['sphere']['center'][2] -
        c['point'][2])) * (i['plane']['normal'][0] * (i['sphere']['center'][0] - c['point'][0]) +
        i['plane']['normal'][1] * (i['sphere']['center'][1] - c['point'][1]) + i['plane']['normal'][2] *
        (i['sphere']['center'][2] - c['point'][2])) == ((i['sphere']['center'][0] - c['point'][0]) *
        (i['sphere']['center'][0] - c['point'][0]) + (i['sphere']['center'][1] - c['point'][1]) *
        (i['sphere']['center'][1] - c['point'][1]) + (i['sphere']['center'][2] - c['point'][2]) *
        (i['sphere']['center'][2] - c['point'][2])) * (i['plane']['normal'][0] * i['plane']['normal'][0] +
        i['plane']['normal'][1] * i['plane']['normal'][1] + i['plane']['normal'][2] * i['plane']['normal'][2]) and
        (i['sphere']['center'][0] - c['point'][0]) * (i['sphere']['center'][0] - c['point'][0]) +
        (i['sphere']['center'][1] - c['point'][1]) * (i['sphere']['center'][1] - c['point'][1]) +
        (i['sphere']['center'][2] - c['point'][2]) * (i['sphere']['center'][2] - c['point'][2]) ==
        i['sphere']['radius'] * i['sphere']['radius']
    ),
    ("sphere_plane", "overlapping", "common_interior_point", None, None): lambda i, t, c: (
        0 <= i['sphere']['radius'] and not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and
        i['plane']['normal'][2] == 0) and i['plane']['normal'][0] * c['point'][0] + i['plane']['normal'][1] *
        c['point'][1] + i['plane']['normal'][2] * c['point'][2] + i['plane']['offset'] < 0 and
        (i['sphere']['center'][0] - c['point'][0]) * (i['sphere']['center'][0] - c['point'][0]) +
        (i['sphere']['center'][1] - c['point'][1]) * (i['sphere']['center'][1] - c['point'][1]) +
        (i['sphere']['center'][2] - c['point'][2]) * (i['sphere']['center'][2] - c['point'][2]) < i['sphere']['radius']
        * i['sphere']['radius']
    ),
    ("aabb_plane", "disjoint", "lowest_point", None, None): lambda i, t, c: (
        not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <= i['aabb']['max'][1] and
        i['aabb']['min'][2] <= i['aabb']['max'][2] and i['aabb']['min'][0] <= c['point'][0] and c['point'][0] <=
        i['aabb']['max'][0] and i['aabb']['min'][1] <= c['point'][1] and c['point'][1] <= i['aabb']['max'][1] and
        i['aabb']['min'][2] <= c['point'][2] and c['point'][2] <= i['aabb']['max'][2] and (i['plane']['normal'][0] <= 0
        or c['point'][0] == i['aabb']['min'][0]) and (0 <= i['plane']['normal'][0] or c['point'][0] ==
        i['aabb']['max'][0]) and (i['plane']['normal'][1] <= 0 or c['point'][1] == i['aabb']['min'][1]) and (0 <=
        i['plane']['normal'][1] or c['point'][1] == i['aabb']['max'][1]) and (i['plane']['normal'][2] <= 0 or
        c['point'][2] == i['aabb']['min'][2]) and (0 <= i['plane']['normal'][2] or c['point'][2] ==
        i['aabb']['max'][2]) and 0 < i['plane']['normal'][0] * c['point'][0] + i['plane']['normal'][1] * c['point'][1]
        + i['plane']['normal'][2] * c['point'][2] + i['plane']['offset']
    ),
    ("aabb_plane", "touching", "lowest_point", None, None): lambda i, t, c: (
        not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <= i['aabb']['max'][1] and
        i['aabb']['min'][2] <= i['aabb']['max'][2] and i['aabb']['min'][0] <= c['point'][0] and c['point'][0] <=
        i['aabb']['max'][0] and i['aabb']['min'][1] <= c['point'][1] and c['point'][1] <= i['aabb']['max'][1] and
        i['aabb']['min'][2] <= c['point'][2] and c['point'][2] <= i['aabb']['max'][2] and (i['plane']['normal'][0] <= 0
        or c['point'][0] == i['aabb']['min'][0]) and (0 <= i['plane']['normal'][0] or c['point'][0] ==
        i['aabb']['max'][0]) and (i['plane']['normal'][1] <= 0 or c['point'][1] == i['aabb']['min'][1]) and (0 <=
        i['plane']['normal'][1] or c['point'][1] == i['aabb']['max'][1]) and (i['plane']['normal'][2] <= 0 or
        c['point'][2] == i['aabb']['min'][2]) and (0 <= i['plane']['normal'][2] or c['point'][2] ==
        i['aabb']['max'][2]) and i['plane']['normal'][0] * c['point'][0] + i['plane']['normal'][1] * c['point'][1] +
        i['plane']['normal'][2] * c['point'][2] + i['plane']['offset'] == 0
    ),
    ("aabb_plane", "touching", "flat_axis", None, 0): lambda i, t, c: (
        not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <= i['aabb']['max'][1] and
        i['aabb']['min'][2] <= i['aabb']['max'][2] and i['aabb']['min'][0] <= c['point'][0] and c['point'][0] <=
        i['aabb']['max'][0] and i['aabb']['min'][1] <= c['point'][1] and c['point'][1] <= i['aabb']['max'][1] and
        i['aabb']['min'][2] <= c['point'][2] and c['point'][2] <= i['aabb']['max'][2] and i['plane']['normal'][0] *
        c['point'][0] + i['plane']['normal'][1] * c['point'][1] + i['plane']['normal'][2] * c['point'][2] +
        i['plane']['offset'] <= 0 and i['aabb']['min'][0] == i['aabb']['max'][0]
    ),
    ("aabb_plane", "touching", "flat_axis", None, 1): lambda i, t, c: (
        not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <= i['aabb']['max'][1] and
        i['aabb']['min'][2] <= i['aabb']['max'][2] and i['aabb']['min'][0] <= c['point'][0] and c['point'][0] <=
        i['aabb']['max'][0] and i['aabb']['min'][1] <= c['point'][1] and c['point'][1] <= i['aabb']['max'][1] and
        i['aabb']['min'][2] <= c['point'][2] and c['point'][2] <= i['aabb']['max'][2] and i['plane']['normal'][0] *
        c['point'][0] + i['plane']['normal'][1] * c['point'][1] + i['plane']['normal'][2] * c['point'][2] +
        i['plane']['offset'] <= 0 and i['aabb']['min'][1] == i['aabb']['max'][1]
    ),
    ("aabb_plane", "touching", "flat_axis", None, 2): lambda i, t, c: (
        not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <= i['aabb']['max'][1] and
        i['aabb']['min'][2] <= i['aabb']['max'][2] and i['aabb']['min'][0] <= c['point'][0] and c['point'][0] <=
        i['aabb']['max'][0] and i['aabb']['min'][1] <= c['point'][1] and c['point'][1] <= i['aabb']['max'][1] and
        i['aabb']['min'][2] <= c['point'][2] and c['point'][2] <= i['aabb']['max'][2] and i['plane']['normal'][0] *
        c['point'][0] + i['plane']['normal'][1] * c['point'][1] + i['plane']['normal'][2] * c['point'][2] +
        i['plane']['offset'] <= 0 and i['aabb']['min'][2] == i['aabb']['max'][2]
    ),
    ("aabb_plane", "overlapping", "common_interior_point", None, None): lambda i, t, c: (
        not (i['plane']['normal'][0] == 0 and i['plane']['normal'][1] == 0 and i['plane']['normal'][2] == 0) and
        i['aabb']['min'][0] <= i['aabb']['max'][0] and i['aabb']['min'][1] <= i['aabb']['max'][1] and
        i['aabb']['min'][2] <= i['aabb']['max'][2] and i['aabb']['min'][0] < c['point'][0] and c['point'][0] <
        i['aabb']['max'][0] and i['aabb']['min'][1] < c['point'][1] and c['point'][1] < i['aabb']['max'][1] and
        i['aabb']['min'][2] < c['point'][2] and c['point'][2] < i['aabb']['max'][2] and i['plane']['normal'][0] *
        c['point'][0] + i['plane']['normal'][1] * c['point'][1] + i['plane']['normal'][2] * c['point'][2] +
        i['plane']['offset'] < 0
    ),
}
