import type { SerialLine } from '../../modbus/index.ts';
import type { Names } from '../names.ts';
import type { Plan } from '../plan.ts';
import { ASK, exchangeText, FLOAT, ONCE, REPORT, setupText, UNTIL } from './arduino-shell.ts';
import { arduinoNames } from './c-names.ts';
import { requestText } from './c-posix.ts';
import { CWriter, cTarget } from './c-program.ts';
import type { CDialect } from './c-requests.ts';
import { type CFamily, cString } from './c-syntax.ts';
import { isAnswered, pauseOf } from './shell.ts';

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

class Writer extends CWriter {
  constructor(plan: Plan) {
    super({ rules: arduinoNames, family, dialect, ending: '.ino' }, plan);
  }

  protected override head(_: string, printed: string): void {
    const { requests, transport } = this.plan;
    this.printer.remark(this.lines, ...requests.map(({ about }) => about));
    this.lines.add('').add('#include <Arduino.h>');
    if (this.speaks && transport === 'tcp') this.lines.add('#include <SPI.h>').add('#include <Ethernet.h>');
    if (this.speaks) {
      this.#settings();
      // Before all routines, as prototypes of them are put in front of the first.
      this.part(requestText('long'));
    }
    if (/\bfloat_of\(/.test(printed)) this.part(FLOAT);
  }

  #settings(): void {
    const { transport, options } = this.plan;
    const { server } = options;
    const isTcp = transport === 'tcp';
    this.printer.aligned(this.lines.add(''), [
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
      { text: `#define FRAME_MOST ${this.mostBytes}`, comment: 'bytes of a frame' },
      { text: `#define TIMEOUT_MS ${options.timeout}UL`, comment: 'how long a reply may stay away' },
      {
        text: `#define SILENCE_MS ${isTcp ? 50 : pauseOf(options)}UL`,
        comment: isTcp ? 'ends a reply whose bytes do not say how long it is' : 'ends a frame: at least 3.5 characters',
      },
    ]);
    if (isTcp) {
      this.printer.remark(this.lines.add(''), 'The address that is printed on the shield.');
      this.lines
        .add('static uint8_t mac[6] = {0xDE, 0xAD, 0xBE, 0xEF, 0xFE, 0xED};')
        .add('static EthernetClient client;');
    }
  }

  /** What speaks to the device, `setup` and `loop`. */
  protected override exchange(): void {
    const { options, transport, requests, sequence } = this.plan;
    if (requests.some(isAnswered)) this.part(REPORT);
    this.requests(requests, sequence === undefined);
    this.part(exchangeText(transport, options.echo));
    this.part(ASK);
    this.sequence(UNTIL);
    const { baud } = options.line;
    this.part(setupText(transport, baud, format(options.line), sequence !== undefined));
    this.part(sequence === undefined ? ONCE : 'void loop()\n{\n}');
  }
}

/** An Arduino with a transceiver for RS-485 on `Serial1`, or with an Ethernet shield. */
export const arduino = cTarget({ id: 'arduino', name: 'Arduino', language: 'arduino' }, Writer);
