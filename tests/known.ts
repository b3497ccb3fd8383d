/** What the tests in browsers know of the source: its words, and what they fill the page with. `scripts/known.mjs` builds it. */
export { defaultRules } from '../src/bus/index.ts';
export { writeTraceJson } from '../src/captures/index.ts';
export { languages } from '../src/words/index.ts';
export { demoLog, recordsOfLines } from '../src/workbench/index.ts';
