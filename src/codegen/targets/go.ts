import { quoted } from './c-like.ts';
import { compiledTarget, type Dialect, type Shape, type Shown } from './compiled.ts';
import { spaced } from './go-spacing.ts';
import { goSyntax, goType } from './go-syntax.ts';
import { isAnswered, pauseOf, SILENCE, TURNAROUND } from './shell.ts';

const PARITIES = { none: 'NoParity', even: 'EvenParity', odd: 'OddParity' } as const;

const lineType = ({ isTcp }: Shape): string => (isTcp ? 'net.Conn' : 'serial.Port');

const verdict = ({ exceptionName, faultName }: Shape): string => `
// verdict says in words what a check gives.
func verdict(result int) string {
    if result > 0 {
        return fmt.Sprintf("exception %d: %s", result, ${exceptionName}(result))
    }
    if result < 0 {
        return fmt.Sprintf("fault %d: %s", result, ${faultName}(result))
    }
    return "good"
}`;

const BYTES_OF = `
// bytesOf reads hexadecimal digits; blanks may stand between them.
func bytesOf(text string) []byte {
    bytes, err := hex.DecodeString(strings.ReplaceAll(text, " ", ""))
    if err != nil {
        fmt.Fprintln(os.Stderr, err)
    }
    return bytes
}`;

const SEND_SERIAL = `
// send sends a request, after the silence that parts it from what was sent before.
func send(line serial.Port, request []byte) error {
    time.Sleep(pause)
    if err := line.ResetInputBuffer(); err != nil {
        return err
    }
    if _, err := line.Write(request); err != nil {
        return err
    }
    return line.Drain()
}`;

const SEND_TCP = `
// send sends a request.
func send(line net.Conn, request []byte) error {
    _, err := line.Write(request)
    return err
}`;

const RECEIVE_SERIAL = `
// receive gives what comes in until all that is wanted is there, or the time is over.
func receive(line serial.Port, wanted func([]byte) int, deadline time.Time) ([]byte, error) {
    received := []byte{}
    for {
        length := wanted(received)
        if length > 0 && len(received) >= length {
            return received, nil
        }
        wait := time.Until(deadline)
        if length == 0 && len(received) > 0 {
            // No byte says how long the reply is: silence ends it.
            wait = min(wait, silence)
        }
        if wait <= 0 {
            return received, nil
        }
        if err := line.SetReadTimeout(wait); err != nil {
            return nil, err
        }
        more := make([]byte, max(1, length-len(received)))
        count, err := line.Read(more)
        if err != nil {
            return nil, err
        }
        if count == 0 {
            return received, nil
        }
        received = append(received, more[:count]...)
    }
}`;

const RECEIVE_TCP = `
// receive gives what comes in until all that is wanted is there, or the time is over.
func receive(line net.Conn, wanted func([]byte) int, deadline time.Time) ([]byte, error) {
    received := []byte{}
    if err := line.SetReadDeadline(deadline); err != nil {
        return nil, err
    }
    for wanted(received) > len(received) {
        more := make([]byte, wanted(received)-len(received))
        count, err := line.Read(more)
        received = append(received, more[:count]...)
        if errors.Is(err, os.ErrDeadlineExceeded) || errors.Is(err, io.EOF) {
            break
        }
        if err != nil {
            return nil, err
        }
    }
    return received, nil
}`;

const exchange = (type: string, echo: boolean): string => `
// exchange sends a request and gives what comes back.
func exchange(line ${type}, request []byte, wanted func([]byte) int) ([]byte, error) {
    if err := send(line, request); err != nil {
        return nil, err
    }
    deadline := time.Now().Add(timeout)
${
  echo
    ? `    // The adapter gives back what is sent.
    own := func([]byte) int { return len(request) }
    if _, err := receive(line, own, deadline); err != nil {
        return nil, err
    }
`
    : ''
}    return receive(line, wanted, deadline)
}`;

const WAIT_UNTIL = `
// waitUntil asks every interval whether something holds, and gives up after the time-out.
func waitUntil(interval, timeout time.Duration, holds func() bool) bool {
    end := time.Now().Add(timeout)
    for due := time.Now().Add(interval); !holds(); due = due.Add(interval) {
        if due.After(end) || time.Now().After(end) {
            return false
        }
        time.Sleep(time.Until(due))
    }
    return true
}`;

const ATTEMPT = `
// attempt goes on after a failure, and says what it was.
func attempt(err error) {
    if err != nil {
        fmt.Fprintln(os.Stderr, err)
    }
}`;

const show = ({ show: name, check, frame, title, list, items, values }: Shown): string => {
  const printed = [
    ...values.map(
      ({ label, call, unit }) => `        fmt.Println(${[label, call, ...(unit === '' ? [] : [unit])].join(', ')})\n`,
    ),
    ...(list ? [`        fmt.Println(values${items === undefined ? '' : `[:${items}]`})\n`] : []),
  ];
  return `
// ${name} prints what a reply says, and tells whether it is good.
func ${name}(reply []byte) bool {
${list ? `    values := make(${goType(list)}, ${list.size})\n` : ''}    result := ${check}(${frame}, reply${list ? ', values' : ''})
    fmt.Println(${title}, verdict(result))
${printed.length > 0 ? `    if result == 0 {\n${printed.join('')}    }\n` : ''}    return result == 0
}`;
};

