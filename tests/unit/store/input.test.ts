import { describe, expect, it } from 'vitest';
import { fromHex } from '../../../src/modbus/index.ts';
import { Fields, Page, type Reader } from '../../../src/store/index.ts';
import { firstFrame, identityOf, inputMeaning, readText } from '../../../src/workbench/index.ts';
import { inputContext } from '../workbench/reading/input-context.ts';
import { TestWindow } from './window.ts';

/** AP 6.3: a request for registers 108 to 110 of unit 17, and the reply. */
const READ = '#rtu/request?unitId=17&functionCode=3&startAddress=HR108&quantity=3';
const REPLY = '11 03 06 02 2B 00 00 00 64 C8 BA';

const reader: Reader = {
  readText,
  firstFrame,
  identityOf,
  meaningOf: (reading, draft) => inputMeaning(reading, inputContext(draft)),
  openLog: () => undefined,
};

function pageAt(hash = READ) {
  const window = new TestWindow(hash);
  const page = new Page(window.bar, window.after);
  page.pasted.bring(reader);
  const fields = new Fields(page);
  return { page, window, fields };
}

describe('the frame that is shown', () => {
  it('is the current one while there is one', () => {
    const { page } = pageAt();
    expect(page.shown.value).toMatchObject({ stale: undefined, frame: { bytes: fromHex('1103006B00037687') } });
  });

  it('is the one before while a field has no value, and says which', () => {
    const { page, fields } = pageAt();
    fields.type('quantity', '');
    expect(page.shown.value).toMatchObject({
      frame: { bytes: fromHex('1103006B00037687') },
      stale: { code: 'field', path: 'quantity', error: { code: 'field-missing' } },
    });
    fields.type('quantity', 'x');
    expect(page.shown.value.frame?.bytes).toEqual(fromHex('1103006B00037687'));
    fields.type('quantity', '1');
    expect(page.shown.value.stale).toBeUndefined();
  });

  it('is the one before where the input has no bytes, until something else is shown', () => {
    const { page, fields } = pageAt();
    page.takeInput('hello world', 'step');
    expect(page.meant.value.kind).toBe('no-bytes');
    expect(page.shown.value).toMatchObject({
      stale: { code: 'no-bytes' },
      frame: { bytes: fromHex('1103006B00037687') },
    });
    fields.type('quantity', '2');
    expect(page.shown.value.stale).toBeUndefined();
    page.takeInput('hello', 'step');
    expect(page.shown.value.stale).toEqual({ code: 'no-bytes' });
    page.takeInput(REPLY, 'step');
    expect(page.shown.value.stale).toBeUndefined();
  });
});

describe('what is typed into the input', () => {
  const TCP = '#tcp/request?transactionId=258&unitId=9&functionCode=3&startAddress=0&quantity=1';

  it('is read beside the frame of before the typing, whatever its beginnings mean', () => {
    const { page } = pageAt(TCP);
    for (const text of ['4', '40', '400', '4000', '40005']) page.takeInput(text);
    expect(page.evaluation.value.frame?.bytes).toEqual(fromHex('010200000006090300040001'));
    for (const text of ['06 0', '06 06 02 AB', '06']) page.takeInput(text);
    expect(`#${page.link.value}`).toBe(TCP);
    for (const text of ['06 06 02 AB', '']) page.takeInput(text);
    expect(`#${page.link.value}`).toBe(TCP);
  });

  it('leaves the frame of the last step in its place, which may be one that was typed here', () => {
    const { page } = pageAt();
    page.takeInput('HR8');
    page.commit();
    for (const text of ['HR', 'h', 'hello', '06']) {
      page.takeInput(text);
      expect(page.shown.value.frame?.reading.fields['startAddress']).toBe(7);
      expect(page.shown.value.stale).toBeDefined();
    }
  });

  it('as bare numbers replaces nothing until one of the offers is chosen', () => {
    const { page, window } = pageAt();
    page.takeInput('06', 'step');
    expect(page.shown.value).toMatchObject({
      stale: { code: 'not-chosen' },
      frame: { bytes: fromHex('1103006B00037687') },
    });
    const { value: meant } = page.meant;
    const [offer] = meant.kind === 'several' ? meant.offers : [];
    page.choose(offer!);
    expect(page.evaluation.value.description.code).toBe(6);
    expect(page.shown.value.stale).toBeUndefined();
    const again = new Page(window.bar, window.after);
    again.pasted.bring(reader);
    expect(again.input.value).toBe('06');
    expect(again.shown.value.stale).toBeUndefined();
  });

  it('as a value with a unit that nothing knows leaves the frame before, and says why', () => {
    const { page } = pageAt('');
    page.takeInput('45 Hz', 'step');
    expect(page.shown.value).toMatchObject({
      frame: { bytes: fromHex('060602AB1000F5E5') },
      stale: { code: 'field', path: 'value', error: { code: 'unit-without-device', unit: 'Hz' } },
    });
  });
});

