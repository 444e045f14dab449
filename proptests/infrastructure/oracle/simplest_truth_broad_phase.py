# SPDX-License-Identifier: Apache-2.0
"""The second truth of the broad phase, as simplest_truth.py has that of other chapters: each pair by its difference, which is a
ball or a box and holds the origin if the two meet."""
from simplest_truth_reading import dot, minus, number, point


def lack_of_balls(a, b):
    """Returns the squared distance less the square of the radii's sum."""
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


def lines(ray, box):
    """How far origin + t direction is beyond each face: (height, slope), height + slope t."""
    origin, direction = point(ray["origin"]), point(ray["direction"])
    low, high = point(box["min"]), point(box["max"])
    return [(least - o, -d) for least, o, d in zip(low, origin, direction)] + [
        (o - most, d) for most, o, d in zip(high, origin, direction)]


def on_ray(ray, box):
    """Returns how much the ray lacks to meet the box, the least over t >= 0 of how far it is beyond a face; and when it enters. The
    least is at the start or where two faces are equally far, the entry where one is on a face."""
    faces = lines(ray, box)
    beyond = lambda t: max(height + slope * t for height, slope in faces)
    level = [(g - h) / (s - r) for h, s in faces for g, r in faces if s != r]
    lack = min(map(beyond, [0, *(t for t in level if t > 0)]))
    entry = None if lack > 0 else min(t for t in (-h / s for h, s in faces if s) if beyond(t) <= 0)
    return lack, entry


def reply_along_ray(ray, bodies):
    margins, entries = [], {}
    for name, box in bodies.items():
        lack, entry = on_ray(ray, box)
        margins.append(lack**2)
        if lack <= 0:
            entries[name] = entry
    order = sorted(entries, key=lambda name: (max(entries[name], 0), name))
    unit = max(map(abs, point(ray["direction"])))
    for one, other in zip(order, order[1:]):
        lead = entries[other] - max(entries[one], 0) if entries[other] > 0 else -entries[one]
        margins.append((unit * lead) ** 2)
    return {"in_order": order}, min(margins, default=None)


def reply_in_box(box, bodies):
    lacks = {name: lack_of_boxes(box, body) for name, body in bodies.items()}
    met = sorted(name for name, lack in lacks.items() if lack <= 0)
    return {"bodies": met}, min((lack**2 for lack in lacks.values()), default=None)


def reply_of_pairs(bodies):
    names = sorted(bodies)
    reply, margin = truth_all_pairs({"boxes": [bodies[name] for name in names]})
    return {"pairs": [[names[i], names[j]] for i, j in reply["pairs"]]}, margin


def truth_broad_phase(q):
    bodies, replies = dict(enumerate(q["boxes"])), []
    count = len(bodies)
    for command in q["commands"]:
        if "insert" in command:
            bodies[count] = command["insert"]
            count += 1
        elif "move" in command:
            bodies[command["move"]] = command["box"]
        elif "remove" in command:
            del bodies[command["remove"]]
        elif "in_box" in command:
            replies.append(reply_in_box(command["in_box"], bodies))
        elif "at_point" in command:
            replies.append(reply_in_box({"min": command["at_point"], "max": command["at_point"]}, bodies))
        elif "along_ray" in command:
            replies.append(reply_along_ray(command["along_ray"], bodies))
        else:
            replies.append(reply_of_pairs(bodies))
    margins = [margin for _, margin in replies if margin is not None]
    return {"replies": [reply for reply, _ in replies]}, min(margins, default=None)