const send = ({ send: name, show: shows, frame, failure, wanted, check }: Shown, shape: Shape): string =>
  wanted === undefined || check === undefined
    ? `
// ${name} sends a request to which no reply comes.
func ${name}(line ${lineType(shape)}) error {
${shape.turnsAround ? '    defer time.Sleep(turnaround)\n' : ''}    return send(line, ${frame})
}`
    : `
// ${name} carries a request out and gives the reply, if it is good.
func ${name}(line ${lineType(shape)}) ([]byte, error) {
    reply, err := exchange(line, ${frame}, ${wanted})
    if err != nil {
        return nil, err
    }
    if !${shows}(reply) {
        return nil, errors.New(${failure})
    }
    return reply, nil
}`;

/** What gives only the error. */
const sent = (shown: Shown): string => `${isAnswered(shown) ? '_, err' : 'err'} := ${shown.send}(line)`;

const milliseconds = (of: number): string =>
  of % 1000 === 0 ? `${of / 1000} * time.Second` : `${of} * time.Millisecond`;

const opened = ({ plan, isTcp }: Shape): string => {
  if (isTcp) return `line, err := net.DialTimeout("tcp", net.JoinHostPort(name, strconv.Itoa(serverPort)), timeout)`;
  const { dataBits, parity, stopBits } = plan.options.line;
  return `line, err := serial.Open(name, &serial.Mode{
        BaudRate: baudRate,
        DataBits: ${dataBits},
        Parity:   serial.${PARITIES[parity]},
        StopBits: serial.${stopBits === 1 ? 'OneStopBit' : 'TwoStopBits'},
    })`;
};

function main(shown: readonly Shown[], shape: Shape): string {
  const { exchanges, checks, isTcp, plan } = shape;
  const { sequence } = plan;
  const printed = shown.map(({ frame }) => `fmt.Printf("% X\\n", ${frame})`);
  const checked = shown.filter(({ check }) => check !== undefined);
  const failed = (err: string) => `if err := ${err}; err != nil {
        fmt.Fprintln(os.Stderr, err)
        return 1
    }`;
  const offline = [
    ...(checks
      ? [
          `if len(arguments) == ${checked.length + 1} && arguments[0] == "--check" {`,
          ...(checked.length === 1
            ? checked.map(
                ({ show: name }) =>
                  `    if ${name}(bytesOf(arguments[1])) {\n            return 0\n        }\n        return 1`,
              )
            : [
                '    failures := 0',
                ...checked.map(
                  ({ show: name }, at) =>
                    `    if !${name}(bytesOf(arguments[${at + 1}])) {\n            failures++\n        }`,
                ),
                '    return min(failures, 1)',
              ]),
          '}',
        ]
      : []),
    ...(exchanges
      ? [
          'if len(arguments) == 1 && arguments[0] == "--bytes" {',
          ...printed.map((line) => `    ${line}`),
          '    return 0',
          '}',
        ]
      : [...printed, 'return 0']),
  ];
  const [only] = shown;
  const online = [
    `name := ${isTcp ? 'serverHost' : 'portName'}`,
    'if len(arguments) > 0 {',
    '    name = arguments[0]',
    '}',
    opened(shape),
    'if err != nil {',
    '    fmt.Fprintln(os.Stderr, err)',
    '    return 1',
    '}',
    'defer line.Close()',
    ...(sequence !== undefined
      ? [...(sequence.finally.length > 0 ? ['defer finish(line)'] : []), failed('steps(line)'), 'return 0']
      : shown.length === 1 && only
        ? [`if ${sent(only)}; err != nil {`, '    fmt.Fprintln(os.Stderr, err)', '    return 1', '}', 'return 0']
        : [
            'failures := 0',
            ...shown.flatMap((one) => [
              `if ${sent(one)}; err != nil {`,
              '    fmt.Fprintln(os.Stderr, err)',
              '    failures++',
              '}',
            ]),
            'return min(failures, 1)',
          ]),
  ];
  const body = [...(sequence === undefined ? offline : []), ...(exchanges ? online : [])];
  return `
// run does what the command line says, and gives the exit code.
func run(arguments []string) int {
${body.map((line) => `    ${line}`).join('\n')}
}

func main() {
    os.Exit(run(os.Args[1:]))
}`;
}

