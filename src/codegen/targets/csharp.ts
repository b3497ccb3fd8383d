import { exitCode, indented, quoted } from './c-like.ts';
import { compiledTarget, type Dialect, type Shape, type Shown } from './compiled.ts';
import { csharpDocumentation, csharpSyntax, csharpType } from './csharp-syntax.ts';
import { isAnswered, pauseOf, SILENCE, TURNAROUND } from './shell.ts';

const PARITIES = { none: 'None', even: 'Even', odd: 'Odd' } as const;

const lineType = ({ isTcp }: Shape): string => (isTcp ? 'NetworkStream' : 'SerialPort');

const verdict = ({ exceptionName, faultName }: Shape): string => `
/** Says in words what a check gives. */
static string Verdict(int result)
{
    if (result > 0)
    {
        return "exception " + result + ": " + ${exceptionName}(result);
    }
    return result == 0 ? "good" : "fault " + result + ": " + ${faultName}(result);
}`;

const BYTES_OF = `
/** Reads hexadecimal digits; blanks may stand between them. */
static byte[] BytesOf(string text)
{
    string digits = text.Replace(" ", "");
    var bytes = new byte[digits.Length / 2];
    for (int index = 0; index < bytes.Length; index++)
    {
        bytes[index] = Convert.ToByte(digits.Substring(2 * index, 2), 16);
    }
    return bytes;
}`;

const HEX_OF = `
/** Writes bytes as hexadecimal digits. */
static string HexOf(byte[] bytes)
{
    return BitConverter.ToString(bytes).Replace('-', ' ');
}`;

const SEND_SERIAL = `
/** Sends a request, after the silence that parts it from what was sent before. */
static void Send(SerialPort line, byte[] request)
{
    Thread.Sleep(Pause);
    line.DiscardInBuffer();
    line.Write(request, 0, request.Length);
    line.BaseStream.Flush();
}`;

const SEND_TCP = `
/** Sends a request. */
static void Send(NetworkStream line, byte[] request)
{
    line.Write(request, 0, request.Length);
}`;

const receive = (isTcp: boolean): string => `
/** Gives what comes in until all that is wanted is there, or the time is over. */
static byte[] Receive(${isTcp ? 'NetworkStream' : 'SerialPort'} line, Func<byte[], int, int> wanted, Stopwatch time)
{
    var received = new byte[MostReceived];
    int count = 0;
    while (count < received.Length)
    {
        int length = wanted(received, count);
        int left = ReplyTimeout - (int)time.ElapsedMilliseconds;
${
  isTcp
    ? ''
    : `        if (length == 0 && count > 0)
        {
            // No byte says how long the reply is: silence ends it.
            left = Math.Min(left, Silence);
        }
`
}        if ((length > 0 && count >= length) || left <= 0)
        {
            break;
        }
        line.ReadTimeout = left;
        try
        {
            int more = Math.Min(Math.Max(1, length - count), received.Length - count);
${
  isTcp
    ? `            int got = line.Read(received, count, more);
            if (got == 0)
            {
                break;
            }
            count += got;`
    : '            count += line.Read(received, count, more);'
}
        }
        catch (${isTcp ? 'IOException' : 'TimeoutException'})
        {
            break;
        }
    }
    Array.Resize(ref received, count);
    return received;
}`;

const exchange = (type: string, echo: boolean): string => `
/** Sends a request and gives what comes back. */
static byte[] Exchange(${type} line, byte[] request, Func<byte[], int, int> wanted)
{
    Send(line, request);
    Stopwatch time = Stopwatch.StartNew();
${
  echo
    ? `    // The adapter gives back what is sent.
    Receive(line, (received, count) => request.Length, time);
`
    : ''
}    return Receive(line, wanted, time);
}`;

const WAIT_UNTIL = `
/** Asks every interval whether something holds, and gives up after the time-out. */
static bool WaitUntil(int interval, int timeout, Func<bool> holds)
{
    Stopwatch time = Stopwatch.StartNew();
    for (long due = interval; !holds(); due += interval)
    {
        if (Math.Max(due, time.ElapsedMilliseconds) > timeout)
        {
            return false;
        }
        Thread.Sleep((int)Math.Max(0, due - time.ElapsedMilliseconds));
    }
    return true;
}`;

const ATTEMPT = `
/** Goes on after a failure, says what it was, and tells whether there was none. */
static bool Attempt(Action step)
{
    try
    {
        step();
        return true;
    }
    catch (Exception error)
    {
        Console.Error.WriteLine(error.Message);
        return false;
    }
}`;

