# SPDX-License-Identifier: Apache-2.0
"""The formulas that Coq has proved, printed by print_python.ml: do not edit.

(operation, word of the truth, kind, dimension, axis of the certificate), None where it is asked for none, and the
condition on i, t, c: input, truth and certificate, with their numbers as fractions. A number p + q sqrt(r) is
(p, q, r).
"""

FORMULAS = {
    ("swept_sphere_sphere", "hit", "start", 2, None): lambda i, t, c: (
        False and False and False and False and 0 <= i['a']['radius'] and 0 <= i['b']['radius'] and c['polynomial'][0]
        == (i['a']['center'][0] - i['b']['center'][0]) * (i['a']['center'][0] - i['b']['center'][0]) +
        (i['a']['center'][1] - i['b']['center'][1]) * (i['a']['center'][1] - i['b']['center'][1]) - (i['a']['radius'] +
        i['b']['radius']) * (i['a']['radius'] + i['b']['radius']) and c['polynomial'][1] == 2 * ((i['a']['center'][0] -
        i['b']['center'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['a']['center'][1] - i['b']['center'][1])
        * (i['velocity_a'][1] - i['velocity_b'][1])) and c['polynomial'][2] == (i['velocity_a'][0] -
        i['velocity_b'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['velocity_a'][1] - i['velocity_b'][1]) *
        (i['velocity_a'][1] - i['velocity_b'][1]) and c['polynomial'][0] <= 0 and 0 <= t['t'][2] and ((t['t'][0] <= 0
        and (t['t'][1] <= 0 or t['t'][1] * t['t'][1] * t['t'][2] <= t['t'][0] * t['t'][0])) or (t['t'][1] <= 0 and
        t['t'][0] * t['t'][0] <= t['t'][1] * t['t'][1] * t['t'][2])) and ((0 - t['t'][0] <= 0 and (0 - t['t'][1] <= 0
        or (0 - t['t'][1]) * (0 - t['t'][1]) * t['t'][2] <= (0 - t['t'][0]) * (0 - t['t'][0]))) or (0 - t['t'][1] <= 0
        and (0 - t['t'][0]) * (0 - t['t'][0]) <= (0 - t['t'][1]) * (0 - t['t'][1]) * t['t'][2]))
    ),
    ("swept_sphere_sphere", "hit", "start", 3, None): lambda i, t, c: (
        0 <= i['a']['radius'] and 0 <= i['b']['radius'] and c['polynomial'][0] == (i['a']['center'][0] -
        i['b']['center'][0]) * (i['a']['center'][0] - i['b']['center'][0]) + (i['a']['center'][1] -
        i['b']['center'][1]) * (i['a']['center'][1] - i['b']['center'][1]) + (i['a']['center'][2] -
        i['b']['center'][2]) * (i['a']['center'][2] - i['b']['center'][2]) - (i['a']['radius'] + i['b']['radius']) *
        (i['a']['radius'] + i['b']['radius']) and c['polynomial'][1] == 2 * ((i['a']['center'][0] -
        i['b']['center'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['a']['center'][1] - i['b']['center'][1])
        * (i['velocity_a'][1] - i['velocity_b'][1]) + (i['a']['center'][2] - i['b']['center'][2]) * (i['velocity_a'][2]
        - i['velocity_b'][2])) and c['polynomial'][2] == (i['velocity_a'][0] - i['velocity_b'][0]) *
        (i['velocity_a'][0] - i['velocity_b'][0]) + (i['velocity_a'][1] - i['velocity_b'][1]) * (i['velocity_a'][1] -
        i['velocity_b'][1]) + (i['velocity_a'][2] - i['velocity_b'][2]) * (i['velocity_a'][2] - i['velocity_b'][2]) and
        c['polynomial'][0] <= 0 and 0 <= t['t'][2] and ((t['t'][0] <= 0 and (t['t'][1] <= 0 or t['t'][1] * t['t'][1] *
        t['t'][2] <= t['t'][0] * t['t'][0])) or (t['t'][1] <= 0 and t['t'][0] * t['t'][0] <= t['t'][1] * t['t'][1] *
        t['t'][2])) and ((0 - t['t'][0] <= 0 and (0 - t['t'][1] <= 0 or (0 - t['t'][1]) * (0 - t['t'][1]) * t['t'][2]
        <= (0 - t['t'][0]) * (0 - t['t'][0]))) or (0 - t['t'][1] <= 0 and (0 - t['t'][0]) * (0 - t['t'][0]) <= (0 -
        t['t'][1]) * (0 - t['t'][1]) * t['t'][2]))
    ),
    ("swept_sphere_sphere", "hit", "first_root", 2, None): lambda i, t, c: (
        False and False and False and False and 0 <= i['a']['radius'] and 0 <= i['b']['radius'] and c['polynomial'][0]
        == (i['a']['center'][0] - i['b']['center'][0]) * (i['a']['center'][0] - i['b']['center'][0]) +
        (i['a']['center'][1] - i['b']['center'][1]) * (i['a']['center'][1] - i['b']['center'][1]) - (i['a']['radius'] +
        i['b']['radius']) * (i['a']['radius'] + i['b']['radius']) and c['polynomial'][1] == 2 * ((i['a']['center'][0] -
        i['b']['center'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['a']['center'][1] - i['b']['center'][1])
        * (i['velocity_a'][1] - i['velocity_b'][1])) and c['polynomial'][2] == (i['velocity_a'][0] -
        i['velocity_b'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['velocity_a'][1] - i['velocity_b'][1]) *
        (i['velocity_a'][1] - i['velocity_b'][1]) and 0 < c['polynomial'][0] and 0 <= t['t'][2] and not (((t['t'][0] <=
        0 and (t['t'][1] <= 0 or t['t'][1] * t['t'][1] * t['t'][2] <= t['t'][0] * t['t'][0])) or (t['t'][1] <= 0 and
        t['t'][0] * t['t'][0] <= t['t'][1] * t['t'][1] * t['t'][2]))) and ((t['t'][0] - 1 <= 0 and (t['t'][1] <= 0 or
        t['t'][1] * t['t'][1] * t['t'][2] <= (t['t'][0] - 1) * (t['t'][0] - 1))) or (t['t'][1] <= 0 and (t['t'][0] - 1)
        * (t['t'][0] - 1) <= t['t'][1] * t['t'][1] * t['t'][2])) and ((c['polynomial'][0] + c['polynomial'][1] *
        t['t'][0] + c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1] * t['t'][1] * t['t'][2]) <= 0 and
        (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1] <= 0 or (c['polynomial'][1] *
        t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1]) * (c['polynomial'][1] * t['t'][1] + 2 *
        c['polynomial'][2] * t['t'][0] * t['t'][1]) * t['t'][2] <= (c['polynomial'][0] + c['polynomial'][1] * t['t'][0]
        + c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1] * t['t'][1] * t['t'][2])) * (c['polynomial'][0] +
        c['polynomial'][1] * t['t'][0] + c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1] * t['t'][1] *
        t['t'][2])))) or (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1] <= 0 and
        (c['polynomial'][0] + c['polynomial'][1] * t['t'][0] + c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1]
        * t['t'][1] * t['t'][2])) * (c['polynomial'][0] + c['polynomial'][1] * t['t'][0] + c['polynomial'][2] *
        (t['t'][0] * t['t'][0] + t['t'][1] * t['t'][1] * t['t'][2])) <= (c['polynomial'][1] * t['t'][1] + 2 *
        c['polynomial'][2] * t['t'][0] * t['t'][1]) * (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] *
        t['t'][0] * t['t'][1]) * t['t'][2])) and ((0 - (c['polynomial'][0] + c['polynomial'][1] * t['t'][0] +
        c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1] * t['t'][1] * t['t'][2])) <= 0 and (0 -
        (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1]) <= 0 or (0 -
        (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1])) * (0 - (c['polynomial'][1] *
        t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1])) * t['t'][2] <= (0 - (c['polynomial'][0] +
        c['polynomial'][1] * t['t'][0] + c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1] * t['t'][1] *
        t['t'][2]))) * (0 - (c['polynomial'][0] + c['polynomial'][1] * t['t'][0] + c['polynomial'][2] * (t['t'][0] *
        t['t'][0] + t['t'][1] * t['t'][1] * t['t'][2]))))) or (0 - (c['polynomial'][1] * t['t'][1] + 2 *
        c['polynomial'][2] * t['t'][0] * t['t'][1]) <= 0 and (0 - (c['polynomial'][0] + c['polynomial'][1] * t['t'][0]
        + c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1] * t['t'][1] * t['t'][2]))) * (0 - (c['polynomial'][0]
        + c['polynomial'][1] * t['t'][0] + c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1] * t['t'][1] *
        t['t'][2]))) <= (0 - (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1])) * (0 -
        (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1])) * t['t'][2])) and
        ((c['polynomial'][1] + 2 * c['polynomial'][2] * t['t'][0] <= 0 and (2 * c['polynomial'][2] * t['t'][1] <= 0 or
        2 * c['polynomial'][2] * t['t'][1] * (2 * c['polynomial'][2] * t['t'][1]) * t['t'][2] <= (c['polynomial'][1] +
        2 * c['polynomial'][2] * t['t'][0]) * (c['polynomial'][1] + 2 * c['polynomial'][2] * t['t'][0]))) or (2 *
        c['polynomial'][2] * t['t'][1] <= 0 and (c['polynomial'][1] + 2 * c['polynomial'][2] * t['t'][0]) *
        (c['polynomial'][1] + 2 * c['polynomial'][2] * t['t'][0]) <= 2 * c['polynomial'][2] * t['t'][1] * (2 *
        c['polynomial'][2] * t['t'][1]) * t['t'][2]))
    ),
    ("swept_sphere_sphere", "hit", "first_root", 3, None): lambda i, t, c: (
        0 <= i['a']['radius'] and 0 <= i['b']['radius'] and c['polynomial'][0] == (i['a']['center'][0] -
        i['b']['center'][0]) * (i['a']['center'][0] - i['b']['center'][0]) + (i['a']['center'][1] -
        i['b']['center'][1]) * (i['a']['center'][1] - i['b']['center'][1]) + (i['a']['center'][2] -
        i['b']['center'][2]) * (i['a']['center'][2] - i['b']['center'][2]) - (i['a']['radius'] + i['b']['radius']) *
        (i['a']['radius'] + i['b']['radius']) and c['polynomial'][1] == 2 * ((i['a']['center'][0] -
        i['b']['center'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['a']['center'][1] - i['b']['center'][1])
        * (i['velocity_a'][1] - i['velocity_b'][1]) + (i['a']['center'][2] - i['b']['center'][2]) * (i['velocity_a'][2]
        - i['velocity_b'][2])) and c['polynomial'][2] == (i['velocity_a'][0] - i['velocity_b'][0]) *
        (i['velocity_a'][0] - i['velocity_b'][0]) + (i['velocity_a'][1] - i['velocity_b'][1]) * (i['velocity_a'][1] -
        i['velocity_b'][1]) + (i['velocity_a'][2] - i['velocity_b'][2]) * (i['velocity_a'][2] - i['velocity_b'][2]) and
        0 < c['polynomial'][0] and 0 <= t['t'][2] and not (((t['t'][0] <= 0 and (t['t'][1] <= 0 or t['t'][1] *
        t['t'][1] * t['t'][2] <= t['t'][0] * t['t'][0])) or (t['t'][1] <= 0 and t['t'][0] * t['t'][0] <= t['t'][1] *
        t['t'][1] * t['t'][2]))) and ((t['t'][0] - 1 <= 0 and (t['t'][1] <= 0 or t['t'][1] * t['t'][1] * t['t'][2] <=
        (t['t'][0] - 1) * (t['t'][0] - 1))) or (t['t'][1] <= 0 and (t['t'][0] - 1) * (t['t'][0] - 1) <= t['t'][1] *
        t['t'][1] * t['t'][2])) and ((c['polynomial'][0] + c['polynomial'][1] * t['t'][0] + c['polynomial'][2] *
        (t['t'][0] * t['t'][0] + t['t'][1] * t['t'][1] * t['t'][2]) <= 0 and (c['polynomial'][1] * t['t'][1] + 2 *
        c['polynomial'][2] * t['t'][0] * t['t'][1] <= 0 or (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] *
        t['t'][0] * t['t'][1]) * (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1]) *
        t['t'][2] <= (c['polynomial'][0] + c['polynomial'][1] * t['t'][0] + c['polynomial'][2] * (t['t'][0] * t['t'][0]
        + t['t'][1] * t['t'][1] * t['t'][2])) * (c['polynomial'][0] + c['polynomial'][1] * t['t'][0] +
        c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1] * t['t'][1] * t['t'][2])))) or (c['polynomial'][1] *
        t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1] <= 0 and (c['polynomial'][0] + c['polynomial'][1] *
        t['t'][0] + c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1] * t['t'][1] * t['t'][2])) *
        (c['polynomial'][0] + c['polynomial'][1] * t['t'][0] + c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1]
        * t['t'][1] * t['t'][2])) <= (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1])
        * (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1]) * t['t'][2])) and ((0 -
        (c['polynomial'][0] + c['polynomial'][1] * t['t'][0] + c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1]
        * t['t'][1] * t['t'][2])) <= 0 and (0 - (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] *
        t['t'][1]) <= 0 or (0 - (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1])) * (0
        - (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1])) * t['t'][2] <= (0 -
        (c['polynomial'][0] + c['polynomial'][1] * t['t'][0] + c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1]
        * t['t'][1] * t['t'][2]))) * (0 - (c['polynomial'][0] + c['polynomial'][1] * t['t'][0] + c['polynomial'][2] *
        (t['t'][0] * t['t'][0] + t['t'][1] * t['t'][1] * t['t'][2]))))) or (0 - (c['polynomial'][1] * t['t'][1] + 2 *
        c['polynomial'][2] * t['t'][0] * t['t'][1]) <= 0 and (0 - (c['polynomial'][0] + c['polynomial'][1] * t['t'][0]
        + c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1] * t['t'][1] * t['t'][2]))) * (0 - (c['polynomial'][0]
        + c['polynomial'][1] * t['t'][0] + c['polynomial'][2] * (t['t'][0] * t['t'][0] + t['t'][1] * t['t'][1] *
        t['t'][2]))) <= (0 - (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1])) * (0 -
        (c['polynomial'][1] * t['t'][1] + 2 * c['polynomial'][2] * t['t'][0] * t['t'][1])) * t['t'][2])) and
        ((c['polynomial'][1] + 2 * c['polynomial'][2] * t['t'][0] <= 0 and (2 * c['polynomial'][2] * t['t'][1] <= 0 or
        2 * c['polynomial'][2] * t['t'][1] * (2 * c['polynomial'][2] * t['t'][1]) * t['t'][2] <= (c['polynomial'][1] +
        2 * c['polynomial'][2] * t['t'][0]) * (c['polynomial'][1] + 2 * c['polynomial'][2] * t['t'][0]))) or (2 *
        c['polynomial'][2] * t['t'][1] <= 0 and (c['polynomial'][1] + 2 * c['polynomial'][2] * t['t'][0]) *
        (c['polynomial'][1] + 2 * c['polynomial'][2] * t['t'][0]) <= 2 * c['polynomial'][2] * t['t'][1] * (2 *
        c['polynomial'][2] * t['t'][1]) * t['t'][2]))
    ),
    ("swept_sphere_sphere", "never", "receding", 2, None): lambda i, t, c: (
        False and False and False and False and 0 <= i['a']['radius'] and 0 <= i['b']['radius'] and c['polynomial'][0]
        == (i['a']['center'][0] - i['b']['center'][0]) * (i['a']['center'][0] - i['b']['center'][0]) +
        (i['a']['center'][1] - i['b']['center'][1]) * (i['a']['center'][1] - i['b']['center'][1]) - (i['a']['radius'] +
        i['b']['radius']) * (i['a']['radius'] + i['b']['radius']) and c['polynomial'][1] == 2 * ((i['a']['center'][0] -
        i['b']['center'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['a']['center'][1] - i['b']['center'][1])
        * (i['velocity_a'][1] - i['velocity_b'][1])) and c['polynomial'][2] == (i['velocity_a'][0] -
        i['velocity_b'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['velocity_a'][1] - i['velocity_b'][1]) *
        (i['velocity_a'][1] - i['velocity_b'][1]) and 0 < c['polynomial'][0] and 0 <= c['polynomial'][1]
    ),
    ("swept_sphere_sphere", "never", "receding", 3, None): lambda i, t, c: (
        0 <= i['a']['radius'] and 0 <= i['b']['radius'] and c['polynomial'][0] == (i['a']['center'][0] -
        i['b']['center'][0]) * (i['a']['center'][0] - i['b']['center'][0]) + (i['a']['center'][1] -
        i['b']['center'][1]) * (i['a']['center'][1] - i['b']['center'][1]) + (i['a']['center'][2] -
        i['b']['center'][2]) * (i['a']['center'][2] - i['b']['center'][2]) - (i['a']['radius'] + i['b']['radius']) *
        (i['a']['radius'] + i['b']['radius']) and c['polynomial'][1] == 2 * ((i['a']['center'][0] -
        i['b']['center'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['a']['center'][1] - i['b']['center'][1])
        * (i['velocity_a'][1] - i['velocity_b'][1]) + (i['a']['center'][2] - i['b']['center'][2]) * (i['velocity_a'][2]
        - i['velocity_b'][2])) and c['polynomial'][2] == (i['velocity_a'][0] - i['velocity_b'][0]) *
        (i['velocity_a'][0] - i['velocity_b'][0]) + (i['velocity_a'][1] - i['velocity_b'][1]) * (i['velocity_a'][1] -
        i['velocity_b'][1]) + (i['velocity_a'][2] - i['velocity_b'][2]) * (i['velocity_a'][2] - i['velocity_b'][2]) and
        0 < c['polynomial'][0] and 0 <= c['polynomial'][1]
    ),
    ("swept_sphere_sphere", "never", "too_late", 2, None): lambda i, t, c: (
        False and False and False and False and 0 <= i['a']['radius'] and 0 <= i['b']['radius'] and c['polynomial'][0]
        == (i['a']['center'][0] - i['b']['center'][0]) * (i['a']['center'][0] - i['b']['center'][0]) +
        (i['a']['center'][1] - i['b']['center'][1]) * (i['a']['center'][1] - i['b']['center'][1]) - (i['a']['radius'] +
        i['b']['radius']) * (i['a']['radius'] + i['b']['radius']) and c['polynomial'][1] == 2 * ((i['a']['center'][0] -
        i['b']['center'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['a']['center'][1] - i['b']['center'][1])
        * (i['velocity_a'][1] - i['velocity_b'][1])) and c['polynomial'][2] == (i['velocity_a'][0] -
        i['velocity_b'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['velocity_a'][1] - i['velocity_b'][1]) *
        (i['velocity_a'][1] - i['velocity_b'][1]) and 0 < c['polynomial'][0] and 0 < c['polynomial'][0] +
        c['polynomial'][1] + c['polynomial'][2] and 2 * c['polynomial'][2] + c['polynomial'][1] <= 0
    ),
    ("swept_sphere_sphere", "never", "too_late", 3, None): lambda i, t, c: (
        0 <= i['a']['radius'] and 0 <= i['b']['radius'] and c['polynomial'][0] == (i['a']['center'][0] -
        i['b']['center'][0]) * (i['a']['center'][0] - i['b']['center'][0]) + (i['a']['center'][1] -
        i['b']['center'][1]) * (i['a']['center'][1] - i['b']['center'][1]) + (i['a']['center'][2] -
        i['b']['center'][2]) * (i['a']['center'][2] - i['b']['center'][2]) - (i['a']['radius'] + i['b']['radius']) *
        (i['a']['radius'] + i['b']['radius']) and c['polynomial'][1] == 2 * ((i['a']['center'][0] -
        i['b']['center'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['a']['center'][1] - i['b']['center'][1])
        * (i['velocity_a'][1] - i['velocity_b'][1]) + (i['a']['center'][2] - i['b']['center'][2]) * (i['velocity_a'][2]
        - i['velocity_b'][2])) and c['polynomial'][2] == (i['velocity_a'][0] - i['velocity_b'][0]) *
        (i['velocity_a'][0] - i['velocity_b'][0]) + (i['velocity_a'][1] - i['velocity_b'][1]) * (i['velocity_a'][1] -
        i['velocity_b'][1]) + (i['velocity_a'][2] - i['velocity_b'][2]) * (i['velocity_a'][2] - i['velocity_b'][2]) and
        0 < c['polynomial'][0] and 0 < c['polynomial'][0] + c['polynomial'][1] + c['polynomial'][2] and 2 *
        c['polynomial'][2] + c['polynomial'][1] <= 0
    ),
    ("swept_sphere_sphere", "never", "no_root", 2, None): lambda i, t, c: (
        False and False and False and False and 0 <= i['a']['radius'] and 0 <= i['b']['radius'] and c['polynomial'][0]
        == (i['a']['center'][0] - i['b']['center'][0]) * (i['a']['center'][0] - i['b']['center'][0]) +
        (i['a']['center'][1] - i['b']['center'][1]) * (i['a']['center'][1] - i['b']['center'][1]) - (i['a']['radius'] +
        i['b']['radius']) * (i['a']['radius'] + i['b']['radius']) and c['polynomial'][1] == 2 * ((i['a']['center'][0] -
        i['b']['center'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['a']['center'][1] - i['b']['center'][1])
        * (i['velocity_a'][1] - i['velocity_b'][1])) and c['polynomial'][2] == (i['velocity_a'][0] -
        i['velocity_b'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['velocity_a'][1] - i['velocity_b'][1]) *
        (i['velocity_a'][1] - i['velocity_b'][1]) and 0 < c['polynomial'][0] and c['polynomial'][1] *
        c['polynomial'][1] < 4 * c['polynomial'][2] * c['polynomial'][0]
    ),
    ("swept_sphere_sphere", "never", "no_root", 3, None): lambda i, t, c: (
        0 <= i['a']['radius'] and 0 <= i['b']['radius'] and c['polynomial'][0] == (i['a']['center'][0] -
        i['b']['center'][0]) * (i['a']['center'][0] - i['b']['center'][0]) + (i['a']['center'][1] -
        i['b']['center'][1]) * (i['a']['center'][1] - i['b']['center'][1]) + (i['a']['center'][2] -
        i['b']['center'][2]) * (i['a']['center'][2] - i['b']['center'][2]) - (i['a']['radius'] + i['b']['radius']) *
        (i['a']['radius'] + i['b']['radius']) and c['polynomial'][1] == 2 * ((i['a']['center'][0] -
        i['b']['center'][0]) * (i['velocity_a'][0] - i['velocity_b'][0]) + (i['a']['center'][1] - i['b']['center'][1])
        * (i['velocity_a'][1] - i['velocity_b'][1]) + (i['a']['center'][2] - i['b']['center'][2]) * (i['velocity_a'][2]
        - i['velocity_b'][2])) and c['polynomial'][2] == (i['velocity_a'][0] - i['velocity_b'][0]) *
        (i['velocity_a'][0] - i['velocity_b'][0]) + (i['velocity_a'][1] - i['velocity_b'][1]) * (i['velocity_a'][1] -
        i['velocity_b'][1]) + (i['velocity_a'][2] - i['velocity_b'][2]) * (i['velocity_a'][2] - i['velocity_b'][2]) and
        0 < c['polynomial'][0] and c['polynomial'][1] * c['polynomial'][1] < 4 * c['polynomial'][2] *
        c['polynomial'][0]
    ),
}
