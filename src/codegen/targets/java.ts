import { exitCode, indented, quoted } from './c-like.ts';
import { compiledTarget, type Dialect, type Shape, type Shown } from './compiled.ts';
import { javaDocumentation, javaSyntax, javaType } from './java-syntax.ts';
import { isAnswered, pauseOf, SILENCE, TURNAROUND } from './shell.ts';

const PARITIES = { none: 'NO_PARITY', even: 'EVEN_PARITY', odd: 'ODD_PARITY' } as const;
const MOST_SIGNED = 0x7f;

const lineType = ({ isTcp }: Shape): string => (isTcp ? 'Socket' : 'SerialPort');

const verdict = ({ exceptionName, faultName }: Shape): string => `
/** Says in words what a check gives. */
static String verdict(int result) {
    if (result > 0) {
        return "exception " + result + ": " + ${exceptionName}(result);
    }
    return result == 0 ? "good" : "fault " + result + ": " + ${faultName}(result);
}`;

const BYTES_OF = `
/** Reads hexadecimal digits; blanks may stand between them. */
static byte[] bytesOf(String text) {
    return HexFormat.of().parseHex(text.replace(" ", ""));
}`;

const HEX_OF = `
/** Writes bytes as hexadecimal digits. */
static String hexOf(byte[] bytes) {
    return HexFormat.ofDelimiter(" ").withUpperCase().formatHex(bytes);
}`;

const SEND_SERIAL = `
/** Sends a request, after the silence that parts it from what was sent before. */
static void send(SerialPort line, byte[] request) throws IOException {
    pause(PAUSE);
    line.flushIOBuffers();
    line.setComPortTimeouts(SerialPort.TIMEOUT_WRITE_BLOCKING, 0, 0);
    if (line.writeBytes(request, request.length) != request.length) {
        throw new IOException("The request cannot be sent.");
    }
}`;

const PAUSED = `
static void pause(long milliseconds) throws InterruptedIOException {
    try {
        Thread.sleep(milliseconds);
    } catch (InterruptedException error) {
        Thread.currentThread().interrupt();
        throw new InterruptedIOException();
    }
}`;

const SEND_TCP = `
/** Sends a request. */
static void send(Socket line, byte[] request) throws IOException {
    line.getOutputStream().write(request);
}`;

const WANTED = `
/** How many bytes a reply has, by those that are there; 0 if only silence ends it. */
private interface Wanted {
    int length(byte[] reply, int replyLength);
}`;

const receive = (isTcp: boolean): string => `
/** Gives what comes in until all that is wanted is there, or the time is over. */
static byte[] receive(${isTcp ? 'Socket' : 'SerialPort'} line, Wanted wanted, long deadline) throws IOException {
    byte[] received = new byte[MOST_RECEIVED];
    int count = 0;
    while (count < received.length) {
        int length = wanted.length(received, count);
        int left = (int) ((deadline - System.nanoTime()) / 1_000_000);
${
  isTcp
    ? ''
    : `        if (length == 0 && count > 0) {
            // No byte says how long the reply is: silence ends it.
            left = Math.min(left, SILENCE);
        }
`
}        if ((length > 0 && count >= length) || left <= 0) {
            break;
        }
        int more = Math.min(Math.max(1, length - count), received.length - count);
${
  isTcp
    ? `        line.setSoTimeout(left);
        try {
            int got = line.getInputStream().read(received, count, more);
            if (got < 0) {
                break;
            }
            count += got;
        } catch (SocketTimeoutException error) {
            break;
        }`
    : `        line.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, left, 0);
        int got = line.readBytes(received, more, count);
        if (got < 0) {
            throw new IOException("The port cannot be read.");
        }
        if (got == 0) {
            break;
        }
        count += got;`
}
    }
    return Arrays.copyOf(received, count);
}`;

const exchange = (type: string, echo: boolean): string => `
/** Sends a request and gives what comes back. */
static byte[] exchange(${type} line, byte[] request, Wanted wanted) throws IOException {
    send(line, request);
    long deadline = System.nanoTime() + TIMEOUT * 1_000_000L;
${
  echo
    ? `    // The adapter gives back what is sent.
    receive(line, (received, count) -> request.length, deadline);
