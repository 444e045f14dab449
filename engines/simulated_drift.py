#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Scenes by float, double, robust and foreign engines side by side, as tables: docs/simulate_engines.md.

  engines/simulated_drift.py [--build DIR] [--npm DIR] [--scenes a,b | --gas] [--write]

DIR is build/release, and where `./dev engines npm` has put the packages. An engine that is not built is left out.
--gas makes the tables of exact gases instead, which are referees of the engines. --write puts the tables into
docs/simulate_engines.md, between its markers.
"""
import argparse
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/simulate_engines.md"
BEGIN, END = "<!-- made by engines/simulated_drift.py -->", "<!-- end -->"
BEGIN_GAS, END_GAS = "<!-- made by engines/simulated_drift.py --gas -->", "<!-- end of gas -->"
GASES, RATES = ["gas_of_27", "gas_in_the_plane"], [60, 240]
PROGRAMS = ["bullet", "box2d", "ode", "chipmunk"]
PACKAGES = ["planck", "matter-js", "cannon-es", "@dimforge/rapier3d-compat"]
SCENES = ["ball_in_a_box", "two_balls_in_a_box", "unequal_masses", "newtons_cradle", "billiard_break",
          "bouncing_to_rest", "domino_row", "resting_stack_passes", "ball_on_stairs", "fast_box"]
COLUMNS = ["run", "steps", "change of energy", "scheme", "decision", "rounding", "its own", "contacts", "other numbers",
           "other contacts", "apart, m"]
PARTS = ["scheme", "decision", "rounding", "own"]


def engines_in(build, npm):
    programs = [build / f"engines/simulate_{name}" for name in PROGRAMS]
    script = npm / "node_modules/touchstone-npm-engines/simulate.mjs"
    return [str(path) for path in programs if path.exists()] + [
        f"node {script} {name}" for name in PACKAGES if script.exists()]


class Run:
    """The kept data of one run of a trajectory."""

    def __init__(self, name):
        self.name, self.parts, self.contacts = name, dict.fromkeys(PARTS, Fraction(0)), 0
        self.start = self.energy = self.numbers = self.other = None
        self.steps = self.tells = 0
        self.apart, self.why = 0.0, ""

    def add(self, step, now, robust):
        self.energy = Fraction(now["energy"])
        if step == 0:
            self.start = self.energy
            return
        self.steps = step
        for part, value in now["drift"].items():
            self.parts["scheme" if part == "law" else part] += Fraction(value)
        self.contacts += len(now["contacts"])
        self.apart = max(math.dist(a[:3], b[:3]) for a, b in zip(now["bodies"], robust["bodies"]))
        if self.numbers is None and now["bodies"] != robust["bodies"]:
            self.numbers = step
        mine, right = touches(now), touches(robust)
        if self.other is None and mine != right:
            self.other = step, mine, right


def touches(now):
    return {(c["body"], "wall", c["wall"]) if "wall" in c else (c["body"], "body", c["other"]) for c in now["contacts"]}


def played(program, scene, commands):
    """The header, the runs, and what the program says of engines that ended."""
    with tempfile.NamedTemporaryFile(suffix=".jsonl") as file:
        command = [program, "simulate", scene, "--trajectory", file.name, "--timeout", "20"]
        for engine in commands:
            command += ["--engine", engine]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 3):
            sys.exit(f"{scene}: {done.stderr}")
        lines = [json.loads(line) for line in open(file.name, encoding="utf-8")]
    runs = [Run(name) for name in lines[0]["runs"]]
    for line in lines[1:]:
        for run in runs:
            if run.name in line:
                run.add(line["step"], line[run.name], line["robust"])
            run.why = line.get("ended", {}).get(run.name, run.why)
    return lines[0], runs


def name_of(header, touch):
    scene = header["scene"]
    if touch[1] == "body":
        return f"{scene['bodies'][touch[0]]['name']} and {scene['bodies'][touch[2]]['name']}"
    room = [f"room.{side}.{axis}" for axis in "xyz" for side in ("min", "max")] if "room" in scene else []
    walls = room + [wall.get("name", f"walls[{i}]") for i, wall in enumerate(scene.get("walls", []))]
    return f"{scene['bodies'][touch[0]]['name']} and {walls[touch[2]]}"


def names_of(header, touches_of):
    names = sorted(name_of(header, touch) for touch in touches_of)
    return ", ".join(names[:3] + (["..."] if len(names) > 3 else [])) or "none"


def short(value):
    value = float(value)
    return "0" if value == 0 else f"{value:.3g}"


def publish(text, begin, end, write):
    text = text.rstrip() + "\n"
    if not write:
        print(text)
        return
    page = PAGE.read_text(encoding="utf-8")
    before, after = page.split(begin)[0], page.split(end)[1]
    PAGE.write_text(f"{before}{begin}\n\n{text}\n{end}{after}", encoding="utf-8")


def row(cells):
    return "| " + " | ".join(cells) + " |"


def table(scene, header, runs):
    title = header["scene"]["title"]
    yield f"### {scene}\n\n{title}. Energy at the start: {short(runs[0].start)} J.\n"
    yield row(COLUMNS)
    yield row(["---"] * len(COLUMNS))
    for run in runs:
        if run.start is None:
            yield row([run.name, run.why] + [""] * (len(COLUMNS) - 2))
            continue
        named = ["scheme", "own"] if run.name in header.get("engines", {}) else PARTS[:3]
        parts = [short(run.parts[part]) if part in named else "" for part in PARTS]
        departed = ["", "", ""]
        if run.name != "robust":
            departed = [str(run.numbers or "never"), str(run.other[0] if run.other else "never"), short(run.apart)]
        yield row([run.name, str(run.steps), short(run.energy - run.start), *parts, str(run.contacts), *departed])
    yield ""
    for run in runs:
        if run.why and run.start is not None:
            yield f"- {run.name} ended: {run.why}."
        if run.other and run.name in header.get("engines", {}):
            step, mine, right = run.other
            yield (f"- {run.name}, step {step}: it answers {names_of(header, mine)}; robust answers "
                   f"{names_of(header, right)}.")
    yield ""


def refereed(program, scene, commands):
    """Returns what the program says of each engine beside a gas: its name, and where it parts."""
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(scene, file)
        file.flush()
        command = [program, "simulate", file.name, "--timeout", "120"]
        for engine in commands:
            command += ["--engine", engine]
        done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 3):
        sys.exit(f"{scene['title']}: {done.stderr}")
    return [line.split(": ", 1) for line in done.stdout.splitlines()[-len(commands):]]


def gas_tables(program, commands):
    for name in GASES:
        scene = json.loads((ROOT / f"simulate/scenes/{name}.json").read_text(encoding="utf-8"))
        said = []
        for rate in RATES:
            scene["gas"]["steps_per_second"] = rate
            said.append(refereed(program, scene, commands))
        hits = next(re.search(r"(?:of|all) (\d+)", text)[1] for _, text in said[0] if "hit" in text)
        yield f"### {name}\n\n{scene['title']}: {hits} hits.\n"
        yield row(["engine"] + [f"parts at hit, {rate} steps a second" for rate in RATES])
        yield row(["---"] * (len(RATES) + 1))
        for engine in zip(*said):
            numbers = [re.search(r"parts at hit (\d+)", text) for _, text in engine]
            yield row([engine[0][0]] + [number[1] if number else "none" if "all" in text else text
                                        for number, (_, text) in zip(numbers, engine)])
        yield ""
        yield from (f"- {engine}: {text}." for engine, text in said[0] if "parts" in text)
        yield ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--npm", type=pathlib.Path, default=ROOT / "build/npm")
    parser.add_argument("--scenes", default=",".join(SCENES))
    parser.add_argument("--gas", action="store_true")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    commands = engines_in(options.build.resolve(), options.npm.resolve())
    if options.gas:
        publish("\n".join(gas_tables(str(options.build / "touchstone"), commands)), BEGIN_GAS, END_GAS, options.write)
        return
    lines, thresholds = [], {}
    for scene in options.scenes.split(","):
        header, runs = played(str(options.build / "touchstone"), str(ROOT / f"simulate/scenes/{scene}.json"), commands)
        thresholds.update(header.get("engines", {}))
        lines += table(scene, header, runs)
    head = ["| engine | numbers | thresholds that remain |", "|---|---|---|"]
    for name, one in thresholds.items():
        head.append(row([name, one["number"], "; ".join(one["thresholds"]) or "none declared"]))
    publish("\n".join([*head, "", *lines]), BEGIN, END, options.write)


if __name__ == "__main__":
    main()
