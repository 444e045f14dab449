// SPDX-License-Identifier: Apache-2.0
/* global escaped, viewer */
// The page: what the reader does changes the question, and what is shown follows from the question.
import { answered, refused } from "./answers.mjs";
import { decimals } from "./doubles.mjs";
import { Formula } from "./formula.mjs";
import { chosenIn, fragmentOf } from "./link.mjs";
import { Maps } from "./maps.mjs";
import { Numbers } from "./numbers.mjs";
import { Picker } from "./picker.mjs";
import { Picture } from "./picture.mjs";
import { pasted } from "./pasted.mjs";
import { Numeral, numeral, parsed, partsOf, textOf } from "./question.mjs";
import inWorker from "./touchstone/client.mjs";
import { jsonOf } from "./touchstone/core.mjs";
import { replyOf } from "./touchstone/engine.mjs";

const one = (selector) => document.querySelector(selector);
const first = "orientation", mostUndone = 200;

const began = performance.now();
// Answers follow the reader's hand from one worker; what takes longer has another, which starts when it is first asked.
const live = await inWorker();
let other;
const slow = async (name, ...given) => (await (other ??= inWorker()))[name](...given);
const operations = await live.operations();
const byName = new Map(operations.map((each) => [each.name, each]));

let operation, tree, parts, text; // the question
let said, drawing; // its answers and figures, as soon as they are there
let claimed; // the question that was pasted with an answer, and that
let before = [], lastHold, drawn = { list: [], from: "" };

// The question and the questions before it.
const question = () => ({ operation, tree, parts, text });
function change(to, { fit = false, undone = false, op = operation } = {}) {
  const { hold } = picture, goesOn = hold !== undefined && hold === lastHold;
  lastHold = hold;
  if (text !== undefined && !undone && !goesOn) before = [...before.slice(-mostUndone), [operation.name, text]];
  if (op !== operation) {
    operation = op;
    drawing = undefined;
    maps.axes = null;
    one("#operation").textContent = operation.name.replaceAll("_", " ");
    one("#asked").textContent = operation.question;
    one("#family").innerHTML =
      `<option value="">any family</option>` + operation.families.map((name) => `<option>${name}</option>`).join("");
    document.title = `${operation.name.replaceAll("_", " ")}: the exact truth`;
    fit = true;
  }
  tree = to;
  parts = partsOf(operation.meanings, tree);
  text = textOf(tree);
  one("#undo").disabled = before.length === 0;
  if (document.activeElement !== one("#text")) one("#text").value = text;
  formula.question = question();
  numbers.set({ tree, parts });
  picture.set({ tree, parts, drawing });
  ask(fit);
  remember();
}
const load = (name, json, options) => change(parsed(json), { op: byName.get(name), ...options });

// One question at a time is asked; of those that come meanwhile the last.
const setBusy = (isBusy) => one("#answers").setAttribute("aria-busy", isBusy);
let asking = false, again = false, fitsNext = false;
async function ask(fit = false) {
  fitsNext ||= fit;
  again = true;
  setBusy(true);
  if (asking) return;
  asking = true;
  while (again) {
    again = false;
    const { name } = operation, asked = text;
    const others = operations.filter((each) => each.implementation_of === name);
    try {
      const now = await live.explain(name, asked);
      const wrong = now.reference?.verdict === "wrong" ? JSON.stringify(now.reference.answer) : undefined;
      const figures = await live.drawing(name, asked, wrong);
      const by = {};
      for (const each of picture.isHeld ? [] : others) by[each.name] = await live.explain(each.name, asked);
      if (name !== operation.name) continue;
      const isClaimed = claimed?.op === name && claimed.text === asked;
      const given = isClaimed && (await live.judgeReply({ engine: "pasted", ops: [name] }, name, asked, claimed.reply));
      said = now;
      drawing = figures;
      show(answered(said, by, given));
    } catch (failure) {
      if (name !== operation.name) continue;
      said = drawing = undefined;
      show(refused(failure));
    }
  }
  asking = false;
  setBusy(false);
  picture.set({ tree, parts, drawing }, fitsNext);
  fitsNext = false;
  followed();
}
function show(html) {
  const place = one("#answers"), open = [...place.querySelectorAll("details")].map((each) => each.open);
  place.innerHTML = html;
  const details = [...place.querySelectorAll("details")];
  if (details.length === open.length) details.forEach((each, i) => { each.open = open[i]; });
  // Notes say in words what a figure shows, too.
  const isDrawn = said && drawing.figures.length + drawing.space.length > 0;
  const notes = said ? [...(isDrawn ? [] : drawing.notes), drawing.search].filter(Boolean) : [];
  one("#notes").innerHTML = notes.map((note) => `<p class="small quiet">${escaped(note)}</p>`).join("");
  picture.set({ tree, parts, drawing }, fitsNext);
  fitsNext = false;
}
// What need not follow the hand.
let following;
function followed() {
  clearTimeout(following);
  following = setTimeout(
    () => {
      one("#spoken").textContent = said ? said.sentence : one("#answers").textContent;
      formula.follow();
      if (one("#neighbours").open && said) maps.show(question());
      if (one("#test").open) showTest();
      if (one("#figure").open) showFigure();
      const wrong = (part) => part?.verdict === "wrong";
      one("#shrink").disabled = !wrong(said?.reference);
      one("#shrink-float").disabled = !wrong(said?.reference_in_float);
    },
    picture.isHeld ? 300 : 60,
  );
}

