#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the shell steps of action.yml as a runner of GitHub Actions does, on the installed package, and looks at what a user gets.

  action_runs.py SOURCE PREFIX SCRATCH

Steps that call other actions are passed over. Exit code 77 (skipped) where PyYAML is not there, or this is no Debian.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

try:
    import yaml
except ImportError:
    sys.exit(77)

EXPRESSION = re.compile(r"\$\{\{\s*([\w.-]+)\s*\}\}")


class Runner:
    """One job: environment and PATH carry over from step to step, as do the steps' outputs."""

    def __init__(self, source, prefix, scratch):
        self.source, self.scratch = source, scratch
        shutil.rmtree(scratch, ignore_errors=True)
        (scratch / "work space").mkdir(parents=True)
        (scratch / "temp").mkdir()
        self.action = yaml.safe_load((source / "action.yml").read_text(encoding="utf-8"))
        self.environment = {name: os.environ[name] for name in ("PATH", "HOME", "LANG") if name in os.environ}
        self.environment |= {"GITHUB_ACTION_PATH": str(source), "RUNNER_TEMP": str(scratch / "temp"),
                             "TOUCHSTONE_PREFIX": str(prefix)}

    def value(self, name):
        if name.startswith("inputs."):
            return self.inputs[name.removeprefix("inputs.")]
        if name.startswith("runner."):
            return {"runner.os": "Linux", "runner.arch": "X64"}[name]
        step = re.fullmatch(r"steps\.([\w-]+)\.outputs\.([\w-]+)", name)
        return self.outputs[step[1]].get(step[2], "")

    def filled(self, text):
        return EXPRESSION.sub(lambda match: self.value(match[1]), str(text))

    def shell(self, step):
        if "${{" in step["run"] or step["shell"] != "bash":
            raise AssertionError(f"{step['run']}: an input would be read as shell code, or the shell is not named")
        files = {name: self.scratch / name for name in ("GITHUB_OUTPUT", "GITHUB_ENV", "GITHUB_PATH")}
        for file in files.values():
            file.write_text("")
        summary = self.scratch / "GITHUB_STEP_SUMMARY"
        environment = self.environment | {name: str(file) for name, file in files.items()}
        environment |= {"GITHUB_STEP_SUMMARY": str(summary)}
        environment |= {name: self.filled(value) for name, value in step.get("env", {}).items()}
        folder = self.scratch / "work space" / self.filled(step.get("working-directory", "."))
        done = subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]], cwd=folder,
                              env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True)
        pairs = {name: dict(line.split("=", 1) for line in files[name].read_text().splitlines())
                 for name in ("GITHUB_OUTPUT", "GITHUB_ENV")}
        self.outputs[step.get("id", "")] = pairs["GITHUB_OUTPUT"]
        self.environment |= pairs["GITHUB_ENV"]
        for line in files["GITHUB_PATH"].read_text().splitlines():
            self.environment["PATH"] = line + ":" + self.environment["PATH"]
        self.log += done.stdout + done.stderr
        return done.returncode

    def use(self, **given):
        """The exit code of the first step that fails, and the outputs of the action."""
        known = self.action["inputs"]
        given = {name.replace("_", "-"): value for name, value in given.items()}
        assert given.keys() <= known.keys()
        self.inputs = {name: given.get(name, described["default"]) for name, described in known.items()}
        self.outputs, self.log, code = {}, "", 0
        (self.scratch / "GITHUB_STEP_SUMMARY").write_text("")
        for step in self.action["runs"]["steps"]:
            if "uses" in step:
                for value in step.get("with", {}).values():
                    self.filled(value)
                continue
            if step.get("if", "") == "inputs.engine != ''" and not self.inputs["engine"]:
                self.outputs[step["id"]] = {}
                continue
            code = self.shell(step)
            if code:
                break
        outputs = {name: self.filled(described["value"]) for name, described in self.action["outputs"].items()}
        return code, outputs, (self.scratch / "GITHUB_STEP_SUMMARY").read_text()