const show = ({ show: name, check, frame, title, list, items, values }: Shown): string => {
  const text = (call: string, type: string) =>
    type === 'real' ? `${call}.ToString(CultureInfo.InvariantCulture)` : call;
  const printed = [
    ...values.map(
      ({ label, call, unit, type }) =>
        `        Console.WriteLine(${label} + " " + ${text(call, type)}${unit === '' ? '' : ` + " " + ${unit}`});\n`,
    ),
    ...(list
      ? [
          `        Console.WriteLine(string.Join(" ", ${items === undefined ? 'values' : `new ArraySegment<${csharpType({ type: list.type, size: undefined })}>(values, 0, ${items})`}));\n`,
        ]
      : []),
  ];
  return `
/** Prints what a reply says, and tells whether it is good. */
static bool ${name}(byte[] reply)
{
${list ? `    var values = new ${csharpType({ type: list.type, size: undefined })}[${list.size}];\n` : ''}    int result = ${check}(${frame}, reply, reply.Length${list ? ', values' : ''});
    Console.WriteLine(${title} + " " + Verdict(result));
${printed.length > 0 ? `    if (result == 0)\n    {\n${printed.join('')}    }\n` : ''}    return result == 0;
}`;
};

const send = (shown: Shown, shape: Shape): string => {
  const { send: name, show: shows, frame, failure, wanted } = shown;
  if (!isAnswered(shown))
    return `
/** Sends a request to which no reply comes. */
static void ${name}(${lineType(shape)} line)
{
    Send(line, ${frame});${shape.turnsAround ? '\n    Thread.Sleep(Turnaround);' : ''}
}`;
  return `
/** Carries a request out and gives the reply, if it is good. */
static byte[] ${name}(${lineType(shape)} line)
{
    byte[] reply = Exchange(line, ${frame}, ${wanted});
    if (!${shows}(reply))
    {
        throw new IOException(${failure});
    }
    return reply;
}`;
};

const opened = ({ plan, isTcp }: Shape): string => {
  if (isTcp)
    return 'using (var client = new TcpClient(name, ServerPort))\nusing (NetworkStream line = client.GetStream())';
  const { dataBits, parity, stopBits } = plan.options.line;
  const stop = stopBits === 1 ? 'One' : 'Two';
  return `using (var line = new SerialPort(name, BaudRate, Parity.${PARITIES[parity]}, ${dataBits}, StopBits.${stop}))`;
};

function main(shown: readonly Shown[], shape: Shape): string {
  const { exchanges, checks, isTcp, plan } = shape;
  const { sequence } = plan;
  const printed = shown.map(({ frame }) => `Console.WriteLine(HexOf(${frame}));`).join('\n');
  const checked = shown.filter(({ check }) => check !== undefined);
  const checkAll = exitCode(checked.map(({ show: name }, at) => `${name}(BytesOf(arguments[${at + 1}]))`));
  const offline = [
    ...(checks
      ? [`if (arguments.Length == ${checked.length + 1} && arguments[0] == "--check")\n{\n${indented(checkAll)}\n}`]
      : []),
    exchanges
      ? `if (arguments.Length == 1 && arguments[0] == "--bytes")\n{\n${indented(`${printed}\nreturn 0;`)}\n}`
      : `${printed}\nreturn 0;`,
  ];
  const [only] = shown;
  const carried =
    sequence !== undefined
      ? sequence.finally.length > 0
        ? 'try\n{\n    Steps(line);\n}\nfinally\n{\n    Finish(line);\n}\nreturn 0;'
        : 'Steps(line);\nreturn 0;'
      : shown.length === 1 && only
        ? `${only.send}(line);\nreturn 0;`
        : exitCode(shown.map((one) => `Attempt(() => ${one.send}(line))`));
  const online = `string name = arguments.Length > 0 ? arguments[0] : ${isTcp ? 'ServerHost' : 'PortName'};
try
{
${indented(opened(shape))}
    {
${indented(isTcp ? carried : `line.Open();\n${carried}`, '        ')}
    }
}
catch (Exception error)
{
    Console.Error.WriteLine(error.Message);
    return 1;
}`;
  const body = [...(sequence === undefined ? offline : []), ...(exchanges ? [online] : [])].join('\n');
  return `
/** Does what the command line says, and gives the exit code. */
static int Main(string[] arguments)
{
${indented(body)}
}`;
}