// Decimals that dragging leaves: those that a pixel needs, or as many as the reader says.
function powerAt(pixel) {
  const { value } = one("#snap");
  return value === "none" ? null : value === "pixel" ? Math.ceil(Math.log10(pixel) - 0.3) : Number(value);
}
const numberAt = (pixel) => (x) => {
  const power = powerAt(pixel);
  return power === null ? numeral(x) : new Numeral(decimals(x, power));
};
const stepAt = (pixel) => (powerAt(pixel) === null ? pixel : 10 ** powerAt(pixel));
function snapped(value) {
  if (Array.isArray(value)) return value.map(snapped);
  if (value instanceof Numeral) return numberAt(picture.view.pixel)(value.value);
  return typeof value === "object" && value !== null
    ? Object.fromEntries(Object.entries(value).map(([name, each]) => [name, snapped(each)]))
    : value;
}

// The address holds all that was chosen.
let remembering;
function remember() {
  clearTimeout(remembering);
  remembering = setTimeout(() => history.replaceState(null, "", address()), 300);
}
const address = () => {
  const { isFlat, yaw, pitch } = picture.view;
  const view = isFlat || !picture.isTurned ? "" : [yaw, pitch].map((angle) => angle.toFixed(3)).join(",");
  return fragmentOf({
    op: operation.name,
    q: text,
    snap: one("#snap").value === "pixel" ? "" : one("#snap").value,
    turn: view,
    axes: maps.axes?.join(","),
    open: [...document.querySelectorAll("details.tool[open]")].map(({ id }) => id).join(","),
    formula: formula.text,
  });
};
function follow(fragment) {
  const chosen = chosenIn(fragment);
  one("#snap").value = chosen.snap ?? "pixel";
  if (one("#snap").selectedIndex < 0) one("#snap").value = "pixel";
  for (const details of document.querySelectorAll("details.tool"))
    details.open = (chosen.open ?? "").split(",").includes(details.id);
  formula.linked = chosen.formula ?? "";
  const op = byName.get(chosen.op) ?? byName.get(first);
  let given;
  try {
    given = parsed(chosen.q);
  } catch {
    given = parsed(jsonOf(op.example));
  }
  change(given, { op, fit: true });
  maps.axes = chosen.axes?.split(",").map(Number) ?? null;
  const turn = chosen.turn?.split(",").map(Number);
  picture.turnWith(turn?.length === 2 && turn.every(Number.isFinite) ? turn : null);
}

const status = (words) => {
  one("#status").textContent = words;
};
async function copy(words, what) {
  try {
    await navigator.clipboard.writeText(words);
    status(`${what} is copied.`);
  } catch {
    status(`This browser does not let the page copy. ${what} is in the address, or can be selected.`);
  }
}

const picture = new Picture(one("#picture"), { moved: (to) => change(to), turned: remember, numberAt, stepAt });
const numbers = new Numbers(one("#numbers"), (to) => change(to));
const maps = new Maps(one("#map-place"), {
  map: (...given) => slow("map", ...given),
  go: (to) => change(to),
  chosen: remember,
});
const formula = new Formula(one("#formula"), { started: inWorker, load, changed: remember });
const picker = new Picker(one("#picker"), {
  operations: operations.filter((each) => !each.implementation_of),
  drawing: (...given) => slow("drawing", ...given),
  pick: (name) => load(name, jsonOf(byName.get(name).example)),
});

