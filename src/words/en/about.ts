/** What the page says of itself. */
export const about = {
  title: 'About this page',
  hidden: 'Below the tables, when nothing is searched for.',
  version: (version: string) => `Framewright ${version}, free software under the MIT licence.`,
  stays:
    'What is typed, pasted or opened here stays in this browser: the page sends nothing anywhere but to the port that is connected.',
  contains: 'It contains these packages of others, unchanged:',
  package: (name: string, version: string, licence: string) => `${name} ${version}, ${licence}`,
};
