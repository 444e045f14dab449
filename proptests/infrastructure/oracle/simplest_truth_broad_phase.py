# SPDX-License-Identifier: Apache-2.0
"""The second truth of the broad phase, as simplest_truth.py has that of other chapters: each pair by its difference, which is a
ball or a box and holds the origin if the two meet."""
from simplest_truth_reading import dot, minus, number, point


def lack_of_balls(a, b):
    """What the squared radii's sum lacks to the squared distance."""
    between = minus(point(b["center"]), point(a["center"]))
    return dot(between, between) - (number(a["radius"]) + number(b["radius"])) ** 2


def lack_of_boxes(a, b):
    """How far the difference of the two is from holding the origin, along the axes; below 0: how deep it does."""
    low, high = minus(point(a["min"]), point(b["max"])), minus(point(a["max"]), point(b["min"]))
    return max(*low, *(-x for x in high))


def truth_all_pairs(q):
    solids, lack = (q["spheres"], lack_of_balls) if "spheres" in q else (q["boxes"], lack_of_boxes)
    lacks = {(i, j): lack(solids[i], solids[j]) for j in range(len(solids)) for i in range(j)}
    pairs = sorted([i, j] for (i, j), lacking in lacks.items() if lacking <= 0)
    size = abs if "spheres" in q else lambda lacking: lacking * lacking
    return {"pairs": pairs}, min(map(size, lacks.values()), default=None)


def truth_broad_phase(q):
    bodies, replies, margins = dict(enumerate(q["boxes"])), [], []
    count = len(bodies)
    for command in q["commands"]:
        if "insert" in command:
            bodies[count] = command["insert"]
            count += 1
        elif "move" in command:
            bodies[command["move"]] = command["box"]
        elif "remove" in command:
            del bodies[command["remove"]]
        else:
            names = sorted(bodies)
            reply, margin = truth_all_pairs({"boxes": [bodies[name] for name in names]})
            replies.append({"pairs": [[names[i], names[j]] for i, j in reply["pairs"]]})
            margins += [] if margin is None else [margin]
    return {"replies": replies}, min(margins, default=None)
