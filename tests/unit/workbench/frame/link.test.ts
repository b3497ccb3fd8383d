import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { brokenLink } from '../../../../src/workbench/frame/broken-link.ts';
import { type Draft, firstDraft } from '../../../../src/workbench/frame/draft.ts';
import { evaluate, requestOf } from '../../../../src/workbench/frame/evaluate.ts';
import { readInFull, readLink, writeLink } from '../../../../src/workbench/frame/link.ts';
import { anyCharacter } from '../../any-character.ts';

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
    const text = fc.string({ unit: anyCharacter });
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
  });

  test('a request has no request that it answers in its link', () => {
    const reply: Draft = { ...draft, kind: 'reply', answering: '06 06 02 AB 10 00 F5 E5' };
    expect(linkOf(reply)).toMatch(/&answering=06\+06\+02\+AB\+10\+00\+F5\+E5$/);
    expect(linkOf({ ...reply, kind: 'request' })).toBe('rtu/request?unitId=6&functionCode=6&address=0x02AB&value=4096');
  });

  test('names that every object has are names like others', () => {
    const unknown = ['toString', 'colour', '__proto__', '_colour'];
    expect(readLink('#rtu/request?toString=1&colour=1&__proto__=1&_colour=1')?.unknown).toEqual(unknown);
    for (const name of ['constructor', 'toString', 'hasOwnProperty', 'valueOf', 'isPrototypeOf']) {
      // As a value that nothing can be forced to.
      const { draft: read, unknown } = readLink(`#rtu/request?v=2&functionCode=6&force.${name}=2&typed.${name}=3`)!;
      expect(unknown).toEqual([`force.${name}`, `typed.${name}`]);
      expect(read.force).toEqual({});
      expect(evaluate(read).frame).toBeDefined();
      expect(linkOf(read)).toBe('rtu/request?functionCode=6');
    }
  });
});

