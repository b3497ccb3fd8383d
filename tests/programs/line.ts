import { spawn } from 'node:child_process';
import { createServer, type Socket } from 'node:net';
import { join } from 'node:path';

/** What a device does with a request: the bytes it sends back, in pieces. Each piece comes some time after the one before. */
export type Answer = (request: Uint8Array, index: number) => readonly Uint8Array[];

/** A line with a device at its other end. */
export interface Line {
  /** The path of the serial port, or the number of the TCP port. */
  readonly path: string;
  /** What the device has heard, request by request. */
  readonly heard: readonly Uint8Array[];
  /** Waits until so many requests are heard, but not for long. */
  readonly hears: (many: number) => Promise<void>;
  readonly close: () => void;
}

/** Requests are further apart than this, pieces of them nearer. */
const GAP = 4;
/** Between the pieces of a reply. */
const PIECES = 6;

/** Cuts what is heard into requests where nothing comes for a while, and answers them. */
function device(answer: Answer, send: (bytes: Uint8Array) => void, heard: Uint8Array[]) {
  let waiting = new Uint8Array();
  let timer: NodeJS.Timeout | undefined;
  const end = async () => {
    const request = waiting;
    waiting = new Uint8Array();
    heard.push(request);
    for (const piece of answer(request, heard.length - 1)) {
      send(piece);
      await new Promise((resolve) => setTimeout(resolve, PIECES));
    }
  };
  return (bytes: Uint8Array) => {
    waiting = Uint8Array.of(...waiting, ...bytes);
    clearTimeout(timer);
    timer = setTimeout(() => void end(), GAP);
  };
}

const LONGEST = 100;

const waitFor = (heard: readonly Uint8Array[]) => async (many: number) => {
  for (let turn = 0; heard.length < many && turn < LONGEST; turn++)
    await new Promise((resolve) => setTimeout(resolve, GAP));
};

/** A pseudo-terminal with a device at its other end. */
export async function openLine(answer: Answer): Promise<Line> {
  const child = spawn('python3', [join(import.meta.dirname, 'line.py')], { stdio: ['pipe', 'pipe', 'inherit'] });
  const heard: Uint8Array[] = [];
  child.stdin.on('error', () => {});
  const hear = device(answer, (bytes) => child.stdin.write(bytes), heard);
  const path = await new Promise<string>((resolve, reject) => {
    child.on('error', reject);
    child.stdout.once('data', (data: Buffer) => {
      resolve(data.toString().trim());
      child.stdout.on('data', hear);
    });
  });
  return { path, heard, hears: waitFor(heard), close: () => child.kill() };
}

/** A server on loopback. */
export async function openServer(answer: Answer): Promise<Line> {
  const heard: Uint8Array[] = [];
  const sockets = new Set<Socket>();
  const server = createServer((socket) => {
    sockets.add(socket);
    socket.on('error', () => {});
    socket.setNoDelay();
    socket.on(
      'data',
      device(answer, (bytes) => void (socket.destroyed || socket.write(bytes)), heard),
    );
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  server.unref();
  const address = server.address();
  const close = () => {
    for (const socket of sockets) socket.destroy();
    server.close();
  };
  return { path: String(typeof address === 'object' && address?.port), heard, hears: waitFor(heard), close };
}
