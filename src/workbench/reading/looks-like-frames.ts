/** Hexadecimal pairs or numbers, at least four, apart as in a frame; no range, and no decimal number, is written so. */
const NUMBERS = /^[^\w\n]*(?:(?:0x|16#|\\x|\$)?[0-9a-f]{1,3}h?[\s,;:|]+){3,}(?:0x|16#|\\x|\$)?[0-9a-f]{1,3}h?\b/i;
/** Hexadecimal digits without a gap, of at least six bytes. */
const UNBROKEN = /^\s*(?:0x)?(?:[0-9a-f]{2}){6,}\s*$/i;
/** The start of an ASCII frame, SL 2.5.2.1. */
const ASCII = /^\s*:[0-9A-F]{6,}/i;
const ESCAPES = /(?:\\x[0-9a-f]{2}){4,}/i;
const LINES = /\S\s*\n\s*\S/;

/** Whether a text is rather a frame or a log than the number that a field asks for. It is not read for that. */
export const looksLikeFrames = (text: string): boolean =>
  [NUMBERS, UNBROKEN, ASCII, ESCAPES, LINES].some((shape) => shape.test(text));
