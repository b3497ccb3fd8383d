import { describe, expect, it } from 'vitest';
import { fromHex } from '../../../src/modbus/index.ts';
import { Page, type Reader, repair } from '../../../src/store/index.ts';
import { firstFrame, identityOf, inputMeaning, itemContext, readText } from '../../../src/workbench/index.ts';
import { inputContext } from '../workbench/reading/input-context.ts';
import { TestWindow } from './window.ts';

// AP 6.3: a request for registers 108 to 110, its reply, and an exception to another request.
const LOG = [
  'Tx 11 03 00 6B 00 03 76 87',
  'Rx 11 03 06 02 2B 00 00 00 64 C8 BA',
  'Tx 11 03 00 00 00 04 46 99',
  'Rx 11 83 02 C1 34',
].join('\n');
/** 51,000 characters. */
const LONG = '11 03 00 6B 00 03 76 87 '.repeat(2125);

function setUp(window = new TestWindow()) {
  const logs: string[] = [];
  const names: (string | undefined)[] = [];
  const page = new Page(window.bar, window.after);
  const { pasted } = page;
  const reader: Reader = {
    readText,
    firstFrame,
    identityOf,
    meaningOf: (reading, draft) => inputMeaning(reading, inputContext(draft)),
    openLog: (text, name) => {
      logs.push(text);
      names.push(name);
    },
  };
  const back = (by = -1) => {
    window.at += by;
    page.address.take();
  };
  return { page, window, pasted, reader, logs, names, back };
}

function withReader(window?: TestWindow) {
  const all = setUp(window);
  all.pasted.bring(all.reader);
  return all;
}

const bytesOf = ({ evaluation }: Page) => evaluation.value.frame?.bytes;

describe('a pasted text', () => {
  it('with more frames than a request and its reply is opened as a log, but not while it is typed', () => {
    const { page, pasted, logs } = withReader();
    pasted.take(LOG.split('\n').slice(0, 2).join('\n'));
    page.takeInput(LOG);
    expect(logs).toEqual([]);
    pasted.take(LOG);
    expect(logs).toEqual([LOG]);
    expect(page.input.value).toBe(LOG);
  });

  it('of a file is opened as a log under the name of the file, short or long, also read another way', () => {
    const { page, pasted, reader, names } = setUp();
    pasted.take(LONG, 'long.log');
    pasted.bring(reader);
    pasted.take(LONG, 'longer.log');
    pasted.take(LOG, 'short.log');
    pasted.read(LOG, 'step', 'hex');
    expect(names).toEqual(['long.log', 'longer.log', 'short.log', 'short.log']);
    pasted.take(`${LOG} `);
    pasted.take(LONG);
    page.takeInput('01', 'step');
    pasted.take(LOG);
    expect(names.slice(4)).toEqual([undefined, undefined, undefined]);
  });

  it('waits for the reader, and shows its first frame as a step', () => {
    const { page, window, pasted, reader } = setUp();
    expect(pasted.wanted.value).toBe(false);
    pasted.take(LOG);
    expect(pasted.wanted.value).toBe(true);
    expect(pasted.state.value).toMatchObject({ kind: 'waiting', text: LOG });
    pasted.bring(reader);
    expect(pasted.state.value).toMatchObject({ kind: 'read', chosen: 0 });
    expect(bytesOf(page)).toEqual(fromHex('1103006B00037687'));
    expect(window.entries.at(-1)).toBe(`#${page.link.value}`);
  });

  it('changes nothing if it is blank', () => {
    const { pasted } = withReader();
    pasted.take(' \n');
    expect(pasted.state.value.kind).toBe('empty');
    expect(pasted.wanted.value).toBe(false);
  });

  it('is read in the notation that is asked for', () => {
    const { page, pasted } = withReader();
    pasted.take('10 11 12 13 14');
    expect(bytesOf(page)).toEqual(fromHex('1011121314'));
    pasted.read('10 11 12 13 14', 'step', 'decimal');
    expect(bytesOf(page)).toEqual(fromHex('0A0B0C0D0E'));
  });

  it('without bytes shows no frame', () => {
    const { page, pasted } = withReader();
    const before = page.draft.value;
    pasted.take('nothing here');
    expect(pasted.state.value.kind).toBe('read');
    expect(pasted.identity.value).toBeUndefined();
    expect(page.draft.value).toBe(before);
  });
});

