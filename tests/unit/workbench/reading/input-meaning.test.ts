import fc from 'fast-check';
import { describe, expect, it, test } from 'vitest';
import {
  type Draft,
  evaluate,
  firstDraft,
  type InputMeaning,
  inputMeaning,
  readText,
} from '../../../../src/workbench/index.ts';
import { draftMeant } from '../../../../src/workbench/reading/draft-meant.ts';
import { inputContext } from './input-context.ts';

const meant = (text: string, device?: string, draft?: Draft): InputMeaning =>
  inputMeaning(readText(text, undefined), inputContext(draft, device));
const hex = (draft: Draft) =>
  Buffer.from(evaluate(draft).frame?.bytes ?? [])
    .toString('hex')
    .toUpperCase();

function draftOf(meaning: InputMeaning): Draft {
  if (meaning.kind === 'address' || meaning.kind === 'function') return meaning.taken.draft;
  if (meaning.kind === 'value-with-unit') return meaning.draft;
  throw new Error(`nothing was taken: ${meaning.kind}`);
}

const offers = (meaning: InputMeaning) => (meaning.kind === 'several' ? meaning.offers : []);

describe('frames, logs and code', () => {
  it.each([
    '06 06 02 AB 10 00 F5 E5',
    '06 06 02 AB 10 00 E6 A1',
    '06 06 02 AB 10 00',
    ':010300000001FB',
    'Tx: 11 03 00 6B 00 03 76 87\nRx: 11 83 02 C1 34',
    'uint8_t frame[8] = { 0x06, 0x06, 0x02, 0xAB, 0x10, 0x00, 0xF5, 0xE5 };',
  ])('%s are frames', (text) => {
    expect(meant(text).kind).toBe('frames');
  });

  it.each(['', ' \n '])('a blank text is empty', (text) => {
    expect(meant(text)).toEqual({ kind: 'empty' });
  });

  it.each(['hello world', 'P9999', 'the frame does not work', '?'])('%s has no bytes', (text) => {
    expect(meant(text).kind).toBe('no-bytes');
  });
});

describe('a manual’s number or the name of a register', () => {
  it.each(['H1000', '&H1000', 'h0013'])('is not %s, which is hexadecimal', (text) => {
    expect(meant(text).kind).not.toBe('address');
  });

  it.each([
    ['HR108', '06', '03', '006B'],
    ['40108', '06', '03', '006B'],
    ['400108', '06', '03', '006B'],
    ['4x108', '06', '03', '006B'],
    ['%MW107', '06', '03', '006B'],
    ['30009', '06', '04', '0008'],
    ['10197', '06', '02', '00C4'],
    ['CO20', '06', '01', '0013'],
    ['00001', '06', '01', '0000'],
    ['00017', '06', '01', '0010'],
  ])('%s is read with its function', (text, unit, code, address) => {
    const meaning = meant(text);
    expect(meaning.kind).toBe('address');
    expect(hex(draftOf(meaning)).slice(0, 12)).toBe(`${unit}${code}${address}0001`);
  });

  it('is read by the device that has it, though it is not chosen', () => {
    const meaning = meant('P0683');
    expect(meaning).toMatchObject({
      kind: 'address',
      taken: { name: 'P0683 speed reference', address: 683, device: 'WEG drive' },
    });
    const draft = draftOf(meaning);
    expect(draft.device).toBe('weg-drive');
    expect(draft.typed).toEqual({ startAddress: { typed: 'P0683', text: 'HR684' } });
    expect(hex(draft).slice(0, 12)).toBe('060302AB0001');
  });

  it('is asked for with as many registers as a range has', () => {
    expect(hex(draftOf(meant('401000–401003'))).slice(0, 12)).toBe('060303E70004');
    expect(hex(draftOf(meant('40108..40110'))).slice(0, 12)).toBe('0603006B0003');
  });

  it('keeps the unit and the transport of the frame', () => {
    const tcp: Draft = {
      ...firstDraft,
      transport: 'tcp',
      texts: { ...firstDraft.texts, unitId: '9', transactionId: '258' },
    };
    expect(hex(draftOf(meant('40005', undefined, tcp)))).toBe('010200000006090300040001');
  });
});

