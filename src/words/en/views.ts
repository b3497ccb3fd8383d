import type { Adapter, LinkState } from '../../bus/index.ts';
import { type SerialLine, serialFormatName } from '../../modbus/index.ts';
import type { Theme } from '../../workbench/index.ts';

const adapterShort = ({ kind, maker, chip }: Adapter): string => {
  if (kind === 'virtual') return 'Virtual bus';
  if (kind === 'bluetooth') return 'Bluetooth port';
  if (kind === 'port') return 'Serial port';
  return maker === undefined ? 'USB adapter' : `${maker} ${chip ?? 'adapter'}`;
};

/** How the line is connected, in a few words. */
function connection(link: LinkState): string {
  switch (link.kind) {
    case 'open':
      return adapterShort(link.adapter);
    case 'opening':
      return 'Connecting…';
    case 'choosing':
      return 'Choosing a port…';
    case 'closing':
      return 'Closing…';
    case 'lost':
      return 'Adapter lost';
    case 'no-session':
      return link.why === 'died' ? 'Connection ended unexpectedly' : 'Not connected';
    default:
      return 'Not connected';
  }
}

/** The shell of the page: what the views are called, the header, and what is said of a part that did not come. */
export const views = {
  title: 'Framewright: Modbus frames built and explained',
  /** The title of the window while a frame is shown, from the first bytes of the frame. */
  frameTitle: (bytes: string) => `${bytes} · Framewright`,
  views: 'Views',
  names: {
    frame: 'Frame',
    log: 'Log',
    checksum: 'Checksum',
    timing: 'Timing',
    bus: 'Bus',
    devices: 'Devices',
    reference: 'Reference',
  },
  skip: 'Skip to the content',
  /** A key as keyboards print it, from a name such as `Ctrl+Enter`. */
  keyText: (key: string) => key.replace('Escape', 'Esc'),
  settings: 'Settings',
  device: (name: string) => `Chosen device: ${name}`,
  noDevice: 'No device',
  line: (setting: string) => `Serial line: ${setting}`,
  lineName: (line: SerialLine) => `${line.baud} ${serialFormatName(line)}`,
  connection,
  connectionTitle: 'Connection: open the Bus view',
  theme: 'Colours',
  themes: { system: 'Auto', light: 'Light', dark: 'Dark' } satisfies Record<Theme, string>,

  print: 'Print this frame',
  /** On paper, where the sheet was not there in time. */
  printAgain: 'Print again for the sheet with the waveform.',

  missing: 'This part of the page could not be loaded.',
  missingWhy:
    'Either the server is out of reach, or it has a newer version of the page, which a reload gets. A reload keeps the frame.',
  failed: (fault: string) => `This part of the page has failed: ${fault}. A reload keeps the frame.`,
  tryAgain: 'Try again',
  reload: 'Reload the page',
};
