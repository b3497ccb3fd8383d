import { TraceView, type TraceWorker } from '../../../src/store/index.ts';
import {
  demoLog,
  type How,
  TraceDesk,
  type TraceFrame,
  type TraceRow,
  type TraceSource,
  type TraceTask,
} from '../../../src/workbench/index.ts';

export type TestFile = { readonly name: string; readonly text: string };

/** A trace whose worker is played: tasks wait until `work` is called. */
export function playedTrace() {
  const shown: { readonly frame: TraceFrame; readonly how: How }[] = [];
  const workers: { tasks: TraceTask<TestFile>[]; end: () => void; alive: boolean; work: (most?: number) => void }[] =
    [];
  const view = new TraceView<TestFile>({
    start: (take, ended): TraceWorker<TestFile> => {
      const later: (() => void)[] = [];
      const desk = new TraceDesk(
        (answer) => worker.alive && take(structuredClone(answer)),
        (act) => later.push(act),
      );
      // The reader is an hour ahead of UTC.
      desk.zone = () => 3_600_000_000;
      const bytesOf = (text: string) => new TextEncoder().encode(text);
      const textOf = (source: TraceSource<TestFile>) =>
        source.kind === 'own' ? demoLog() : source.kind === 'text' ? source.text : source.file.text;
      const worker = {
        tasks: [] as TraceTask<TestFile>[],
        alive: true,
        end: () => {
          worker.alive = false;
          ended('died');
        },
        work: () => {
          for (let task = worker.tasks.shift(); task || later.length > 0; task = worker.tasks.shift()) {
            if (task === undefined) later.shift()?.();
            else if (task.kind !== 'open') desk.take(task);
            else desk.open(bytesOf(textOf(task.source)));
          }
        },
      };
      workers.push(worker);
      return {
        post: (task) => worker.tasks.push(structuredClone(task)),
        end: () => {
          worker.alive = false;
        },
      };
    },
    show: (frame, how) => shown.push({ frame, how }),
  });
  const work = () => workers.at(-1)?.work();
  const rows = (): readonly (TraceRow | undefined)[] => {
    const all = () => Array.from({ length: view.rowsKept.value }, (_, row) => view.row(row));
    all();
    work();
    return all();
  };
  return { view, workers, work, rows, shown };
}
