import type { Trouble, TroublePlace } from '../../workbench/index.ts';

/** Signs that something is wrong on the line, and what is usual behind them. */
export const troubles = {
  silence: {
    title: 'No answer (time-out, timeout)',
    text: 'Check in this order: the number of the unit, speed and parity, wires A and B, an echo of the adapter, a gap inside the request, power, termination.',
  },
  broadcast: {
    title: 'No answer to unit 0',
    text: 'That is a broadcast: every device takes it, and none answers.',
  },
  sometimes: {
    title: 'An answer now and then',
    text: 'Termination (120 Ω) at both ends and nowhere else, a bias (polarization) that holds the idle line, a common ground. Or two clients ask on one line.',
  },
  late: {
    title: 'The answer comes after the time-out (timeout)',
    text: 'The device needs longer than the client waits (response timeout), or answers the request before. Wait longer, or ask for less.',
  },
  echo: {
    title: 'The request comes back (echo)',
    text: 'The adapter hears what it sends on two wires. The echo is taken off before the reply is read; the bus finds out by itself whether there is one, unless you set it.',
  },
  checksum: {
    title: 'The CRC of a reply does not hold',
    text: 'Bytes are lost or changed on the way: noise, no termination, another format than the device has, or two devices that answer at once.',
  },
  garbage: {
    title: 'Bytes come that are no frame',
    text: 'Speed or parity is not that of the device, or wires A and B are swapped, so that every bit is inverted.',
  },
  otherDevice: {
    title: 'Two devices have one number',
    text: 'Both answer, and the line carries neither. Take one off the line, and scan.',
  },
} satisfies Record<Trouble, { readonly title: string; readonly text: string }>;

/** The link to the place of the page that helps. */
export const troublePlaces: Readonly<Record<TroublePlace, string>> = {
  checklist: 'The checklist of the bus',
  scan: 'Scan for units and speeds',
  bus: 'Settings of the bus',
  timing: 'Times of an exchange',
  wire: 'The frame on the wire',
};
