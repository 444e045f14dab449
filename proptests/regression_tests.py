#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the test that `touchstone ask OP --as FRAMEWORK` prints runs as it is and can fail, for every operation.

--catch2 FILE writes the tests for Catch2 into a file, of some vectors of every operation, with robust in the place of the
user's functions: cmake/proptests.cmake builds and runs it, but for the operations of which many answers are right; these
are tagged. --run runs those for pytest and Jest, without these frameworks,
against the `rounded` of the vectors, and holds those for GoogleTest against those for Catch2, which are compiled.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

VECTORS = pathlib.Path(__file__).parent.parent / "vectors"
LONGEST = 4000  # characters of a line: a compiler reads it


def vectors_of(name):
    """The first two of each set of fields and each form of an answer."""
    chosen, seen = [], {}
    for line in open(VECTORS / f"{name}.jsonl"):
        vector = json.loads(line)
        if "refused" in vector or len(line) > LONGEST or '"meshes/' in line:
            continue
        words = [value for value in vector["truth"].values() if isinstance(value, str) and value.isalpha()]
        # Points in the plane and in space stand in the same fields.
        kind = (*vector["input"], *words, re.sub("[^][{}]", "", json.dumps(vector["input"]))[:6], len(vector["input"]),
                str(vector["input"]).count(",") if len(line) < 500 else 0)
        seen[kind] = seen.get(kind, 0) + 1
        if seen[kind] <= 2 and len(chosen) < 12:
            chosen.append(vector)
    assert chosen, name
    return chosen


def printed(program, name, framework, vectors):
    lines = "".join(json.dumps(vector["input"]) + "\n" for vector in vectors)
    return subprocess.run([program, "ask", name, "--as", framework], input=lines, check=True, capture_output=True,
                          text=True).stdout


def with_robust(text, operation):
    """The functions that the user would write, as calls of robust."""
    name = operation["name"]

    def body(match):
        parameters, types = match[1], None
        while types != parameters:  # a type's own commas
            types, parameters = parameters, re.sub("<[^<>]*>", "", parameters)
        names = [parameter.split()[-1] for parameter in types.split(", ")]
        call = f"robust::{name}({', '.join(names)})"
        if "optional" in types.split(", ")[-1]:  # robust has a default
            call = f"{names[-1]} ? robust::{name}({', '.join([*names[:-1], '*' + names[-1]])})" + \
                f" : robust::{name}({', '.join(names[:-1])})"
        return f"my_{name}({match[1]}) {{\n  return {call};"
    text, count = re.subn(rf"my_{name}\((.*)\) {{\n  throw std::logic_error\(.*\);", body, text)
    assert count >= 1, text[:2000]
    if operation["kind"] == "checked":
        text = re.sub(r'(TEST_CASE\("\w+")\)', r'\1, "[checked]")', text)
    return f"#include <touchstone/robust/{operation['chapter']}/{name}.h>\n{text}"


def check_gtest(text, catch2):
    text = re.sub(r"TEST\(touchstone, (\w+)\)", r'TEST_CASE("\1")', text).replace("EXPECT_TRUE(", "CHECK(")
    assert text[text.index("#include <touchstone"):] == catch2[catch2.index("#include <touchstone"):]


def check_pytest(text, name, vectors):
    tests = {}
    exec(compile(text, name, "exec"), tests)  # pylint: disable=exec-used
    for number, vector in enumerate(vectors, 1):
        test, asked = tests[f"test_{name}_{number}"], []
        original = tests[f"my_{name}"]
        try:
            test()
            raise SystemExit(f"{name}: the function to be written was not called")
        except NotImplementedError:
            pass
        rounded = json.loads(json.dumps(vector["rounded"]).replace('"inf"', "Infinity").replace('"-inf"', "-Infinity"))
        tests[f"my_{name}"] = lambda **question: asked.append(question) or rounded
        test()
        assert asked == [vector["input"]], (asked, vector["input"])
        tests[f"my_{name}"] = lambda **question: {"another": "answer"}
        try:
            test()
            raise SystemExit(f"{name}: a wrong answer passes")
        except AssertionError:
            pass
        tests[f"my_{name}"] = original


SHIM = """
import assert from "node:assert";
const failed = [];
const expect = (answer) => ({ toEqual: (expected) => assert.deepStrictEqual(answer, expected) });
const test = (name, body) => { try { body(); } catch (error) { failed.push(error.message); } };
const infinite = { inf: Infinity, "-inf": -Infinity };
const read = (text) => JSON.parse(text, (key, value) => infinite[value] ?? value);
"""


def run_node(node, text):
    with tempfile.NamedTemporaryFile("w", suffix=".mjs") as file:
        file.write(SHIM + text + "\nconsole.log(JSON.stringify(failed));\n")
        file.flush()
        return json.loads(subprocess.run([node, file.name], check=True, capture_output=True, text=True).stdout)


def check_jest(node, texts, all_vectors):
    """All operations at once: node starts slowly."""
    count = sum(len(vectors) for vectors in all_vectors.values())
    stubs = run_node(node, "".join(texts.values()))
    assert stubs == ["call your implementation here"] * count, stubs[:3]
    right = ""
    for name, text in texts.items():
        answers = json.dumps([json.dumps([vector["input"], vector["rounded"]]) for vector in all_vectors[name]])
        text, replaced = re.subn(rf"function my_{name}\(.*\) {{\n  throw .*\n",
                                 f"const {name}_answers = {answers};\nfunction my_{name}(question) {{\n"
                                 f"  const [asked, answer] = read({name}_answers.shift());\n"
                                 "  assert.deepEqual(question, asked);\n  return answer;\n", text)
        assert replaced == 1
        right += text
    assert run_node(node, right) == []
    wrong = run_node(node, right.replace("  return answer;", '  return { another: "answer" };'))
    assert len(wrong) == count, len(wrong)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    choice = parser.add_mutually_exclusive_group(required=True)
    choice.add_argument("--catch2", type=pathlib.Path)
    choice.add_argument("--run", action="store_true")
    arguments = parser.parse_args()
    listed = json.loads(subprocess.run([arguments.program, "ops", "--json"], check=True, capture_output=True).stdout)
    operations = [operation for operation in listed if (VECTORS / f"{operation['name']}.jsonl").exists()]
    all_vectors = {operation["name"]: vectors_of(operation["name"]) for operation in operations}

    def of_framework(framework):
        return {name: printed(arguments.program, name, framework, vectors) for name, vectors in all_vectors.items()}
    catch2 = of_framework("catch2")
    if arguments.catch2:
        texts = [with_robust(catch2[operation["name"]], operation) for operation in operations]
        arguments.catch2.write_text("".join(texts))
        return
    gtest, pytest = of_framework("gtest"), of_framework("pytest")
    for name, vectors in all_vectors.items():
        check_gtest(gtest[name], catch2[name])
        check_pytest(pytest[name], name, vectors)
    node = shutil.which("node")
    if node:
        check_jest(node, of_framework("jest"), all_vectors)
    tried = sum(len(vectors) for vectors in all_vectors.values())
    print(f"{tried} questions of {len(operations)} operations" + ("" if node else "; no node, so Jest's were not run"))


if __name__ == "__main__":
    sys.exit(main())
