import { describe, expect, it } from 'vitest';
import { looksLikeFrames } from '../../../../src/workbench/reading/looks-like-frames.ts';

describe('a text in a field for one number', () => {
  it.each([
    '06 06 02 AB 10 00 F5 E5',
    '6, 6, 2, 171, 16, 0, 245, 229',
    '0x06,0x06,0x02,0xAB,0x10,0x00',
    '[6, 6, 2, 171, 16, 0, 245, 229]',
    '060602ABF5E51000',
    ':0606 02AB'.replace(' ', ''),
    '\\x06\\x06\\x02\\xAB',
    '16#06, 16#06, 16#02, 16#AB',
    'Tx 06 06\nRx 06 86',
  ])('%j is rather a frame or a log', (text) => {
    expect(looksLikeFrames(text)).toBe(true);
  });

  it.each([
    '',
    '683',
    '0x02AB',
    '401000-401003',
    '401000–401003',
    '40108..40110',
    '40108 to 40110',
    '16#02AB',
    '02ABh',
    'P0683',
    '30 Hz',
    '1.5e3',
    '-4096',
    '%MW683',
    '4x00108',
    '1 2 3',
    '683\n',
    '12345678',
  ])('%j is not', (text) => {
    expect(looksLikeFrames(text)).toBe(false);
  });
});
