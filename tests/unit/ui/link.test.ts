import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import type { Draft } from '../../../src/workbench/frame/draft.ts';
import { evaluate } from '../../../src/workbench/frame/evaluate.ts';
import { readLink, writeLink } from '../../../src/workbench/frame/link.ts';

const draft: Draft = {
  transport: 'rtu',
  kind: 'request',
  texts: { unitId: '6', functionCode: '6', address: '0x02AB', value: '4096' },
  force: {},
  answering: '',
};

const linkOf = (given: Draft) => writeLink(given, evaluate(given).controls);

describe('the link to a draft', () => {
  test('holds what was typed, as it was typed', () => {
    expect(linkOf(draft)).toBe('rtu/request?unitId=6&functionCode=6&address=0x02AB&value=4096');
  });

  test('holds forced values, groups and the request that is answered', () => {
    const reply: Draft = {
      transport: 'tcp',
      kind: 'reply',
      texts: { unitId: '255', functionCode: '21', subRequests: '1', 'subRequests[0].recordData': '1 2' },
      force: { length: '9' },
      answering: '00 01',
    };
    expect(linkOf(reply)).toBe(
      'tcp/reply?unitId=255&functionCode=21&subRequests=1&subRequests[0].recordData=1+2&force.length=9&answering=00+01',
    );
    expect(readLink(`#${linkOf(reply)}`)).toEqual({ draft: reply, unknown: [] });
  });

  test('brings any texts back, invalid ones too', () => {
    const text = fc.string({ unit: 'binary' });
    fc.assert(
      fc.property(
        fc.constantFrom('rtu', 'ascii', 'tcp', 'pdu'),
        text,
        text,
        fc.option(text, { nil: undefined }),
        (transport, unitId, value, checksum) => {
          const given: Draft = {
            ...draft,
            transport,
            texts: { unitId, functionCode: '6', address: '', value },
            force: checksum === undefined ? {} : { checksum },
          };
          expect(readLink(`#${linkOf(given)}`)).toEqual({ draft: given, unknown: [] });
        },
      ),
    );
  });

  test('any text at all is read without an error, and parts that mean nothing are named', () => {
    fc.assert(
      fc.property(fc.string(), (text) => {
        const read = readLink(`#${text}`);
        if (read) expect(() => evaluate(read.draft)).not.toThrow();
      }),
    );
    expect(readLink('')).toBeUndefined();
    expect(readLink('#rtu/question?unitId=9&%25=1')).toMatchObject({
      draft: { transport: 'rtu', kind: 'request', texts: { unitId: '9' } },
      unknown: ['rtu/question', '%'],
    });
    expect(readLink('#rtu/request?constructor=1&force.__proto__=2')?.unknown).toEqual([
      'constructor',
      'force.__proto__',
    ]);
  });
});

describe('a draft comes to a frame, or to reasons', () => {
  test('the first draft', () => {
    const { frame, errors } = evaluate(draft);
    expect(errors.size).toBe(0);
    expect(Array.from(frame!.bytes)).toEqual([0x06, 0x06, 0x02, 0xab, 0x10, 0x00, 0xf5, 0xe5]);
  });

  test('every wrong text is named, and there are no bytes', () => {
    const { frame, errors } = evaluate({ ...draft, texts: { ...draft.texts, unitId: '256', value: 'x' } });
    expect(frame).toBeUndefined();
    expect([...errors.keys()].sort()).toEqual(['unitId', 'value']);
  });

  test('any texts whatever give a frame or an error, never both and never neither', () => {
    const texts = fc.record({
      unitId: fc.string(),
      functionCode: fc.oneof(fc.integer({ min: 0, max: 255 }).map(String), fc.string()),
      startAddress: fc.string(),
      registers: fc.string(),
      subRequests: fc.string(),
    });
    const kind = fc.constantFrom('request', 'reply', 'exception');
    fc.assert(
      fc.property(texts, kind, (given, as) => {
        const { frame, errors } = evaluate({ ...draft, kind: as, texts: given });
        expect(frame === undefined).toBe(errors.size > 0);
      }),
      { numRuns: 300 },
    );
  });
});
