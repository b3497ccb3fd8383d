import { MOST_ASCII, MOST_RTU, MOST_TCP, type SerialLine } from '../../modbus/index.ts';
import { Names } from '../names.ts';
import type { Plan, ProgramNote } from '../plan.ts';
import { CodePrinter } from '../print.ts';
import type { Target } from '../target.ts';
import { Lines, type WrittenFile } from '../written.ts';
import { ASK, exchangeText, FLOAT, ONCE, REPORT, setupText, UNTIL } from './arduino-shell.ts';
import { arduinoNames } from './c-names.ts';
import { requestText } from './c-posix.ts';
import { type CDialect, hasStep, RequestWriter } from './c-requests.ts';
import { type CFamily, cString, cSyntax, cType, withoutComments } from './c-syntax.ts';
import { isAnswered, partsOf, pauseOf, programName } from './shell.ts';

/** C++ of Arduino: an `int` may have 16 bits, and tables stand in flash memory. */
const family = (own: string, names: Names): CFamily => ({
  name: names.of,
  own,
  real: 'double',
  int: (of) => (of === 'place' ? 'int' : 'long'),
  dword: 'UL',
  wordsAreInts: false,
  memory: { mark: ' PROGMEM', read: (type, element) => `pgm_read_${type}(&${element})` },
  texts: 'const __FlashStringHelper *',
  string: flashString,
});

const flashString = (text: string): string => `F(${cString(text)})`;

/** An Arduino with a transceiver for RS-485 on `Serial1`, or with an Ethernet shield. */
export const arduino: Target = {
  id: 'arduino',
  name: 'Arduino',
  language: 'arduino',
  proof: 'run',
  parts: ['bytes', 'build', 'check', 'exchange'],
  transports: ['rtu', 'ascii', 'tcp', 'pdu'],
  sequences: true,
  write: (plan) => {
    const writer = new Writer(plan);
    const files = [writer.write()];
    return { files, notes: writer.notes };
  },
};

const MOST = { rtu: MOST_RTU, ascii: MOST_ASCII, tcp: MOST_TCP, pdu: MOST_RTU } as const;

const dialect: CDialect = {
  result: 'long',
  copy: 'memcpy_P',
  wait: 'delay',
  port: { parameter: 'void', argument: '' },
  value: (_, name, value, unit) => [
    `Serial.print(F("  ${cString(name).slice(1, -1)} = "));`,
    `Serial.${unit === '' ? 'println' : 'print'}(${value});`,
    ...(unit === '' ? [] : [`Serial.println(F(" ${cString(unit).slice(1, -1)}"));`]),
  ],
  element: (_, array) => [
    `Serial.print(F("  ${array}["));`,
    'Serial.print(i);',
    'Serial.print(F("] = "));',
    `Serial.println(${array}[i]);`,
  ],
};

const format = ({ dataBits, parity, stopBits }: SerialLine): string =>
  `SERIAL_${dataBits}${parity[0]?.toUpperCase()}${stopBits}`;

class Writer {
  readonly #lines = new Lines('    ');
  readonly #notes: ProgramNote[] = [];
  readonly #plan: Plan;
  readonly #speaks: boolean;
  readonly #names: Names;
  readonly #printer: CodePrinter;

  constructor(plan: Plan) {
    this.#plan = plan;
    this.#speaks = plan.transport !== 'pdu' && partsOf(plan).exchanges;
    this.#names = new Names(arduinoNames, plan.options.names);
    const syntax = cSyntax(family(this.#speaks ? 'static ' : '', this.#names));
    this.#printer = new CodePrinter(syntax, plan.code, plan.options.comments);
  }

  get notes(): readonly ProgramNote[] {
    return [...this.#notes, ...this.#names.notes];
  }

  write(): WrittenFile {
    const { code, options, requests, transport } = this.#plan;
    const lines = this.#lines;
    const printed = new Lines('    ');
    this.#printer.code(printed, code);
    this.#printer.remark(lines, ...requests.map(({ about }) => about));
    lines.add('').add('#include <Arduino.h>');
    if (this.#speaks && transport === 'tcp') lines.add('#include <SPI.h>').add('#include <Ethernet.h>');
    if (this.#speaks) {
      this.#settings();
      // Before all routines, as prototypes of them are put in front of the first.
      this.#shell(requestText('long'));
    }
    if (/\bfloat_of\(/.test(printed.file('').text)) this.#shell(FLOAT);
    this.#printer.code(lines, code);
    if (this.#speaks) this.#exchange();
    else if (options.part === 'exchange') this.#notes.push({ code: 'not-offered', what: 'exchange' });
    return lines.file(`${this.#names.of(programName(this.#plan), 'routine')}.ino`);
  }

  #shell(text: string): void {
    this.#lines.add('').text(this.#plan.options.comments ? text : withoutComments(text));
  }

  #settings(): void {
    const { transport, options } = this.#plan;
    const { server } = options;
    const isTcp = transport === 'tcp';
    this.#printer.aligned(this.#lines.add(''), [
      ...(isTcp
        ? [
            { text: '#define MODBUS client', comment: 'the connection' },
            { text: `#define SERVER ${cString(server.host)}`, comment: 'the address or name of the device' },
            { text: `#define SERVER_PORT ${server.port}` },
          ]
        : [
            { text: '#define MODBUS Serial1', comment: 'the serial port of the transceiver' },
            { text: '#define DIRECTION_PIN 2', comment: 'DE and RE of the transceiver: high while it sends' },
          ]),
      { text: `#define FRAME_MOST ${MOST[transport]}`, comment: 'bytes of a frame' },
      { text: `#define TIMEOUT_MS ${options.timeout}UL`, comment: 'how long a reply may stay away' },
      {
        text: `#define SILENCE_MS ${isTcp ? 50 : pauseOf(options)}UL`,
        comment: isTcp ? 'ends a reply whose bytes do not say how long it is' : 'ends a frame: at least 3.5 characters',
      },
    ]);
    if (isTcp) {
      this.#printer.remark(this.#lines.add(''), 'The address that is printed on the shield.');
      this.#lines
        .add('static uint8_t mac[6] = {0xDE, 0xAD, 0xBE, 0xEF, 0xFE, 0xED};')
        .add('static EthernetClient client;');
    }
  }

  /** What speaks to the device, `setup` and `loop`. */
  #exchange(): void {
    const { options, transport, requests, sequence } = this.#plan;
    const written = new RequestWriter(
      this.#lines,
      this.#printer,
      (type) => cType(family('', this.#names), type),
      dialect,
    );
    if (requests.some(isAnswered)) this.#shell(REPORT);
    written.requests(requests, sequence === undefined);
    this.#shell(exchangeText(transport, options.echo));
    this.#shell(ASK);
    if (sequence !== undefined) {
      if (hasStep('until', sequence)) this.#shell(UNTIL);
      written.sequence(sequence);
    }
    const { baud } = options.line;
    this.#shell(setupText(transport, baud, format(options.line), sequence !== undefined));
    this.#shell(sequence === undefined ? ONCE : 'void loop()\n{\n}');
  }
}
