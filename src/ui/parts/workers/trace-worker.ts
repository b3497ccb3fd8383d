import { languages, languageTag } from '../../../words/index.ts';
import { type TraceAnswer, TraceDesk, type TraceTask } from '../../../workbench/index.ts';
import { readSource } from './trace-source.ts';
import { sayAlive } from './worker-alive.ts';

const { postMessage } = globalThis as unknown as Worker;

/** What is to be done after the tasks that wait: a message to itself waits behind them, and no longer, as a timer would. */
const acts: (() => void)[] = [];
const { port1, port2 } = new MessageChannel();
port1.onmessage = () => acts.shift()?.();
function later(act: () => void): void {
  acts.push(act);
  port2.postMessage(undefined);
}

/** Holds a trace off the main thread. */
const desk = new TraceDesk((answer) => {
  if (answer.kind !== 'exported') postMessage(answer);
  // The pieces of a file are handed over as one, without a copy.
  else postMessage({ ...answer, parts: [new File([...answer.parts], '')] } satisfies TraceAnswer<File>);
}, later);

const MILLISECOND = 1000;
const MINUTE = 60_000_000;
desk.zone = (time) => -new Date(time / MILLISECOND).getTimezoneOffset() * MINUTE;

/** A filter looks into what the rows say; without the words it finds nothing there. */
const language = languages[languageTag(navigator.languages)];
const worded = language.trace().then(
  ({ sentence }) => {
    desk.says = sentence;
  },
  () => undefined,
);

async function reportWords() {
  const words = await language.trace();
  const make = await words.report();
  return make(words);
}

/** Tasks are done in their order, also behind a file that is being read. */
let before: Promise<void> = worded;
addEventListener('message', ({ data }: MessageEvent<TraceTask<File>>) => {
  // An error that nobody hears would leave all that comes behind it undone.
  before = before.then(() => take(data)).catch(reportError);
});
sayAlive();

async function take(task: TraceTask<File>): Promise<void> {
  if (task.kind === 'export' && task.wanted.format === 'report')
    desk.report ??= await reportWords().catch(() => undefined);
  if (task.kind !== 'open') return desk.take(task);
  const bytes = await readSource(task.source);
  if (typeof bytes === 'string') postMessage({ kind: 'failed', code: bytes });
  else desk.open(bytes);
}