const dialect: Dialect = {
  length: 'reply.Length',
  rules: {
    styles: { routine: 'pascal', variable: 'camel', constant: 'pascal', table: 'pascal', type: 'pascal' },
    reserved: [
      ...'abstract as base bool break byte case catch char checked class const continue decimal default delegate do double'.split(
        ' ',
      ),
      ...'else enum event explicit extern false finally fixed float for foreach goto if implicit in int interface internal'.split(
        ' ',
      ),
      ...'is lock long namespace new null object operator out override params private protected public readonly ref return'.split(
        ' ',
      ),
      ...'sbyte sealed short sizeof stackalloc static string struct switch this throw true try typeof uint ulong unchecked'.split(
        ' ',
      ),
      ...'unsafe ushort using virtual void volatile while var value await async yield dynamic nameof when where record'.split(
        ' ',
      ),
      ...'field required scoped file line name arguments result client time'.split(' '),
      ...'Main Verdict BytesOf HexOf Send Receive Exchange WaitUntil Attempt Steps Finish'.split(' '),
      ...'PortName BaudRate ServerHost ServerPort ReplyTimeout Pause Silence Turnaround MostReceived'.split(' '),
      ...'Action Array BitConverter Console Convert CultureInfo Exception Func IOException Math NetworkStream Parity'.split(
        ' ',
      ),
      ...'SerialPort StopBits Stopwatch TcpClient Thread TimeoutException System Equals GetHashCode GetType ToString'.split(
        ' ',
      ),
      ...'MemberwiseClone ReferenceEquals Finalize'.split(' '),
    ],
  },
  ending: '.cs',
  indent: '    ',
  isClass: true,
  syntax: csharpSyntax,
  quoted,
  documentation: (text) => csharpDocumentation([text], []).join('\n'),
  head: (lines) => `${lines.map((line) => `// ${line}`.trimEnd()).join('\n')}\n`,
  imports: ({ isTcp, exchanges, receives, plan, waits }) => {
    const real = plan.requests.some(({ values }) => values.some(({ type }) => type === 'real'));
    return [
      'System',
      ...(receives ? ['System.Diagnostics'] : []),
      ...(real ? ['System.Globalization'] : []),
      ...(receives ? ['System.IO'] : []),
      ...(exchanges && !isTcp ? ['System.IO.Ports'] : []),
      ...(exchanges && isTcp ? ['System.Net.Sockets'] : []),
      ...((exchanges && !isTcp) || waits ? ['System.Threading'] : []),
    ]
      .map((name) => `using ${name};`)
      .join('\n');
  },
  open: (name) => `public static class ${name}\n{`,
  command: (name) => `${name}`,
  settings: ({ plan, isTcp, exchanges, receives, turnsAround }) => {
    if (!exchanges) return [];
    const { line, server, timeout } = plan.options;
    const time = (name: string, value: number, comment: string) => ({ text: `const int ${name} = ${value};`, comment });
    return [
      ...(isTcp
        ? [
            { text: `const string ServerHost = ${quoted(server.host)};` },
            { text: `const int ServerPort = ${server.port};` },
          ]
        : [{ text: `const string PortName = ${quoted(line.port)};` }, { text: `const int BaudRate = ${line.baud};` }]),
      ...(receives
        ? [time('ReplyTimeout', timeout, 'milliseconds from the end of the request to the whole reply')]
        : []),
      ...(isTcp ? [] : [time('Pause', pauseOf(plan.options), 'milliseconds between two frames')]),
      ...(turnsAround ? [time('Turnaround', TURNAROUND, 'milliseconds for the devices, after a broadcast')] : []),
      ...(receives && !isTcp ? [time('Silence', SILENCE, 'milliseconds that end a reply of unknown length')] : []),
      ...(receives ? [{ text: 'const int MostReceived = 600;', comment: 'bytes' }] : []),
    ];
  },
  list: (parameter, items) => `new ${csharpType(parameter)} { ${items.join(', ')} }`,
  frame: (name, call) => `public static readonly byte[] ${name} = ${call};`,
  built: 'table',
  readFrame: (name) => name,
  shared: (shape) => {
    const { checks, exchanges, isTcp, plan, receives, waitsUntil, attempts } = shape;
    const { sequence, options, requests } = plan;
    return [
      ...(checks ? [verdict(shape)] : []),
      ...(checks && sequence === undefined ? [BYTES_OF] : []),
      ...(sequence === undefined ? [HEX_OF] : []),
      ...(exchanges ? [isTcp ? SEND_TCP : SEND_SERIAL] : []),
      ...(receives ? [receive(isTcp), exchange(lineType(shape), options.echo && !isTcp)] : []),
      ...(waitsUntil ? [WAIT_UNTIL] : []),
      ...(attempts || waitsUntil || (exchanges && requests.length > 1 && sequence === undefined) ? [ATTEMPT] : []),
    ];
  },
  show,
  send,
  step: {
    wait: (milliseconds) => `Thread.Sleep(${milliseconds});`,
    repeat: (times, depth) => {
      const counter = depth === 0 ? 'round' : `round${depth + 1}`;
      return [`for (int ${counter} = 0; ${counter} < ${times}; ${counter}++)\n{`, '}'];
    },
    send: (shown, stops) => (stops ? `${shown.send}(line);` : `Attempt(() => ${shown.send}(line));`),
    until: (shown, { holds, interval, timeout, about }, stops) => `if (!WaitUntil(${interval}, ${timeout}, () =>
{
    bool holds = false;
    return Attempt(() => holds = ${holds}(${shown.send}(line))) && holds;
}))
{
    ${stops ? `throw new TimeoutException(${about});` : `Console.Error.WriteLine(${about});`}
}`,
  },
  steps: (name, about, line) => [
    `/** ${about} */\nstatic void ${name === 'steps' ? 'Steps' : 'Finish'}(${line} line)\n{`,
    '}',
  ],
  line: lineType,
  main,
};

export const csharp = compiledTarget({ id: 'csharp', name: 'C# (System.IO.Ports)', language: 'csharp' }, dialect);