describe('an item of a text', () => {
  it('is shown when it is chosen, a reply with its request', () => {
    const { page, pasted } = withReader();
    pasted.take(LOG);
    pasted.choose(1, 'step');
    expect(bytesOf(page)).toEqual(fromHex('110306022B00000064C8BA'));
    expect(page.draft.value.answering).toBe('11 03 00 6B 00 03 76 87');
    expect(pasted.identity.value?.request).toEqual(fromHex('1103006B00037687'));
  });

  it('that does not exist is not chosen', () => {
    const { pasted } = withReader();
    pasted.choose(0, 'step');
    pasted.take(LOG);
    pasted.choose(4, 'step');
    expect(pasted.state.value).toMatchObject({ chosen: 0 });
  });

  it('tells what stands around it, but of other bytes nothing', () => {
    const { page, pasted } = withReader();
    pasted.take(LOG);
    pasted.choose(1, 'edit');
    const context = itemContext(pasted.itemWith(bytesOf(page)!)!, 'rtu');
    expect(context.request).toEqual(fromHex('1103006B00037687'));
    expect(context.preceding).toEqual([fromHex('1103006B00037687')]);
    expect(context.following).toEqual([fromHex('1103000000044699'), fromHex('118302C134')]);
    // The transport was guessed from the same bytes; another one was chosen by a person.
    expect(context.transport).toBeUndefined();
    expect(itemContext(pasted.itemWith(bytesOf(page)!)!, 'tcp').transport).toBe('tcp');
    expect(pasted.itemWith(fromHex('118302C134')!)).toBeUndefined();
  });
});

describe('a long text', () => {
  it('is a log, whatever is in it; the frame, its text and the history stay as they are', () => {
    for (const how of ['step', 'edit'] as const) {
      const { page, window, pasted, logs } = withReader();
      page.takeInput(LOG, 'step');
      const before = [pasted.state.value, window.inputs, bytesOf(page)];
      pasted.read(LONG, how);
      expect(logs.at(-1)).toBe(LONG);
      expect([pasted.state.value, window.inputs, bytesOf(page)]).toEqual(before);
      expect(page.input.value).toBe(LOG);
    }
  });

  it('is opened when what reads has come', () => {
    const { page, pasted, reader, logs } = setUp();
    pasted.take(LONG);
    expect([pasted.wanted.value, logs]).toEqual([true, []]);
    pasted.bring(reader);
    expect([pasted.state.value.kind, page.input.value, logs]).toEqual(['empty', '', [LONG]]);
  });
});

describe('who goes to another view before a text has been read', () => {
  const LOG_REQUEST = fromHex('1103006B00037687');

  it('stays there; the frame waits in the Frame view', () => {
    const { page, window, pasted, reader } = setUp();
    pasted.take(LOG);
    page.open('bus');
    pasted.bring(reader);
    window.wait(1000);
    expect(page.view.value).toBe('bus');
    expect(window.entries.at(-1)).toBe('#bus');
    expect(bytesOf(page)).toEqual(LOG_REQUEST);
    page.open(undefined);
    expect(bytesOf(page)).toEqual(LOG_REQUEST);
    expect(page.input.value).toBe(LOG);
    expect(pasted.state.value).toMatchObject({ kind: 'read', chosen: 0 });
  });

  it.each(['step', 'edit'] as const)('stays there (%s; the reader comes later)', (how) => {
    for (const text of [LOG, 'HR108', 'P0683 30 Hz', 'write registers', '06', 'hello']) {
      const { page, window, pasted, reader } = setUp();
      page.takeInput(text, how);
      page.open('timing');
      pasted.bring(reader);
      window.wait(1000);
      expect(page.view.value).toBe('timing');
      expect(window.entries.at(-1)).toBe('#timing');
    }
  });

  it('stays there though the pause of what was typed ends there', () => {
    const { page, window, pasted } = withReader();
    pasted.read('HR108', 'edit');
    page.open('bus');
    pasted.read('HR109', 'edit');
    expect(page.view.value).toBe('bus');
    pasted.read('', 'edit');
    window.wait(1000);
    expect(page.view.value).toBe('bus');
    expect(window.entries.at(-1)).toBe('#bus');
  });

  it('and comes back by Back sees what the text says', () => {
    const { page, pasted, reader, back } = setUp();
    pasted.take(LOG);
    page.open('bus');
    pasted.bring(reader);
    back();
    expect(page.view.value).toBeUndefined();
    expect(page.input.value).toBe(LOG);
    expect(bytesOf(page)).toEqual(LOG_REQUEST);
    expect(pasted.state.value).toMatchObject({ kind: 'read', chosen: 0 });
  });

  it('and comes back meanwhile sees the frame when it is read', () => {
    const { page, pasted, reader } = setUp();
    pasted.take(LOG);
    page.open('bus');
    page.open(undefined);
    expect(pasted.state.value.kind).toBe('waiting');
    pasted.bring(reader);
    expect(page.view.value).toBeUndefined();
    expect(bytesOf(page)).toEqual(LOG_REQUEST);
    expect(pasted.state.value).toMatchObject({ kind: 'read', chosen: 0 });
  });

  it('is brought to the frame by what is pasted there', () => {
    const { page, pasted } = withReader();
    page.open('bus');
    pasted.take(LOG);
    expect(page.view.value).toBeUndefined();
  });
});