describe('the parts of a link', () => {
  const textsOf = (query: string) => readLink(`#rtu/request?${query}`)!.draft.texts;
  const unknownOf = (query: string) => readLink(`#rtu/request?${query}`)!.unknown;

  test.each([
    ['#rtx/request?unitId=9', 'rtu', 'request', { unitId: '9' }, ['rtx/request']],
    ['#tcp/question?unitId=9', 'tcp', 'request', { unitId: '9' }, ['tcp/question']],
    ['#tcp', 'tcp', 'request', {}, ['tcp']],
    ['#tcp?unitId=9', 'tcp', 'request', { unitId: '9' }, ['tcp']],
    ['#pdu/exception', 'pdu', 'exception', {}, []],
    ['ascii/reply?unitId=9', 'ascii', 'reply', { unitId: '9' }, []],
    ['tcp/reply?data=#1', 'tcp', 'reply', { data: '#1' }, []],
    ['#tcp/reply?data=a?b=c/d', 'tcp', 'reply', { data: 'a?b=c/d' }, []],
    ['#?unitId=9', 'rtu', 'request', { unitId: '9' }, ['']],
    ['#/reply?unitId=9', 'rtu', 'reply', { unitId: '9' }, ['/reply']],
    ['#rtu/reply?unitId&answering', 'rtu', 'reply', { unitId: '' }, []],
    ['#rtu/reply?&unitId=9&&', 'rtu', 'reply', { unitId: '9' }, []],
    ['#tcp/reply/x?unitId=9', 'tcp', 'request', { unitId: '9' }, ['tcp/reply/x']],
  ])('%s', (hash, transport, kind, texts, unknown) => {
    expect(readLink(hash)).toEqual({ draft: { transport, kind, texts, force: {}, answering: '' }, unknown });
  });

  test('without a transport and a text there is the first draft', () => {
    for (const hash of ['#values', '#x/request', '#x/request?answering=01', '#x?force.length=1']) {
      expect(readLink(hash)!.draft).toEqual(firstDraft);
      expect(readLink(hash)!.unknown.length).toBe(1);
    }
  });

  test('a name of a field is one that a function has, perhaps in a group', () => {
    for (const name of ['unitId', 'registers', 'subRequests[0].recordData', 'subRequests[34567].fileNumber']) {
      expect(textsOf(`${name}=1`)).toEqual({ [name]: '1' });
      expect(readLink(`#rtu/request?v=2&${name}=1&typed.${name}=2`)!.draft.typed).toEqual({
        [name]: { typed: '2', text: '1' },
      });
    }
    for (const name of [
      '',
      '9',
      '9a',
      '_a',
      'a-b',
      '-a',
      'a.b',
      'a[].b',
      'a[x].b',
      'a[0]',
      'a[0]b',
      'a[0].9',
      'a[0].-b',
      'a[0].b-',
      'a',
      'colour',
      'a[0].fileNumber',
      'subRequests[0].colour',
    ]) {
      expect(unknownOf(`${name}=1`)).toEqual([name]);
      expect(unknownOf(`v=2&typed.${name}=1`)).toEqual([`typed.${name}`]);
    }
    expect(unknownOf('a[0].b[0].c=1&.a[0].b=1')).toEqual(['a[0].b[0].c', '.a[0].b']);
  });

  test('a value is forced by a name behind "force.", and nothing else', () => {
    expect(readLink('#rtu/request?force.length=1')!.draft.force).toEqual({ length: '1' });
    expect(unknownOf('Force.length=1&xforce.length=1&force.=1&force.force.length=1')).toEqual([
      'Force.length',
      'xforce.length',
      'force.',
      'force.force.length',
    ]);
    expect(unknownOf('v=2&xtyped.unitId=1&typed.=1')).toEqual(['xtyped.unitId', 'typed.']);
  });

  test('a version is a whole number from 1 of at most nine digits, or else a name without a meaning', () => {
    for (const v of ['0', '01', 'x1', '1x', '-1', '1.5', '', '1234567890']) {
      expect(readLink(`#rtu/request?v=${v}`)).toEqual({
        draft: { transport: 'rtu', kind: 'request', texts: {}, force: {}, answering: '' },
        unknown: ['v'],
      });
    }
    expect(readLink('#rtu/request?v=1')).toEqual({
      draft: { transport: 'rtu', kind: 'request', texts: {}, force: {}, answering: '' },
      unknown: [],
    });
    expect(readLink('#rtu/request?v=123456789')).toMatchObject({ newer: 123_456_789, draft: { texts: {} } });
    expect(readLink('#rtu/request?v=6&unitId=1&v=7')).toMatchObject({
      newer: 6,
      unknown: ['v'],
      draft: { texts: { unitId: '1' } },
    });
    expect(readLink('#rtu/request?w=3')!.newer).toBeUndefined();
  });

  test('what was typed has a place in a link of any version, with or without a text and a device', () => {
    const typedOf = (query: string) => readLink(`#rtu/request?${query}&typed.value=30+Hz`)!.draft;
    expect(typedOf('v=2').typed).toEqual({ value: { typed: '30 Hz', text: '' } });
    expect(typedOf('v=2').device).toBeUndefined();
    expect(typedOf('v=2&device=weg-drive').device).toBe('weg-drive');
    expect(typedOf('v=3&device=weg-drive').device).toBe('weg-drive');
    expect(typedOf('v=1&device=weg-drive')).toEqual(typedOf('device=weg-drive'));
    expect(typedOf('device=weg-drive')).toEqual(typedOf('v=3&device=weg-drive'));
    expect(readLink('#rtu/request?device=weg-drive')!.draft.device).toBe('weg-drive');
  });

  test('bytes that cannot be read are kept as they were typed', () => {
    const given: Draft = { ...draft, bytes: '06 0' };
    expect(linkOf(given)).toBe('rtu/request?unitId=6&functionCode=6&address=0x02AB&value=4096&bytes=06+0');
    expect(readLink(`#${linkOf(given)}`)).toEqual({ draft: given, unknown: [] });
    expect(linkOf({ ...draft, bytes: '' })).toMatch(/&bytes=$/);
  });

  test('an order: the envelope, the fields as they stand in the frame, what is forced, what is answered, bytes', () => {
    const given: Draft = {
      transport: 'tcp',
      kind: 'reply',
      texts: { value: '3', address: '2', functionCode: '6', unitId: '1', transactionId: '9', quantity: '7' },
      force: { length: '5' },
      answering: '01',
      bytes: 'x',
    };
    expect(linkOf(given)).toBe(
      'tcp/reply?transactionId=9&unitId=1&functionCode=6&address=2&value=3&force.length=5&answering=01&bytes=x',
    );
    expect(linkOf({ ...given, answering: '' })).not.toMatch(/answering/);
  });

  test('derived fields have none, unless they are forced', () => {
    const texts = { functionCode: '16', startAddress: '1', quantity: '9', byteCount: '9', registers: '1' };
    expect(linkOf({ ...draft, texts })).toBe('rtu/request?functionCode=16&startAddress=1&registers=1');
    expect(linkOf({ ...draft, texts, force: { byteCount: '3' } })).toBe(
      'rtu/request?functionCode=16&startAddress=1&registers=1&force.byteCount=3',
    );
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

describe('the request that a reply answers', () => {
  const asked = (answering: string, kind: Draft['kind'] = 'reply') => requestOf({ ...draft, kind, answering });

  test('is its bytes, or undefined', () => {
    expect(Array.from(asked(' 06 06 02 ab ')!)).toEqual([0x06, 0x06, 0x02, 0xab]);
    expect(Array.from(asked('06', 'exception')!)).toEqual([0x06]);
    for (const text of ['', '  ', '0', 'x']) expect(asked(text)).toBeUndefined();
    expect(asked('06', 'request')).toBeUndefined();
  });

  test('is an error where it is not bytes, and none where it is blank', () => {
    const errorsOf = (answering: string, kind: Draft['kind'] = 'reply') =>
      Object.fromEntries(evaluate({ ...draft, kind, answering }).errors);
    expect(errorsOf('x y')).toEqual({ answering: { code: 'not-octets', text: 'x y' } });
    expect(errorsOf('x', 'exception')).toMatchObject({ answering: { code: 'not-octets', text: 'x' } });
    for (const text of ['', '  ']) expect(errorsOf(text)).toEqual({});
    expect(errorsOf('x', 'request')).toEqual({});
  });
});

describe('a link that asks for too much', () => {
  test('names of forced values that no field has are unknown parts, the first of which are named', () => {
    const names = Array.from({ length: 100_000 }, (_, index) => `force.a${index}=1`);
    const reading = readLink(`#rtu/request?functionCode=6&force.checksum=0x1234&${names.slice(0, 500).join('&')}`)!;
    expect(reading.draft.force).toEqual({ checksum: '0x1234' });
    const said = brokenLink('#', reading);
    expect(said.unknown).toEqual(names.slice(0, 8).map((name) => name.slice(0, -2)));
    expect(said.more).toBe(492);
    expect(brokenLink('#', readLink(`#rtu/request?${names.slice(0, 20_000).join('&')}`)!).more).toBe(19_992);
    expect(readLink(`#rtu/request?${names.join('&')}`)).toMatchObject({ draft: firstDraft, tooLong: true });
  });

  test('every name that a broken frame forces is a name that a link can force', () => {
    for (const name of [
      'unitId',
      'length',
      'byteCount',
      'quantity',
      'rest',
      'after',
      'padding',
      'rawValue',
      'start',
      'data',
    ]) {
      expect(readLink(`#rtu/request?force.${name}=1`)?.draft.force).toEqual({ [name]: '1' });
    }
  });

  test('64 kB of data are a frame', () => {
    const { draft: read, unknown } = readLink(`#rtu/request?functionCode=99&data="${'A'.repeat(64_000)}"`)!;
    expect(unknown).toEqual([]);
    const { bytes } = evaluate(read).frame!;
    expect(bytes.length).toBe(1 + 1 + 64_000 + 2);
    expect(Array.from(bytes.subarray(0, 3))).toEqual([0x01, 0x63, 0x41]);
  });

  test('2 MB are too long, and no more than the beginning is kept', () => {
    for (const hash of [`#rtu/request?data="${'A'.repeat(2_000_000)}"`, `#${'x'.repeat(2_000_000)}`]) {
      const reading = readLink(hash)!;
      expect(reading).toEqual({ draft: firstDraft, unknown: [], tooLong: true });
      const broken = brokenLink(hash, reading);
      expect(broken).toMatchObject({ tooLong: true, length: hash.length });
      expect(broken.text).toBe(`${hash.slice(0, 400)}…`);
    }
  });

  test('400,000 characters are read, and no more', () => {
    const beginning = 'rtu/request?data=';
    const longest = beginning + 'A'.repeat(400_000 - beginning.length);
    expect(readLink(`#${longest}`)!.tooLong).toBeUndefined();
    expect(readLink(`#${longest}A`)!.tooLong).toBe(true);
  });

  test('a long part that means nothing is cut', () => {
    const hash = `#${'x'.repeat(200_000)}`;
    const broken = brokenLink(hash, readLink(hash)!);
    expect(broken.unknown).toEqual([`${'x'.repeat(100)}…`]);
    expect(JSON.stringify(broken).length).toBeLessThan(1000);
  });

  test('what was read in full is told from what was not', () => {
    const inFull = (hash: string) => readInFull(readLink(hash)!);
    expect(inFull('#rtu/request?unitId=6')).toBe(true);
    expect(inFull('#rtu/request?v=9')).toBe(false);
    expect(inFull('#rtu/request?%25=1')).toBe(false);
    expect(inFull(`#${'x'.repeat(2_000_000)}`)).toBe(false);
  });
});
