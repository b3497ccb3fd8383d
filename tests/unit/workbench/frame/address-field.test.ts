import { expect, it, test } from 'vitest';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { readLink, writeLink } from '../../../../src/workbench/frame/link.ts';

const open = (startAddress: string, functionCode = 3) => {
  const query = new URLSearchParams({ unitId: '17', functionCode: String(functionCode), startAddress, quantity: '3' });
  const { draft } = readLink(`#pdu/request?${query}`)!;
  return { draft, ...evaluate(draft) };
};

test.each([
  ['107', '03006B0003'],
  ['0x6B', '03006B0003'],
  // Plain numbers count from 0 in a link, whoever opens it.
  ['40108', '039CAC0003'],
  ['00108', '03006C0003'],
  ['400108', '03006B0003'],
  ['4x108', '03006B0003'],
  ['4x00108', '03006B0003'],
  ['4:108', '03006B0003'],
  ['HR108', '03006B0003'],
  ['%MW107', '03006B0003'],
  // An address of another table is one all the same; the page says so.
  ['3x108', '03006B0003'],
])('%s in a link is understood at once, and kept as typed', (text, hex) => {
  const { draft, frame, controls } = open(text);
  expect(Buffer.from(frame!.bytes).toString('hex').toUpperCase()).toBe(hex);
  expect(new URLSearchParams(writeLink(draft, controls).split('?')[1]).get('startAddress')).toBe(text);
});

it('says what is not an address, and what is beyond the end', () => {
  expect(open('HR').errors.get('startAddress')).toEqual({ code: 'not-an-address', text: 'HR' });
  expect(open('4x65537').errors.get('startAddress')).toEqual({ code: 'not-an-address', text: '4x65537' });
  expect(open('65536').errors.get('startAddress')).toMatchObject({ code: 'number-out-of-range', got: 65536 });
  expect(open('0x10000', 1).errors.get('startAddress')).toMatchObject({ code: 'number-out-of-range', got: 65536 });
});