describe('a pair', () => {
  it('is the reply that is pasted and the request that stood here, which comes back with what was typed', () => {
    const { page } = pageAt(
      '#rtu/request?v=2&unitId=17&functionCode=3&startAddress=HR108&quantity=3&typed.startAddress=40108',
    );
    const asked = page.draft.value;
    page.takeInput(REPLY, 'step');
    expect(page.draft.value.answering).toBe('11 03 00 6B 00 03 76 87');
    expect(page.pair.value).toMatchObject({ why: 'unit-function-length' });
    page.toRequest();
    expect(page.draft.value).toMatchObject(asked);
    expect(page.pair.value?.reply.bytes).toEqual(fromHex(REPLY.replaceAll(' ', '')));
    page.toReply();
    expect(page.draft.value.kind).toBe('reply');
    page.part();
    expect(page.pair.value).toBeUndefined();
    expect(page.draft.value.answering).toBe('');
  });

  it('gives back the request when the form is asked for one', () => {
    const { page } = pageAt();
    const asked = page.draft.value;
    page.takeInput(REPLY, 'step');
    page.chooseKind('request');
    expect(page.draft.value).toMatchObject(asked);
    page.chooseKind('reply');
    expect(page.evaluation.value.frame?.bytes).toEqual(fromHex(REPLY.replaceAll(' ', '')));
    page.chooseKind('exception');
    expect(page.draft.value.kind).toBe('exception');
  });

  it('is in one text with request and reply, also if the reply has the same bytes', () => {
    const { page } = pageAt('');
    page.takeInput('PLC sends: 06 06 02 AB 10 00 F5 E5\nWEG responds: 06 06 02 AB 10 00 F5 E5', 'step');
    expect(page.draft.value.kind).toBe('request');
    expect(page.pair.value).toMatchObject({ why: 'same-content', reply: { bytes: fromHex('060602AB1000F5E5') } });
    page.toReply();
    expect(page.draft.value).toMatchObject({ kind: 'reply', answering: '06 06 02 AB 10 00 F5 E5' });
  });

  it('outlives a reload, for the address has it', () => {
    const { page, window } = pageAt(
      '#rtu/request?v=2&unitId=17&functionCode=3&startAddress=HR108&quantity=3&typed.startAddress=40108',
    );
    page.takeInput(REPLY, 'step');
    const again = new Page(window.bar, window.after);
    expect(again.draft.value).toEqual(page.draft.value);
    again.toRequest();
    expect(again.draft.value.typed).toEqual({ startAddress: { typed: '40108', text: 'HR108' } });
  });

  it('is an echo only if the request was built here, or the text says so', () => {
    const echo = '11 06 00 01 00 03 9A 9B';
    const { page, fields } = pageAt('#rtu/request?unitId=17&functionCode=6&address=1&value=2');
    page.takeInput('11 06 00 01 00 02 5B 5B', 'step');
    expect(page.draft.value.kind).toBe('request');
    fields.choose('value', '3');
    page.takeInput(echo, 'step');
    expect(page.pair.value?.why).toBe('same-content');
    const { page: other } = pageAt('#rtu/request?unitId=17&functionCode=6&address=1&value=3');
    other.takeInput(`Rx: ${echo}`, 'step');
    expect(other.pair.value?.why).toBe('same-content');
  });
});

describe('an address that may be two things', () => {
  it('is open until one of them is taken, as a step', () => {
    const { page, window } = pageAt('#rtu/request?unitId=17&functionCode=3&startAddress=40108&quantity=3');
    expect(page.openReading('startAddress')).toMatchObject({ number: 107, address: 40108, taken: 'address' });
    expect(page.openReading('quantity')).toBeUndefined();
    page.settle('startAddress', 'number');
    expect(page.evaluation.value.frame?.bytes).toEqual(fromHex('1103006B00037687'));
    expect(page.openReading('startAddress')).toBeUndefined();
    expect(window.entries).toHaveLength(2);
  });
});

it('takes a request whose checksum is wrong for the request that stood here, and not for its echo', () => {
  // The frame of a fresh page, and what a guide prints for it.
  const { page } = pageAt('');
  page.takeInput('06 06 02 AB 10 00 E6 A1', 'step');
  expect(page.draft.value.kind).toBe('request');
  expect(page.pair.value).toBeUndefined();
});

it('has the bytes of a link that cannot be read, so that they can be mended', () => {
  const { page } = pageAt('#rtu/request?v=2&unitId=6&functionCode=6&bytes=06+06+02+AB+1');
  expect(page.input.value).toBe('06 06 02 AB 1');
  expect(page.evaluation.value.frame).toBeUndefined();
});

describe('the tab', () => {
  it('is in the link, and comes back with it', () => {
    const { page, window } = pageAt();
    page.openTab('values');
    window.wait(250);
    expect(window.entries).toEqual([
      '#rtu/request?v=3&unitId=17&functionCode=3&startAddress=HR108&quantity=3&tab=values',
    ]);
    expect(new Page(window.bar, window.after).tab.value).toBe('values');
    page.openTab('bytes');
    window.wait(250);
    expect(window.entries).toEqual([READ]);
  });
});
