import { compiledTarget, type Dialect, type Shape, type Shown } from './compiled.ts';
import { Sizes } from './rust-numbers.ts';
import { rustSyntax, rustText } from './rust-syntax.ts';
import { isAnswered, pauseOf, SILENCE, TURNAROUND } from './shell.ts';

const DATA_BITS = { 7: 'Seven', 8: 'Eight' } as const;
const PARITIES = { none: 'None', even: 'Even', odd: 'Odd' } as const;

const lineType = ({ isTcp }: Shape): string => (isTcp ? '&mut TcpStream' : '&mut dyn SerialPort');

const verdict = ({ exceptionName, faultName }: Shape): string => `
/// Says in words what a check gives.
fn verdict(result: i32) -> String {
    match result {
        0 => "good".to_string(),
        1.. => format!("exception {result}: {}", ${exceptionName}(result)),
        _ => format!("fault {result}: {}", ${faultName}(result)),
    }
}`;

const BYTES_OF = `
/// Reads hexadecimal digits; blanks may stand between them.
fn bytes_of(text: &str) -> Vec<u8> {
    let digits: Vec<u8> = text
        .chars()
        .filter_map(|digit| digit.to_digit(16))
        .map(|digit| digit as u8)
        .collect();
    digits.chunks(2).map(|pair| pair.iter().fold(0, |byte, digit| byte << 4 | digit)).collect()
}`;

const HEX_OF = `
/// Writes bytes as hexadecimal digits.
fn hex_of(bytes: &[u8]) -> String {
    let pairs: Vec<String> = bytes.iter().map(|byte| format!("{byte:02X}")).collect();
    pairs.join(" ")
}`;

const SEND_SERIAL = `
/// Sends a request, after the silence that parts it from what was sent before.
fn send(line: &mut dyn SerialPort, request: &[u8]) -> io::Result<()> {
    thread::sleep(PAUSE);
    line.clear(ClearBuffer::Input)?;
    line.write_all(request)?;
    line.flush()
}`;

const SEND_TCP = `
/// Sends a request.
fn send(line: &mut TcpStream, request: &[u8]) -> io::Result<()> {
    line.write_all(request)
}`;

const receive = (isTcp: boolean): string => `
/// Gives what comes in until all that is wanted is there, or the time is over.
fn receive(
    line: ${isTcp ? '&mut TcpStream' : '&mut dyn SerialPort'},
    wanted: impl Fn(&[u8]) -> i32,
    deadline: Instant,
) -> io::Result<Vec<u8>> {
    let mut received = Vec::new();
    loop {
        let length = wanted(&received) as usize;
        if length > 0 && received.len() >= length {
            return Ok(received);
        }
        ${isTcp ? 'let' : 'let mut'} left = deadline.saturating_duration_since(Instant::now());
${
  isTcp
    ? ''
    : `        if length == 0 && !received.is_empty() {
            // No byte says how long the reply is: silence ends it.
            left = left.min(SILENCE);
        }
`
}        if left.is_zero() {
            return Ok(received);
        }
        ${isTcp ? 'line.set_read_timeout(Some(left))?' : 'line.set_timeout(left)?'};
        let mut more = vec![0; length.saturating_sub(received.len()).max(1)];
        match line.read(&mut more) {
            Ok(0) => return Ok(received),
            Ok(count) => received.extend_from_slice(&more[..count]),
            Err(error) if matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::WouldBlock) => {
                return Ok(received);
            }
            Err(error) => return Err(error),
        }
    }
}`;

const exchange = (type: string, echo: boolean): string => `
/// Sends a request and gives what comes back.
fn exchange(
    line: ${type},
    request: &[u8],
    wanted: impl Fn(&[u8]) -> i32,
) -> io::Result<Vec<u8>> {
    send(line, request)?;
    let deadline = Instant::now() + TIMEOUT;
${
  echo
    ? `    // The adapter gives back what is sent.
    receive(line, |_| request.len() as i32, deadline)?;
