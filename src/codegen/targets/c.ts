import { MOST_ASCII, MOST_RTU, MOST_TCP } from '../../modbus/index.ts';
import { Names } from '../names.ts';
import type { Plan, ProgramNote } from '../plan.ts';
import { CodePrinter } from '../print.ts';
import type { Target } from '../target.ts';
import { Lines, type WrittenFile } from '../written.ts';
import { cNames } from './c-names.ts';
import { ASK, exchangeText, floatText, mainText, openingText, REPORT, requestText, UNTIL } from './c-posix.ts';
import { type CDialect, hasStep, RequestWriter } from './c-requests.ts';
import { type CFamily, cString, cSyntax, cType, withoutComments } from './c-syntax.ts';
import { isAnswered, partsOf, pauseOf, programName, SILENCE } from './shell.ts';

/** What C99 writes; `own` stands before what only this file uses. */
const family = (own: string, names: Names): CFamily => ({
  name: names.of,
  own,
  real: 'double',
  int: () => 'int',
  dword: 'u',
  wordsAreInts: true,
  texts: 'const char *',
  string: cString,
});

/** C99 without allocation; POSIX for what speaks to the device. */
export const c: Target = {
  id: 'c',
  name: 'C99',
  language: 'c',
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

const FORMATS = { byte: '%u', word: '%u', dword: '%" PRIu32 "', int: '%d', bool: '%d', real: '%.10g' } as const;

const dialect: CDialect = {
  result: 'int',
  copy: 'memcpy',
  wait: 'wait_ms',
  port: { parameter: 'int port', argument: 'port, ' },
  value: (type, name, value, unit) => [
    `printf("  %s = ${FORMATS[type]}${unit && ' %s'}\\n", ${[cString(name), value, ...(unit === '' ? [] : [cString(unit)])].join(', ')});`,
  ],
  element: (type, array) => [`printf("  ${array}[%d] = ${FORMATS[type]}\\n", i, ${array}[i]);`],
};

const MOST = { rtu: MOST_RTU, ascii: MOST_ASCII, tcp: MOST_TCP, pdu: MOST_RTU } as const;

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
    this.#names = new Names(cNames, plan.options.names);
    const syntax = cSyntax(family(this.#speaks ? 'static ' : '', this.#names));
    this.#printer = new CodePrinter(syntax, plan.code, plan.options.comments);
  }

  get notes(): readonly ProgramNote[] {
    return [...this.#notes, ...this.#names.notes];
  }

  write(): WrittenFile {
    const { code, options } = this.#plan;
    const printed = new Lines('    ');
    this.#printer.code(printed, code);
    const name = this.#names.of(programName(this.#plan), 'routine');
    this.#head(name, printed.file('').text);
    this.#printer.code(this.#lines, code);
    if (this.#speaks) this.#exchange();
    else if (options.part === 'exchange') this.#notes.push({ code: 'not-offered', what: 'exchange' });
    return this.#lines.file(`${name}.c`);
  }

  /** Whether anything waits for a time. */
  get #waits(): boolean {
    const { transport, sequence } = this.#plan;
    return transport === 'rtu' || (sequence !== undefined && WAITS.some((kind) => hasStep(kind, sequence)));
  }

  #shell(text: string): void {
    this.#lines.add('').text(this.#plan.options.comments ? text : withoutComments(text));
  }

  #head(name: string, printed: string): void {
    const { requests, transport, sequence } = this.#plan;
    const [floors, floats, bools] = [/\bfloor\(/, /\bfloat_of\(/, /\b(bool|true|false)\b/].map((sign) =>
      sign.test(printed),
    );
    this.#printer.remark(this.#lines, ...requests.map(({ about }) => about));
    if (this.#speaks && this.#printer.comments) {
      const several = requests.length > 1;
      const usage: readonly (readonly [string, string])[] = [
        [
          `[${transport === 'tcp' ? 'HOST' : 'PORT'}]`,
          sequence ? 'carries out the steps' : 'sends, and prints what the reply says',
        ],
        ['--bytes', 'prints the bytes that are sent'],
        [
          `--check HEX${several ? ' [NUMBER]' : ''}`,
          `checks a reply${several ? ' to the request of this number, from 1' : ''}`,
        ],
      ];
      const width = Math.max(...usage.map(([command]) => command.length));
      const how = usage.map(([command, does]) => `// ./${name} ${command.padEnd(width)}  ${does}`);
      this.#lines.text(['//', `// cc -std=c99 -O2 -o ${name} ${name}.c${floors ? ' -lm' : ''}`, ...how].join('\n'));
    }
    const headers = [
      'stdint.h',
      ...(floors ? ['math.h'] : []),
      ...(floats ? ['string.h'] : []),
      ...(bools ? ['stdbool.h'] : []),
      ...(this.#speaks && requests.length > 1 ? ['stdlib.h'] : []),
      ...(this.#speaks && this.#waits ? ['errno.h'] : []),
      ...(requests.some(({ values }) => values.some(({ type }) => type === 'dword')) ? ['inttypes.h'] : []),
      ...(this.#speaks ? [...OWN_HEADERS, ...(transport === 'tcp' ? TCP_HEADERS : SERIAL_HEADERS)] : []),
    ];
    this.#lines.add('');
    if (this.#speaks) this.#lines.add('#define _DEFAULT_SOURCE').add('');
    for (const header of [...new Set(headers)].sort()) this.#lines.add(`#include <${header}>`);
    if (this.#speaks) this.#settings();
    if (floats) this.#shell(floatText(this.#speaks ? 'static ' : ''));
  }

  #settings(): void {
    const { transport, options } = this.#plan;
    this.#printer.aligned(this.#lines.add(''), [
      { text: `#define FRAME_MOST ${MOST[transport]}`, comment: 'bytes of a frame' },
      { text: `#define TIMEOUT_MS ${options.timeout}`, comment: 'how long a reply may stay away' },
      { text: `#define SILENCE_MS ${SILENCE}`, comment: 'ends a reply whose bytes do not say how long it is' },
      ...(transport === 'tcp' ? [{ text: `#define SERVER_PORT "${options.server.port}"` }] : []),
      ...(transport === 'rtu'
        ? [
            {
              text: `#define PAUSE_MS ${pauseOf(options)}`,
              comment: 'silence before a request: at least 3.5 characters',
            },
          ]
        : []),
    ]);
  }

  /** What speaks to the device, and main. */
  #exchange(): void {
    const { options, transport, requests, sequence } = this.#plan;
    const answered = requests.some(isAnswered);
    const written = new RequestWriter(
      this.#lines,
      this.#printer,
      (type) => cType(family('', this.#names), type),
      dialect,
    );
    this.#shell(answered ? `${requestText('int')}\n\n${REPORT}` : requestText('int'));
    written.requests(requests, true);
    this.#shell(openingText(this.#plan, this.#notes));
    this.#shell(exchangeText(transport, options.echo, this.#waits));
    this.#shell(ASK);
    if (sequence !== undefined) {
      if (hasStep('until', sequence)) this.#shell(UNTIL);
      written.sequence(sequence);
    }
    this.#shell(mainText(this.#plan));
  }
}

const WAITS = ['wait', 'until'] as const;
const OWN_HEADERS = ['poll.h', 'stdbool.h', 'stdio.h', 'string.h', 'time.h', 'unistd.h'];
const TCP_HEADERS = ['netdb.h', 'sys/socket.h', 'sys/time.h'];
const SERIAL_HEADERS = ['fcntl.h', 'termios.h'];