`
    : ''
}    return receive(line, wanted, deadline);
}`;

const CONDITION = `
/** Something that holds or not. */
private interface Condition {
    boolean holds();
}`;

const WAIT_UNTIL = `
/** Asks every interval whether something holds, and gives up after the time-out. */
static boolean waitUntil(long interval, long timeout, Condition condition) throws IOException {
    long begin = System.nanoTime();
    for (long due = interval; !condition.holds(); due += interval) {
        long now = (System.nanoTime() - begin) / 1_000_000;
        if (Math.max(due, now) > timeout) {
            return false;
        }
        pause(Math.max(0, due - now));
    }
    return true;
}`;

const ATTEMPT = `
/** A step that may fail. */
private interface Step {
    boolean take() throws IOException;
}

/** Goes on after a failure, says what it was, and tells whether all is well. */
static boolean attempt(Step step) {
    try {
        return step.take();
    } catch (IOException error) {
        System.err.println(error.getMessage());
        return false;
    }
}`;

const newList = ({
  type,
  size = 0,
}: {
  readonly type: 'bool' | string;
  readonly size?: number | undefined;
}): string => {
  const element = type === 'bool' ? 'boolean' : type === 'dword' ? 'long' : 'int';
  return `${element}[] values = new ${element}[${size}];`;
};

const show = ({ show: name, check, frame, title, list, items, values }: Shown): string => {
  const printed = [
    ...values.map(
      ({ label, call, unit }) =>
        `        System.out.println(${label} + " " + ${call}${unit === '' ? '' : ` + " " + ${unit}`});\n`,
    ),
    ...(list
      ? [
          `        System.out.println(Arrays.toString(${items === undefined ? 'values' : `Arrays.copyOf(values, ${items})`}));\n`,
        ]
      : []),
  ];
  return `
/** Prints what a reply says, and tells whether it is good. */
static boolean ${name}(byte[] reply) {
${list ? `    ${newList(list)}\n` : ''}    int result = ${check}(${frame}, reply, reply.length${list ? ', values' : ''});
    System.out.println(${title} + " " + verdict(result));
${printed.length > 0 ? `    if (result == 0) {\n${printed.join('')}    }\n` : ''}    return result == 0;
}`;
};

const send = (shown: Shown, shape: Shape): string => {
  const { send: name, show: shows, frame, failure, wanted } = shown;
  if (!isAnswered(shown))
    return `
/** Sends a request to which no reply comes. */
static boolean ${name}(${lineType(shape)} line) throws IOException {
    send(line, ${frame});${shape.turnsAround ? '\n    pause(TURNAROUND);' : ''}
    return true;
}`;
  return `
/** Carries a request out and gives the reply, if it is good. */
static byte[] ${name}(${lineType(shape)} line) throws IOException {
    byte[] reply = exchange(line, ${frame}, ${shape.className}::${wanted});
    if (!${shows}(reply)) {
        throw new IOException(${failure});
    }
    return reply;
}`;
};

const attempted = (shown: Shown): string =>
  isAnswered(shown) ? `attempt(() -> ${shown.send}(line).length > 0)` : `attempt(() -> ${shown.send}(line))`;

function opened({ plan, isTcp }: Shape, carried: string, mayThrow: boolean): string {
  if (isTcp)
    return `try (Socket line = new Socket(name, SERVER_PORT)) {
${indented(carried)}
} catch (IOException error) {
    System.err.println(error.getMessage());
    return 1;
}`;
  const { dataBits, parity, stopBits } = plan.options.line;
  const stop = stopBits === 1 ? 'ONE_STOP_BIT' : 'TWO_STOP_BITS';
  return `SerialPort line;
try {
    line = SerialPort.getCommPort(name);
} catch (SerialPortInvalidPortException error) {
    System.err.println(name + ": " + error.getMessage());
    return 1;
}
line.setComPortParameters(BAUD_RATE, ${dataBits}, SerialPort.${stop}, SerialPort.${PARITIES[parity]});
if (!line.openPort(0)) {
    System.err.println(name + " cannot be opened.");
    return 1;
}
try {
${indented(carried)}
}${mayThrow ? ' catch (IOException error) {\n    System.err.println(error.getMessage());\n    return 1;\n}' : ''} finally {
    line.closePort();
}`;
}