`
    : ''
}    receive(line, wanted, deadline)
}`;

const WAIT_UNTIL = `
/// Asks every interval whether something holds, and gives up after the time-out.
fn wait_until(interval: Duration, timeout: Duration, mut holds: impl FnMut() -> bool) -> bool {
    let end = Instant::now() + timeout;
    let mut due = Instant::now() + interval;
    while !holds() {
        if due.max(Instant::now()) > end {
            return false;
        }
        thread::sleep(due.saturating_duration_since(Instant::now()));
        due += interval;
    }
    true
}`;

const ATTEMPT = `
/// Goes on after a failure, and says what it was.
fn attempt<T>(result: io::Result<T>) {
    if let Err(error) = result {
        eprintln!("{error}");
    }
}`;

/** A text that is printed with a value behind it, and what follows that. */
const printed = (text: string, after = ''): string => {
  const plain = (of: string) => of.slice(1, -1).replace(/[{}]/g, '$&$&');
  return `"${plain(text)} {}${after === '' ? '' : ` ${plain(after)}`}"`;
};

const show = ({ show: name, check, frame, title, list, items, values }: Shown): string => {
  const zero = list?.type === 'bool' ? 'false' : '0';
  const shown = [
    ...values.map(({ label, call, unit }) => `        println!(${printed(label, unit)}, ${call});\n`),
    ...(list
      ? [`        println!("{:?}", ${items === undefined ? 'values' : `&values[..${items} as usize]`});\n`]
      : []),
  ];
  return `
/// Prints what a reply says, and tells whether it is good.
fn ${name}(reply: &[u8]) -> bool {
${list ? `    let mut values = [${zero}; ${list.size}];\n` : ''}    let result = ${check}(${frame}, reply${list ? ', &mut values' : ''});
    println!(${printed(title)}, verdict(result));
${shown.length > 0 ? `    if result == 0 {\n${shown.join('')}    }\n` : ''}    result == 0
}`;
};

const send = (shown: Shown, shape: Shape): string => {
  const { send: name, show: shows, frame, failure, wanted } = shown;
  if (!isAnswered(shown))
    return `
/// Sends a request to which no reply comes.
fn ${name}(line: ${lineType(shape)}) -> io::Result<()> {
    send(line, ${frame})${shape.turnsAround ? '?;\n    thread::sleep(TURNAROUND);\n    Ok(())' : ''}
}`;
  return `
/// Carries a request out and gives the reply, if it is good.
fn ${name}(line: ${lineType(shape)}) -> io::Result<Vec<u8>> {
    let reply = exchange(line, ${frame}, ${wanted})?;
    if !${shows}(&reply) {
        return Err(io::Error::other(${failure}));
    }
    Ok(reply)
}`;
};

const duration = (milliseconds: number): string =>
  milliseconds % 1000 === 0 && milliseconds > 0
    ? `Duration::from_secs(${milliseconds / 1000})`
    : `Duration::from_millis(${milliseconds})`;

const opened = ({ plan, isTcp }: Shape): readonly string[] => {
  if (isTcp) return ['let mut line = TcpStream::connect((name.as_str(), SERVER_PORT))?;'];
  const { dataBits, parity, stopBits } = plan.options.line;
  return [
    'let mut line = serialport::new(name, BAUD_RATE)',
    `    .data_bits(DataBits::${DATA_BITS[dataBits]})`,
    `    .parity(Parity::${PARITIES[parity]})`,
    `    .stop_bits(StopBits::${stopBits === 1 ? 'One' : 'Two'})`,
    '    .open()?;',
  ];
};

