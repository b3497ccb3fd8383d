import { describe, expect, it } from 'vitest';
import { type ChunkLabel, readBytes } from '../../../src/notation/index.ts';

type Says = Pick<ChunkLabel, 'direction' | 'transport'>;

/** What is said of the bytes 01 03 02 behind these words. */
function saidBy(before: string): Says {
  const { bytes, chunks } = readBytes(`${before} 01 03 02`);
  expect([...bytes], before).toEqual([1, 3, 2]);
  expect(chunks, before).toHaveLength(1);
  const { direction, transport } = chunks[0] ?? {};
  return { ...(direction && { direction }), ...(transport && { transport }) };
}

const tx: Says = { direction: 'tx' };
const rx: Says = { direction: 'rx' };
const request: Says = { direction: 'request' };
const response: Says = { direction: 'response' };

/** What each word or arrow in front of bytes says of them. */
const table: readonly (readonly [says: Says, ...words: string[]])[] = [
  // An arrow to the right is what the writer of the log sent, one to the left what came back.
  [tx, '->', '-->', '=>', '==>', '>>', '>>>', '>>:'],
  [rx, '<-', '<--', '<=', '<==', '<<', '<<<', '<<:'],
  [tx, 'tx', 'TX', 'txd', 'send', 'sent', 'sends', 'sending', 'transmit', 'transmitted', 'transmitting'],
  [tx, 'written', 'writing', 'Tx:', '[TX]', 'TX>', 'Sent:'],
  [rx, 'rx', 'RX', 'rxd', 'recv', 'recvd', 'receive', 'received', 'receives', 'receiving', 'Rx:', '[RX]', 'RX>'],
  [request, 'request', 'Request:', 'req', 'query', 'indication'],
  [response, 'response', 'Response:', 'resp', 'rsp', 'reply', 'replied', 'answer'],
  [{ transport: 'rtu' }, 'rtu', 'RTU:'],
  [{ transport: 'tcp' }, 'tcp', 'TCP:', 'mbap'],
  [{ transport: 'ascii' }, 'ascii', 'ASCII:'],
  // These mean other things too, and say something only where a colon or a bracket ends them.
  [tx, 'write:', 'out:', 'T:', 'W:', '[out]', 'out>'],
  [rx, 'read:', 'in:', 'R:', '[in]', 'in>'],
  [request, 'master:', 'client:', 'poll:', 'Q:', '[master]'],
  [response, 'slave:', 'server:', 'confirmation:', '[slave]'],
  [{}, 'write', 'out', 't', 'w', 'read', 'in', 'r', 'master', 'client', 'poll', 'q', 'slave', 'server', 'confirmation'],
  // The last word counts, and each of a direction and a transport is kept.
  [{ direction: 'tx', transport: 'tcp' }, 'TCP ->', 'TX tcp', '-> tcp'],
  [{ direction: 'rx', transport: 'rtu' }, '<- RTU:', 'rtu received'],
];

describe('what stands in front of the bytes of a log says their direction', () => {
  it.each(table.flatMap(([says, ...words]) => words.map((word) => ({ word, says }))))('$word', ({ word, says }) => {
    expect(saidBy(word)).toEqual(says);
  });

  it('one arrow in each line, as terminal programs write them', () => {
    const { chunks } = readBytes('-> 01 03 00 00 00 01\n<- 01 03 02 00 05');
    expect(chunks).toEqual([
      { from: 0, to: 6, direction: 'tx' },
      { from: 6, to: 11, direction: 'rx' },
    ]);
  });
});
