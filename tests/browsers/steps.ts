import type { Driver } from './driver.ts';
import { LINK, LOG, type Step } from './step.ts';

/** Write 4096 into register 683 of unit 6, with its CRC: SL 6.2, AP 6.6. */
const WRITE = '06 06 02 AB 10 00 F5 E5';
/** 41 2D 0A 3D is 10.815 as IEEE 754 single: unit 1, two registers. */
const REPLY = '01 03 04 41 2D 0A 3D B9 77';

const bytes = (hex: string) => Uint8Array.from(hex.match(/[\da-f]{2}/gi) ?? [], (pair) => Number.parseInt(pair, 16));

/** A capture of one request and its reply, RTU (LINKTYPE_USER0). */
const PCAP = bytes(
  `d4c3b2a1 0200 0400 00000000 00000000 ffff0000 93000000
   00000000 00000000 08000000 08000000 06 03 02 a9 00 01 54 25
   00000000 e8030000 07000000 07000000 06 03 02 10 00 00 44`,
);

/** Connects to the virtual bus, with a read of unit 33 as the current frame. */
async function connect(page: Driver): Promise<void> {
  await page.open('#rtu/request?unitId=33&functionCode=3&startAddress=999&quantity=4');
  await page.click('link', 'Bus');
  await page.fill('Speed of the virtual bus', 'as fast as possible');
  await page.click('button', 'Use the virtual bus');
  await page.sees('region', 'Connection', /Connected to the virtual bus/);
}

