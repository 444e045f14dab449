#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""An engine for two operations that echoes a number of the question and misbehaves as its argument says.

misbehaving.py BEHAVIOUR [NUMBER...]: on questions whose p is (NUMBER, ...), or on all without numbers.
"""
import json
import os
import signal
import sys
import time

behaviour, chosen = sys.argv[1], [float(n) for n in sys.argv[2:]]
hello = {"engine": "misbehaving 1", "ops": ["orientation", "explicit_line"]}
held = []


def say(line):
    sys.stdout.write((line if isinstance(line, str) else json.dumps(line)) + "\n")
    sys.stdout.flush()


def echo(question):
    point = question["input"].get("p") or question["input"]["point"]
    return {"id": question["id"], "answer": point[0]}


def swaps(question):
    held.append(echo(question))
    if len(held) == 2:
        say(held.pop())
        say(held.pop())


def answers_in_pieces(question):
    for letter in json.dumps(echo(question)) + "\n":
        os.write(1, letter.encode())


def dies_after_ten(question):
    say(echo(question))
    held.append(question)
    if len(held) == 10:
        sys.exit(0)


def answers_for_the_dead(question):
    """Dies of it; started anew, it first answers the question that was put to its predecessor last."""
    if question["id"] == echo(question)["answer"] + 1:
        os.kill(os.getpid(), signal.SIGSEGV)
    say({"id": question["id"] - 1, "answer": -1})
    say(echo(question))


def leaves_half_a_line(question):
    os.write(1, b'{"id":')
    sys.exit(1)


def complains_at_length(question):
    sys.stderr.write("x" * 300000 + "\n")
    say(echo(question))


def stops_reading(question):
    os.close(0)
    time.sleep(60)


misbehave = {
    "behaves": lambda q: say(echo(q)),
    "exits": lambda q: sys.exit("no licence"),
    "crashes": lambda q: os.kill(os.getpid(), signal.SIGSEGV),
    "hangs": lambda q: time.sleep(60),
    "is_silent": lambda q: None,
    "babbles": lambda q: (say("have a nice day"), say(echo(q))),
    "babbles_only": lambda q: say("have a nice day"),
    "says_left": lambda q: say({"id": q["id"], "answer": {"side": "left"}}),
    "babbles_and_says_left": lambda q: (say("have a nice day"), say({"id": q["id"], "answer": {"side": "left"}})),
    "lists": lambda q: (say("[1, 2]"), say(echo(q))),
    "prints_objects": lambda q: (say({"debug": echo(q)["answer"]}), say(echo(q))),
    "prints_python": lambda q: say(str(echo(q))),
    "indents": lambda q: say(json.dumps(echo(q), indent=1)),
    "nests": lambda q: say('{"id":%d,"answer":%s}' % (q["id"], "[" * 40000 + "]" * 40000)),
    "forgets_the_id": lambda q: say({"answer": 1}),
    "invents_an_id": lambda q: say({"id": q["id"] + 100000, "answer": 1}),
    "answers_twice": lambda q: (say(echo(q)), say(echo(q))),
    "floods": lambda q: [os.write(1, b"x" * 65536) for _ in range(100)],
    "has_an_error": lambda q: say({"id": q["id"], "error": "division by zero"}),
    "does_not_support": lambda q: say({"id": q["id"], "unsupported": True}),
    "answers_nothing": lambda q: say({"id": q["id"]}),
    "answers_at_length": lambda q: say({**echo(q), "why": "because " * 2000}),
    "swaps": swaps,
    "answers_in_pieces": answers_in_pieces,
    "counts_in_floats": lambda q: say({**echo(q), "id": float(q["id"])}),
    "dies_after_ten": dies_after_ten,
    "answers_for_the_dead": answers_for_the_dead,
    "leaves_half_a_line": leaves_half_a_line,
    "complains_at_length": complains_at_length,
    "stops_reading": stops_reading,
    "prints_hexadecimal": lambda q: say({"id": q["id"], "answer": float(q["input"]["p"][0]).hex()}),
}[behaviour]

sys.stdin.readline()
say(hello)
for text in sys.stdin:
    asked = json.loads(text)
    if not chosen or echo(asked)["answer"] in chosen:
        misbehave(asked)
    else:
        say(echo(asked))
