// What the first view says, and what other subjects take from it: they import it here, so that it comes as one file.
export { addressIn, capital, elementIn } from './address.ts';
export { en } from './en.ts';
export { en as fields } from './fields.ts';
export { input } from './input.ts';
export { all, byte, byteHex, bytesOf, code, grouped, plural, sizeOf, word } from './numbers.ts';
export { page } from './page.ts';
export { tools } from './tools.ts';
export { views } from './views.ts';