describe('what is asked for in words', () => {
  it.each([
    // The 06 in front of the verb is the unit; VW800 is the first register of the S7-200 example.
    ['06 read 5 from VW800', '060300000005'],
    ['unit 17 read 3 from 40108', '1103006B0003'],
    ['read 3 from 00017', '060100100003'],
    ['read HR108', '0603006B0001'],
    ['17 read 40108..40110', '1103006B0003'],
    ['write 2 to HR1', '060600000002'],
    ['set HR1 = 2', '060600000002'],
    ['write 10 258 to HR2', '06100001000204000A0102'],
    ['17 write on to CO173', '110500ACFF00'],
  ])('%s', (text, body) => {
    expect(hex(draftOf(meant(text))).slice(0, body.length)).toBe(body);
  });

  it('has a value in the unit of the register, as it was typed', () => {
    const meaning = meant('P0683 30 Hz');
    expect(meaning).toMatchObject({ kind: 'address', taken: { value: '30 Hz', name: 'P0683 speed reference' } });
    const draft = draftOf(meaning);
    expect(hex(draft)).toBe('060602AB1000F5E5');
    expect(draft.typed).toEqual({
      address: { typed: 'P0683', text: 'HR684' },
      value: { typed: '30 Hz', text: '4096' },
    });
  });

  it.each([
    ['write 683', '683', '6'],
    ['set P0683', 'HR684', '6'],
    ['set coil 19', 'CO19', '5'],
    ['fc 16 40108', 'HR108', '16'],
  ])('that the text does not say is left open: %s', (text, address, code) => {
    const meaning = meant(text);
    const draft = offers(meaning)[0]?.draft ?? draftOf(meaning);
    const { functionCode, address: one, startAddress = one } = draft.texts;
    expect([functionCode, startAddress]).toEqual([code, address]);
    expect(evaluate(draft).frame?.reading.problems[0]?.severity ?? 'error').toBe('error');
  });

  it('goes from one plain number to another, or both are a range', () => {
    const frames = (text: string) => offers(meant(text)).map(({ draft }) => hex(draft));
    expect(frames('4096 to 683')).toEqual(['060602AB1000F5E5', expect.stringMatching(/^060602AA1000/)]);
    expect(frames('40 to 50')).toEqual(
      [/^060600320028/, /^060600310028/, /^06030028000B/, /^06030027000B/].map((frame) => expect.stringMatching(frame)),
    );
  });

  it('has a value for the register of the frame, if its unit is known', () => {
    expect(hex(draftOf(meant('45 Hz', 'weg-drive')))).toBe('060602AB1800F225');
  });

  it('without a device has no frame: what would do is said', () => {
    const { errors, frame } = evaluate(draftOf(meant('45 Hz')));
    expect(frame).toBeUndefined();
    expect(errors.get('value')).toEqual({ code: 'unit-without-device', text: '45 Hz', unit: 'Hz' });
  });
});

describe('a function', () => {
  it.each([
    ['write registers', 'Write Multiple Registers'],
    ['read holding registers', 'Read Holding Registers'],
    ['Read', 'Read Holding Registers'],
    ['mask write', 'Mask Write Register'],
    ['function 6', 'Write Single Register'],
    ['fc 0x10', 'Write Multiple Registers'],
    ['read device identification', 'Read Device Identification'],
  ])('%s is %s', (text, name) => {
    expect(meant(text)).toMatchObject({ kind: 'function', taken: { as: 'function', name } });
  });

  it('offers the others that have the words too', () => {
    expect(meant('write register')).toMatchObject({
      taken: { name: 'Write Single Register' },
      others: [
        { name: 'Write Multiple Registers' },
        { name: 'Read/Write Multiple Registers' },
        { name: 'Mask Write Register' },
      ],
    });
  });
});

describe('bare numbers', () => {
  const asOf = (text: string) => offers(meant(text)).map((offer) => (offer.as === 'function' ? offer.name : offer.as));

  it('of one are a function, bytes or an address', () => {
    expect(asOf('06')).toEqual(['Write Single Register', 'bytes', 'address']);
    expect(asOf('16')).toEqual(['Write Multiple Registers', 'Mask Write Register', 'bytes', 'address']);
  });

  it('of two are values, a function or bytes', () => {
    expect(asOf('03 16')).toEqual(['values', 'Read Holding Registers', 'bytes']);
    expect(asOf('2B 0E')).toEqual(['values', 'Read Device Identification', 'bytes']);
  });

  it('of four or eight bytes that make no frame are values first', () => {
    expect(asOf('07 7A 42 9B')).toEqual(['values', 'bytes']);
    expect(asOf('077A429B')).toEqual(['values', 'bytes']);
    expect(asOf('FF FF 00 00 12 34 56 78')).toEqual(['values', 'bytes']);
    const [values] = offers(meant('07 7A 42 9B'));
    expect(values).toMatchObject({ registers: [0x077a, 0x429b] });
    expect(hex(values!.draft).slice(0, 14)).toBe('060304077A429B');
  });

  it('are bytes as they are, without a checksum that nobody typed', () => {
    const bytes = offers(meant('07 7A 42 9B')).find(({ as }) => as === 'bytes');
    expect(hex(bytes!.draft)).toBe('077A429B');
  });

  it('40000 and 0x… are addresses, and never a manual’s number', () => {
    const address = offers(meant('0x0100')).find(({ as }) => as === 'address');
    expect(hex(address!.draft).slice(0, 12)).toBe('060301000001');
  });
});

describe('any text', () => {
  const words = fc.constantFrom(
    ...[
      '06',
      'read',
      'write',
      'set',
      '5',
      '70000',
      '-1',
      'from',
      'to',
      '=',
      'HR108',
      'HR0',
      '40108',
      '49999',
      '410000',
    ],
    ...[
      'P0683',
      'VW800',
      'CO5',
      '30 Hz',
      '1e9 Hz',
      'on',
      'unit',
      '0x06',
      '..',
      '–',
      '1 2 3',
      'f32 21.5',
      'function',
      '\n',
    ],
  );
  const phrases = fc.array(words, { maxLength: 6 }).map((several) => several.join(' '));

  test.each(['', 'weg-drive', 's7-200', 'modicon-984'])(
    'has a meaning whose drafts can be worked out (%s)',
    (device) => {
      fc.assert(
        fc.property(fc.oneof(phrases, fc.string()), (text) => {
          const meaning = meant(text, device);
          const all = [
            draftMeant(meaning),
            ...('others' in meaning ? meaning.others.map(({ draft }) => draft) : []),
            ...offers(meaning).map(({ draft }) => draft),
          ];
          for (const draft of all) if (draft) evaluate(draft);
        }),
        { numRuns: 300 },
      );
    },
  );
});
