/** What the views are called, and what is said of a part of the page that did not come. */
export const views = {
  title: 'Framewright: Modbus frames built and explained',
  views: 'Views',
  names: { frame: 'Frame', checksum: 'Checksum', timing: 'Timing', bus: 'Bus', reference: 'Reference' },
  /** A key as keyboards print it, from a name such as `Ctrl+Enter`. */
  keyText: (key: string) => key.replace('Escape', 'Esc'),

  missing: 'This part of the page could not be loaded.',
  missingWhy:
    'Either the server is out of reach, or it has a newer version of the page, which a reload gets. A reload keeps the frame.',
  tryAgain: 'Try again',
  reload: 'Reload the page',
};
