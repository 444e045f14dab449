// SPDX-License-Identifier: Apache-2.0
// Writes index.d.ts of a package from its catalogue: node types.mjs PACKAGE_FOLDER
import { readFileSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const folder = pathToFileURL(`${process.argv[2]}/`);
const { default: touchstone } = await import(new URL("index.mjs", folder));
const operations = (await touchstone()).operations();

/** A described question or answer as a type; `number` is what stands for a number. */
function typeOf(described, number) {
  if (Array.isArray(described)) {
    if (described[1] === "...") return `${typeOf(described[0], number)}[]`;
    return `[${described.map((each) => typeOf(each, number)).join(", ")}]`;
  }
  if (typeof described === "object") {
    if (described["one of"]) return `(${described["one of"].map((each) => typeOf(each, number)).join(" | ")})`;
    const fields = Object.entries(described).map(([name, each]) => `${name}: ${typeOf(each, number)}`);
    return `{ ${fields.join("; ")} }`;
  }
  if (described === "number") return number;
  if (described === "index") return "Index";
  if (described === "true | false") return "boolean";
  const words = described.split(" | ").map((word) => JSON.stringify(word)).join(" | ");
  return described.includes(" | ") ? `(${words})` : words;
}

const questionOf = ({ input }) =>
  Array.isArray(input) ? input.map((each) => typeOf(each, "number")).join(" | ") : typeOf(input, "number");
const listed = (typed) => operations.map((each) => `  /** ${each.question} */\n  ${each.name}: ${typed(each)};`).join("\n");
const made = {
  questions: listed(questionOf),
  answers: listed(({ answer }) => typeOf(answer, "number")),
  truths: listed(({ answer }) => typeOf(answer, "Exact")),
  families: listed(({ families }) => families.map((name) => JSON.stringify(name)).join(" | ")),
};
const template = readFileSync(new URL("index.d.ts.in", import.meta.url), "utf8");
writeFileSync(new URL("index.d.ts", folder), template.replace(/@(\w+)@/g, (_, name) => made[name]));
