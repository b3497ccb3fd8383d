import type { Adapter, Doubt, LineError, LinkSettings, LinkState, Refusal } from '../../bus/index.ts';
import { hexDigits } from '../../modbus/index.ts';
import { byteHex, grouped, plural } from './common.ts';
import { send } from './sent.ts';

const adapterName = ({ kind, maker, chip, vendorId, productId }: Adapter): string => {
  if (kind === 'virtual') return 'the virtual bus';
  if (kind === 'bluetooth') return 'a Bluetooth serial port';
  if (kind === 'port') return 'a serial port of this computer';
  const ids = [vendorId, productId].map((id) => hexDigits(id ?? 0, 4)).join(':');
  if (maker === undefined) return `a USB adapter (${ids})`;
  return chip === undefined ? `a USB adapter by ${maker} (${ids})` : `${maker} ${chip}`;
};

const settingsName = ({ baud, dataBits, parity, stopBits }: LinkSettings) =>
  `${baud} baud, ${dataBits}${parity[0]?.toUpperCase()}${stopBits}`;

/** A connection in words: what it is, and what to do if it does not work. */
export interface LinkWords {
  readonly is: string;
  readonly todo?: string;
}

const links: { readonly [K in LinkState['kind']]: (state: Extract<LinkState, { kind: K }>) => LinkWords } = {
  closed: () => ({ is: 'Not connected.' }),
  unsupported: ({ why }) =>
    why === 'insecure'
      ? {
          is: 'This page came over an insecure connection, and browsers give serial ports to secure pages only.',
          todo: 'Open it over https, or from localhost. The virtual bus works here too.',
        }
      : {
          is: 'This browser has no Web Serial, the way from a page to a serial port.',
          todo: 'Chrome, Edge and Opera on a computer have had it since version 89, and newer versions of some other browsers have it. The virtual bus and everything else on this page work here too.',
        },
  choosing: () => ({ is: 'Choose a port in the browser’s list.' }),
  refused: ({ why }) =>
    ({
      cancelled: {
        is: 'No port was chosen.',
        todo: 'Connect again, and choose one in the list. An adapter that is plugged in while the list is open appears in it.',
      },
      policy: {
        is: 'The browser did not show its list of ports.',
        todo: 'Serial ports may be blocked for this page: look at the site settings beside the address, or ask who manages this browser.',
      },
      'no-gesture': {
        is: 'The browser shows its list of ports only when a button is pressed.',
        todo: 'Press Connect.',
      },
    })[why],
  'no-session': ({ why }) =>
    ({
      'not-loaded': {
        is: 'The part of this page that works on the line did not load.',
        todo: 'Check the network, and connect again.',
      },
      died: {
        is: 'The part of this page that works on the line has ended unexpectedly, and the connection with it.',
        todo: 'Perhaps the browser was short of memory. Connect again.',
      },
      forbidden: {
        is: 'The browser does not let this page work in the background, which it needs for the line.',
        todo: 'A policy of the browser or of the server forbids workers: ask who manages them.',
      },
    })[why],
  opening: ({ adapter }) => ({ is: `Opening ${adapterName(adapter)}…` }),
  open: ({ adapter, settings }) => ({ is: `Connected to ${adapterName(adapter)}, ${settingsName(settings)}.` }),
  taken: ({ adapter, by }) => ({
    is: `${adapterName(adapter)} is there, but does not open.`,
    todo:
      by === 'this-page'
        ? 'Another tab with this page has it open: close it there.'
        : 'Another program or another tab has it, or it was pulled out since. Close that program (a terminal, the PLC’s software) or that tab, look at the plug, and connect again. On Linux the user must be in the group dialout.',
  }),
  failed: ({ adapter, settings, message }) => ({
    is: `${adapterName(adapter)} did not open with ${settingsName(settings)}: ${message}`,
    todo: 'Some adapters do not know every speed or format: try 9600 baud, 8N1.',
  }),
  closing: () => ({ is: 'Closing…' }),
  lost: ({ adapter, why }) => ({
    is:
      why === 'unplugged' ? `${adapterName(adapter)} was pulled out.` : `${adapterName(adapter)} has stopped working.`,
    todo: 'Plug it in again and connect. An adapter without a serial number has to be chosen in the list again.',
  }),
};

const doubts: { readonly [D in Doubt]: (units: string) => string } = {
  'first-write': (units) => `This may change something in device ${units}. You will be asked once per device.`,
  broadcast: () => 'This is a broadcast: every device on the line obeys it, and no device answers.',
  'breaks-rule': () => 'This frame breaks a rule of the specification: what a device does with it is unknown.',
};

const refusals: Readonly<Record<Refusal, string>> = {
  'read-only': 'Not sent: it may change something in a device, and “Read only” is on.',
  serving:
    'Not sent: the virtual devices answer on this line, and another master asks. Stop them under “Virtual devices”.',
  listening: 'Not sent: this page is listening, and sends nothing meanwhile. Stop listening first.',
  scanning: 'Not sent: a scan tries other speeds and formats. Stop it first, or wait for its end.',
  busy: 'Not begun: something else is being sent. Stop it first.',
};

const codes = (list: readonly number[]) => list.map(byteHex).join(', ');