function main(shown: readonly Shown[], shape: Shape): string {
  const { exchanges, checks, isTcp, plan } = shape;
  const { sequence } = plan;
  const printed = shown.map(({ frame }) => `System.out.println(hexOf(${frame}));`).join('\n');
  const checked = shown.filter(({ check }) => check !== undefined);
  const checkAll = exitCode(checked.map(({ show: name }, at) => `${name}(bytesOf(arguments[${at + 1}]))`));
  const offline = [
    ...(checks
      ? [`if (arguments.length == ${checked.length + 1} && arguments[0].equals("--check")) {\n${indented(checkAll)}\n}`]
      : []),
    exchanges
      ? `if (arguments.length == 1 && arguments[0].equals("--bytes")) {\n${indented(`${printed}\nreturn 0;`)}\n}`
      : `${printed}\nreturn 0;`,
  ];
  const [only] = shown;
  const carried =
    sequence !== undefined
      ? sequence.finally.length > 0
        ? 'try {\n    steps(line);\n} finally {\n    finish(line);\n}\nreturn 0;'
        : 'steps(line);\nreturn 0;'
      : shown.length === 1 && only
        ? `${only.send}(line);\nreturn 0;`
        : exitCode(shown.map(attempted));
  const online = `String name = arguments.length > 0 ? arguments[0] : ${isTcp ? 'SERVER_HOST' : 'PORT_NAME'};
${opened(shape, carried, sequence !== undefined || shown.length === 1)}`;
  const body = [...(sequence === undefined ? offline : []), ...(exchanges ? [online] : [])].join('\n');
  return `
/** Does what the command line says, and gives the exit code. */
static int run(String[] arguments) {
${indented(body)}
}

public static void main(String[] arguments) {
    System.exit(run(arguments));
}`;
}

