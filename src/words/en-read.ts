/** What is said where bytes are typed, pasted and read. */
export const read = {
  bytes: 'Bytes',
  bytesHint: 'Typing here changes the form. Hexadecimal pairs, or text in quotes.',
  fixChecksum: 'Fix the checksum',
};

export type ReadWords = typeof read;
