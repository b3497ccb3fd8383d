import { hexDigits, type Transport } from '../../modbus/index.ts';
import type { Plan, PlannedRequest, ProgramNote } from '../plan.ts';
import { plainText } from '../print.ts';
import type { Target } from '../target.ts';
import { Lines } from '../written.ts';
import { type Call, callFor, callText, numbersOf } from './calls.ts';
import { programAbout, programName } from './shell.ts';

/** A text as one word of a shell: between single quotes, in which nothing is special but the quote itself. */
export const shellWord = (text: string): string => `'${plainText(text).replaceAll("'", "'\\''")}'`;

const SECOND = 1000;
/** What the commands take for a time-out, in seconds. */
const TIMEOUTS = { least: 0.01, most: 10 };
const MOST_READ = 125;

/** A command that polls devices, told what to do by options. */
interface PollCommand {
  readonly id: string;
  readonly proof: Target['proof'];
  readonly calls: readonly Call[];
  /** The option of parity. */
  readonly parity: string;
  readonly transports: readonly Transport[];
  readonly leastUnit: (transport: Transport) => number;
}

const values = (value: unknown): string => (Array.isArray(value) ? numbersOf(value).join(' ') : String(Number(value)));

const READS: readonly Call[] = [
  { code: 0x01, text: '-t 0 -r {startAddress} -c {quantity} @' },
  { code: 0x02, text: '-t 1 -r {startAddress} -c {quantity} @' },
  { code: 0x03, text: '-t 4 -r {startAddress} -c {quantity} @' },
  { code: 0x04, text: '-t 3 -r {startAddress} -c {quantity} @' },
];
const WRITES_SINGLE: readonly Call[] = [
  { code: 0x05, text: '-t 0 -r {address} @ {value}' },
  { code: 0x06, text: '-t 4 -r {address} @ {value}' },
];
const WRITES_MANY: readonly Call[] = [
  { code: 0x0f, text: '-t 0 -r {startAddress} @ {bits}' },
  { code: 0x10, text: '-t 4 -r {startAddress} @ {registers}' },
];

/** What options say about the line or the server; `@` is where the port or host stands. */
function optionsOf({ parity }: PollCommand, plan: Plan, unit: number | undefined): string {
  const { line, server, timeout } = plan.options;
  const seconds = Math.min(TIMEOUTS.most, Math.max(TIMEOUTS.least, timeout / SECOND)).toFixed(2);
  const where =
    plan.transport === 'tcp'
      ? `-p ${server.port}`
      : `-b ${line.baud} -d ${line.dataBits} ${parity} ${line.parity} -s ${line.stopBits}`;
  return `-m ${plan.transport} -a ${unit} ${where} -o ${seconds} -0 -1`;
}

/** The call, if the command sends these bytes by it. */
function pollCall(command: PollCommand, request: PlannedRequest): Call | undefined {
  const call = callFor(command.calls, request);
  const { fields, unitId = 0, transport } = request.reading;
  const many = Number(fields['quantity'] ?? 1);
  // One value is written by the functions for one.
  const single =
    numbersOf(fields['bits'] ?? fields['registers']).length === 1 && command.calls.includes(WRITES_SINGLE[0] as Call);
  return many > MOST_READ || single || unitId < command.leastUnit(transport) ? undefined : call;
}

const isTcp = ({ transport }: Plan): boolean => transport === 'tcp';

/** What all scripts begin with: what they do, and where the line or the server is. */
function begin(lines: Lines, plan: Plan, shell: string, needs: string, file: string): void {
  const { comments, line, server } = plan.options;
  lines.add(`#!${shell}`);
  if (comments) {
    lines.add(`# ${plainText(programAbout(plan))}`);
    lines.add(
      `# ${shell.slice('/bin/'.length)} ${file} [${isTcp(plan) ? 'HOST' : 'PORT'}]  carries it out. It needs ${needs}.`,
    );
  }
  lines.add('');
  const where = isTcp(plan) ? 'host' : 'port';
  lines.add(`${where}=${shellWord(isTcp(plan) ? server.host : line.port)}`);
  lines.add(`[ $# -eq 0 ] || ${where}=$1`).add('');
}

