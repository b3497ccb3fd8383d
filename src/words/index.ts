export type { AddressWords } from './en/addresses.ts';
export type { CompareWords } from './en/compare.ts';
export type { Complaints } from './en/complaints.ts';
export type { Words } from './en/en.ts';
export type { ToolWords } from './en/tools.ts';
export type { ValueWords } from './en/values.ts';
export type { WireWords } from './en/wire.ts';
export { type Language, languages, languageTag, type Subject, type WordsOf } from './languages.ts';
export { Vocabulary } from './vocabulary.ts';