function main(shown: readonly Shown[], shape: Shape): string {
  const { exchanges, checks, isTcp, plan } = shape;
  const { sequence } = plan;
  const printed = shown.map(({ frame }) => `println!("{}", hex_of(${frame}));`);
  const checked = shown.filter(({ check }) => check !== undefined);
  const line = isTcp ? '&mut line' : 'line.as_mut()';
  const offline = [
    ...(checks
      ? [
          `if arguments.len() == ${checked.length + 1} && arguments[0] == "--check" {`,
          ...(checked.length === 1
            ? checked.map(({ show: name }) => `    return Ok(${name}(&bytes_of(&arguments[1])));`)
            : [
                '    let good = [',
                ...checked.map(({ show: name }, at) => `        ${name}(&bytes_of(&arguments[${at + 1}])),`),
                '    ];',
                '    return Ok(!good.contains(&false));',
              ]),
          '}',
        ]
      : []),
    ...(exchanges
      ? [
          'if arguments.len() == 1 && arguments[0] == "--bytes" {',
          ...printed.map((one) => `    ${one}`),
          '    return Ok(true);',
          '}',
        ]
      : [...printed, 'Ok(true)']),
  ];
  const [only] = shown;
  const online = [
    `let name = arguments.first().cloned().unwrap_or_else(|| ${isTcp ? 'SERVER_HOST' : 'PORT_NAME'}.to_string());`,
    ...opened(shape),
    ...(sequence !== undefined
      ? sequence.finally.length > 0
        ? [`let result = steps(${line});`, `finish(${line});`, 'result.map(|()| true)']
        : [`steps(${line}).map(|()| true)`]
      : shown.length === 1 && only
        ? [`${only.send}(${line}).map(|_| true)`]
        : [
            'let results = [',
            ...shown.map((one) => `    ${one.send}(${line}).map(|_| ()),`),
            '];',
            'for error in results.iter().filter_map(|result| result.as_ref().err()) {',
            '    eprintln!("{error}");',
            '}',
            'Ok(results.iter().all(|result| result.is_ok()))',
          ]),
  ];
  const body = [...(sequence === undefined ? offline : []), ...(exchanges ? online : [])];
  const given = checks || exchanges ? 'arguments' : '_arguments';
  return `
/// Does what the command line says, and tells whether all went well.
fn run(${given}: &[String]) -> io::Result<bool> {
${body.map((one) => `    ${one}`).join('\n')}
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match run(&arguments) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}`;
}

