import { describe, expect, it } from 'vitest';
import { programTargets, targetOffer, writeProgram } from '../../../../src/codegen/index.ts';
import { decodeFrame, fromHex, type Transport } from '../../../../src/modbus/index.ts';
import {
  allPrograms,
  bytesByLine,
  draftOf,
  evaluate,
  firstDraft,
  offeredParts,
  offeredTargets,
  programForFrame,
  programForFrames,
  writtenProgram,
} from '../../../../src/workbench/index.ts';

const bytes = (hex: string) => fromHex(hex.replaceAll(' ', '')) ?? new Uint8Array();

/** The draft of a frame as it was received. */
function draft(
  hex: string,
  direction: 'request' | 'response' = 'request',
  request?: string,
  transport: Transport = 'rtu',
) {
  const asked = request === undefined ? undefined : bytes(request);
  return draftOf(decodeFrame(bytes(hex), { transport, direction, request: asked }), asked);
}

const forDraft = (of: ReturnType<typeof draft>) => programForFrame(of, evaluate(of).frame);

/** Set the reference of unit 6 to 30 Hz, and read three registers of unit 17 (SL 2.5.1, AP 6.3 and 6.6). */
const WRITE = '06 06 02 AB 10 00 F5 E5';
const READ = '11 03 00 6B 00 03 76 87';
const REPLY = '11 03 06 AE 41 56 52 43 40 49 AD';

describe('the program of a frame', () => {
  it('is that of its request', () => {
    expect(forDraft(draft(WRITE))).toMatchObject({
      kind: 'subject',
      transport: 'rtu',
      subject: { request: { unitId: 6, functionCode: 6, fields: { address: 683, value: 4096 } } },
    });
    expect(forDraft(draft(REPLY, 'response', READ))).toMatchObject({
      kind: 'subject',
      subject: { request: { direction: 'request', unitId: 17, functionCode: 3, fields: { startAddress: 107 } } },
    });
  });

  it('sends the bytes of the frame, also those that are forced', () => {
    for (const hex of [WRITE, '06 06 02 AB 10 00 E6 A1', '11 41 01 02 03 E5 53']) {
      const wanted = forDraft(draft(hex));
      if (wanted.kind !== 'subject') throw new Error(wanted.why);
      const text = writeProgram('c', wanted.subject, { part: 'bytes', comments: false }).files[0]?.text ?? '';
      expect([...text.matchAll(/0x([\dA-F]{2})\b/g)].map(([, byte]) => byte).join(' ')).toBe(hex);
    }
  });

  it('is not there for what sends nothing', () => {
    expect(programForFrame(firstDraft, undefined)).toEqual({ kind: 'none', why: 'no-frame' });
    expect(forDraft(draft('11 03 00 6B 00'))).toEqual({ kind: 'none', why: 'broken' });
    expect(forDraft(draft(REPLY, 'response'))).toEqual({ kind: 'none', why: 'no-request' });
  });
});

describe('one program of several frames', () => {
  it('has each request under its name', () => {
    const wanted = programForFrames([
      { name: 'set 30 Hz', draft: draft(WRITE) },
      { name: 'levels', draft: draft(REPLY, 'response', READ) },
    ]);
    if (wanted.kind !== 'subject') throw new Error(wanted.why);
    const text = writeProgram('c', wanted.subject).files[0]?.text ?? '';
    expect(text).toMatch(/build_set_30_hz\(/);
    expect(text).toMatch(/build_levels\(/);
    expect(text.match(/^(static )?uint16_t crc\(.*\)$/gm)).toHaveLength(1);
  });

  it('is not there for frames of two transports, and of what is not a request', () => {
    const tcp = draft('00 01 00 00 00 06 11 03 00 6B 00 03', 'request', undefined, 'tcp');
    const both = [
      { name: 'one', draft: draft(WRITE) },
      { name: 'two', draft: tcp },
    ];
    expect(programForFrames(both)).toEqual({ kind: 'none', why: 'mixed' });
    expect(programForFrames([{ name: 'one', draft: draft(REPLY, 'response') }])).toEqual({
      kind: 'none',
      why: 'no-requests',
    });
    expect(programForFrames([])).toEqual({ kind: 'none', why: 'no-requests' });
  });
});

describe('targets', () => {
  it('all belong to a group, and write what they offer without a note that it is not offered', () => {
    const wanted = forDraft(draft(WRITE));
    if (wanted.kind !== 'subject') throw new Error(wanted.why);
    for (const { id } of programTargets) {
      expect(targetOffer(id).group, `the group of ${id} (codegen/offers.ts)`).toBeDefined();
      if (!targetOffer(id).transports.includes('rtu')) continue;
      for (const part of offeredParts(id, false)) {
        const notes = writtenProgram(id, wanted.subject, { part })?.notes.map(({ code, what }) => [code, what]);
        expect(notes, id).not.toContainEqual(['not-offered', part]);
      }
    }
  });

  it('that cannot speak on a transport are told', () => {
    for (const { id, able } of offeredTargets('tcp', false))
      expect(able).toBe(targetOffer(id).transports.includes('tcp'));
  });

  it('are saved together, each in a folder of its own', () => {
    const wanted = forDraft(draft(WRITE));
    if (wanted.kind !== 'subject') throw new Error(wanted.why);
    const files = allPrograms(wanted, {});
    const able = offeredTargets('rtu', false).filter((target) => target.able);
    expect(new Set(files.map(({ path }) => path.split('/')[0]))).toEqual(new Set(able.map(({ id }) => id)));
    expect(new Set(files.map(({ path }) => path)).size).toBe(files.length);
  });
});

describe('the lines of a program', () => {
  it('have the bytes that they make', () => {
    const frame = draft(WRITE);
    const { reading } = evaluate(frame).frame ?? {};
    const wanted = forDraft(frame);
    if (wanted.kind !== 'subject' || reading === undefined) throw new Error('no program');
    const program = writeProgram('c', wanted.subject, { part: 'build', comments: false });
    const text = program.files[0]?.text.split('\n') ?? [];
    const made = Array.from(bytesByLine(program, 0, reading), ([line, { from, to }]) => [
      text[line - 1]?.trim(),
      from,
      to,
    ]);
    expect(made).toEqual([
      ['frame[length++] = unit;', 0, 1],
      ['frame[length++] = 0x06;', 1, 2],
      ['frame[length++] = (uint8_t)(address >> 8);', 2, 4],
      ['frame[length++] = (uint8_t)address;', 2, 4],
      ['frame[length++] = (uint8_t)(value >> 8);', 4, 6],
      ['frame[length++] = (uint8_t)value;', 4, 6],
      ['frame[length++] = (uint8_t)checksum;', 6, 8],
      ['frame[length++] = (uint8_t)(checksum >> 8);', 6, 8],
    ]);
    expect(bytesByLine(program, 1, reading).size).toBe(0);
  });
});
