import { describe, expect, it } from 'vitest';
import { type Draft, evaluate, firstDraft, formLayout } from '../../../../src/workbench/index.ts';

const layoutOf = (change: Partial<Draft>) => {
  const draft: Draft = { ...firstDraft, texts: { functionCode: '16' }, ...change };
  return formLayout(draft, evaluate(draft));
};

describe('the form of a frame', () => {
  it('has the fields that its function lays out, and what the encoder works out', () => {
    expect(layoutOf({})).toEqual({
      envelope: ['unitId'],
      fields: ['startAddress', 'registers'],
      answering: false,
      derived: ['quantity', 'byteCount', 'checksum'],
    });
  });

  it('has the envelope of its transport', () => {
    const parts = (transport: Draft['transport']) => {
      const { envelope, derived } = layoutOf({ transport, texts: { functionCode: '3' } });
      return [envelope, derived];
    };
    expect(parts('ascii')).toEqual([['unitId'], ['checksum']]);
    expect(parts('tcp')).toEqual([
      ['transactionId', 'unitId'],
      ['protocolId', 'length'],
    ]);
    expect(parts('pdu')).toEqual([[], []]);
  });

  it('asks a reply for its request', () => {
    expect(layoutOf({ kind: 'reply' }).answering).toBe(true);
    expect(layoutOf({ kind: 'exception' }).answering).toBe(true);
  });

  it('shows what is forced among what is worked out, each once', () => {
    const { envelope, fields, derived } = layoutOf({
      force: { unitId: '[]', startAddress: '[00]', checksum: '1', after: '00' },
    });
    expect([envelope, fields]).toEqual([[], ['registers']]);
    expect(derived).toEqual(['quantity', 'byteCount', 'checksum', 'unitId', 'startAddress', 'after']);
  });
});
