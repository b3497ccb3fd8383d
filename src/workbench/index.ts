export * from './frame/characters.ts';
export * from './frame/draft.ts';
export * from './frame/draft-of-reading.ts';
export * from './frame/evaluate.ts';
export * from './frame/expected-reply.ts';
export * from './frame/input-error.ts';
export * from './frame/link.ts';
export * from './stored.ts';
