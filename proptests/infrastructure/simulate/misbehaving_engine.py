#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""An engine whose bodies stand still, and which misbehaves in step 3 as its argument says."""
import json
import os
import signal
import sys
import time

behaviour = sys.argv[1]
scene = json.loads(sys.stdin.readline())["scene"]
hello = {"engine": "misbehaving 1"}


def still(step):
    return {"step": step, "bodies": [b["position"] + b["velocity"] for b in scene["bodies"]]}


def say(line):
    sys.stdout.write((line if isinstance(line, str) else json.dumps(line)) + "\n")
    sys.stdout.flush()


def with_number(answer, text):
    answer["bodies"][0][1] = "@"
    return json.dumps(answer).replace('"@"', text)


first_lines = {
    "says_nothing": lambda: sys.exit("no licence"),
    "greets_badly": lambda: (say("hello"), sys.exit(1)),
    "is_nameless": lambda: say({"number": "binary64"}),
    "misspells": lambda: say({**hello, "canot": ["boxes"]}),
    "lacks_what_is_none": lambda: say({**hello, "cannot": ["spheers"]}),
    "lacks_spheres": lambda: say({**hello, "cannot": ["spheres", "boxes", "walls"]}),
    "declines": lambda: say({**hello, "unsupported": "more than one body"}),
    "is_called_robust": lambda: say({"engine": "robust"}),
}
misbehave = {
    "crashes": lambda a: os.kill(os.getpid(), signal.SIGSEGV),
    "exits": lambda a: sys.exit("no licence"),
    "hangs": lambda a: time.sleep(60),
    "says_nan": lambda a: say(with_number(a, "NaN")),
    "says_null": lambda a: say(with_number(a, "null")),
    "is_infinite": lambda a: say(with_number(a, "1e999")),
    "forgets_a_body": lambda a: say({**a, "bodies": a["bodies"][:-1]}),
    "forgets_a_number": lambda a: say({**a, "bodies": [a["bodies"][0][:5]] + a["bodies"][1:]}),
    "is_late": lambda a: say({**a, "step": 2}),
    "meets_nobody": lambda a: say({**a, "contacts": [{"body": 0, "other": 9}]}),
    "meets_itself": lambda a: say({**a, "contacts": [{"body": 0, "other": 0}]}),
    "gives_up": lambda a: say({"error": "no solution"}),
    "babbles": lambda a: (say("have a nice day"), say(a)),
    "half_a_line": lambda a: (sys.stdout.write('{"step":'), sys.stdout.flush(), sys.exit(1)),
}
first_lines.get(behaviour, lambda: say(hello))()
for text in sys.stdin:
    answer = still(json.loads(text)["step"])
    if answer["step"] == 3 and behaviour in misbehave:
        misbehave[behaviour](answer)
    else:
        say(answer)
