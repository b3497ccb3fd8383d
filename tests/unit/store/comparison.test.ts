import { expect, test } from 'vitest';
import { Comparison } from '../../../src/store/index.ts';
import { evaluate, readLink } from '../../../src/workbench/index.ts';

const { draft } = readLink('rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3')!;
const { frame } = evaluate(draft);

const codesOf = (comparison: Comparison) => comparison.of(draft, frame)?.comparison.causes.map(({ code }) => code);

test('what was sent is compared with the frame, in any notation', () => {
  const comparison = new Comparison();
  comparison.text.value = 'TX: 11 03 00 6B 00 03 76 87';
  expect(codesOf(comparison)).toEqual(['identical']);
  comparison.text.value = '0x11, 0x03, 0x00, 0x6b, 0x00, 0x04, 0x37, 0x45';
  expect(comparison.of(draft, frame)?.comparison.differences.map(({ mine }) => mine?.name)).toEqual([
    'quantity',
    'checksum',
  ]);
});

test('a blank text, one without bytes, and a draft without a frame give nothing to compare', () => {
  const comparison = new Comparison();
  expect(comparison.bytes.value).toHaveLength(0);
  expect(codesOf(comparison)).toBeUndefined();
  comparison.text.value = 'no bytes';
  expect(comparison.bytes.value).toBeUndefined();
  expect(codesOf(comparison)).toBeUndefined();
  comparison.text.value = '11 03 00 6B 00 03 76 87';
  expect(comparison.of(draft, undefined)).toBeUndefined();
});