function writePoll(command: PollCommand, plan: Plan): ReturnType<Target['write']> {
  const lines = new Lines();
  const notes: ProgramNote[] = [];
  const file = `${programName(plan).replaceAll(' ', '-')}-${command.id}.sh`;
  begin(lines, plan, '/bin/sh', command.id, file);
  for (const request of plan.requests) {
    const call = pollCall(command, request);
    if (plan.options.comments) lines.add(`# ${plainText(request.about)}`);
    if (call !== undefined) {
      const text = callText(call, request, values).replace('@', isTcp(plan) ? '"$host"' : '"$port"');
      const spans = request.reading.spans.map(({ name }) => name);
      lines.add(`${command.id} ${optionsOf(command, plan, request.reading.unitId)} ${text}`, spans);
      continue;
    }
    notes.push({ code: 'not-offered', what: 'function', request: request.name });
    if (plan.options.comments) lines.add(`# ${command.id} has no option for this. The bytes are:`);
    writeRows(lines, plan, request);
    const bytes = [...request.bytes].map((byte) => hexDigits(byte, 2)).join(' ');
    lines.add(`echo ${shellWord(`${command.id} cannot send ${bytes}`)} >&2`);
  }
  return { files: [lines.file(file)], notes };
}

/** What each byte is, in comments. */
function writeRows(lines: Lines, { options: { comments } }: Plan, { rows, bytes }: PlannedRequest): void {
  if (!comments) return;
  for (const { from, to, span, comment } of rows) {
    const pairs = [...bytes.subarray(from, to)].map((byte) => hexDigits(byte, 2)).join(' ');
    lines.add(`#   ${pairs}  ${plainText(comment)}`, [span]);
  }
}

const pollCommand = (command: PollCommand): Target => ({
  id: command.id,
  name: command.id,
  language: 'bash',
  proof: command.proof,
  parts: ['exchange'],
  transports: command.transports,
  sequences: false,
  write: (plan) => writePoll(command, plan),
});

/** mbpoll 1.4 and later, free software on libmodbus. */
export const mbpoll = pollCommand({
  id: 'mbpoll',
  proof: 'run',
  calls: [...READS, ...WRITES_SINGLE, ...WRITES_MANY],
  parity: '-P',
  transports: ['rtu', 'tcp'],
  leastUnit: (transport) => (transport === 'tcp' ? 0 : 1),
});

/** modpoll, which writes one value by the functions for many unless it is told otherwise. */
export const modpoll = pollCommand({
  id: 'modpoll',
  proof: 'rules',
  calls: [...READS, ...WRITES_MANY],
  parity: '-p',
  transports: ['rtu', 'ascii', 'tcp'],
  leastUnit: (transport) => (transport === 'tcp' ? 0 : 1),
});

const PARITY_FLAGS = { none: '-parenb', even: 'parenb -parodd', odd: 'parenb parodd' } as const;

/** Bytes by `printf` of bash, into a port or a connection of its own. */
export const printf: Target = {
  id: 'printf',
  name: 'printf (bash)',
  language: 'bash',
  proof: 'run',
  parts: ['bytes', 'exchange'],
  transports: ['rtu', 'ascii', 'tcp'],
  sequences: false,
  write: (plan) => {
    const { line, server, timeout, part, comments } = plan.options;
    const lines = new Lines();
    const file = `${programName(plan).replaceAll(' ', '-')}.sh`;
    const remark = (text: string) => comments && lines.add(`# ${text}`);
    begin(lines, plan, '/bin/bash', isTcp(plan) ? 'bash' : 'bash and stty of GNU', file);
    if (isTcp(plan)) lines.add(`exec 3<> "/dev/tcp/$host/${server.port}" || exit 1`);
    else {
      const stop = line.stopBits === 2 ? 'cstopb' : '-cstopb';
      const format = `cs${line.dataBits} ${PARITY_FLAGS[line.parity]} ${stop}`;
      lines.add(`stty -F "$port" ${line.baud} raw -echo ${format} || exit 1`);
      lines.add('exec 3<> "$port" || exit 1');
    }
    for (const request of plan.requests) {
      lines.add('');
      remark(plainText(request.about));
      writeRows(lines, plan, request);
      const escapes = [...request.bytes].map((byte) => `\\x${hexDigits(byte, 2)}`).join('');
      lines.add(
        `printf '${escapes}' >&3`,
        request.rows.map(({ span }) => span),
      );
      if (part === 'bytes' || request.check === undefined) continue;
      remark('What comes back until the time is over:');
      lines.add(`timeout ${timeout / SECOND} cat <&3 | od -An -v -t x1`);
    }
    return { files: [lines.file(file)], notes: [] };
  },
};
