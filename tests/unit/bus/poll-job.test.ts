import { describe, expect, it } from 'vitest';
import { BusClient, type PollSample } from '../../../src/bus/index.ts';
import { startJob } from '../../../src/bus/jobs/index.ts';
import { fromHex } from '../../../src/modbus/index.ts';
import { ScriptedLink } from './scripted-link.ts';
import { VirtualClock } from './virtual-clock.ts';

const bytes = (hex: string) => fromHex(hex) as Uint8Array;
// unit, function code, start address, quantity, CRC
const first = bytes('0103000A0002E409');
const second = bytes('010300140001C40E');
// unit, function code, byte count, registers, CRC
const answer = { bytes: bytes('01030403F203F31B31'), after: 30 };
const other = { bytes: bytes('01030203FCB8F5'), after: 30 };

function poll(interval: number, rounds: number) {
  const clock = new VirtualClock();
  const link = new ScriptedLink(clock);
  for (let round = 0; round < rounds; round++) link.replies.push([answer], [other]);
  const samples: PollSample[] = [];
  const client = new BusClient(link, clock, { timeout: 200 });
  const job = startJob(
    { kind: 'poll', requests: [first, second], interval },
    {
      client,
      clock,
      link,
      reopen: () => Promise.resolve(false),
      log: () => 0,
      tell: (news) => news.kind === 'sample' && samples.push(news),
    },
  );
  return { clock, link, samples, job };
}

describe('a poll', () => {
  it('sends its requests in rounds, from beginning to beginning', async () => {
    const { clock, link, samples, job } = poll(500, 3);
    await clock.advance(1400);
    job.stop();
    await clock.until(job.ended);
    expect(link.written.map(({ bytes: sent }) => sent)).toEqual([first, second, first, second, first, second]);
    const starts = link.written.filter((_, index) => index % 2 === 0).map(({ at }) => at);
    for (const [round, at] of starts.entries()) expect(Math.abs(at - round * 500)).toBeLessThan(10);
    expect(samples.map(({ round, index }) => [round, index])).toEqual([
      [0, 0],
      [0, 1],
      [1, 0],
      [1, 1],
      [2, 0],
      [2, 1],
    ]);
    expect(samples[0]).toMatchObject({ outcome: 'reply', verdict: 'good', reply: answer.bytes });
  });

  it('goes on behind a device that is silent', async () => {
    const { clock, samples, job } = poll(500, 1);
    await clock.advance(1200);
    job.stop();
    await clock.until(job.ended);
    expect(samples.map(({ outcome }) => outcome).slice(0, 4)).toEqual(['reply', 'reply', 'silent', 'silent']);
  });

  it('says the code of an exception', async () => {
    const clock = new VirtualClock();
    const link = new ScriptedLink(clock);
    // unit, function code with the bit of an exception, exception code, CRC
    const refusal = { bytes: bytes('018302C0F1'), after: 30 };
    link.replies.push([refusal], [other]);
    const samples: PollSample[] = [];
    const job = startJob(
      { kind: 'poll', requests: [first, second], interval: 500 },
      {
        client: new BusClient(link, clock, { timeout: 200 }),
        clock,
        link,
        reopen: () => Promise.resolve(false),
        log: () => 0,
        tell: (news) => news.kind === 'sample' && samples.push(news),
      },
    );
    await clock.advance(400);
    job.stop();
    await clock.until(job.ended);
    expect(samples.map(({ outcome, exceptionCode }) => [outcome, exceptionCode])).toEqual([
      ['exception', 2],
      ['reply', undefined],
    ]);
  });

  it.each([
    ['while a reply is waited for', 510, 'lost'],
    ['between two rounds', 300, 'not-sent'],
  ] as const)('ends when the line is lost %s', async (_, at, outcome) => {
    const { clock, link, samples, job } = poll(500, 5);
    await clock.advance(at);
    link.lose();
    await clock.until(job.ended);
    expect(samples.at(-1)).toMatchObject({ round: 1, index: 0, outcome });
    expect(samples).toHaveLength(3);
  });
});
