import fc from 'fast-check';

const [SURROGATES, MANY] = [0xd800, 0x800] as const;

/** Any character of Unicode. The unit `binary` of fast-check is the same, but makes a table of all 1,112,064 of them first. */
export const anyCharacter = fc.integer({ min: 0, max: 0x10ffff - MANY }).map(
  (index) => String.fromCodePoint(index < SURROGATES ? index : index + MANY),
  (text) => {
    const [character = '', ...others] = typeof text === 'string' ? text : '';
    const code = character.codePointAt(0) ?? SURROGATES;
    const isHalf = code >= SURROGATES && code < SURROGATES + MANY;
    if (isHalf || others.length > 0) throw new TypeError('not one character');
    return code < SURROGATES ? code : code - MANY;
  },
);