/** The sentences of the Bus view. */
export const bus = {
  title: 'Bus · Framewright',
  tabs: {
    label: 'What to do on the line',
    names: {
      reply: 'Reply',
      frame: 'Frame',
      'no-answer': 'No answer',
      poll: 'Poll',
      scan: 'Scan',
      listen: 'Listen',
      sequence: 'Sequence',
      virtual: 'Virtual devices',
    },
  },
  heading: 'Connection',
  connect: 'Connect…',
  connectAgain: 'Choose another port…',
  remembered: (adapter: Adapter) => `Connect to ${adapterName(adapter)}`,
  virtual: 'Use the virtual bus',
  pace: {
    label: 'Speed of the virtual bus',
    paces: { line: 'as on a real line', fast: 'as fast as possible' },
  },
  serving: 'The virtual devices answer what arrives here. Meanwhile the page itself sends nothing.',
  disconnect: 'Disconnect',
  change: 'Change',
  adapterName,
  link: (state: LinkState): LinkWords => (links[state.kind] as (state: LinkState) => LinkWords)(state),
  linkShort: (state: LinkState) => {
    if (state.kind === 'lost') return 'The adapter is lost';
    if (state.kind === 'no-session' && state.why === 'died') return 'The connection has ended unexpectedly';
    return state.kind === 'open' ? `Connected to ${adapterName(state.adapter)}, ${settingsName(state.settings)}` : '';
  },
  inWindow:
    'Two adapters of the same kind are plugged in, which only this window can tell apart: in a hidden tab the browser may slow the bus down.',
  settings: {
    heading: 'Speed and format',
    baud: 'Speed (baud)',
    baudWrong: 'A whole number from 50 to 4,000,000, decimal or hexadecimal (0x…).',
    dataBits: 'Data bits',
    parity: 'Parity',
    stopBits: 'Stop bits',
    flowControl: 'Flow control',
    bufferSize: 'Buffer (bytes)',
    bufferWrong: 'A whole number from 1 to 16,777,216.',
    parities: { none: 'none', even: 'even', odd: 'odd' },
    flows: { none: 'none', hardware: 'hardware (RTS/CTS)' },
    later: (settings: LinkSettings) => `${settingsName(settings)}: applies at the next connection.`,
    now: 'Connect again now',
  },
  rules: {
    heading: 'Transactions',
    timeout: 'Time-out (ms)',
    retries: 'Retries',
    turnaround: 'After a broadcast (ms)',
    echo: 'Echo of the adapter',
    quiet: 'Quiet after a time-out',
    quietHint: (timeout: number) =>
      `A request that a late reply could answer waits until that reply has come, at most ${timeout} ms more. Without this pause, more replies are doubtful.`,
    echoes: { auto: 'find out', on: 'remove it', off: 'it has none' },
    wrong: (least: number, most: number) => `A whole number from ${least} to ${most}, decimal or hexadecimal (0x…).`,
  },
  signals: {
    heading: 'Lines of the adapter',
    dtr: 'DTR',
    rts: 'RTS',
    refused: 'This adapter has no such lines, or does not let them be set.',
    inputs: (cts: boolean, dsr: boolean, dcd: boolean, ri: boolean) =>
      `CTS ${cts ? 'on' : 'off'}, DSR ${dsr ? 'on' : 'off'}, DCD ${dcd ? 'on' : 'off'}, RI ${ri ? 'on' : 'off'}.`,
  },
  guard: {
    readOnly: 'Read only: send nothing that may change a device',
    /** @param some functions of which not every request reads */
    readOnlyCodes: (all: readonly number[], some: readonly number[]) =>
      `Allowed: ${codes(all)}; of ${codes(some)} what only reads.`,
    sendOnce: 'Send this one',
    refusals,
    title: 'Send this request?',
    doubt: (why: Doubt, units: readonly (number | undefined)[]) =>
      doubts[why](units.map((unit) => unit ?? '?').join(', ')),
    more: (count: number) => `and ${count} more`,
    yes: 'Send',
    no: 'Do not send',
  },
  send,
  errors: (counts: Readonly<Record<LineError, number>>) => {
    const names: Readonly<Record<LineError, string>> = {
      parity: 'parity',
      framing: 'framing',
      overrun: 'overrun',
      break: 'break',
      unknown: 'other',
    };
    const parts = (Object.keys(names) as readonly LineError[]).flatMap((name) =>
      counts[name] > 0 ? [`${counts[name]} ${names[name]}`] : [],
    );
    return parts.length === 0
      ? ''
      : `Errors of the line: ${parts.join(', ')}. Parity and framing errors mean another speed or format, or a bad cable.`;
  },
  log: {
    heading: 'Log',
    empty: 'Nothing has been sent or received yet.',
    follow: 'Follow',
    pause: 'Pause',
    clear: 'Clear',
    undo: 'Undo clear',
    openInLog: 'Open in Log',
    held: (count: number) => `Paused: ${plural(count, 'frame')} not shown yet.`,
    oldest: (most: number) => `The log keeps at least the last ${grouped(most)} frames.`,
    restored: (count: number) => `${plural(count, 'frame')} from before the page was loaded again.`,
    survives: (most: number) => `If the page is loaded again, the last ${grouped(most)} frames at most stay.`,
  },
};
