// SPDX-License-Identifier: Apache-2.0
// Scenes as text, played in float, double and by robust: the page of `touchstone simulate`, and what it prints.
import { chosenIn, fragmentOf } from "./link.mjs";
import inWorker from "./touchstone/client.mjs";

const one = (selector) => document.querySelector(selector);
const box = one("#scene"), frame = one("#player");
const first = "two_balls_in_a_box";
const names = await (await fetch("scenes/list.json")).json();

let worker = null, playing = 0;
const say = (words) => {
  one("#status").textContent = words;
};
const textOfScene = async (name) => (await fetch(`scenes/${name}.json`)).text();
const nameOf = () => one("#name").value;

function stop() {
  worker?.then((started) => started.terminate());
  worker = null;
  one("#stop").disabled = true;
}

async function play() {
  const turn = ++playing;
  if (!one("#stop").disabled) stop();
  one("#stop").disabled = false;
  say("Playing ...");
  const runs = [...document.querySelectorAll("[name=run]:checked")].map(({ value }) => value);
  const began = performance.now();
  try {
    const { summary, page, ended } = await (
      await (worker ??= inWorker())
    ).simulate(box.value, runs.length ? { runs } : {});
    if (turn !== playing) return;
    one("#summary").textContent = summary;
    frame.hidden = !page;
    if (page) frame.srcdoc = page;
    say(`${ended ? `Ended: ${ended}. ` : ""}Played in ${((performance.now() - began) / 1000).toFixed(1)} s`);
  } catch (failure) {
    if (turn === playing) say(failure.field ? `${failure.field}: ${failure.rule}` : failure.message);
  }
  if (turn === playing) one("#stop").disabled = true;
}

async function remember() {
  const isOwn = box.value !== (await textOfScene(nameOf()));
  const runs = [...document.querySelectorAll("[name=run]:checked")].map(({ value }) => value).join(",");
  history.replaceState(
    null,
    "",
    fragmentOf({ name: nameOf(), scene: isOwn ? box.value : "", runs: runs === "float,double,robust" ? "" : runs }),
  );
}
async function follow(fragment) {
  const { name, scene, runs } = chosenIn(fragment);
  one("#name").value = names.includes(name) ? name : first;
  box.value = scene ?? (await textOfScene(nameOf()));
  if (runs)
    for (const run of document.querySelectorAll("[name=run]")) run.checked = runs.split(",").includes(run.value);
  await play();
}

// As high as what it shows.
frame.addEventListener("load", () => {
  const { body } = frame.contentDocument;
  const fit = () => { frame.style.height = `${body.offsetHeight + 2}px`; };
  new ResizeObserver(fit).observe(body);
});
one("#name").innerHTML = names
  .map((name) => `<option value="${name}">${name.replaceAll("_", " ")}</option>`)
  .join("");
one("#name").addEventListener("change", async () => {
  box.value = await textOfScene(nameOf());
  await Promise.all([play(), remember()]);
});
one("#play").addEventListener("click", () => {
  play();
  remember();
});
one("#stop").addEventListener("click", () => {
  ++playing;
  stop();
  say("Stopped");
});
box.addEventListener("change", remember);
box.addEventListener("keydown", (event) => {
  if (event.key !== "Enter" || !(event.ctrlKey || event.metaKey)) return;
  event.preventDefault();
  one("#play").click();
});
for (const run of document.querySelectorAll("[name=run]")) run.addEventListener("change", remember);
one("#link").addEventListener("click", async () => {
  await remember();
  await navigator.clipboard.writeText(location.href).then(
    () => say("The link is copied."),
    () => say("The link is the page's address."),
  );
});
addEventListener("hashchange", ({ newURL }) => follow(new URL(newURL).hash));
await follow(location.hash);
