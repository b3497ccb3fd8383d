/** What the list of keys says. */
export const commands = {
  heading: 'Keys',
  titles: {
    stop: 'Stop the sequence that runs',
    close: 'Close what is open',
    'focus-input': 'Go to the input',
    send: 'Send the frame',
    'copy-frame': 'Copy the frame',
    'next-fault': 'Go to the next fault',
    'previous-fault': 'Go to the previous fault',
    print: 'Print a sheet of the frame',
    'view-frame': 'Open the Frame view',
    'view-log': 'Open the Log view',
    'view-checksum': 'Open the Checksum view',
    'view-timing': 'Open the Timing view',
    'view-bus': 'Open the Bus view',
    'view-devices': 'Open the Devices view',
    'view-reference': 'Open the Reference view',
    keys: 'Show this list',
  },
  singleKeys: 'Characters without Ctrl are keys too, outside of text fields',
  close: 'Close',
};
