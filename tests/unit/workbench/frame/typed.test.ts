import { describe, expect, it } from 'vitest';
import { type Draft, withoutGroup, withText } from '../../../../src/workbench/frame/draft.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { readLink, writeLink } from '../../../../src/workbench/frame/link.ts';
import { shownAt, typedAt, withTyped } from '../../../../src/workbench/frame/typed.ts';

const draft: Draft = {
  transport: 'rtu',
  kind: 'request',
  texts: { unitId: '6', functionCode: '6', address: '0x02AB', value: '1' },
  force: {},
  answering: '',
};

const linkOf = (given: Draft) => writeLink(given, evaluate(given).controls);
const again = (given: Draft) => readLink(`#${linkOf(given)}`)!.draft;

describe('what was typed where the frame has another text', () => {
  const hertz = withTyped(draft, 'value', '30 Hz', '4096', 'weg-drive');

  it('is in the draft, beside the text that was made of it', () => {
    expect(hertz.texts['value']).toBe('4096');
    expect(typedAt(hertz, 'value')).toBe('30 Hz');
    expect(Array.from(evaluate(hertz).frame!.bytes)).toEqual([
      0x06, // unit
      0x06, // function code
      0x02,
      0xab, // address
      0x10,
      0x00, // value: 30 Hz of 60 is 4096 of 8192
      0xf5,
      0xe5, // CRC
    ]);
  });

  it('comes back from the link, with its device', () => {
    expect(linkOf(hertz)).toBe(
      'rtu/request?v=2&unitId=6&functionCode=6&address=0x02AB&value=4096&typed.value=30+Hz&device=weg-drive',
    );
    expect(again(hertz)).toEqual(hertz);
    expect(again(withTyped(draft, 'address', '40684', 'HR684')).typed).toEqual({
      address: { typed: '40684', text: 'HR684' },
    });
  });

  it('is nothing where the field has what was typed: such a link is of the first version', () => {
    expect(linkOf(withTyped(draft, 'value', '4096', '4096', 'weg-drive'))).toBe(
      'rtu/request?unitId=6&functionCode=6&address=0x02AB&value=4096',
    );
  });

  it('is over once the field has another text, however it got it', () => {
    expect(typedAt(withText(hertz, 'value', '5'), 'value')).toBeUndefined();
    expect(typedAt(withText(withText(hertz, 'value', '5'), 'value', '4096'), 'value')).toBeUndefined();
    const replaced = { ...hertz, texts: { ...hertz.texts, value: '5' } };
    expect(typedAt(replaced, 'value')).toBeUndefined();
    expect(linkOf(replaced)).toBe('rtu/request?unitId=6&functionCode=6&address=0x02AB&value=5');
  });

  it('stays while another field is typed in', () => {
    expect(typedAt(withText(hertz, 'unitId', '7'), 'value')).toBe('30 Hz');
  });

  it('moves up with its group', () => {
    const groups: Draft = {
      ...draft,
      transport: 'pdu',
      texts: {
        functionCode: '21',
        subRequests: '3',
        'subRequests[0].recordData': '1',
        'subRequests[1].recordData': '2',
        'subRequests[2].recordData': '3',
      },
    };
    const typed = withTyped(groups, 'subRequests[2].recordData', '30 Hz', '4096', 'weg-drive');
    const removed = withoutGroup(typed, 'subRequests', 1, 3);
    expect(removed.texts).toEqual({
      functionCode: '21',
      subRequests: '2',
      'subRequests[0].recordData': '1',
      'subRequests[1].recordData': '4096',
    });
    expect(typedAt(removed, 'subRequests[1].recordData')).toBe('30 Hz');
    expect(typedAt(removed, 'subRequests[2].recordData')).toBeUndefined();
    expect(again(removed).typed).toEqual({ 'subRequests[1].recordData': { typed: '30 Hz', text: '4096' } });
  });
});

describe('what a field shows', () => {
  const hertz = withTyped(draft, 'value', '30 Hz', '4096', 'weg-drive');
  const show = (inFrame: (typed: string) => string, given = hertz) =>
    shownAt(given, 'value', given.texts['value']!, inFrame);

  it('is what was typed, if it makes the text of the field here too', () => {
    expect(show(() => '4096')).toEqual({ text: '30 Hz', notHere: undefined });
  });

  it('is the text of the field, if what was typed means something else here, or nothing', () => {
    expect(show(() => '8192')).toEqual({ text: '4096', notHere: '30 Hz' });
    expect(show((typed) => typed)).toEqual({ text: '4096', notHere: '30 Hz' });
  });

  it('is the text of the field, if nothing else was typed', () => {
    expect(show((typed) => typed, draft)).toEqual({ text: '1', notHere: undefined });
  });
});
