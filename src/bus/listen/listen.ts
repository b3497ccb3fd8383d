import { toHex } from '../../modbus/index.ts';
import type { JobParts, RunningJob } from '../jobs/job.ts';
import { lineTimes } from '../transaction/rules.ts';
import { Conversation } from './conversation.ts';
import type { HeardNews } from './heard.ts';
import { type HeardPiece, StreamSplitter } from './stream-splitter.ts';

/** How long after its first byte a piece is split, in milliseconds, even on a line that is never silent. */
const SOON = 250;

/** Splits what others send on the line, pairs it, logs it and counts it, until it is stopped or the line is closed. */
export function startListening({ client, clock, link, log, tell }: JobParts<HeardNews>): RunningJob {
  const splitter = new StreamSplitter();
  const conversation = new Conversation();
  let offSilence = () => {};
  let offSoon: (() => void) | undefined;
  let settle = () => {};
  const ended = new Promise<void>((resolve) => {
    settle = resolve;
  });

  const take = (pieces: readonly HeardPiece[]) => {
    if (pieces.length === 0) return;
    for (const piece of pieces) {
      const line = { time: clock.origin + piece.at, hex: toHex(piece.bytes) };
      conversation.add(piece, (said) => log({ ...line, ...said }));
    }
    tell(conversation.news);
  };
  const stopWaiting = () => {
    offSilence();
    offSoon?.();
    offSoon = undefined;
  };
  const finish = () => {
    off();
    stopWaiting();
    take(splitter.end());
    settle();
  };
  const off = link.listen((event) => {
    if (event.kind === 'state' && event.state.kind !== 'open') finish();
    if (event.kind !== 'received' || link.state.kind !== 'open') return;
    take(splitter.add(event.bytes, event.at));
    offSoon ??= clock.after(SOON, () => {
      offSoon = undefined;
      take(splitter.split());
    });
    offSilence();
    offSilence = clock.after(lineTimes(link.state.settings, client.rules).silence, () => {
      stopWaiting();
      take(splitter.end());
    });
  });
  tell(conversation.news);
  if (link.state.kind !== 'open') finish();
  return { stop: finish, ended };
}
