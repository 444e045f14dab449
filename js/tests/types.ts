// SPDX-License-Identifier: Apache-2.0
// What the compiler must accept of the package's types, and what it must refuse.
import fc from "fast-check";
import touchstone, { type Engine, type Truths } from "touchstone";
import arbitraries from "touchstone/arbitraries";
import inWorker from "touchstone/worker";

const t = await touchstone();
const side: "left" | "on" | "right" = t.ask("orientation", { p0: [0, 0], p1: [1, 1], p: [2, 2] }).truth.side;
const truth: Truths["segment_segment"] = t.truth("segment_segment", '{"a":[[0,0],[2,0]],"b":[[1,0],[3,0]]}').truth;
// @ts-expect-error: a point has two numbers
t.ask("orientation", { p0: [0], p1: [1, 1], p: [2, 2] });
// @ts-expect-error: there is no such operation
t.ask("orientatoin", {});
for (const drawn of t.draw("orientation", { families: ["collinear"], cases: 3 })) drawn.input.p0[0].toFixed();
// @ts-expect-error: there is no such family
t.draw("orientation", { families: ["colinear"] });

const engine: Engine = { name: "mine", boundary: "closed", orientation: ({ p }) => (p[0] > 0 ? "left" : "right") };
const { exit_code: code } = await t.judge(engine, "orientation", 100);
const verdicts = await t.judge(engine, "orientation", [{ p0: [0, 0], p1: [1, 1], p: [2, 2] }]);
const worker = await inWorker();
const outcome: string = (await worker.explain("orientation", { p0: [0, 0], p1: [1, 1], p: [2, 2] })).outcome;
const { questions } = arbitraries(fc, t);
fc.assert(fc.property(questions("orientation"), (question) => t.answer("orientation", question).side.length > 0));
console.log(side, truth, code, verdicts[0]?.verdict, outcome);
