import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { createInterface } from 'node:readline';

const running = new Set<{ kill(signal: 'SIGKILL'): boolean }>();
process.on('exit', () => {
  for (const child of running) child.kill('SIGKILL');
});

export interface Helper {
  /** Ends the program, and waits until it has ended. */
  stop(): Promise<void>;
}

/** Starts a program and waits for its first line, "ready"; each later line goes to `onLine`. */
export async function startHelper(program: string, args: string[], onLine = (_line: string) => {}): Promise<Helper> {
  const child = spawn(program, args, { stdio: ['ignore', 'pipe', 'inherit'] });
  running.add(child);
  const gone = once(child, 'exit').then(() => running.delete(child));
  const lines = createInterface(child.stdout);
  const endedAtOnce = gone.then(() => Promise.reject(new Error(`${program} ${args.join(' ')} ended at once`)));
  endedAtOnce.catch(() => {});
  await Promise.race([once(lines, 'line'), endedAtOnce]);
  lines.on('line', onLine);
  return {
    async stop() {
      child.kill();
      await gone;
    },
  };
}

/** Waits until something is true. */
export async function until<T>(
  what: string,
  ask: () => Promise<T> | T,
  milliseconds = 60_000,
): Promise<NonNullable<T>> {
  for (const end = Date.now() + milliseconds; ; ) {
    const answer = await ask();
    if (answer) return answer;
    if (Date.now() > end) throw new Error(`waited in vain for ${what}`);
    await pause(25);
  }
}

export const pause = (milliseconds: number): Promise<void> =>
  new Promise((resolve) => {
    setTimeout(resolve, milliseconds);
  });
