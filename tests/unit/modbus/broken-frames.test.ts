import { describe, expect, test } from 'vitest';
import { decodeFrame } from '../../../src/modbus/index.ts';
import { encodedAgain, expectEveryByteInOneSpan, hex } from './frames.ts';
import { brokenFrames } from './vectors.ts';

/**
 * By frame, for each of its directions: the problem that says what the vectors say is wrong, and the faulty bytes. A
 * frame that is too short for its function has its fault where it ends.
 */
// biome-ignore format: a line a frame
const faults: readonly (readonly [id: string, ...faults: string[]])[] = [
  ['neg-pub-rtu-41c1cda4', 'pdu-short 2-3', 'count-wrong 2-3'],
  ['neg-pub-tcp-9d9112b1', 'pdu-short 8-10', 'pdu-short 8-10'],
  ['neg-pub-tcp-36c784a6', 'function-above-127 7-8', 'pdu-short 7-8'],
  ['neg-pub-tcp-ff916059', 'count-contradicts-quantity 12-13', 'pdu-rest 12-15'],
  ['neg-pub-tcp-8bed6eb3', 'function-above-127 7-8', 'exception-undefined 8-9'],
  ['neg-pub-tcp-7d5252b5', 'pdu-short 8-10', 'pdu-short 8-10'],
  ['neg-pub-tcp-c4d5fa63', 'count-contradicts-quantity 16-17', 'count-odd 8-9'],
  ['neg-pub-tcp-4a40b0e4', 'quantity-out-of-range 10-12', 'count-wrong 8-9'],
  ['neg-pub-tcp-f1a91d50', 'pdu-short 10-11', 'count-wrong 8-9'],
  ['neg-pub-tcp-80f49fc0', 'quantity-out-of-range 10-12', 'count-wrong 8-9'],
  ['neg-pub-tcp-183fb80d', 'pdu-short 10-11', 'count-wrong 8-9'],
  ['neg-pub-tcp-42109837', 'quantity-out-of-range 10-12', 'count-wrong 8-9'],
  ['neg-pub-tcp-6a42418d', 'pdu-short 10-11', 'count-wrong 8-9'],
  ['neg-pub-tcp-e4934d55', 'pdu-rest 8-12', 'count-wrong 8-9'],
  ['neg-pub-tcp-3bb28364', 'count-contradicts-quantity 16-17', 'count-wrong 8-9'],
  ['neg-pub-tcp-e1bfd4e5', 'function-above-127 7-8', 'pdu-rest 9-21'],
  ['neg-pub-tcp-c244a06c', 'quantity-out-of-range 10-12', 'count-wrong 8-9'],
  ['neg-pub-tcp-6ca63698', 'quantity-out-of-range 10-12', 'count-wrong 8-9'],
  ['neg-pub-tcp-d061b069', 'count-contradicts-quantity 16-17', 'count-wrong 8-9'],
  ['neg-pub-tcp-60a1db9e', 'count-contradicts-quantity 16-17', 'count-wrong 8-9'],
  ['neg-pub-tcp-cdb8f8c5', 'pdu-short 10-11', 'count-wrong 8-9'],
  ['neg-pub-tcp-0a676932', 'count-contradicts-quantity 12-13', 'pdu-rest 12-14'],
  ['neg-pub-tcp-605e3d0a', 'count-wrong 12-13', 'pdu-rest 12-14'],
  ['neg-pub-tcp-399cafd4', 'count-contradicts-quantity 12-13', 'pdu-rest 12-19'],
  ['neg-pub-tcp-684c8e5d', 'count-wrong 12-13', 'pdu-rest 12-19'],
  ['neg-pub-tcp-a88d6acf', 'coil-value-illegal 10-12', 'coil-value-illegal 10-12'],
  ['neg-pub-tcp-6c25e8ac', 'pdu-short 10-11', 'pdu-short 10-11'],
  ['neg-pub-tcp-ac55d74c', 'pdu-short 10-11', 'pdu-short 10-11'],
  ['neg-pub-tcp-9ef6075e', 'quantity-out-of-range 10-12', 'count-wrong 8-9'],
  ['neg-pub-tcp-28a55591', 'count-contradicts-quantity 12-13', 'pdu-rest 12-14'],
  ['neg-pub-tcp-dd2b7172', 'pdu-short 7-8', 'pdu-short 7-8'],
  ['neg-pub-tcp-b9e7f6a1', 'function-above-127 7-8', 'pdu-rest 9-12'],
  ['neg-pub-tcp-f2a42f35', 'pdu-short 7-8', 'pdu-short 7-8'],
  ['neg-pub-rtu-3d695715', 'pdu-short 4-5', 'pdu-short 4-5'],
  ['neg-pub-rtu-3f170b93', 'pdu-short 4-5', 'pdu-short 4-5'],
  ['neg-pub-rtu-76f5ace3', 'pdu-short 4-5', 'count-wrong 2-3'],
  ['neg-pub-rtu-c379844a', 'function-above-127 1-2', 'pdu-rest 3-5'],
  ['neg-pub-rtu-08768a0b', 'count-wrong 6-7', 'pdu-rest 6-13'],
  ['neg-pub-rtu-3e4ee36f', 'pdu-rest 6-13', 'count-wrong 2-3'],
  ['neg-pub-rtu-d187c3e8', 'pdu-rest 6-21', 'count-wrong 2-3'],
  ['neg-pub-rtu-b3c8212b', 'pdu-rest 6-13', 'count-wrong 2-3'],
  ['neg-pub-rtu-63043c8f', 'function-above-127 1-2', 'pdu-rest 3-21'],
  ['neg-pub-ascii-53715e31', 'pdu-short 9-11', 'count-wrong 5-7'],
  ['neg-pub-ascii-ab8ed3c9', 'pdu-short 9-11', 'count-wrong 5-7'],
  ['neg-pub-ascii-4b36e142', 'function-above-127 3-5', 'pdu-rest 7-11'],
  ['neg-pub-ascii-8342bd27', 'pdu-short 9-11', 'count-wrong 5-7'],
  ['neg-pub-tcp-07025e2b', 'pdu-short 10-11', 'count-wrong 8-9'],
  ['neg-pub-rtu-aaa71766', 'pdu-short 1-2', 'pdu-short 1-2'],
  ['neg-pub-ascii-f9aa9bf3', 'pdu-short 3-5', 'pdu-short 3-5'],
  ['neg-pub-rtu-5f24d74d', 'pdu-rest 5-16', 'next-object-not-zero 6-7'],
  ['neg-pub-rtu-ead625c9', 'function-above-127 1-2', 'exception-undefined 2-3'],
  ['neg-pub-tcp-ed26c4bf', 'pdu-rest 8-9', 'count-out-of-range 8-9'],
  ['neg-pub-tcp-630de14d', 'count-out-of-range 8-9', 'count-out-of-range 8-9'],
  ['neg-pub-tcp-ab2dbb1a', 'count-out-of-range 8-9', 'count-out-of-range 8-9'],
  ['neg-pub-rtu-c649b37d', 'pdu-short 2-4', 'pdu-short 2-4'],
  ['neg-pub-tcp-c2164149', 'pdu-rest 8-12', 'count-wrong 8-9'],
  ['neg-pub-tcp-36a00357', 'pdu-short 8-10', 'pdu-short 8-10'],
  ['neg-pub-tcp-1cd769a9', 'pdu-short 8-10', 'pdu-short 8-10'],
  ['neg-pub-tcp-489325b7', 'pdu-short 8-10', 'count-wrong 8-9'],
  ['neg-pub-tcp-0e486f47', 'pdu-rest 12-16', 'count-wrong 8-9'],
  ['neg-pub-tcp-6c666d44', 'pdu-rest 12-17', 'pdu-rest 12-17'],
  ['neg-pub-rtu-9138e4fd', 'pdu-short 4-5', 'pdu-short 4-5'],
  ['neg-pub-rtu-6c2feb44', 'pdu-rest 6-8', 'frame-extra 9-10'],
  ['neg-pub-tcp-1db770ae', 'pdu-short 8-10', 'count-wrong 8-9'],
  ['neg-pub-tcp-03b87bb2', 'quantity-out-of-range 10-12', 'count-wrong 8-9'],
  ['neg-pub-rtu-322f1dff', 'quantity-out-of-range 4-6', 'count-wrong 2-3'],
  ['neg-pub-rtu-45307985', 'quantity-out-of-range 4-6', 'count-wrong 2-3'],
  ['neg-pub-rtu-a8c534b7', 'pdu-short 2-3', 'pdu-short 2-3'],
  ['neg-pub-tcp-c497e63c', 'pdu-rest 12-14', 'pdu-rest 12-14'],
  ['neg-pub-tcp-b5b73ba9', 'pdu-rest 8-12', 'pdu-rest 9-12'],
  ['neg-pub-tcp-e7791aec', 'quantity-out-of-range 10-12', 'count-wrong 8-9'],
  ['neg-pub-tcp-1d9ec422', 'quantity-out-of-range 10-12', 'count-wrong 8-9'],
  ['neg-pub-tcp-8e436262', 'quantity-out-of-range 10-12', 'count-wrong 8-9'],
  ['neg-pub-ascii-796cdb66', 'checksum-wrong 13-15', 'checksum-wrong 13-15'],
  ['neg-pub-ascii-fe30937e', 'checksum-wrong 13-15', 'checksum-wrong 13-15'],
  ['neg-pub-rtu-e970a901', 'frame-extra 6-8', 'frame-extra 6-8'],
  ['neg-pub-rtu-e356ce29', 'checksum-wrong 3-5', 'checksum-wrong 3-5'],
  ['neg-pub-rtu-81fe9246', 'checksum-wrong 8-10', 'frame-extra 8-10'],
  ['neg-pub-rtu-4d68b99a', 'frame-short 6-7', 'checksum-wrong 5-7'],
  ['neg-pub-rtu-9dc51211', 'frame-short 6-7', 'checksum-wrong 5-7'],
  ['neg-pub-rtu-e88e9609', 'frame-short 6-7', 'checksum-wrong 5-7'],
  ['neg-pub-rtu-a8c7fb04', 'checksum-wrong 6-8', 'checksum-wrong 6-8'],
  ['neg-pub-rtu-31d5c3bf', 'checksum-wrong 6-8', 'checksum-wrong 6-8'],
  ['neg-pub-rtu-533ec524', 'frame-short 7-8', 'checksum-wrong 6-8'],
  ['neg-pub-rtu-6daa3cab', 'frame-short 7-8', 'checksum-wrong 6-8'],
  ['neg-pub-rtu-36935f03', 'frame-extra 8-10', 'frame-extra 8-10'],
  ['neg-pub-ascii-a52b50a0', 'checksum-wrong 11-13', 'checksum-wrong 11-13'],
  ['neg-pub-ascii-d7b5847f', 'checksum-wrong 15-17', 'checksum-wrong 15-17'],
  ['neg-pub-ascii-fdb648f3', 'checksum-wrong 13-15', 'checksum-wrong 13-15'],
  ['neg-pub-rtu-36bf215e', 'checksum-wrong 6-8', 'checksum-wrong 6-8'],
  ['neg-pub-ascii-2d4c84d1', 'checksum-wrong 13-15', 'checksum-wrong 13-15'],
  ['neg-pub-rtu-bd73ada2', 'checksum-wrong 6-8', 'checksum-wrong 6-8'],
  ['neg-pub-rtu-4d72fce4', 'frame-extra 8-9', 'checksum-wrong 7-9'],
  ['neg-pub-rtu-4a714760', 'checksum-wrong 9-11', 'frame-extra 9-11'],
  ['neg-pub-rtu-41ce90dd', 'checksum-wrong 6-8', 'frame-short 7-8'],
  ['neg-der-rtu-7bafd63d', 'quantity-out-of-range 4-6'],
  ['neg-der-tcp-c01f6b88', 'quantity-out-of-range 10-12'],
  ['neg-der-rtu-d6c1908e', 'quantity-out-of-range 4-6'],
  ['neg-der-rtu-086f99dd', 'quantity-out-of-range 4-6'],
  ['neg-der-rtu-14d949f6', 'address-range-over-end 4-6'],
  ['neg-der-tcp-64e8d11b', 'address-range-over-end 10-12'],
  ['neg-der-tcp-8a682bc9', 'coil-value-illegal 10-12'],
  ['neg-der-rtu-ef247ac0', 'quantity-out-of-range 4-6'],
  ['neg-der-tcp-ebdfb53a', 'quantity-out-of-range 10-12'],
  ['neg-der-tcp-151ac66e', 'count-contradicts-quantity 12-13'],
  ['neg-der-rtu-3292f2fb', 'count-contradicts-quantity 6-7'],
  ['neg-der-tcp-bef52c18', 'count-contradicts-quantity 12-13'],
  ['neg-der-rtu-439d202d', 'quantity-out-of-range 4-6'],
  ['neg-der-tcp-6895a253', 'quantity-out-of-range 10-12'],
  ['neg-der-rtu-ae3be848', 'quantity-out-of-range 4-6'],
  ['neg-der-tcp-bca282d6', 'quantity-out-of-range 10-12'],
  ['neg-der-tcp-e904eaa9', 'count-out-of-range 8-9'],
  ['neg-der-tcp-433f731e', 'value-not-allowed 9-10'],
  ['neg-der-rtu-7355fc11', 'value-out-of-range 4-6'],
  ['neg-der-tcp-7d800771', 'value-out-of-range 10-12'],
  ['neg-der-rtu-dc1049c2', 'count-out-of-range 2-3'],
  ['neg-der-rtu-b96cb311', 'pdu-rest 12-13'],
  ['neg-der-rtu-a70a5b99', 'value-not-allowed 3-4'],
  ['neg-der-tcp-7acd2b21', 'value-not-allowed 9-10'],
  ['neg-der-rtu-546d50ca', 'value-not-allowed 3-4'],
  ['neg-der-tcp-6fc0c342', 'data-not-allowed 10-12'],
  ['neg-der-rtu-d69d3343', 'data-not-allowed 4-6'],
  ['neg-der-tcp-f943191f', 'data-not-allowed 10-12'],
  ['neg-der-rtu-02062977', 'pdu-rest 2-3'],
  ['neg-der-tcp-d9aacb85', 'pdu-rest 8-9'],
  ['neg-der-rtu-aebeaabd', 'pdu-short 4-6'],
  ['neg-der-tcp-10226104', 'count-out-of-range 10-12'],
  ['neg-der-tcp-e8a38b7f', 'count-out-of-range 8-10'],
  ['neg-der-rtu-78533bd3', 'count-odd 2-3'],
  ['neg-der-tcp-b8b23ea1', 'exception-undefined 8-9'],
  ['neg-der-rtu-c135c8c7', 'exception-undefined 2-3'],
  ['neg-der-tcp-c077eec6', 'exception-undefined 8-9'],
  ['neg-der-rtu-cfe21a0c', 'value-not-allowed 2-4'],
  ['neg-der-tcp-3c9cc3d5', 'value-not-allowed 8-10'],
  ['neg-der-rtu-d9bf0d7d', 'sub-function-without-reply 2-4'],
  ['neg-der-tcp-b682588d', 'object-count-differs 13-14'],
  ['neg-der-rtu-d86c3dd0', 'next-object-not-zero 6-7'],
  ['neg-der-tcp-b80dfea1', 'next-object-not-zero 12-13'],
  ['neg-der-tcp-a11d0011', 'value-not-allowed 10-11'],
  ['neg-der-rtu-11526768', 'checksum-wrong 6-8', 'frame-extra 6-8'],
  ['neg-der-rtu-bf9d89f1', 'checksum-wrong 6-8', 'frame-extra 6-8'],
  ['neg-der-rtu-8ab270fb', 'frame-extra 8-9'],
  ['neg-der-ascii-8ce49cfe', 'checksum-wrong 13-15', 'checksum-wrong 13-15'],
  ['neg-der-ascii-d5b09cd3', 'ascii-character 13-14', 'ascii-character 13-14'],
  ['neg-der-ascii-860c3f59', 'ascii-lower-case 8-9', 'ascii-lower-case 8-9'],
  ['neg-der-tcp-6f9d0bee', 'mbap-length-wrong 4-6', 'frame-short 11-12'],
  ['neg-der-tcp-fc6d36d6', 'frame-short 6-7', 'frame-short 6-7'],
];