const dialect: Dialect = {
  length: 'len(reply)',
  rules: {
    styles: { routine: 'camel', variable: 'camel', constant: 'camel', table: 'camel', type: 'snake' },
    reserved: [
      ...'break case chan const continue default defer else fallthrough for func go goto if import interface map package'.split(
        ' ',
      ),
      ...'range return select struct switch type var any bool byte comparable complex64 complex128 error float32'.split(
        ' ',
      ),
      ...'float64 int int8 int16 int32 int64 rune string uint uint8 uint16 uint32 uint64 uintptr true false iota nil'.split(
        ' ',
      ),
      ...'append cap clear close complex copy delete imag len make max min new panic print println real recover init'.split(
        ' ',
      ),
      ...'errors fmt hex io math net os serial strconv strings time line err result'.split(' '),
      ...'baudRate portName serverHost serverPort timeout pause silence verdict bytesOf send receive exchange'.split(
        ' ',
      ),
      ...'turnaround waitUntil attempt steps finish run main name arguments failures'.split(' '),
    ],
  },
  ending: '.go',
  indent: '\t',
  isClass: false,
  syntax: (name, _, uses) => goSyntax(name, uses),
  quoted,
  head: (lines) => `${lines.map((line) => `// ${line}`.trimEnd()).join('\n')}\n`,
  imports: ({ isTcp, checks, exchanges, receives, plan, uses, waits }) => {
    const offline = plan.sequence === undefined;
    const standard = [
      ...(checks && offline ? ['encoding/hex'] : []),
      ...(receives || plan.sequence ? ['errors'] : []),
      'fmt',
      ...(isTcp && receives ? ['io'] : []),
      ...(uses.has('math') ? ['math'] : []),
      ...(isTcp && exchanges ? ['net'] : []),
      'os',
      ...(isTcp && exchanges ? ['strconv'] : []),
      ...(checks && offline ? ['strings'] : []),
      ...(exchanges || waits ? ['time'] : []),
    ];
    const lines = standard.map((path) => `\t"${path}"`);
    if (exchanges && !isTcp) lines.push('', '\t"go.bug.st/serial"');
    return `package main\n\nimport (\n${lines.join('\n')}\n)`;
  },
  open: () => '',
  command: (_, file) => `go run ${file}`,
  settings: ({ plan, isTcp, exchanges, receives, turnsAround }) => {
    if (!exchanges) return [];
    const { line, server, timeout } = plan.options;
    return [
      ...(isTcp
        ? [{ text: `serverHost = ${quoted(server.host)}` }, { text: `serverPort = ${server.port}` }]
        : [{ text: `portName = ${quoted(line.port)}` }, { text: `baudRate = ${line.baud}` }]),
      ...(receives || isTcp
        ? [{ text: `timeout = ${milliseconds(timeout)}`, comment: 'from the end of the request to the whole reply' }]
        : []),
      ...(isTcp
        ? []
        : [
            { text: `pause = ${milliseconds(pauseOf(plan.options))}`, comment: 'between two frames' },
            ...(receives
              ? [{ text: `silence = ${milliseconds(SILENCE)}`, comment: 'ends a reply of unknown length' }]
              : []),
            ...(turnsAround
              ? [{ text: `turnaround = ${milliseconds(TURNAROUND)}`, comment: 'for the devices, after a broadcast' }]
              : []),
          ]),
    ];
  },
  list: (parameter, items) => `${goType(parameter)}{${items.join(', ')}}`,
  frame: (name, call) => `var ${name} = ${call}`,
  built: 'table',
  readFrame: (name) => name,
  shared: (shape) => {
    const { checks, exchanges, isTcp, plan, receives, waitsUntil, attempts } = shape;
    const { sequence, options } = plan;
    return [
      ...(checks ? [verdict(shape)] : []),
      ...(checks && sequence === undefined ? [BYTES_OF] : []),
      ...(exchanges ? [isTcp ? SEND_TCP : SEND_SERIAL] : []),
      ...(receives ? [isTcp ? RECEIVE_TCP : RECEIVE_SERIAL, exchange(lineType(shape), options.echo && !isTcp)] : []),
      ...(waitsUntil ? [WAIT_UNTIL] : []),
      ...(attempts ? [ATTEMPT] : []),
    ];
  },
  show,
  send,
  step: {
    wait: (duration) => `time.Sleep(${milliseconds(duration)})`,
    repeat: (times) => [`for range ${times} {`, '}'],
    send: (shown, stops) =>
      stops
        ? `if ${sent(shown)}; err != nil {\n    return err\n}`
        : isAnswered(shown)
          ? `if ${sent(shown)}; err != nil {\n    attempt(err)\n}`
          : `attempt(${shown.send}(line))`,
    until: (
      shown,
      { holds, interval, timeout, about },
      stops,
    ) => `if !waitUntil(${spaced(milliseconds(interval), 2)}, ${spaced(milliseconds(timeout), 2)}, func() bool {
    reply, err := ${shown.send}(line)
    return err == nil && ${holds}(reply)
}) {
    ${stops ? `return errors.New(${about})` : `attempt(errors.New(${about}))`}
}`,
  },
  steps: (name, about, line, last) => [
    `// ${name}: ${about}\nfunc ${name}(line ${line})${last ? '' : ' error'} {`,
    last ? '}' : '    return nil\n}',
  ],
  line: lineType,
  main,
};

export const go = compiledTarget({ id: 'go', name: 'Go (go.bug.st/serial)', language: 'go' }, dialect);