async function draw() {
  const families = one("#family").value ? [one("#family").value] : [], from = `${operation.name} ${families}`;
  if (drawn.from !== from) drawn = { from, list: [], seed: 1 };
  if (!drawn.list.length) drawn.list = await slow("draw", operation.name, { families, cases: 40, seed: drawn.seed++ });
  const { input, family, index } = drawn.list.shift();
  status(`Question ${index} of the family ${family}`);
  change(parsed(jsonOf(input)), { fit: true });
}
async function shrink(options) {
  status("Shrinking ...");
  const from = text;
  try {
    const { input, candidates } = await slow("shrink", operation.name, from, options);
    if (text !== from) return status("");
    change(parsed(jsonOf(input)), { fit: true });
    status(`The least of ${candidates} questions on which the formula is wrong in the same way`);
  } catch (failure) {
    status(failure.rule ?? failure.message);
  }
}
async function read(given) {
  setBusy(true);
  try {
    const found = await pasted(given, {
      current: operation,
      tree,
      operations,
      read: (...texts) => slow("read", ...texts),
    });
    claimed = found.answer !== undefined && { ...found, reply: replyOf(byName.get(found.op), found.answer) };
    load(found.op, found.text, { fit: true });
    one("#text").removeAttribute("aria-invalid");
    one("#text-says").textContent = "";
  } catch (failure) {
    setBusy(asking);
    one("#text").setAttribute("aria-invalid", "true");
    one("#text-says").textContent = failure.field ? `${failure.field}: ${failure.rule}` : failure.message;
  }
}
async function showTest() {
  try {
    one("#test pre").textContent = await slow("regressionTest", operation.name, text, one("#framework").value);
  } catch (failure) {
    one("#test pre").textContent = failure.rule ?? failure.message;
  }
}
function showFigure() {
  const place = one("#figure-place");
  if (drawing?.svg) place.innerHTML = drawing.svg;
  else if (drawing?.model) viewer.show(place, drawing.model);
  else place.textContent = "Nothing of this question can be drawn.";
}

one("#pick").addEventListener("click", () => picker.open(operation.name));
one("#draw").addEventListener("click", draw);
one("#family").addEventListener("change", draw);
one("#example").addEventListener("click", () => load(operation.name, jsonOf(operation.example), { fit: true }));
one("#undo").addEventListener("click", () => {
  const [name, json] = before.pop();
  load(name, json, { undone: true });
});
one("#link").addEventListener("click", () => copy(new URL(address(), location.href).href, "The link"));
one("#fit").addEventListener("click", () => picture.fit());
one("#nearer").addEventListener("click", () => picture.zoom(0.6));
one("#farther").addEventListener("click", () => picture.zoom(1 / 0.6));
one("#snap").addEventListener("change", remember);
one("#snap-all").addEventListener("click", () => change(snapped(tree)));
one("#shrink").addEventListener("click", () => shrink({}));
one("#shrink-float").addEventListener("click", () => shrink({ binary32: true }));
one("#framework").addEventListener("change", showTest);
one("#copy-test").addEventListener("click", () => copy(one("#test pre").textContent, "The test"));
one("#text").addEventListener("change", ({ target }) => read(target.value));
one("#text").addEventListener("paste", () => setTimeout(() => read(one("#text").value)));
for (const details of document.querySelectorAll("details.tool")) {
  details.addEventListener("toggle", () => {
    if (details.open && details.id === "own") formula.begin();
    followed();
    remember();
  });
}
addEventListener("keydown", (event) => {
  if (event.target.matches("input, textarea, select") || one("#picker").open) return;
  if (event.key === "/") picker.open(operation.name);
  else if (event.key === "z" && (event.ctrlKey || event.metaKey)) one("#undo").click();
  else return;
  event.preventDefault();
});
// Of the event: the address itself may have been written meanwhile.
addEventListener("hashchange", ({ newURL }) => follow(new URL(newURL).hash));
matchMedia("(prefers-color-scheme: dark)").addEventListener(
  "change",
  () => one("#neighbours").open && maps.show(question()),
);

follow(location.hash);
status(`${picker.operations.length} operations, ready in ${Math.round(performance.now() - began)} ms`);
