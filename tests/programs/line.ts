import { spawn } from 'node:child_process';
import { createServer, type Socket } from 'node:net';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { crc16 } from '../../src/modbus/index.ts';

/** What a device does with a request: the bytes it sends back, in pieces. Each piece comes some time after the one before. */
export type Answer = (request: Uint8Array) => readonly Uint8Array[];

/** A line with a device at its other end. */
export interface Line {
  /** The path of the serial port, or the number of the TCP port. */
  readonly path: string;
  /** What the device has heard, request by request. */
  readonly heard: readonly Uint8Array[];
  /** Waits until so many requests are heard, but not for ever. */
  readonly hears: (many: number) => Promise<void>;
}

/** Between the pieces of a reply. */
const PIECES = 6;
/** How often it is looked whether something was heard, and how often at most. */
const LOOK = 5;
const LOOKS = 12_000;

const LF = 0x0a;
const COLON = 0x3a;
/** The bytes of a TCP frame that its header does not count. */
const HEADER = 6;

const pause = (milliseconds: number) => new Promise((resolve) => setTimeout(resolve, milliseconds));

const isWholeSerial = (bytes: Uint8Array): boolean =>
  bytes[0] === COLON ? bytes.at(-1) === LF : bytes.length > 2 && crc16(bytes) === 0;
const isWholeTcp = (bytes: Uint8Array): boolean => bytes.length >= HEADER + (bytes[HEADER - 1] ?? 0);

/** Answers each request when all of it is heard. */
function device(
  isWhole: (bytes: Uint8Array) => boolean,
  answer: Answer,
  send: (bytes: Uint8Array) => void,
  heard: Uint8Array[],
) {
  let waiting = new Uint8Array();
  return async (bytes: Uint8Array) => {
    waiting = Uint8Array.of(...waiting, ...bytes);
    if (!isWhole(waiting)) return;
    heard.push(waiting);
    waiting = new Uint8Array();
    for (const piece of answer(heard[heard.length - 1] as Uint8Array)) {
      send(piece);
      await pause(PIECES);
    }
  };
}

const waitFor = (heard: readonly Uint8Array[]) => async (many: number) => {
  for (let look = 0; heard.length < many && look < LOOKS; look++) await pause(LOOK);
};

/** Pseudo-terminals with a device each at the other end; one process has them all. */
export async function openLines(
  answers: readonly Answer[],
): Promise<{ readonly lines: readonly Line[]; readonly close: () => void }> {
  const script = join(import.meta.dirname, 'line.py');
  const child = spawn('python3', [script, String(answers.length)], { stdio: ['pipe', 'pipe', 'inherit'] });
  child.stdin.on('error', () => {});
  const said = createInterface({ input: child.stdout });
  const paths = await new Promise<readonly string[]>((resolve, reject) => {
    const found: string[] = [];
    child.on('error', reject);
    said.on('line', (line) => {
      if (found.push(line) === answers.length) resolve(found);
    });
  });
  said.removeAllListeners('line');
  const lines = answers.map((_, number) => {
    const heard: Uint8Array[] = [];
    return { path: paths[number] ?? '', heard, hears: waitFor(heard) };
  });
  const devices = answers.map((answer, number) => {
    const send = (bytes: Uint8Array) => void child.stdin.write(`${number} ${Buffer.from(bytes).toString('hex')}\n`);
    return device(isWholeSerial, answer, send, lines[number]?.heard ?? []);
  });
  said.on('line', (line) => {
    const [number, digits = ''] = line.split(' ');
    void devices[Number(number)]?.(Buffer.from(digits, 'hex'));
  });
  return { lines, close: () => child.kill() };
}

/**
 * Ports of servers: the same each time, as programs have them in their texts, so that tests side by side take different addresses.
 * Of a server that answers and one that does not, of one by libmodbus, and of one that is told what to answer.
 */
export const SERVER_PORTS = [5020, 5021] as const;
export const SLAVE_PORT = 5022;
export const PEER_PORT = 5023;

/** An address of this machine that no other test is likely to use: all of 127.0.0.0/8 are, on Linux. */
export function loopback(): string {
  if (process.platform !== 'linux') return '127.0.0.1';
  const any = () => 1 + Math.floor(Math.random() * 254);
  return `127.${any()}.${any()}.${any()}`;
}

/** A server on this machine. */
export async function openServer(
  answer: Answer,
  host: string,
  port = 0,
): Promise<Line & { readonly close: () => void }> {
  const heard: Uint8Array[] = [];
  const sockets = new Set<Socket>();
  const server = createServer((socket) => {
    sockets.add(socket);
    socket.on('error', () => {});
    socket.setNoDelay();
    socket.on(
      'data',
      device(isWholeTcp, answer, (bytes) => void (socket.destroyed || socket.write(bytes)), heard),
    );
  });
  await new Promise<void>((resolve) => server.listen(port, host, resolve));
  server.unref();
  const address = server.address();
  const close = () => {
    for (const socket of sockets) socket.destroy();
    server.close();
  };
  return { path: String(typeof address === 'object' && address?.port), heard, hears: waitFor(heard), close };
}
