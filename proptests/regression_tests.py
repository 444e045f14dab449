#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the test that `touchstone ask OP --as FRAMEWORK` prints runs as it is and can fail, for every operation.

--catch2 FILE writes the tests for Catch2 into a file, of some vectors of every operation, with robust in the place of the
user's functions: cmake/proptests.cmake builds and runs it, but for the operations of which many answers are right; these
are tagged. --run runs those for pytest, Jest and Rust, without these frameworks,
against the `rounded` of the vectors, and holds those for GoogleTest against those for Catch2, which are compiled. It also
holds every list of the frameworks against that of the program.
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
    if name in ("convex_distance", "point_in_polygon"):
        assert ("Where others are as near" in text) == (name == "convex_distance"), "which of many answers it is"
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


STAND_IN = """
use std::collections::BTreeMap;
#[derive(Clone, Debug, PartialEq)]
pub enum Value { Bool(bool), Number(f64), Text(String), List(Vec<Value>), Object(BTreeMap<String, Value>) }
impl std::fmt::Display for Value {
    fn fmt(&self, to: &mut std::fmt::Formatter) -> std::fmt::Result { write!(to, "{self:?}") }
}
impl From<bool> for Value { fn from(value: bool) -> Self { Value::Bool(value) } }
impl From<f64> for Value { fn from(value: f64) -> Self { Value::Number(value) } }
impl From<i64> for Value { fn from(value: i64) -> Self { Value::Number(value as f64) } }
impl From<&str> for Value { fn from(value: &str) -> Self { Value::Text(value.to_string()) } }
impl From<Vec<Value>> for Value { fn from(value: Vec<Value>) -> Self { Value::List(value) } }
macro_rules! json {
    (@fields $to:ident) => {};
    (@fields $to:ident $name:literal: {$($in:tt)*} $(, $($rest:tt)*)?) =>
        { $to.insert($name.to_string(), json!({$($in)*})); $(json!(@fields $to $($rest)*);)? };
    (@fields $to:ident $name:literal: [$($in:tt)*] $(, $($rest:tt)*)?) =>
        { $to.insert($name.to_string(), json!([$($in)*])); $(json!(@fields $to $($rest)*);)? };
    (@fields $to:ident $name:literal: $value:expr $(, $($rest:tt)*)?) =>
        { $to.insert($name.to_string(), json!($value)); $(json!(@fields $to $($rest)*);)? };
    (@parts $to:ident) => {};
    (@parts $to:ident {$($in:tt)*} $(, $($rest:tt)*)?) => { $to.push(json!({$($in)*})); $(json!(@parts $to $($rest)*);)? };
    (@parts $to:ident [$($in:tt)*] $(, $($rest:tt)*)?) => { $to.push(json!([$($in)*])); $(json!(@parts $to $($rest)*);)? };
    (@parts $to:ident $value:expr $(, $($rest:tt)*)?) => { $to.push(json!($value)); $(json!(@parts $to $($rest)*);)? };
    ({$($in:tt)*}) => {{ #[allow(unused_mut)] let mut to = BTreeMap::new(); json!(@fields to $($in)*); Value::Object(to) }};
    ([$($in:tt)*]) => {{ #[allow(unused_mut)] let mut to: Vec<Value> = vec![]; json!(@parts to $($in)*); Value::List(to) }};
    ($value:expr) => { Value::from($value) };
}
"""


def in_rust(value):
    """For the stand-in, whatever its length."""
    if isinstance(value, dict):
        return "json!({" + ", ".join(f"{json.dumps(name)}: {in_rust(part)}" for name, part in value.items()) + "})"
    if isinstance(value, list):
        return "Value::List(vec![" + ", ".join(map(in_rust, value)) + "])"
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return f"Value::Number({float(value)!r})" if is_number else f"json!({json.dumps(value)})"


def run_rust(rustc, text, folder):
    """The number of tests that pass, and the messages of those that fail."""
    source, program = folder / "tests.rs", folder / "tests"
    source.write_text(STAND_IN + text)
    subprocess.run([rustc, "--edition", "2021", "--test", "-C", "debuginfo=0", "-o", program, source], check=True)
    said = subprocess.run([program, "--test-threads", "1"], capture_output=True, text=True, check=False).stdout
    return int(re.search(r"(\d+) passed", said)[1]), re.findall(r"panicked at .*\n(.*)", said)


def check_rust(rustc, texts, all_vectors):
    """A sixth of the operations: the compiler takes its time."""
    names = sorted(texts)[::6]
    count = sum(len(all_vectors[name]) for name in names)
    prelude = "use serde_json::{json, Value};\n"
    assert all(text.count(prelude) == 1 for text in texts.values())
    printed_tests = "".join(texts[name].replace(prelude, "") for name in names)
    right = printed_tests
    for name in names:
        answers = "".join(f"    if *question == {in_rust(vector['input'])} {{ return {in_rust(vector['rounded'])}; }}\n"
                          for vector in all_vectors[name])
        right, replaced = re.subn(rf'(fn my_{name}\(.*\) -> Value {{\n)(    panic!\(".*)\n',
                                  lambda match, answers=answers: match[1] + answers + match[2] + "\n", right)
        assert replaced == 1, name
    with tempfile.TemporaryDirectory() as folder:
        stubs = run_rust(rustc, printed_tests, pathlib.Path(folder))
        assert stubs[0] == 0 and len(stubs[1]) == count, stubs
        assert all(message.startswith("call your implementation here: ") for message in stubs[1]), stubs[1][:3]
        assert run_rust(rustc, right, pathlib.Path(folder)) == (count, [])
        # Each answer is another one's.
        wrong = re.sub(r"return (.*); }", r'return json!({"other": \1}); }', right)
        passed, messages = run_rust(rustc, wrong, pathlib.Path(folder))
        assert passed == 0 and all("left == right" in message for message in messages), (passed, messages[:3])


def check_lists(program):
    """The frameworks that the pages, the types and the interfaces list are the program's."""
    said = subprocess.run([program, "ask", "--help"], check=True, capture_output=True, text=True).stdout
    wanted = re.search(r"--as TEXT:{([a-z0-9,]+)}", said)[1].split(",")
    root = VECTORS.parent
    for file, before, after in (("js/page/index.html", 'id="framework">', "</select>"),
                                ("js/index.d.ts.in", "type TestFramework =", ";"),
                                ("js/core.mjs", "A regression test of a question, as a file for", "."),
                                ("js/README.md", "`regressionTest(op, question, framework)`", "\n"),
                                ("c/touchstone.h", "a regression test of the question for", "."),
                                ("docs/testing.md", "`touchstone ask OP --as", ":"),
                                ("docs/testing.md", "With `--as", "that command"),
                                ("docs/page.md", "question as `touchstone ask --as` does", ".")):
        listed = (root / file).read_text().split(before)[1].split(after)[0].replace("GoogleTest", "gtest")
        found = [word for word in re.findall(r"[a-z0-9]+", listed.split("| a test")[-1].lower()) if word in {*wanted}]
        found = list(dict.fromkeys(found))
        assert found == wanted, (file, before, found, wanted)


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
    rustc = shutil.which("rustc")
    if rustc:
        check_rust(rustc, of_framework("rust"), all_vectors)
    check_lists(arguments.program)
    tried = sum(len(vectors) for vectors in all_vectors.values())
    print(f"{tried} questions of {len(operations)} operations" + ("" if node else "; no node, so Jest's were not run") +
          ("" if rustc else "; no rustc, so Rust's were not run"))


if __name__ == "__main__":
    sys.exit(main())