def defects(source, prefix, scratch):
    runner = Runner(source, prefix, scratch)
    here = scratch / "work space"

    code, outputs, summary = runner.use()
    if code or outputs["prefix"] != str(prefix) or summary:
        yield f"only to install: exit code {code}, {outputs}, {summary}: {runner.log}"
    where = subprocess.run("command -v touchstone; echo $CMAKE_PREFIX_PATH; pkg-config --variable=libdir touchstone-robust",
                           shell=True, env=runner.environment, capture_output=True, text=True).stdout.splitlines()
    if where[:2] != [f"{prefix}/bin/touchstone", str(prefix)] or any(not libraries.startswith(str(prefix)) for libraries in where[2:]):
        yield f"later steps find {where}"

    (here / "my engines").mkdir()
    shutil.copy(source / "examples/engine.py", here / "my engines/naive engine.py")
    engine = f"{sys.executable} 'naive engine.py'"
    wrong = "--ops segment_segment --cases 200"
    code, outputs, summary = runner.use(engine=engine, args=wrong, working_directory="my engines")
    if code != 1 or outputs["exit-code"] != "1":
        yield f"a naive engine: exit code {code}, {outputs}: {runner.log}"
    elif not pathlib.Path(outputs["json"]).is_file():
        yield "a naive engine: no JSON"
    headline = re.compile(r"^### touchstone audit\n[^\n]*textbook in Python.*?```text\n.*^segment_segment ", re.DOTALL | re.MULTILINE)
    if not headline.search(summary):
        yield f"a naive engine: the page of the run has {summary}"

    code, _, _ = runner.use(engine=engine, args=wrong, working_directory="my engines", fail_on="invalid")
    if code:
        yield f"a naive engine whose answers can be read: exit code {code}: {runner.log}"
    (here / "my engines/known.json").write_text('{"touchstone":1,"kind":"baseline","engine":"e","seed":1,"known":[]}\n')
    code, _, summary = runner.use(engine=engine, args=wrong, working_directory="my engines", baseline="known.json",
                                  sarif="found here.sarif", junit="found.xml", source="naive engine.py")
    if code != 1 or not re.search("^### touchstone audit\ntextbook in Python.*\ngate: failed.*new findings", summary):
        yield f"a baseline in which nothing is known: exit code {code}: {runner.log}"
    else:
        found = [(here / "my engines" / file).read_text() for file in ("found here.sarif", "found.xml")]
        for word, text in zip(("naive%20engine.py|naive engine.py", "<failure"), found):
            if not re.search(word, text) or "segment_segment" not in text:
                yield f"no {word} in {text}"

    right = "--ops orientation --families collinear,axis_parallel --cases 200"
    code, outputs, _ = runner.use(engine=engine, args=right, working_directory="my engines")
    if code or outputs["exit-code"] != "0":
        yield f"an engine that is right: exit code {code}, {outputs}: {runner.log}"
    code, _, _ = runner.use(engine=engine, args="--ops nonsense", working_directory="my engines")
    if code != 2 or "nonsense" not in runner.log:
        yield f"an operation that does not exist: exit code {code}: {runner.log}"
    code, _, _ = runner.use(engine="/no/such/engine", args=wrong)
    if code != 3:
        yield f"an engine that does not exist: exit code {code}: {runner.log}"


def defects_of_container(source):
    """The image holds what a user of the package needs, as cmake/components.cmake says it, and no stray build directory."""
    text = (source / "Containerfile").read_text(encoding="utf-8")
    last = text[text.rindex("\nFROM "):]
    components = (source / "cmake/components.cmake").read_text(encoding="utf-8")
    for package in re.findall(r"^set\(touchstone_debian_of_\w+ ([\w.-]+)\)", components, re.MULTILINE):
        if package not in last.split():
            yield f"Containerfile: {package} is not installed in the image"
    for name in (".containerignore", ".dockerignore"):
        if "/build" not in (source / name).read_text(encoding="utf-8").splitlines():
            yield f"{name}: the build directory would be copied"


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    if not shutil.which("dpkg-query"):
        return 77
    source, prefix, scratch = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    found = list(defects_of_container(source)) + list(defects(source, prefix, scratch))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
