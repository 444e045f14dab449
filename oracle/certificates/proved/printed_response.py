# SPDX-License-Identifier: Apache-2.0
"""The formulas that Coq has proved, printed by print_python.ml: do not edit.

(operation, word of the truth, kind, dimension, axis of the certificate), None where it is asked for none, and the
condition on i, t, c: input, truth and certificate, with their numbers as fractions. A number p + q sqrt(r) is
(p, q, r).
"""

FORMULAS = {
    ("reflect_plane", "", "decomposition", None, None): lambda i, t, c: (
        not (i['normal'][0] == 0 and i['normal'][1] == 0 and i['normal'][2] == 0) and c['along'][0] + c['across'][0] ==
        i['velocity'][0] and c['along'][1] + c['across'][1] == i['velocity'][1] and c['along'][2] + c['across'][2] ==
        i['velocity'][2] and c['along'][1] * i['normal'][2] - c['along'][2] * i['normal'][1] == 0 and c['along'][2] *
        i['normal'][0] - c['along'][0] * i['normal'][2] == 0 and c['along'][0] * i['normal'][1] - c['along'][1] *
        i['normal'][0] == 0 and c['across'][0] * i['normal'][0] + c['across'][1] * i['normal'][1] + c['across'][2] *
        i['normal'][2] == 0 and t['velocity'][0] == c['across'][0] - c['along'][0] and t['velocity'][1] ==
        c['across'][1] - c['along'][1] and t['velocity'][2] == c['across'][2] - c['along'][2]
    ),
    ("damped_reflection", "", "decomposition", None, None): lambda i, t, c: (
        not (i['normal'][0] == 0 and i['normal'][1] == 0 and i['normal'][2] == 0) and c['along'][0] + c['across'][0] ==
        i['velocity'][0] and c['along'][1] + c['across'][1] == i['velocity'][1] and c['along'][2] + c['across'][2] ==
        i['velocity'][2] and c['along'][1] * i['normal'][2] - c['along'][2] * i['normal'][1] == 0 and c['along'][2] *
        i['normal'][0] - c['along'][0] * i['normal'][2] == 0 and c['along'][0] * i['normal'][1] - c['along'][1] *
        i['normal'][0] == 0 and c['across'][0] * i['normal'][0] + c['across'][1] * i['normal'][1] + c['across'][2] *
        i['normal'][2] == 0 and t['velocity'][0] == c['across'][0] - i['k'] * c['along'][0] and t['velocity'][1] ==
        c['across'][1] - i['k'] * c['along'][1] and t['velocity'][2] == c['across'][2] - i['k'] * c['along'][2]
    ),
    ("inelastic_collision", "", "momentum", None, None): lambda i, t, c: (
        0 < i['masses'][0] and 0 < i['masses'][1] and c['momentum'][0] == i['masses'][0] * i['velocities'][0][0] +
        i['masses'][1] * i['velocities'][1][0] and c['momentum'][1] == i['masses'][0] * i['velocities'][0][1] +
        i['masses'][1] * i['velocities'][1][1] and c['momentum'][2] == i['masses'][0] * i['velocities'][0][2] +
        i['masses'][1] * i['velocities'][1][2] and (i['masses'][0] + i['masses'][1]) * t['velocity'][0] ==
        c['momentum'][0] and (i['masses'][0] + i['masses'][1]) * t['velocity'][1] == c['momentum'][1] and
        (i['masses'][0] + i['masses'][1]) * t['velocity'][2] == c['momentum'][2]
    ),
    ("contact_state", "separating", "point_velocities", None, None): lambda i, t, c: (
        not (i['normal'][0] == 0 and i['normal'][1] == 0 and i['normal'][2] == 0) and c['of_a'][0] ==
        i['a']['velocity'][0] + i['a']['angular_velocity'][1] * (i['point'][2] - i['a']['position'][2]) -
        i['a']['angular_velocity'][2] * (i['point'][1] - i['a']['position'][1]) and c['of_a'][1] ==
        i['a']['velocity'][1] + i['a']['angular_velocity'][2] * (i['point'][0] - i['a']['position'][0]) -
        i['a']['angular_velocity'][0] * (i['point'][2] - i['a']['position'][2]) and c['of_a'][2] ==
        i['a']['velocity'][2] + i['a']['angular_velocity'][0] * (i['point'][1] - i['a']['position'][1]) -
        i['a']['angular_velocity'][1] * (i['point'][0] - i['a']['position'][0]) and c['of_b'][0] ==
        i['b']['velocity'][0] + i['b']['angular_velocity'][1] * (i['point'][2] - i['b']['position'][2]) -
        i['b']['angular_velocity'][2] * (i['point'][1] - i['b']['position'][1]) and c['of_b'][1] ==
        i['b']['velocity'][1] + i['b']['angular_velocity'][2] * (i['point'][0] - i['b']['position'][0]) -
        i['b']['angular_velocity'][0] * (i['point'][2] - i['b']['position'][2]) and c['of_b'][2] ==
        i['b']['velocity'][2] + i['b']['angular_velocity'][0] * (i['point'][1] - i['b']['position'][1]) -
        i['b']['angular_velocity'][1] * (i['point'][0] - i['b']['position'][0]) and 0 < i['normal'][0] * (c['of_a'][0]
        - c['of_b'][0]) + i['normal'][1] * (c['of_a'][1] - c['of_b'][1]) + i['normal'][2] * (c['of_a'][2] -
        c['of_b'][2])
    ),
    ("contact_state", "resting", "point_velocities", None, None): lambda i, t, c: (
        not (i['normal'][0] == 0 and i['normal'][1] == 0 and i['normal'][2] == 0) and c['of_a'][0] ==
        i['a']['velocity'][0] + i['a']['angular_velocity'][1] * (i['point'][2] - i['a']['position'][2]) -
        i['a']['angular_velocity'][2] * (i['point'][1] - i['a']['position'][1]) and c['of_a'][1] ==
        i['a']['velocity'][1] + i['a']['angular_velocity'][2] * (i['point'][0] - i['a']['position'][0]) -
        i['a']['angular_velocity'][0] * (i['point'][2] - i['a']['position'][2]) and c['of_a'][2] ==
        i['a']['velocity'][2] + i['a']['angular_velocity'][0] * (i['point'][1] - i['a']['position'][1]) -
        i['a']['angular_velocity'][1] * (i['point'][0] - i['a']['position'][0]) and c['of_b'][0] ==
        i['b']['velocity'][0] + i['b']['angular_velocity'][1] * (i['point'][2] - i['b']['position'][2]) -
        i['b']['angular_velocity'][2] * (i['point'][1] - i['b']['position'][1]) and c['of_b'][1] ==
        i['b']['velocity'][1] + i['b']['angular_velocity'][2] * (i['point'][0] - i['b']['position'][0]) -
        i['b']['angular_velocity'][0] * (i['point'][2] - i['b']['position'][2]) and c['of_b'][2] ==
        i['b']['velocity'][2] + i['b']['angular_velocity'][0] * (i['point'][1] - i['b']['position'][1]) -
        i['b']['angular_velocity'][1] * (i['point'][0] - i['b']['position'][0]) and i['normal'][0] * (c['of_a'][0] -
        c['of_b'][0]) + i['normal'][1] * (c['of_a'][1] - c['of_b'][1]) + i['normal'][2] * (c['of_a'][2] - c['of_b'][2])
        == 0
    ),
    ("contact_state", "colliding", "point_velocities", None, None): lambda i, t, c: (
        not (i['normal'][0] == 0 and i['normal'][1] == 0 and i['normal'][2] == 0) and c['of_a'][0] ==
        i['a']['velocity'][0] + i['a']['angular_velocity'][1] * (i['point'][2] - i['a']['position'][2]) -
        i['a']['angular_velocity'][2] * (i['point'][1] - i['a']['position'][1]) and c['of_a'][1] ==
        i['a']['velocity'][1] + i['a']['angular_velocity'][2] * (i['point'][0] - i['a']['position'][0]) -
        i['a']['angular_velocity'][0] * (i['point'][2] - i['a']['position'][2]) and c['of_a'][2] ==
        i['a']['velocity'][2] + i['a']['angular_velocity'][0] * (i['point'][1] - i['a']['position'][1]) -
        i['a']['angular_velocity'][1] * (i['point'][0] - i['a']['position'][0]) and c['of_b'][0] ==
        i['b']['velocity'][0] + i['b']['angular_velocity'][1] * (i['point'][2] - i['b']['position'][2]) -
        i['b']['angular_velocity'][2] * (i['point'][1] - i['b']['position'][1]) and c['of_b'][1] ==
        i['b']['velocity'][1] + i['b']['angular_velocity'][2] * (i['point'][0] - i['b']['position'][0]) -
        i['b']['angular_velocity'][0] * (i['point'][2] - i['b']['position'][2]) and c['of_b'][2] ==
        i['b']['velocity'][2] + i['b']['angular_velocity'][0] * (i['point'][1] - i['b']['position'][1]) -
        i['b']['angular_velocity'][1] * (i['point'][0] - i['b']['position'][0]) and i['normal'][0] * (c['of_a'][0] -
        c['of_b'][0]) + i['normal'][1] * (c['of_a'][1] - c['of_b'][1]) + i['normal'][2] * (c['of_a'][2] - c['of_b'][2])
        < 0
    ),
}
