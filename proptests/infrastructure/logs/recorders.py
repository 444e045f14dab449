#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The recorders for C, Python and JavaScript: what they write is what the program reads.

  recorders.py --program PATH [--cc COMMAND] [--cxx COMMAND]
"""
import argparse
import importlib.util
import json
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parents[3]
WARNINGS = "-pedantic -Wall -Wextra -Wconversion -Werror -O1 -pthread".split()
IN_NODE = """
import { Recording, toFile } from "RECORDER";
const recording = new Recording(await toFile(process.argv[2]), { engine: "node \\u00e9", boundary: "closed", oneIn: 10, first: 3, near: 0.5 });
const meets = recording.recorded("segment_segment", ["a", "b"], (a, b) => {
  if (b[0][0] === 7) throw new Error("seven");
  if (b[0][0] % 100 === 99) recording.nearness(0.25);
  return b[0][0] < 2;
});
for (let i = 0; i < 1000; ++i) {
  try { meets([[0, -0], [2, 0]], [new Float64Array([i, -1]), [0.1, NaN]]); } catch (error) { if (i !== 7) throw error; }
}
// A BigInt has no JSON: the call is lost, and nothing is thrown.
const kept = [], other = new Recording((text) => kept.push(text), {});
other.recorded("segment_segment", ["a", "b"], () => true)(5n, [[0, 0], [1, 1]]);
other.close();
if (!kept.at(-1).includes('"lost":1')) throw new Error(kept.at(-1));
if (process.argv[3] !== "cut") recording.close();
"""


def loaded():
    spec = importlib.util.spec_from_file_location("record", ROOT / "python/touchstone/record.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Failed(Exception):
    pass


def require(right, what):
    if not right:
        raise Failed(what)


class Logs:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def read(self, file):
        """Header, calls and end mark as the program converts them, and what it says of the log."""
        form = file.with_suffix(".read")
        told = subprocess.run([self.program, "log", "convert", file, form, "--to", "json"], capture_output=True, text=True)
        require(told.returncode == 0, f"{file.name}: exit code {told.returncode}: {told.stderr}")
        lines = [json.loads(line) for line in form.read_text(encoding="ascii").splitlines()]
        end = lines.pop()["end"] if "end" in lines[-1] else None
        return lines[0], lines[1:], end, told.stderr


def in_c(logs, commands):
    for compiler in commands:
        program, log = logs.folder / "game", logs.folder / "game.log"
        subprocess.run([*compiler.split(), *WARNINGS, "-I", ROOT / "c", ROOT / "examples/record/game.c", "-o", program], check=True)
        subprocess.run([program, log], check=True)
        header, calls, end, told = logs.read(log)
        require(header["engine"] == "game 1.0" and header["boundary"] == "closed" and not told, f"{compiler}: {header} {told}")
        require(end == {"seen": 20000, "written": 20000, "sampled_out": 0, "lost": 0} and len(calls) == 20000, f"{compiler}: {end}")
        own = [call for call in calls if call["input"]["a"][0] == [0, 1]]
        require(len(own) == 10 and own[3]["input"] == {"a": [[0, 1], [0.05, 1]], "b": [[3, 0], [3.5, 0]]}, f"{compiler}: {own[3:4]}")
        # Segments on one line: the game says that all of them meet.
        require(sum(call["answer"] for call in calls if call["input"]["a"][0][1] == 0) == 10000, "answers")


def in_cpp(logs, compiler):
    """The example of bugs: its own tests pass, and what it records is in float."""
    program, log = logs.folder / "arena", logs.folder / "arena.log"
    subprocess.run([compiler, *WARNINGS[:3], "-Werror", "-std=c++20", "-pthread", "-I", ROOT, "-I", ROOT / "c",
                    ROOT / "examples/record/arena.cpp", "-o", program], check=True)
    subprocess.run([program, "--test"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([program, log, "1"], check=True, stdout=subprocess.DEVNULL)
    _, calls, end, told = logs.read(log)
    require(not told and end["seen"] == len(calls) > 10000, f"{end} {told}")
    require({call["number"] for call in calls} == {"binary32"}, "the game is in float")
    require({call["op"] for call in calls} == {"segment_aabb", "segment_segment", "sphere_aabb", "sphere_sphere"}, "operations")


def in_python(logs):
    record = loaded()
    log = logs.folder / "python.jsonl"

    @record.recorded("segment_segment")
    def meets(a, b):
        if b[0][0] == 7:
            raise ArithmeticError("seven")
        return None if b[0][0] == 8 else {"relation": "disjoint"} if b[0][0] == 9 else bool(b[0][0] < 2)

    def call(x):
        try:
            return meets([[0, -0.0], [2, 0]], b=((x, -1), (0.1, float("nan"))))
        except ArithmeticError:
            return None

    require(call(1) is True, "what is recorded is not what is answered")
    with record.Recording(str(log), engine="python \u00e9", tolerance=0.5):
        threads = [threading.Thread(target=lambda t=t: [call(1000 * t + i) for i in range(1000)]) for t in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    call(1)
    header, calls, end, told = logs.read(log)
    require(header["engine"] == "python \u00e9" and header["tolerance"] == 0.5 and not told, f"{header} {told}")
    require(end == {"seen": 3999, "written": 3999, "sampled_out": 0, "lost": 0}, f"{end}")
    of = {call["input"]["b"][0][0]: call for call in calls}
    require(len(of) == len(calls) == 3999 and 8 not in of and of[7]["error"] == "seven", "calls")
    require(of[1]["answer"] is True and of[9]["answer"] == {"relation": "disjoint"}, "answers")
    require(of[1]["input"] == {"a": [[0, -0.0], [2, 0]], "b": [[1, -1], [0.1, "nan"]]}, f"{of[1]}")
    require(of[1]["site"].endswith("recorders.py:" + str(meets.__wrapped__.__code__.co_firstlineno)), of[1]["site"])

    with record.Recording(str(log), one_in=10, first=3, near=0.5):
        for i in range(10000):
            record.nearness(0.25 if i % 1000 == 999 else 2)
            call(i + 10)
    _, calls, end, _ = logs.read(log)
    written = {call["input"]["b"][0][0] for call in calls}
    require({10, 11, 12, *range(1009, 10010, 1000)} <= written, "the first and the near ones are written")
    # As in recorder.cpp: 13 for certain, and 1,000 give or take five standard deviations, 100.
    require(abs(end["written"] - 1013) <= 100 and end["written"] + end["sampled_out"] == end["seen"] == 10000, f"{end}")

    with record.Recording(str(log), most_bytes=100_000):
        for i in range(10000):
            call(i + 10)
    _, calls, end, _ = logs.read(log)
    require(log.stat().st_size <= 100_000 and end["written"] == len(calls) > 100, f"{end}")
    require(end["written"] + end["lost"] == end["seen"] == 10000, f"{end}")


def methods_in_python(logs):
    """The object of a method is no argument; an argument that is no JSON loses the call, and not the program."""
    record, log = loaded(), logs.folder / "methods.jsonl"

    class World:
        @record.recorded("segment_segment")
        def meet(self, a, b):
            return True

    world, segment = World(), [[0, 0], [1, 0]]
    with record.Recording(str(log)):
        require(world.meet(segment, b=segment) and world.meet(world, segment), "what is recorded is not what is answered")
    _, calls, end, told = logs.read(log)
    require(not told and [call["input"] for call in calls] == [{"a": segment, "b": segment}], f"{calls} {told}")
    require(end == {"seen": 2, "written": 1, "sampled_out": 0, "lost": 1}, f"{end}")


def killed_in_python(logs):
    log = logs.folder / "killed.jsonl"
    script = """
