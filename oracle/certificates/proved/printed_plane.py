# SPDX-License-Identifier: Apache-2.0
"""The formulas that Coq has proved, printed by print_python.ml: do not edit.

(operation, word of the truth, kind, dimension, axis of the certificate), None where it is asked for none, and the
condition on i, t, c: input, truth and certificate, with their numbers as fractions. A number p + q sqrt(r) is
(p, q, r).
"""

FORMULAS = {
    ("orientation", "left", "determinant", None, None): lambda i, t, c: (
        c['determinant'][0] == (i['p1'][0] - i['p0'][0]) * (i['p'][1] - i['p0'][1]) - (i['p1'][1] - i['p0'][1]) *
        (i['p'][0] - i['p0'][0]) and 0 < c['determinant'][0]
    ),
    ("orientation", "right", "determinant", None, None): lambda i, t, c: (
        c['determinant'][0] == (i['p1'][0] - i['p0'][0]) * (i['p'][1] - i['p0'][1]) - (i['p1'][1] - i['p0'][1]) *
        (i['p'][0] - i['p0'][0]) and c['determinant'][0] < 0
    ),
    ("orientation", "on", "determinant", None, None): lambda i, t, c: (
        c['determinant'][0] == (i['p1'][0] - i['p0'][0]) * (i['p'][1] - i['p0'][1]) - (i['p1'][1] - i['p0'][1]) *
        (i['p'][0] - i['p0'][0]) and c['determinant'][0] == 0
    ),
    ("point_on_segment", "off", "separating_line", None, None): lambda i, t, c: (
        c['normal'][0] * i['point'][0] + c['normal'][1] * i['point'][1] < c['offset'][0] and c['offset'][0] <
        c['normal'][0] * i['segment'][0][0] + c['normal'][1] * i['segment'][0][1] and c['offset'][0] < c['normal'][0] *
        i['segment'][1][0] + c['normal'][1] * i['segment'][1][1]
    ),
    ("point_on_segment", "on", "weights", None, None): lambda i, t, c: (
        0 <= c['weights'][0] and 0 <= c['weights'][1] and c['weights'][0] + c['weights'][1] == 1 and i['point'][0] ==
        c['weights'][0] * i['segment'][0][0] + c['weights'][1] * i['segment'][1][0] and i['point'][1] ==
        c['weights'][0] * i['segment'][0][1] + c['weights'][1] * i['segment'][1][1] and t['t'] == c['weights'][1] and
        (not (i['segment'][0][0] == i['segment'][1][0] and i['segment'][0][1] == i['segment'][1][1]) or t['t'] == 0)
    ),
    ("segment_segment", "disjoint", "separating_line", None, None): lambda i, t, c: (
        c['normal'][0] * i['a'][0][0] + c['normal'][1] * i['a'][0][1] < c['offset'][0] and c['normal'][0] *
        i['a'][1][0] + c['normal'][1] * i['a'][1][1] < c['offset'][0] and c['offset'][0] < c['normal'][0] *
        i['b'][0][0] + c['normal'][1] * i['b'][0][1] and c['offset'][0] < c['normal'][0] * i['b'][1][0] +
        c['normal'][1] * i['b'][1][1]
    ),
    ("segment_segment", "point", "transversal", None, None): lambda i, t, c: (
        0 <= t['ta'] and t['ta'] <= 1 and 0 <= t['tb'] and t['tb'] <= 1 and t['point'][0] == i['a'][0][0] + t['ta'] *
        (i['a'][1][0] - i['a'][0][0]) and t['point'][1] == i['a'][0][1] + t['ta'] * (i['a'][1][1] - i['a'][0][1]) and
        t['point'][0] == i['b'][0][0] + t['tb'] * (i['b'][1][0] - i['b'][0][0]) and t['point'][1] == i['b'][0][1] +
        t['tb'] * (i['b'][1][1] - i['b'][0][1]) and (not (i['a'][0][0] == i['a'][1][0] and i['a'][0][1] ==
        i['a'][1][1]) or t['ta'] == 0) and (not (i['b'][0][0] == i['b'][1][0] and i['b'][0][1] == i['b'][1][1]) or
        t['tb'] == 0) and c['determinant'][0] == (i['a'][1][0] - i['a'][0][0]) * (i['b'][1][1] - i['b'][0][1]) -
        (i['a'][1][1] - i['a'][0][1]) * (i['b'][1][0] - i['b'][0][0]) and not (c['determinant'][0] == 0)
    ),
    ("segment_segment", "point", "single_point", None, None): lambda i, t, c: (
        0 <= t['ta'] and t['ta'] <= 1 and 0 <= t['tb'] and t['tb'] <= 1 and t['point'][0] == i['a'][0][0] + t['ta'] *
        (i['a'][1][0] - i['a'][0][0]) and t['point'][1] == i['a'][0][1] + t['ta'] * (i['a'][1][1] - i['a'][0][1]) and
        t['point'][0] == i['b'][0][0] + t['tb'] * (i['b'][1][0] - i['b'][0][0]) and t['point'][1] == i['b'][0][1] +
        t['tb'] * (i['b'][1][1] - i['b'][0][1]) and (not (i['a'][0][0] == i['a'][1][0] and i['a'][0][1] ==
        i['a'][1][1]) or t['ta'] == 0) and (not (i['b'][0][0] == i['b'][1][0] and i['b'][0][1] == i['b'][1][1]) or
        t['tb'] == 0) and ((i['a'][0][0] == i['a'][1][0] and i['a'][0][1] == i['a'][1][1]) or (i['b'][0][0] ==
        i['b'][1][0] and i['b'][0][1] == i['b'][1][1]))
    ),
    ("segment_segment", "point", "supporting_line", None, None): lambda i, t, c: (
        0 <= t['ta'] and t['ta'] <= 1 and 0 <= t['tb'] and t['tb'] <= 1 and t['point'][0] == i['a'][0][0] + t['ta'] *
        (i['a'][1][0] - i['a'][0][0]) and t['point'][1] == i['a'][0][1] + t['ta'] * (i['a'][1][1] - i['a'][0][1]) and
        t['point'][0] == i['b'][0][0] + t['tb'] * (i['b'][1][0] - i['b'][0][0]) and t['point'][1] == i['b'][0][1] +
        t['tb'] * (i['b'][1][1] - i['b'][0][1]) and (not (i['a'][0][0] == i['a'][1][0] and i['a'][0][1] ==
        i['a'][1][1]) or t['ta'] == 0) and (not (i['b'][0][0] == i['b'][1][0] and i['b'][0][1] == i['b'][1][1]) or
        t['tb'] == 0) and c['normal'][0] * i['a'][0][0] + c['normal'][1] * i['a'][0][1] <= c['offset'][0] and
        c['normal'][0] * i['a'][1][0] + c['normal'][1] * i['a'][1][1] <= c['offset'][0] and c['offset'][0] <=
        c['normal'][0] * i['b'][0][0] + c['normal'][1] * i['b'][0][1] and c['offset'][0] <= c['normal'][0] *
        i['b'][1][0] + c['normal'][1] * i['b'][1][1] and (not (c['normal'][0] * i['a'][0][0] + c['normal'][1] *
        i['a'][0][1] == c['offset'][0] and c['normal'][0] * i['a'][1][0] + c['normal'][1] * i['a'][1][1] ==
        c['offset'][0]) or not (c['normal'][0] * i['b'][0][0] + c['normal'][1] * i['b'][0][1] == c['offset'][0] and
        c['normal'][0] * i['b'][1][0] + c['normal'][1] * i['b'][1][1] == c['offset'][0]))
    ),
    ("segment_segment", "overlap", "overlap", None, None): lambda i, t, c: (
        (t['overlap'][0][0] < t['overlap'][1][0] or (t['overlap'][0][0] == t['overlap'][1][0] and t['overlap'][0][1] <
        t['overlap'][1][1])) and 0 <= c['on_a'][0] and c['on_a'][0] <= 1 and 0 <= c['on_a'][1] and c['on_a'][1] <= 1
        and 0 <= c['on_b'][0] and c['on_b'][0] <= 1 and 0 <= c['on_b'][1] and c['on_b'][1] <= 1 and t['overlap'][0][0]
        == i['a'][0][0] + c['on_a'][0] * (i['a'][1][0] - i['a'][0][0]) and t['overlap'][0][1] == i['a'][0][1] +
        c['on_a'][0] * (i['a'][1][1] - i['a'][0][1]) and t['overlap'][1][0] == i['a'][0][0] + c['on_a'][1] *
        (i['a'][1][0] - i['a'][0][0]) and t['overlap'][1][1] == i['a'][0][1] + c['on_a'][1] * (i['a'][1][1] -
        i['a'][0][1]) and t['overlap'][0][0] == i['b'][0][0] + c['on_b'][0] * (i['b'][1][0] - i['b'][0][0]) and
        t['overlap'][0][1] == i['b'][0][1] + c['on_b'][0] * (i['b'][1][1] - i['b'][0][1]) and t['overlap'][1][0] ==
        i['b'][0][0] + c['on_b'][1] * (i['b'][1][0] - i['b'][0][0]) and t['overlap'][1][1] == i['b'][0][1] +
        c['on_b'][1] * (i['b'][1][1] - i['b'][0][1]) and (c['on_a'][0] == 0 or (c['on_a'][0] == 1 or (c['on_b'][0] == 0
        or c['on_b'][0] == 1))) and (c['on_a'][1] == 0 or (c['on_a'][1] == 1 or (c['on_b'][1] == 0 or c['on_b'][1] ==
        1)))
    ),
    ("line_line", "crossing", "transversal", None, None): lambda i, t, c: (
        not (i['a'][0][0] == i['a'][1][0] and i['a'][0][1] == i['a'][1][1]) and not (i['b'][0][0] == i['b'][1][0] and
        i['b'][0][1] == i['b'][1][1]) and c['determinant'][0] == (i['a'][1][0] - i['a'][0][0]) * (i['b'][1][1] -
        i['b'][0][1]) - (i['a'][1][1] - i['a'][0][1]) * (i['b'][1][0] - i['b'][0][0]) and not (c['determinant'][0] ==
        0) and t['point'][0] == i['a'][0][0] + t['ta'] * (i['a'][1][0] - i['a'][0][0]) and t['point'][1] ==
        i['a'][0][1] + t['ta'] * (i['a'][1][1] - i['a'][0][1]) and t['point'][0] == i['b'][0][0] + t['tb'] *
        (i['b'][1][0] - i['b'][0][0]) and t['point'][1] == i['b'][0][1] + t['tb'] * (i['b'][1][1] - i['b'][0][1])
    ),
    ("line_line", "parallel", "level_lines", None, None): lambda i, t, c: (
        not (i['a'][0][0] == i['a'][1][0] and i['a'][0][1] == i['a'][1][1]) and not (i['b'][0][0] == i['b'][1][0] and
        i['b'][0][1] == i['b'][1][1]) and c['normal'][0] * i['a'][0][0] + c['normal'][1] * i['a'][0][1] ==
        c['normal'][0] * i['a'][1][0] + c['normal'][1] * i['a'][1][1] and c['normal'][0] * i['b'][0][0] +
        c['normal'][1] * i['b'][0][1] == c['normal'][0] * i['b'][1][0] + c['normal'][1] * i['b'][1][1] and not
        (c['normal'][0] * i['a'][0][0] + c['normal'][1] * i['a'][0][1] == c['normal'][0] * i['b'][0][0] +
        c['normal'][1] * i['b'][0][1])
    ),
    ("line_line", "same", "same_line", None, None): lambda i, t, c: (
        not (i['a'][0][0] == i['a'][1][0] and i['a'][0][1] == i['a'][1][1]) and not (i['b'][0][0] == i['b'][1][0] and
        i['b'][0][1] == i['b'][1][1]) and i['b'][0][0] == i['a'][0][0] + c['on_a'][0] * (i['a'][1][0] - i['a'][0][0])
        and i['b'][0][1] == i['a'][0][1] + c['on_a'][0] * (i['a'][1][1] - i['a'][0][1]) and i['b'][1][0] ==
        i['a'][0][0] + c['on_a'][1] * (i['a'][1][0] - i['a'][0][0]) and i['b'][1][1] == i['a'][0][1] + c['on_a'][1] *
        (i['a'][1][1] - i['a'][0][1])
    ),
    ("ray_segment", "none", "separating_line", None, None): lambda i, t, c: (
        not (i['ray']['direction'][0] == 0 and i['ray']['direction'][1] == 0) and c['normal'][0] *
        i['ray']['origin'][0] + c['normal'][1] * i['ray']['origin'][1] < c['offset'][0] and c['normal'][0] *
        i['ray']['direction'][0] + c['normal'][1] * i['ray']['direction'][1] <= 0 and c['offset'][0] < c['normal'][0] *
        i['segment'][0][0] + c['normal'][1] * i['segment'][0][1] and c['offset'][0] < c['normal'][0] *
        i['segment'][1][0] + c['normal'][1] * i['segment'][1][1]
    ),
    ("ray_segment", "point", "transversal", None, None): lambda i, t, c: (
        not (i['ray']['direction'][0] == 0 and i['ray']['direction'][1] == 0) and 0 <= t['t'] and t['point'][0] ==
        i['ray']['origin'][0] + t['t'] * i['ray']['direction'][0] and t['point'][1] == i['ray']['origin'][1] + t['t'] *
        i['ray']['direction'][1] and 0 <= c['on_segment'][0] and c['on_segment'][0] <= 1 and t['point'][0] ==
        i['segment'][0][0] + c['on_segment'][0] * (i['segment'][1][0] - i['segment'][0][0]) and t['point'][1] ==
        i['segment'][0][1] + c['on_segment'][0] * (i['segment'][1][1] - i['segment'][0][1]) and c['determinant'][0] ==
        i['ray']['direction'][0] * (i['segment'][1][1] - i['segment'][0][1]) - i['ray']['direction'][1] *
        (i['segment'][1][0] - i['segment'][0][0]) and not (c['determinant'][0] == 0)
    ),
    ("ray_segment", "point", "single_point", None, None): lambda i, t, c: (
        not (i['ray']['direction'][0] == 0 and i['ray']['direction'][1] == 0) and 0 <= t['t'] and t['point'][0] ==
        i['ray']['origin'][0] + t['t'] * i['ray']['direction'][0] and t['point'][1] == i['ray']['origin'][1] + t['t'] *
        i['ray']['direction'][1] and i['segment'][0][0] == i['segment'][1][0] and i['segment'][0][1] ==
        i['segment'][1][1] and t['point'][0] == i['segment'][0][0] and t['point'][1] == i['segment'][0][1]
    ),
    ("ray_segment", "point", "supporting_line", None, None): lambda i, t, c: (
        not (i['ray']['direction'][0] == 0 and i['ray']['direction'][1] == 0) and 0 <= t['t'] and t['point'][0] ==
        i['ray']['origin'][0] + t['t'] * i['ray']['direction'][0] and t['point'][1] == i['ray']['origin'][1] + t['t'] *
        i['ray']['direction'][1] and 0 <= c['on_segment'][0] and c['on_segment'][0] <= 1 and t['point'][0] ==
        i['segment'][0][0] + c['on_segment'][0] * (i['segment'][1][0] - i['segment'][0][0]) and t['point'][1] ==
        i['segment'][0][1] + c['on_segment'][0] * (i['segment'][1][1] - i['segment'][0][1]) and c['normal'][0] *
        i['ray']['origin'][0] + c['normal'][1] * i['ray']['origin'][1] <= c['offset'][0] and c['normal'][0] *
        i['ray']['direction'][0] + c['normal'][1] * i['ray']['direction'][1] <= 0 and c['offset'][0] <= c['normal'][0]
        * i['segment'][0][0] + c['normal'][1] * i['segment'][0][1] and c['offset'][0] <= c['normal'][0] *
        i['segment'][1][0] + c['normal'][1] * i['segment'][1][1] and (c['normal'][0] * i['ray']['direction'][0] +
        c['normal'][1] * i['ray']['direction'][1] < 0 or not (c['normal'][0] * i['segment'][0][0] + c['normal'][1] *
        i['segment'][0][1] == c['offset'][0] and c['normal'][0] * i['segment'][1][0] + c['normal'][1] *
        i['segment'][1][1] == c['offset'][0]))
    ),
    ("ray_segment", "overlap", "overlap", None, None): lambda i, t, c: (
        not (i['ray']['direction'][0] == 0 and i['ray']['direction'][1] == 0) and t['t'] == c['on_ray'][0] and
        c['on_ray'][0] < c['on_ray'][1] and 0 <= c['on_ray'][0] and t['overlap'][0][0] == i['ray']['origin'][0] +
        c['on_ray'][0] * i['ray']['direction'][0] and t['overlap'][0][1] == i['ray']['origin'][1] + c['on_ray'][0] *
        i['ray']['direction'][1] and 0 <= c['on_ray'][1] and t['overlap'][1][0] == i['ray']['origin'][0] +
        c['on_ray'][1] * i['ray']['direction'][0] and t['overlap'][1][1] == i['ray']['origin'][1] + c['on_ray'][1] *
        i['ray']['direction'][1] and 0 <= c['on_segment'][0] and c['on_segment'][0] <= 1 and 0 <= c['on_segment'][1]
        and c['on_segment'][1] <= 1 and t['overlap'][0][0] == i['segment'][0][0] + c['on_segment'][0] *
        (i['segment'][1][0] - i['segment'][0][0]) and t['overlap'][0][1] == i['segment'][0][1] + c['on_segment'][0] *
        (i['segment'][1][1] - i['segment'][0][1]) and t['overlap'][1][0] == i['segment'][0][0] + c['on_segment'][1] *
        (i['segment'][1][0] - i['segment'][0][0]) and t['overlap'][1][1] == i['segment'][0][1] + c['on_segment'][1] *
        (i['segment'][1][1] - i['segment'][0][1]) and (c['on_ray'][0] == 0 or (c['on_segment'][0] == 0 or
        c['on_segment'][0] == 1)) and (c['on_segment'][1] == 0 or c['on_segment'][1] == 1)
    ),
}
