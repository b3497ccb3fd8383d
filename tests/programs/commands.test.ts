import { chmodSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import type { ProgramOptions } from '../../src/codegen/options.ts';
import { writeFor } from '../../src/codegen/program.ts';
import type { Target } from '../../src/codegen/target.ts';
import { mbpoll, modpoll, printf, shellWord } from '../../src/codegen/targets/commands.ts';
import { encodeFrame, type FrameInput, toHex } from '../../src/modbus/index.ts';
import { programCases, repliesTo } from './cases.ts';
import { PEER_PORT, SLAVE_PORT } from './line.ts';
import { Peer } from './peers/peers.ts';
import { slaveCases, startSlave, toNobody } from './peers/slave.ts';
import { emptyFolder, expectProved, run, withTools } from './tools.ts';

const folder = emptyFolder('commands');

/** Time-outs in milliseconds: the longest that mbpoll has, and of `printf`, which waits to its end. */
const LONG = 10_000;
const MIDDLE = 3000;

/** Writes a script and runs it. */
async function runScript(
  target: Target,
  name: string,
  request: FrameInput,
  options: ProgramOptions,
  ...given: string[]
) {
  const { files, notes } = writeFor(target, { request }, options);
  const file = join(folder, `${target.id}_${name.replaceAll(' ', '_')}.sh`);
  writeFileSync(file, files[0]?.text ?? '');
  chmodSync(file, 0o755);
  return { ...(await run(file, given)), isOffered: !notes.some(({ code }) => code === 'not-offered') };
}

const read = (unitId: number, transport: FrameInput['transport'] = 'rtu'): FrameInput => ({
  transport,
  direction: 'request',
  unitId,
  functionCode: 0x03,
  fields: { startAddress: 681, quantity: 2 },
});

withTools(['mbpoll', 'python3', 'python'], () => {
  let peer: Peer;
  beforeAll(async () => {
    peer = await Peer.start();
  });
  afterAll(() => peer.end());
  const options = (timeout = LONG): ProgramOptions => ({
    timeout,
    line: { parity: 'none' },
    server: { port: PEER_PORT },
  });

  const mbpollCases = (transport: 'rtu' | 'tcp') =>
    programCases(transport, 0).filter(
      ({ request }) => !writeFor(mbpoll, { request }, options()).notes.some(({ code }) => code === 'not-offered'),
    );
  const printfCases = (transport: 'rtu' | 'ascii' | 'tcp') =>
    programCases(transport, 0).slice(0, transport === 'rtu' ? undefined : 12);

  describe('mbpoll', () => {
    test.each(['rtu', 'tcp'] as const)('sends the bytes of every request that it offers by %s', async (transport) => {
      for (const { name, request } of mbpollCases(transport)) {
        const sent = encodeFrame(request);
        const good = repliesTo(request).find(({ what }) => what === 'good')?.bytes;
        await peer.expect(sent, good, { sameTransaction: transport === 'tcp' });
        const given = [transport === 'rtu' ? peer.port : peer.host];
        const { code, out, err } = await runScript(mbpoll, `${transport} ${name}`, request, options(), ...given);
        const own = transport === 'tcp' ? 4 : 0;
        expect([name, (await peer.got(sent.length)).slice(own)]).toEqual([name, toHex(sent).slice(own)]);
        expect([name, code, out + err]).toEqual([name, 0, out + err]);
      }
      const offered = new Set(mbpollCases(transport).map(({ request }) => request.functionCode ?? 0));
      expect([...offered].sort((one, other) => one - other)).toEqual([1, 2, 3, 4, 5, 6, 15, 16]);
    });

    test('says that nothing came', async () => {
      await peer.expect(encodeFrame(read(6)), undefined);
      const { out, err } = await runScript(mbpoll, 'no reply', read(6), options(100), peer.port);
      expect(out + err).toMatch(/timed out/);
    });

    test('says what it cannot send, and in which bytes', async () => {
      const request = { ...read(17), functionCode: 0x07, fields: {} };
      const { code, err, isOffered } = await runScript(mbpoll, 'not offered', request, options());
      expect([code, isOffered, err]).toEqual([0, false, 'mbpoll cannot send 11 07 4C 22\n']);
    });
  });

  describe('printf', () => {
    test.each(['rtu', 'ascii', 'tcp'] as const)('sends the bytes of every request by %s', async (transport) => {
      for (const { name, request } of printfCases(transport)) {
        const sent = encodeFrame(request);
        await peer.expect(sent, undefined);
        const given = [transport === 'tcp' ? peer.host : peer.port];
        await runScript(printf, `${transport} ${name}`, request, { ...options(), part: 'bytes' }, ...given);
        expect([name, await peer.got(sent.length)]).toEqual([name, toHex(sent)]);
      }
    });

    test.each(['rtu', 'tcp'] as const)('prints what comes back by %s', async (transport) => {
      const given = [transport === 'tcp' ? peer.host : peer.port];
      const request = read(6, transport);
      const reply = encodeFrame({ ...request, direction: 'response', fields: { registers: [0x1234, 7] } });
      await peer.expect(encodeFrame(request), reply);
      const { out } = await runScript(printf, `${transport} reply`, request, options(MIDDLE), ...given);
      expect(out.replace(/\s/g, '').toUpperCase()).toBe(toHex(reply));
      await peer.expect(encodeFrame(request), undefined);
      expect((await runScript(printf, `${transport} no reply`, request, options(100), ...given)).out).toBe('');
    });
  });

  test('mbpoll and printf are said to have sent what they sent', () => {
    const sent = {
      mbpoll: (['rtu', 'tcp'] as const).flatMap(mbpollCases),
      printf: (['rtu', 'ascii', 'tcp'] as const).flatMap(printfCases),
    };
    for (const target of ['mbpoll', 'printf'] as const)
      expectProved(target, { how: 'sent', frames: sent[target].length });
  });
});

withTools(['mbpoll', 'libmodbus'], () => {
  const options = { timeout: LONG, line: { parity: 'none' }, server: { port: SLAVE_PORT } } as const;
  test.each(['rtu', 'tcp'] as const)('libmodbus answers mbpoll and printf by %s', async (transport) => {
    const slave = await startSlave();
    const where = transport === 'tcp' ? slave.host : slave.serial;
    const [, , registers] = slaveCases(transport);
    if (registers === undefined) throw new Error('no request');
    for (const { name, request } of slaveCases(transport, [1, 2, 3, 4, 5, 6, 15, 16])) {
      const { code, out } = await runScript(mbpoll, `slave ${transport} ${name}`, request, options, where);
      expect([name, code === 0]).toEqual([name, name !== 'beyond the last']);
      if (name === registers.name) expect(out).toMatch(/\[8\]:\s+1008\n\[9\]:\s+1009\n/);
    }
    const mute = await runScript(
      mbpoll,
      `nobody ${transport}`,
      toNobody(transport),
      { ...options, timeout: 100 },
      where,
    );
    expect(mute.out + mute.err).toMatch(/timed out/);
    const reply = toHex(
      encodeFrame({ ...registers.request, direction: 'response', fields: { registers: [1008, 1009] } }),
    );
    const { out } = await runScript(
      printf,
      `slave ${transport}`,
      registers.request,
      { ...options, timeout: MIDDLE },
      where,
    );
    expect(out.replace(/\s/g, '').toUpperCase()).toBe(reply);
    slave.end();
  });
});

describe('scripts', () => {
  const nasty = [
    "'; touch broken; '",
    '$(touch broken)',
    '`touch broken`',
    '"; touch broken; "',
    'a\ntouch broken',
    '\\',
    "it's",
  ];

  test('what stands in quotes stays there', async () => {
    for (const text of nasty) {
      const { out } = await run('sh', ['-c', `printf %s ${shellWord(text)}`], { cwd: folder });
      expect(out).toBe(text.replace('\n', ' '));
    }
  });

  test('no name, port or host of the user breaks out', async () => {
    for (const target of [mbpoll, modpoll, printf]) {
      for (const text of nasty) {
        for (const transport of ['rtu', 'tcp'] as const) {
          const options = { name: text, line: { port: text }, server: { host: text }, timeout: 20 };
          const [file] = writeFor(target, { request: read(6, transport) }, options).files;
          // Nothing but the shell itself is found, so that no command does anything.
          const { out } = await run(
            'bash',
            ['-c', `PATH=; touch() { echo BROKEN; }; exec() { :; }; ${file?.text ?? ''}`],
            { cwd: folder },
          );
          expect(out).not.toContain('BROKEN');
        }
      }
    }
  });

  test('modpoll is told the reference, the table and the values', () => {
    const text = (request: FrameInput) => writeFor(modpoll, { request }, { comments: false }).files[0]?.text;
    expect(text(read(6))).toBe(
      `#!/bin/sh\n\nport='/dev/ttyUSB0'\n[ $# -eq 0 ] || port=$1\n\nmodpoll -m rtu -a 6 -b 19200 -d 8 -p even -s 1 -o 1.00 -0 -1 -t 4 -r 681 -c 2 "$port"\n`,
    );
    const write = { ...read(6, 'tcp'), functionCode: 0x10, fields: { startAddress: 1, registers: [3, 65535] } };
    expect(text(write)).toContain('modpoll -m tcp -a 6 -p 502 -o 1.00 -0 -1 -t 4 -r 1 "$host" 3 65535\n');
    const single = writeFor(modpoll, { request: { ...read(6), functionCode: 0x06, fields: { address: 1, value: 3 } } });
    expect(single.notes).toContainEqual(expect.objectContaining({ code: 'not-offered' }));
  });
});
