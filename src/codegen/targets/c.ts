import type { Names } from '../names.ts';
import type { Plan } from '../plan.ts';
import { cNames } from './c-names.ts';
import { ASK, exchangeText, floatText, mainText, openingText, REPORT, requestText, UNTIL } from './c-posix.ts';
import { CWriter, cTarget } from './c-program.ts';
import { type CDialect, hasStep } from './c-requests.ts';
import { type CFamily, cString } from './c-syntax.ts';
import { isAnswered, pauseOf, SILENCE } from './shell.ts';

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

class Writer extends CWriter {
  constructor(plan: Plan) {
    super({ rules: cNames, family, dialect, ending: '.c' }, plan);
  }

  /** Whether anything waits for a time. */
  get #waits(): boolean {
    const { transport, sequence } = this.plan;
    return transport === 'rtu' || (sequence !== undefined && WAITS.some((kind) => hasStep(kind, sequence)));
  }

  protected override head(name: string, printed: string): void {
    const { requests, transport, sequence } = this.plan;
    const [floors, floats, bools] = [/\bfloor\(/, /\bfloat_of\(/, /\b(bool|true|false)\b/].map((sign) =>
      sign.test(printed),
    );
    this.printer.remark(this.lines, ...requests.map(({ about }) => about));
    if (this.speaks && this.printer.comments) {
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
      this.lines.text(['//', `// cc -std=c99 -O2 -o ${name} ${name}.c${floors ? ' -lm' : ''}`, ...how].join('\n'));
    }
    const headers = [
      'stdint.h',
      ...(floors ? ['math.h'] : []),
      ...(floats ? ['string.h'] : []),
      ...(bools ? ['stdbool.h'] : []),
      ...(this.speaks && requests.length > 1 ? ['stdlib.h'] : []),
      ...(this.speaks && this.#waits ? ['errno.h'] : []),
      ...(requests.some(({ values }) => values.some(({ type }) => type === 'dword')) ? ['inttypes.h'] : []),
      ...(this.speaks ? [...OWN_HEADERS, ...(transport === 'tcp' ? TCP_HEADERS : SERIAL_HEADERS)] : []),
    ];
    this.lines.add('');
    if (this.speaks) this.lines.add('#define _DEFAULT_SOURCE').add('');
    for (const header of [...new Set(headers)].sort()) this.lines.add(`#include <${header}>`);
    if (this.speaks) this.#settings();
    if (floats) this.part(floatText(this.own));
  }

  #settings(): void {
    const { transport, options } = this.plan;
    this.printer.aligned(this.lines.add(''), [
      { text: `#define FRAME_MOST ${this.mostBytes}`, comment: 'bytes of a frame' },
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
  protected override exchange(): void {
    const { options, transport, requests } = this.plan;
    const answered = requests.some(isAnswered);
    this.part(answered ? `${requestText('int')}\n\n${REPORT}` : requestText('int'));
    this.requests(requests, true);
    this.part(openingText(this.plan, this.notes));
    this.part(exchangeText(transport, options.echo, this.#waits));
    this.part(ASK);
    this.sequence(UNTIL);
    this.part(mainText(this.plan));
  }
}

const WAITS = ['wait', 'until'] as const;
const OWN_HEADERS = ['poll.h', 'stdbool.h', 'stdio.h', 'string.h', 'time.h', 'unistd.h'];
const TCP_HEADERS = ['netdb.h', 'sys/socket.h', 'sys/time.h'];
const SERIAL_HEADERS = ['fcntl.h', 'termios.h'];

/** C99 without allocation; POSIX for what speaks to the device. */
export const c = cTarget({ id: 'c', name: 'C99', language: 'c' }, Writer);
