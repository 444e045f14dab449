import type {
  AnswersOf, Asked, Audit, AuditOptions, Claim, Drawing, DrawOptions, Drawn, Families, InWords, JudgedReply, MapOptions,
  Operation, OperationMetadata, Question, Questions, ShrinkOptions, Simulated, TestFramework, UlpMap,
} from "./index.js";

export { InvalidInput } from "./index.js";

/** The functions of Touchstone, answered by a worker; an engine is the address of a module that exports it. */
export interface InWorker {
  operations(): Promise<OperationMetadata[]>;
  operation(name: Operation): Promise<OperationMetadata>;
  answer<O extends Operation>(operation: O, question: Question<O>): Promise<AnswersOf[O]>;
  truth<O extends Operation>(operation: O, question: Question<O>): Promise<Claim<O>>;
  ask<O extends Operation>(operation: O, question: Question<O>): Promise<Asked<O>>;
  askText<O extends Operation>(operation: O, question: Question<O>): Promise<string>;
  explain<O extends Operation>(operation: O, question: Question<O>): Promise<InWords<O>>;
  drawing<O extends Operation>(operation: O, question: Question<O>, answer?: unknown): Promise<Drawing>;
  read(operation: Operation, text: string): Promise<string>;
  regressionTest<O extends Operation>(operation: O, question: Question<O>, framework?: TestFramework): Promise<string>;
  map<O extends Operation>(operation: O, question: Question<O>, options?: MapOptions): Promise<UlpMap>;
  simulate(scene: object | string, options?: { runs?: ("float" | "double" | "robust")[]; steps?: number }):
    Promise<Simulated>;
  certify(claim: object | string): Promise<string>;
  draw<O extends Operation>(operation: O, options?: DrawOptions<O>): Promise<Drawn<O>[]>;
  replay<O extends Operation>(operation: O, family: Families[O], bytes: Uint8Array): Promise<Questions[O]>;
  accepts<O extends Operation>(operation: O, question: Question<O>): Promise<boolean>;
  audit(engine: string, options?: AuditOptions): Promise<Audit>;
  judge<O extends Operation>(engine: string, operation: O, cases?: number, options?: AuditOptions): Promise<Audit>;
  judge<O extends Operation>(engine: string, operation: O, questions: Question<O>[]): Promise<JudgedReply[]>;
  shrink<O extends Operation>(operation: O, question: Question<O>, options?: ShrinkOptions & { engine?: string }):
    Promise<{ input: Questions[O]; candidates: number; finished: boolean }>;
  /** Ends the worker; calls that it has not answered fail. */
  terminate(): void | Promise<number>;
}
/** A new instance of the module in a worker: a slow answer stalls nothing. */
export default function inWorker(): Promise<InWorker>;