export const steps: readonly Step[] = [
  {
    name: 'a link opens its frame',
    always: true,
    async run(page) {
      await page.open(LINK);
      await page.sees('list', 'The frame', /06.*06.*02.*AB.*10.*00.*F5.*E5/);
    },
  },
  {
    name: 'a typed value changes the bytes, and is there after a reload',
    async run(page) {
      await page.open(LINK);
      await page.fill('Value', '4097');
      await page.sees('list', 'The frame', /10.*01.*34.*25/);
      await page.reload();
      await page.sees('list', 'The frame', /10.*01.*34.*25/);
    },
  },
  {
    name: 'Back comes back from another view',
    async run(page) {
      await page.open(LINK);
      await page.click('link', 'Timing');
      await page.sees('region', 'Usual speeds', /19200/);
      await page.back();
      await page.sees('list', 'The frame', /F5.*E5/);
    },
  },
  {
    name: 'a pasted frame with a wrong CRC says why, and how it is right',
    always: true,
    async run(page) {
      await page.open();
      await page.paste(WRITE.replace('F5 E5', 'E5 F5'));
      await page.sees('region', 'The frame', /CRC/);
      await page.click('button', /^Make it valid|^Repair|F5 E5/);
      await page.sees('list', 'The frame', /F5.*E5/);
    },
  },
  {
    name: 'the frame is copied, or it is said why not',
    async run(page) {
      await page.open(LINK);
      await page.click('button', /^Copy hex/);
      await page.sees('region', 'The frame', /Copied|copy/i);
    },
  },
  {
    name: 'values are read in every type',
    async run(page) {
      await page.open();
      await page.paste(REPLY);
      await page.sees('list', 'The frame', /41 2D/);
      await page.click('tab', 'Values');
      await page.sees('region', 'Values', /10\.8\d*/);
    },
  },
  {
    name: 'the wire is drawn',
    async run(page) {
      await page.open(LINK);
      await page.click('tab', 'On the wire');
      await page.sees('region', /^Waveform/, /./);
    },
  },
  {
    name: 'the CRC is told step by step',
    async run(page) {
      await page.open(LINK);
      await page.click('tab', 'CRC');
      await page.sees('region', 'CRC', /E5F5|F5 E5/);
    },
  },
  {
    name: 'the other transports stand beside it',
    async run(page) {
      await page.open(LINK);
      await page.click('tab', 'Compare');
      await page.sees('region', 'Compare', /Transaction identifier/);
    },
  },
  {
    name: 'a program is written and highlighted',
    async run(page) {
      await page.open(LINK);
      await page.click('tab', 'Program');
      await page.fill('Program for', 'Arduino');
      await page.sees('region', /^The program /, /#include <Arduino\.h>/);
    },
  },
  {
    name: 'a pasted log opens in the Log view, and F8 finds its faults',
    always: true,
    async run(page) {
      await page.open();
      await page.paste(LOG);
      await page.sees('main', undefined, /6 frames, 3 exchanges/);
      await page.press('F8');
      await page.sees('main', undefined, /210 ms/);
    },
  },
  {
    name: 'a capture is opened',
    async run(page, { file }) {
      await page.open('#log');
      await page.attach(/^Open file/, file('two.pcap', PCAP));
      await page.sees('main', undefined, /2 frames, 1 exchange/);
    },
  },
  {
    name: 'a filter keeps what it names',
    async run(page) {
      await page.open();
      await page.paste(LOG);
      await page.sees('main', undefined, /6 frames/);
      await page.fill(/^Filter/, 'exception:02');
      await page.sees('listbox', undefined, /ILLEGAL DATA ADDRESS/i);
    },
  },
  {
    name: 'a device on the virtual bus answers',
    always: true,
    async run(page) {
      await connect(page);
      await page.click('button', 'Send');
      await page.sees('main', undefined, /21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18/);
    },
  },
  {
    name: 'a poll shows its values and a chart',
    async run(page) {
      await connect(page);
      await page.click('tab', 'Poll');
      await page.fill('Interval (ms)', '20');
      await page.click('button', 'Start');
      await page.sees('region', /^Values: /, /\d\d rounds/);
      await page.sees('region', 'Chart', /./);
      await page.click('button', 'Stop');
    },
  },
  {
    name: 'a scan finds the devices',
    async run(page) {
      await connect(page);
      await page.click('tab', 'Scan');
      await page.fill('Last unit', '9');
      await page.fill('Wait for a reply (ms)', '20');
      await page.click('button', 'Start the scan');
      await page.sees('region', 'What was found', /Unit.* 1 01 .* 6 06 .* 9 09 /);
    },
  },
  {
    name: 'where there is no serial port to be had, it is said',
    async run(page) {
      await page.open('#bus');
      const serial = await page.ask(() => 'serial' in navigator);
      await page.sees('region', 'Connection', serial ? /Connect…/ : /Web Serial/);
    },
  },
  {
    name: 'checksums of typed bytes',
    async run(page) {
      await page.open('#checksum');
      await page.fill('Bytes, written in any way', '31 32 33 34 35 36 37 38 39');
      await page.sees('region', 'Checksums', /0x4B37/);
    },
  },
  {
    name: 'the checksum of a file comes from a worker',
    async run(page, { file }) {
      await page.open('#checksum');
      await page.attach(/^Open a file/, file('check.bin', new TextEncoder().encode('123456789')));
      await page.sees('main', undefined, /0x4B37/);
    },
  },
  {
    name: 'times at another speed',
    async run(page) {
      await page.open('#timing');
      await page.fill('Speed, bits a second', '9600');
      await page.sees('region', 'Character and silences', /1\.146 ms|1,146|1146/);
    },
  },
  {
    name: 'the reference is searched',
    async run(page) {
      await page.open('#reference');
      await page.fill('Search the reference', '0x2B');
      await page.sees('main', undefined, /Encapsulated Interface Transport/);
    },
  },
  {
    name: 'a device gives names to registers',
    async run(page) {
      await page.open(LINK);
      await page.click('button', /^Device: /);
      await page.click('button', /^WEG drive/);
      await page.sees('main', undefined, /P0683 speed reference/);
    },
  },
  {
    name: 'a saved frame is there after a reload',
    async run(page) {
      await page.open(LINK);
      await page.click('button', 'All examples and saved frames');
      await page.click('tab', /^Saved frames/);
      await page.fill('Name of this frame', 'Thirty hertz');
      await page.click('button', 'Save this frame');
      await page.reload();
      await page.click('button', 'All examples and saved frames');
      await page.click('tab', /^Saved frames/);
      await page.sees('main', undefined, /Thirty hertz/);
    },
  },
];
