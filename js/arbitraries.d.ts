import type * as FastCheck from "fast-check";

import type { Families, Operation, Questions, Touchstone } from "./index.js";

export interface Arbitraries {
  /** Questions of families, by default of all, within the contract; they shrink within their family. */
  questions<O extends Operation>(operation: O, options?: { families?: Families[O][] }): FastCheck.Arbitrary<Questions[O]>;
  /** Small integers and any finite doubles, within the contract; `all` leaves in what it refuses. */
  raw<O extends Operation>(operation: O, options?: { all?: boolean }): FastCheck.Arbitrary<Questions[O]>;
}
type Generators = "array" | "boolean" | "constantFrom" | "double" | "integer" | "nat" | "oneof" | "record" | "tuple" | "uint8Array";
export default function arbitraries(fc: Pick<typeof FastCheck, Generators>, touchstone: Touchstone): Arbitraries;
