// SPDX-License-Identifier: Apache-2.0
/* global escaped */
// What is answered, as HTML: the truth in a sentence, who says what, with verdict and cause, and the certificate.

const longest = 600;
const spaced = (text) => escaped(text).replace(/([,:])(?=\S)/g, "$1<wbr>");
/** A value as JSON; a long one may be opened. */
export function coded(value) {
  const text = typeof value === "string" ? value : JSON.stringify(value);
  if (text.length <= longest) return `<code>${spaced(text)}</code>`;
  return (
    `<details class="long"><summary><code>${spaced(text.slice(0, 120))} ...</code> ${text.length} characters` +
    `</summary><code>${spaced(text)}</code></details>`
  );
}
export const badge = (word) => `<span class="badge ${escaped(word)}">${escaped(word.replaceAll("_", " "))}</span>`;
const upper = (text) => text.replace(/^./, (c) => c.toUpperCase());

/** An exact number in a few digits, where it can be said so. */
function about(exact) {
  const [p, q = "1"] = exact.split("/").map(Number);
  const value = p / Number(q);
  return exact.length > 6 && value > 0 && Number.isFinite(value) ? ` (about ${+value.toPrecision(3)})` : "";
}
function marginOf({ margin, touch }) {
  const words =
    margin === undefined
      ? "Nothing is decided, so there is no margin."
      : margin === "0"
        ? "Margin 0: the smallest change may change the answer."
        : `Margin ${coded(margin)}${about(margin)}`;
  return words + (touch ? " They touch: as open sets they would be answered otherwise." : "");
}

function asTyped({ as_typed, truth }) {
  if (!as_typed) return "";
  if (as_typed.truth === null)
    return `<p class="small">As typed, in exact decimals, the question is outside the contract.</p>`;
  const same = JSON.stringify(as_typed.truth) === JSON.stringify(truth);
  return same
    ? `<p class="small quiet" data-part="as-typed">As typed, in exact decimals: the same.</p>`
    : `<div data-part="as-typed">As typed, in exact decimals: <strong>${escaped(as_typed.sentence)}</strong> ` +
        `${coded(as_typed.truth)} ` +
        `<span class="small quiet">Doubles are not these decimals.</span></div>`;
}

/** The verdict in one word: of a wrong answer its cause. */
export const verdictOf = ({ verdict, cause }) => (verdict === "wrong" ? (cause ?? "wrong") : verdict);

/** truth: that of the question in doubles. */
function row(who, part, words, truth) {
  if (!part) return "";
  const heading = `<tr data-part="${who}"><th scope="row">${words}</th>`;
  if (part.not_evaluated) return `${heading}<td>not evaluated: ${escaped(part.not_evaluated)}</td><td></td></tr>`;
  const ulps = part.ulps ? `<br><span class="small quiet">${escaped(part.ulps)} ulps off</span>` : "";
  const notSought = part.cause_not_evaluated ? `The cause was not sought: ${part.cause_not_evaluated}.` : "";
  const reason = part.why ?? notSought;
  const why = reason ? `<br><span class="small quiet">${escaped(reason)}</span>` : "";
  const remark = part.remark && part.remark !== part.why ? `<br><span class="small quiet">${escaped(part.remark)}</span>` : "";
  const rounded = part.input && (part.verdict !== "agree" || JSON.stringify(part.truth) !== JSON.stringify(truth))
    ? `<br><span class="small quiet">The numbers as floats: ${coded(part.input)}, for which the truth is ` +
      `${coded(part.truth)}</span>`
    : "";
  return (
    `${heading}<td>${escaped(part.sentence ?? "")} ${coded(part.answer)}${ulps}${remark}${why}${rounded}</td>` +
    `<td>${badge(verdictOf(part))}</td></tr>`
  );
}

/** others: the same of other formulas for the same question, by their names; given: a pasted answer with its verdict. */
export function answered(said, others, given) {
  const { truth, sentence = "" } = said;
  const rows = [
    row("given", given, "the pasted answer", truth),
    row("robust", said.robust, "robust", truth),
    row("double", said.reference, "the formula in double", truth),
    row("float", said.reference_in_float, "the formula in float", truth),
  ];
  for (const [name, { reference, reference_in_float }] of Object.entries(others)) {
    const words = escaped(name.replaceAll("_", " "));
    rows.push(row(`${name}-double`, reference, `${words} in double`, truth));
    rows.push(row(`${name}-float`, reference_in_float, `${words} in float`, truth));
  }
  return (
    `<section class="card truth-card" data-part="truth"><p class="kicker">The exact truth</p>` +
    `<p class="sentence${sentence.length > 70 ? " wordy" : ""}">${escaped(upper(sentence))}</p>` +
    `<div class="exact">${coded(said.truth)}</div>` +
    `<p class="small quiet" data-part="margin">${marginOf(said)}</p>${asTyped(said)}</section>` +
    `<section class="card"><h2>Who says what</h2><table class="said"><tbody>${rows.join("")}</tbody></table>` +
    "</section>" +
    `<section class="card" data-part="certificate"><h2>Certificate</h2><p>${
      said.checker
        ? `${badge("invalid")} ${escaped(said.checker)}`
        : `The checker accepts it: <strong>${escaped(said.certificate.kind.replaceAll("_", " "))}</strong> ` +
          "proves the truth."
    }</p>` +
    `<details><summary>What it holds</summary>${coded(said.certificate)}</details></section>`
  );
}

/** A question outside the contract, or a failure. */
export const refused = (failure) =>
  `<section class="card refused" data-part="refused" role="alert">` +
  `<h2>${failure.rule === undefined ? "No answer" : "Outside the contract"}</h2>` +
  `<p>${failure.field ? `<code>${escaped(failure.field)}</code>: ` : ""}` +
  `${escaped(failure.rule ?? failure.message)}</p></section>`;
