import { type ChildProcessWithoutNullStreams, spawn } from 'node:child_process';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { toHex } from '../../../src/modbus/index.ts';
import { loopback, PEER_PORT } from '../line.ts';
import { python } from '../tools.ts';

/** A process that answers each line of JSON with a line. */
class Lines {
  readonly #child: ChildProcessWithoutNullStreams;
  readonly #lines: AsyncIterator<string>;
  #errors = '';

  constructor(command: string, args: readonly string[], env: Readonly<Record<string, string>> = {}) {
    this.#child = spawn(command, args, { env: { ...process.env, ...env } });
    this.#lines = createInterface({ input: this.#child.stdout })[Symbol.asyncIterator]();
    // That it has ended is said by the next line that is waited for.
    this.#child.stdin.on('error', () => {});
    this.#child.stderr.setEncoding('utf8').on('data', (text: string) => {
      this.#errors += text;
    });
  }

  async next(): Promise<string> {
    const late = new Promise<never>((_, reject) => {
      setTimeout(() => reject(new Error('no answer within two minutes')), 120_000).unref();
    });
    const { value, done } = await Promise.race([this.#lines.next(), late]);
    if (done) throw new Error(`ended: ${this.#errors}`);
    return value;
  }

  ask(told: unknown): Promise<string> {
    this.#child.stdin.write(`${JSON.stringify(told)}\n`);
    return this.next();
  }

  end(): void {
    this.#child.stdin.end();
  }
}

const here = import.meta.dirname;

/** The other end of a pseudo-terminal and of a connection. */
export class Peer {
  readonly #lines: Lines;
  /** The path of the pseudo-terminal. */
  readonly port: string;
  /** The address of the server; its port is `PEER_PORT`. */
  readonly host: string;

  private constructor(lines: Lines, port: string, host: string) {
    this.#lines = lines;
    this.port = port;
    this.host = host;
  }

  static async start(): Promise<Peer> {
    const host = loopback();
    const lines = new Lines('python3', [join(here, 'peer.py'), host, String(PEER_PORT)]);
    return new Peer(lines, JSON.parse(await lines.next()).port, host);
  }

  /**
   * Waits for a request of this length, and answers it; not at all, if there is no reply, and each by one, if there are several.
   * With `echo` it repeats the request first, with `sameTransaction` the reply has the transaction that the request has.
   */
  async expect(
    request: Uint8Array,
    reply: Uint8Array | readonly Uint8Array[] | undefined,
    { echo = false, sameTransaction = false }: { readonly echo?: boolean; readonly sameTransaction?: boolean } = {},
  ): Promise<void> {
    const replies = (reply === undefined ? [] : reply instanceof Uint8Array ? [reply] : reply).map((one) => toHex(one));
    await this.#lines.ask({ bytes: request.length, replies, echo, same: sameTransaction });
  }

  /** What has come since, in hexadecimal, when there are so many bytes, or after a minute. */
  async got(bytes: number): Promise<string> {
    return (await this.#lines.ask({ wait: bytes })).toUpperCase();
  }

  end(): void {
    this.#lines.end();
  }
}

/** What `main` or another function of a program gave, and what it printed. */
export interface Ended {
  readonly code: unknown;
  readonly out: string;
}

/**
 * What reads and closes a port in Node are threads of a pool. With several of them, one that still reads keeps a port locked that
 * another one has closed, or takes what comes to the next program, where both have the same number of the file.
 */
const ONE_THREAD = { UV_THREADPOOL_SIZE: '1' };

/** Runs programs of one language, all in one process. */
export class Runner {
  readonly #lines: Lines;

  constructor(language: 'python' | 'javascript') {
    this.#lines =
      language === 'python'
        ? new Lines(python(), [join(here, 'runner.py')])
        : new Lines(process.execPath, [join(here, 'runner.mjs')], ONE_THREAD);
  }

  async main(file: string, ...given: readonly string[]): Promise<Ended> {
    return JSON.parse(await this.#lines.ask({ file, arguments: given }));
  }

  /** Calls a function with bytes, and a list of so many elements to fill. */
  async call(file: string, call: string, given: readonly Uint8Array[], fill?: number): Promise<Ended> {
    return JSON.parse(await this.#lines.ask({ file, call, arguments: given.map((bytes) => toHex(bytes)), fill }));
  }

  end(): void {
    this.#lines.end();
  }
}
