import { plural } from './common.ts';

/** What is said of a link that could not be read in full. */
export const brokenLink = {
  title: 'This link could not be read in full',
  tooLong: (length: number) => `It is too long: ${length} characters. This is its beginning:`,
  newer: (version: number) =>
    `It is from a newer version of this page: version ${version} of links. What this page knows was read.`,
  unknown: (part: string) => `“${part}” is not known and was left out.`,
  more: (count: number) => `${plural(count, 'more part')} left out.`,
};
