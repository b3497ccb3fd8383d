import { describe, expect, it } from 'vitest';
import { firstFrame, identityOf } from '../../../../src/workbench/reading/item-identity.ts';
import { readText } from '../../../../src/workbench/reading/read-text.ts';

const hex = (bytes: Uint8Array | undefined) => bytes && Buffer.from(bytes).toString('hex').toUpperCase();
const log = readText('TX: 11 03 00 6B 00 01 F7 16\nRX: 11 03 02 02 2B F9 F8', undefined);

describe('what an item of a text may be', () => {
  it('is the likeliest reading first, of a reply with the request that it answers', () => {
    const reply = identityOf(log, 1)!;
    expect(hex(reply.bytes)).toBe('110302022BF9F8');
    expect(hex(reply.request)).toBe('1103006B0001F716');
    expect(reply.identities[0]).toMatchObject({ transport: 'rtu', direction: 'response' });
    expect(identityOf(log, 0)!.request).toBeUndefined();
    expect(identityOf(log, 2)).toBeUndefined();
  });

  it('is asked with the request that waits, if it is not a sound answer', () => {
    const wrong = readText('TX: 11 03 00 6B 00 01 F7 16\nRX: 11 03 02 02 2B F9 00', undefined);
    expect(hex(identityOf(wrong, 1)!.request)).toBe('1103006B0001F716');
    // A text that says it is a request has none.
    const twice = readText('TX: 11 03 00 6B 00 01 F7 16\nTX: 11 03 00 6B 00 01 F7 00', undefined);
    expect(identityOf(twice, 1)!.request).toBeUndefined();
  });
});

describe('the item that is shown first', () => {
  it('is the first frame, or else the first bytes', () => {
    expect(firstFrame(log)).toBe(0);
    const noise = readText('FF FF FF\n\n11 03 00 6B 00 01 F7 16', undefined);
    expect(noise.items[firstFrame(noise)]).toMatchObject({ kind: 'frame' });
    expect(firstFrame(readText('FF FF', undefined))).toBe(0);
    expect(firstFrame(readText('', undefined))).toBe(0);
  });
});