const dialect: Dialect = {
  length: 'reply.length',
  rules: {
    styles: { routine: 'camel', variable: 'camel', constant: 'constant', table: 'constant', type: 'pascal' },
    reserved: [
      ...'abstract assert boolean break byte case catch char class const continue default do double else enum extends'.split(
        ' ',
      ),
      ...'final finally float for goto if implements import instanceof int interface long native new package private'.split(
        ' ',
      ),
      ...'protected public return short static strictfp super switch synchronized this throw throws transient try void'.split(
        ' ',
      ),
      ...'volatile while true false null var yield record sealed permits non exports module line name arguments result'.split(
        ' ',
      ),
      ...'deadline verdict bytesOf hexOf send receive exchange waitUntil attempt steps finish run main pause'.split(
        ' ',
      ),
      ...'getClass hashCode equals clone toString notify notifyAll wait finalize'.split(' '),
      ...'PORT_NAME BAUD_RATE SERVER_HOST SERVER_PORT TIMEOUT PAUSE SILENCE TURNAROUND MOST_RECEIVED'.split(' '),
      ...'SerialPort SerialPortInvalidPortException IOException InterruptedIOException Arrays HexFormat Socket'.split(
        ' ',
      ),
      ...'SocketTimeoutException String System Math Float Thread Object Integer Wanted Condition Step'.split(' '),
    ],
  },
  ending: '.java',
  indent: '    ',
  isClass: true,
  syntax: javaSyntax,
  quoted,
  head: (lines) => `${lines.map((line) => `// ${line}`.trimEnd()).join('\n')}\n`,
  imports: ({ isTcp, checks, exchanges, receives, plan, waits }) => {
    const offline = plan.sequence === undefined;
    const lists = checks && plan.requests.some(({ list }) => list !== undefined);
    const pauses = (exchanges && !isTcp) || waits;
    return [
      ...(exchanges && !isTcp
        ? ['com.fazecast.jSerialComm.SerialPort', 'com.fazecast.jSerialComm.SerialPortInvalidPortException']
        : []),
      ...(exchanges ? ['java.io.IOException'] : []),
      ...(pauses ? ['java.io.InterruptedIOException'] : []),
      ...(exchanges && isTcp ? ['java.net.Socket', ...(receives ? ['java.net.SocketTimeoutException'] : [])] : []),
      ...(receives || lists ? ['java.util.Arrays'] : []),
      ...(offline ? ['java.util.HexFormat'] : []),
    ]
      .map((name) => `import ${name};`)
      .join('\n');
  },
  open: (name) => `public final class ${name} {`,
  command: (name) => `java ${name}`,
  settings: ({ plan, isTcp, exchanges, receives, turnsAround }) => {
    if (!exchanges) return [];
    const { line, server, timeout } = plan.options;
    const time = (name: string, value: number, comment: string) => ({
      text: `static final int ${name} = ${value};`,
      comment,
    });
    return [
      ...(isTcp
        ? [
            { text: `static final String SERVER_HOST = ${quoted(server.host)};` },
            { text: `static final int SERVER_PORT = ${server.port};` },
          ]
        : [
            { text: `static final String PORT_NAME = ${quoted(line.port)};` },
            { text: `static final int BAUD_RATE = ${line.baud};` },
          ]),
      ...(receives ? [time('TIMEOUT', timeout, 'milliseconds from the end of the request to the whole reply')] : []),
      ...(isTcp ? [] : [time('PAUSE', pauseOf(plan.options), 'milliseconds between two frames')]),
      ...(turnsAround ? [time('TURNAROUND', TURNAROUND, 'milliseconds for the devices, after a broadcast')] : []),
      ...(receives && !isTcp ? [time('SILENCE', SILENCE, 'milliseconds that end a reply of unknown length')] : []),
      ...(receives ? [time('MOST_RECEIVED', 600, 'bytes')] : []),
    ];
  },
  list: (parameter, items) => `new ${javaType(parameter)} {${items.join(', ')}}`,
  item: ({ type }, value, text) => (type === 'byte' && value > MOST_SIGNED ? `(byte) ${text}` : text),
  frame: (name, call) => `static final byte[] ${name} = ${call};`,
  built: 'table',
  readFrame: (name) => name,
  shared: (shape) => {
    const { checks, exchanges, isTcp, plan, receives, waitsUntil, waits, attempts } = shape;
    const { sequence, options, requests } = plan;
    return [
      ...(checks ? [verdict(shape)] : []),
      ...(checks && sequence === undefined ? [BYTES_OF] : []),
      ...(sequence === undefined ? [HEX_OF] : []),
      ...((exchanges && !isTcp) || waits ? [PAUSED] : []),
      ...(exchanges ? [isTcp ? SEND_TCP : SEND_SERIAL] : []),
      ...(receives ? [WANTED, receive(isTcp), exchange(lineType(shape), options.echo && !isTcp)] : []),
      ...(waitsUntil ? [CONDITION, WAIT_UNTIL] : []),
      ...(attempts || waitsUntil || (exchanges && requests.length > 1 && sequence === undefined) ? [ATTEMPT] : []),
    ];
  },
  show,
  send,
  step: {
    wait: (milliseconds) => `pause(${milliseconds});`,
    repeat: (times, depth) => {
      const counter = depth === 0 ? 'round' : `round${depth + 1}`;
      return [`for (int ${counter} = 0; ${counter} < ${times}; ${counter}++) {`, '}'];
    },
    send: (shown, stops) => (stops ? `${shown.send}(line);` : `${attempted(shown)};`),
    until: (
      shown,
      { holds, interval, timeout, about },
      stops,
    ) => `if (!waitUntil(${interval}, ${timeout}, () -> attempt(() -> ${holds}(${shown.send}(line))))) {
    ${stops ? `throw new IOException(${about});` : `System.err.println(${about});`}
}`,
  },
  steps: (name, about, line) => [
    `${javaDocumentation([about]).join('\n')}\nstatic void ${name}(${line} line) throws IOException {`,
    '}',
  ],
  line: lineType,
  main,
};

export const java = compiledTarget({ id: 'java', name: 'Java (jSerialComm)', language: 'java' }, dialect);