describe('a frame that is repaired', () => {
  const WRONG = '06 06 02 AB 10 00 E6 A1';

  it('takes the place of its text, as one step; Back brings back what was pasted', () => {
    const { page, pasted, back } = withReader();
    page.takeInput(WRONG, 'step');
    repair(page, page.draft.value, fromHex('060602AB1000F5E5')!);
    expect(page.input.value).toBe('06 06 02 AB 10 00 F5 E5');
    expect(pasted.state.value).toMatchObject({ kind: 'read', chosen: 0, reading: { text: page.input.value } });
    expect(page.shown.value.stale).toBeUndefined();
    back();
    expect(page.input.value).toBe(WRONG);
    expect(bytesOf(page)).toEqual(fromHex('060602AB1000E6A1'));
    back(1);
    expect(page.input.value).toBe('06 06 02 AB 10 00 F5 E5');
    expect(bytesOf(page)).toEqual(fromHex('060602AB1000F5E5'));
  });

  it('is written as it was: the characters of ASCII', () => {
    const { page } = withReader();
    page.takeInput(':010300000001FF', 'step');
    // ":010300000001FB", CR, LF
    repair(page, page.draft.value, fromHex('3A30313033303030303030303146420D0A')!);
    expect(page.input.value).toBe(':010300000001FB');
  });

  it('leaves a text with other frames as it is, from which its frame can be shown again', () => {
    const { page, pasted } = withReader();
    page.takeInput(`${WRONG}\n${LOG}`, 'step');
    repair(page, page.draft.value, fromHex('060602AB1000F5E5')!);
    expect(page.input.value).toBe(`${WRONG}\n${LOG}`);
    expect(pasted.itemWith(bytesOf(page)!)).toBeUndefined();
    pasted.choose(0, 'step');
    expect(bytesOf(page)).toEqual(fromHex('060602AB1000E6A1'));
  });

  it('leaves the input blank where the frame came from a link', () => {
    const { page } = withReader(
      new TestWindow('#rtu/request?unitId=6&functionCode=6&address=0x02AB&value=4096&force.checksum=0xA1E6'),
    );
    repair(page, page.draft.value, fromHex('060602AB1000F5E5')!);
    expect(page.input.value).toBe('');
    expect(bytesOf(page)).toEqual(fromHex('060602AB1000F5E5'));
  });
});

describe('the history', () => {
  it('has the text of each entry, and after a reload it is read again beside the frame of the address', () => {
    const { window, pasted: before } = withReader();
    before.take(LOG);
    before.choose(1, 'step');
    const { page, pasted, reader } = setUp(window);
    const { draft } = page;
    const own = draft.value;
    expect(page.input.value).toBe(LOG);
    expect(pasted.wanted.value).toBe(true);
    pasted.bring(reader);
    expect(pasted.state.value).toMatchObject({ kind: 'read', chosen: 1 });
    expect(draft.value).toBe(own);
  });

  it('brings back the text with its frame', () => {
    const { page, pasted, back } = withReader();
    page.takeInput('11 03 00 6B 00 03 76 87', 'step');
    page.takeInput('11 83 02 C1 34', 'step');
    back();
    expect(page.input.value).toBe('11 03 00 6B 00 03 76 87');
    expect(bytesOf(page)).toEqual(fromHex('1103006B00037687'));
    expect(pasted.state.value).toMatchObject({ kind: 'read', chosen: 0 });
    back(1);
    expect(page.input.value).toBe('11 83 02 C1 34');
    expect(bytesOf(page)).toEqual(fromHex('118302C134'));
    back(-2);
    expect(page.input.value).toBe('');
    expect(page.meant.value.kind).toBe('empty');
  });

  it('has an entry for a text that shows no frame, and follows one that is typed in place', () => {
    const { page, window } = withReader();
    page.takeInput('hello world', 'step');
    expect(window.inputs).toEqual(['', 'hello world']);
    page.takeInput('hello w', 'edit');
    window.wait(250);
    expect(window.inputs).toEqual(['', 'hello w']);
    page.commit();
    expect(window.inputs).toEqual(['', 'hello world', 'hello w']);
  });

  it('has no text that is cleared', () => {
    const { page, window } = withReader();
    page.takeInput(LOG, 'step');
    page.takeInput('', 'step');
    expect(window.inputs).toEqual(['', LOG, '']);
  });

  it('leaves the input as it is where a link within the page leads back to the frame', () => {
    const { page, window } = withReader();
    page.takeInput(LOG, 'step');
    window.goTo('#timing');
    page.address.take();
    window.goTo(`#${page.link.value}`);
    page.address.take();
    expect(page.input.value).toBe(LOG);
    window.goTo('#rtu/request?unitId=1&functionCode=3&startAddress=0&quantity=1');
    page.address.take();
    expect(page.input.value).toBe('');
  });
});