const dialect: Dialect = {
  length: 'reply.len() as i32',
  rules: {
    styles: { routine: 'snake', variable: 'snake', constant: 'constant', table: 'constant', type: 'snake' },
    reserved: [
      ...'as break const continue crate dyn else enum extern false fn for if impl in let loop match mod move mut pub'.split(
        ' ',
      ),
      ...'ref return self Self static struct super trait true type unsafe use where while async await abstract become'.split(
        ' ',
      ),
      ...'box do final gen macro override priv try typeof unsized virtual yield union'.split(' '),
      ...'bool char f32 f64 i8 i16 i32 i64 i128 isize str u8 u16 u32 u64 u128 usize io thread serialport std core'.split(
        ' ',
      ),
      ...'line result name arguments deadline verdict bytes_of hex_of send receive exchange wait_until attempt'.split(
        ' ',
      ),
      ...'steps finish run main'.split(' '),
      ...'PORT_NAME BAUD_RATE SERVER_HOST SERVER_PORT TIMEOUT PAUSE SILENCE TURNAROUND'.split(' '),
    ],
  },
  ending: '.rs',
  indent: '    ',
  isClass: false,
  syntax: (name) => rustSyntax(name, new Sizes()),
  quoted: rustText,
  head: (lines) => `${lines.map((line) => `//! ${line}`.trimEnd()).join('\n')}\n`,
  imports: ({ plan, isTcp, exchanges, receives, waits }) => {
    const read = isTcp ? (receives ? ', Read, Write' : ', Write') : '';
    const io = exchanges ? `{self${receives ? ', ErrorKind' : ''}${read}}` : '';
    return [
      // Names of the user's own stay as they are.
      ...(Object.keys(plan.options.names).length > 0 ? ['#![allow(non_snake_case, non_upper_case_globals)]', ''] : []),
      ...(exchanges && !isTcp ? ['use serialport::{ClearBuffer, DataBits, Parity, SerialPort, StopBits};'] : []),
      io === '' || io === '{self}' ? 'use std::io;' : `use std::io::${io};`,
      ...(exchanges && isTcp ? ['use std::net::TcpStream;'] : []),
      'use std::process::ExitCode;',
      ...((exchanges && !isTcp) || waits ? ['use std::thread;'] : []),
      ...(receives
        ? ['use std::time::{Duration, Instant};']
        : (exchanges && !isTcp) || waits
          ? ['use std::time::Duration;']
          : []),
    ].join('\n');
  },
  open: () => '',
  command: () => 'cargo run --',
  settings: ({ plan, isTcp, exchanges, receives, turnsAround }) => {
    if (!exchanges) return [];
    const { line, server, timeout } = plan.options;
    const time = (name: string, value: number, comment: string) => ({
      text: `const ${name}: Duration = ${duration(value)};`,
      comment,
    });
    return [
      ...(isTcp
        ? [
            { text: `const SERVER_HOST: &str = ${rustText(server.host)};` },
            { text: `const SERVER_PORT: u16 = ${server.port};` },
          ]
        : [
            { text: `const PORT_NAME: &str = ${rustText(line.port)};` },
            { text: `const BAUD_RATE: u32 = ${line.baud};` },
          ]),
      ...(receives ? [time('TIMEOUT', timeout, 'from the end of the request to the whole reply')] : []),
      ...(isTcp ? [] : [time('PAUSE', pauseOf(plan.options), 'between two frames')]),
      ...(turnsAround ? [time('TURNAROUND', TURNAROUND, 'for the devices, after a broadcast')] : []),
      ...(receives && !isTcp ? [time('SILENCE', SILENCE, 'ends a reply of unknown length')] : []),
    ];
  },
  list: (_, items) => `&[${items.join(', ')}]`,
  frame: (name, call) => `fn ${name}() -> Vec<u8> {\n    ${call}\n}`,
  built: 'routine',
  readFrame: (name, isBuilt) => (isBuilt ? `&${name}()` : `&${name}`),
  shared: (shape) => {
    const { checks, exchanges, isTcp, plan, receives, waitsUntil, attempts } = shape;
    const { sequence, options } = plan;
    return [
      ...(checks ? [verdict(shape)] : []),
      ...(checks && sequence === undefined ? [BYTES_OF] : []),
      ...(sequence === undefined ? [HEX_OF] : []),
      ...(exchanges ? [isTcp ? SEND_TCP : SEND_SERIAL] : []),
      ...(receives ? [receive(isTcp), exchange(lineType(shape), options.echo && !isTcp)] : []),
      ...(waitsUntil ? [WAIT_UNTIL] : []),
      ...(attempts ? [ATTEMPT] : []),
    ];
  },
  show,
  send,
  step: {
    wait: (milliseconds) => `thread::sleep(${duration(milliseconds)});`,
    repeat: (times) => [`for _ in 0..${times} {`, '}'],
    send: (shown, stops) => (stops ? `${shown.send}(line)?;` : `attempt(${shown.send}(line));`),
    until: (
      shown,
      { holds, interval, timeout, about },
      stops,
    ) => `if !wait_until(${duration(interval)}, ${duration(timeout)}, || {
    ${shown.send}(line).is_ok_and(|reply| ${holds}(&reply))
}) {
    ${stops ? `return Err(io::Error::other(${about}));` : `attempt::<()>(Err(io::Error::other(${about})));`}
}`,
  },
  steps: (name, about, line, last, idle) => [
    `/// ${about}\nfn ${name}(${idle ? '_line' : 'line'}: ${line})${last ? '' : ' -> io::Result<()>'} {`,
    last ? '}' : '    Ok(())\n}',
  ],
  line: lineType,
  main,
};

export const rust = compiledTarget({ id: 'rust', name: 'Rust (serialport)', language: 'rust' }, dialect);