test('every broken frame has its fault here', () => {
  expect(brokenFrames).toHaveLength(147);
  expect(faults.map(([id]) => id)).toEqual(brokenFrames.map(({ id }) => id));
});

describe.each(brokenFrames)('$id: $wrong', ({ id, transport, directions, hex: text }) => {
  const bytes = hex(text);
  const [, ...expected] = faults.find((fault) => fault[0] === id) ?? [id];

  test.each(directions.map((direction, i) => ({ direction, fault: expected[i] })))('as a $direction: $fault', (one) => {
    const reading = decodeFrame(bytes, { transport, direction: one.direction });
    const [code, from, to] = /^(.+) (\d+)-(\d+)$/.exec(one.fault ?? '')?.slice(1) ?? [];
    const flagged = reading.problems.filter(({ severity }) => severity !== 'note');
    for (const { span } of flagged) {
      expect(span.from).toBeLessThan(span.to);
      expect(span.to).toBeLessThanOrEqual(bytes.length);
    }
    const holding = flagged.filter(({ span }) => span.from <= Number(from) && span.to >= Number(to));
    expect(holding.map((problem) => problem.code)).toContain(code);
    expectEveryByteInOneSpan(reading, bytes.length);
    expect(encodedAgain(reading)).toBe(text);
  });
});