import os, signal, sys
sys.path.insert(0, sys.argv[1])
import record
meets = record.recorded("segment_segment", fields=["a", "b"])(lambda p, q: True)
record.Recording(sys.argv[2]).open()
for i in range(5000):
    meets([[i, 0], [1, 0]], [[0, 0], [1, 1]])
os.kill(os.getpid(), signal.SIGKILL)
"""
    killed = subprocess.run([sys.executable, "-B", "-c", script, ROOT / "python/touchstone", log])
    require(killed.returncode == -signal.SIGKILL, "it was not killed")
    _, calls, end, told = logs.read(log)
    require(end is None and "no end mark" in told and 0 < len(calls) < 5000, f"{end} {told}")


def over_numpy(logs):
    if importlib.util.find_spec("numpy") is None:
        return
    import numpy
    record = loaded()
    log = logs.folder / "numpy.jsonl"

    @record.recorded("orientation", fields=["p0", "p1", "p"], answer="side", rows=True)
    def sides(p, q, r):
        side = (q[:, 0] - p[:, 0]) * (r[:, 1] - p[:, 1]) - (q[:, 1] - p[:, 1]) * (r[:, 0] - p[:, 0])
        return numpy.array(["right", "on", "left"])[numpy.sign(side).astype(int) + 1]

    rows = numpy.arange(60, dtype=numpy.float32).reshape(3, 10, 2) / numpy.float32(10)
    with record.Recording(str(log)):
        answers = sides(*rows)
    _, calls, _, told = logs.read(log)
    require(not told and len(calls) == 10 and {call["number"] for call in calls} == {"binary32"}, f"{calls[:1]} {told}")
    require([call["answer"]["side"] for call in calls] == list(answers), "answers of rows")
    require(calls[3]["input"]["p1"] == rows[1, 3].tolist(), f"{calls[3]}")

    crowd = logs.folder / "crowd.jsonl"
    subprocess.run([sys.executable, "-B", ROOT / "examples/record/crowd.py", crowd, "10"], check=True)
    _, calls, end, told = logs.read(crowd)
    require(not told and end["seen"] == 10000 and len(calls) == end["written"], f"{end} {told}")
    require({len(call["input"]["polygon"]) for call in calls} == {5} and {call["answer"] for call in calls} == {True, False}, "rows")


def in_node(logs):
    if shutil.which("node") is None:
        return
    script, log = logs.folder / "in_node.mjs", logs.folder / "node.jsonl"
    script.write_text(IN_NODE.replace("RECORDER", str(ROOT / "examples/record/record.mjs")), encoding="utf-8")
    subprocess.run(["node", script, log], check=True)
    header, calls, end, told = logs.read(log)
    require(header["engine"] == "node \u00e9" and not told, f"{header} {told}")
    require(end["seen"] == 1000 and end["written"] == len(calls) and end["written"] + end["sampled_out"] == 1000, f"{end}")
    of = {call["input"]["b"][0][0]: call for call in calls}
    require({0, 1, 2, *range(99, 1000, 100)} <= of.keys(), "the first and the near ones are written")
    require(of[1]["input"] == {"a": [[0, -0.0], [2, 0]], "b": [[1, -1], [0.1, "nan"]]} and of[1]["answer"] is True, f"{of[1]}")
    require(7 not in of or of[7]["error"] == "seven", "an exception is an error")
    # 13 for certain; 100 more, give or take five standard deviations, 5 * 5.5 * sqrt(100) / 10.
    require(abs(end["written"] - 112) <= 30, f"{end}")
    subprocess.run(["node", script, log, "cut"], check=True)
    _, calls, end, told = logs.read(log)
    require(end is None and "no end mark" in told and not calls, f"{end} {told}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--cc", default="cc")
    parser.add_argument("--cxx", default="c++")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        logs = Logs(options.program, pathlib.Path(folder))
        for test in (lambda: in_c(logs, [options.cc + " -std=c99", options.cxx + " -x c++ -std=c++17"]), lambda: in_cpp(logs, options.cxx), lambda: in_python(logs),
                     lambda: methods_in_python(logs), lambda: killed_in_python(logs),
                     lambda: over_numpy(logs), lambda: in_node(logs)):
            try:
                test()
            except Failed as failed:
                print(failed)
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
