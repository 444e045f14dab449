# SPDX-License-Identifier: Apache-2.0
"""The planted bugs: a file for each operation, planted/OPERATION.json, with a list of
{"file", "find", "plant", "what"}: in that file of robust/ the expression `find`, which stands there once (or once in `within`,
which does), becomes `plant`."""
import json
import pathlib


def listed():
    """[(number from 1, bug)], each bug with its `operation` and its `id`, OPERATION/PLACE."""
    bugs = []
    for path in sorted((pathlib.Path(__file__).resolve().parent / "planted").glob("*.json")):
        for place, bug in enumerate(json.loads(path.read_text(encoding="utf-8")), 1):
            bugs.append({"operation": path.stem, "id": f"{path.stem}/{place}"} | bug)
    return list(enumerate(bugs, 1))
