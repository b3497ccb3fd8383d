import { REFERENCE } from './address.ts';

const SEARCH = 'search';

/** What is searched for by this address. */
export const searchOf = (hash: string): string =>
  new URLSearchParams(hash.split('?').slice(1).join('?')).get(SEARCH) ?? '';

/** The address of the reference with a search. */
export const addressOf = (search: string): string =>
  search === '' ? REFERENCE : `${REFERENCE}?${new URLSearchParams({ [SEARCH]: search })}`;
