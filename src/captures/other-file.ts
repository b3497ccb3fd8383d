/** What a file is by its first bytes that is not traffic and is opened by mistake. */
export type OtherFile = 'zip' | 'picture' | 'pdf' | 'program';

/** The first bytes by which files of other kinds are known, each byte as a character. */
const SIGNATURES: readonly (readonly [OtherFile, string])[] = [
  ['zip', 'PK\x03\x04'],
  ['picture', '\x89PNG\r\n\x1a\n'],
  ['picture', '\xff\xd8\xff'],
  ['picture', 'GIF8'],
  ['pdf', '%PDF-'],
  ['program', '\x7fELF'],
  ['program', 'MZ\x90\x00'],
];

/** What a file is that is neither a text nor traffic; `undefined` if its first bytes do not say. */
export const otherFile = (bytes: Uint8Array): OtherFile | undefined =>
  SIGNATURES.find(([, signature]) =>
    Array.from(signature).every((character, at) => bytes[at] === character.charCodeAt(0)),
  )?.[0];
