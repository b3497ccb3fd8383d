import { fork } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';

const worker = fileURLToPath(new URL('worker.mjs', import.meta.url));

/** The process in which one program does one subject. */
export class Contestant {
  #child;
  #row;

  /** @param {import('./report.mjs').Row} row where its speeds go */
  constructor(row) {
    this.#row = row;
    this.#child = fork(worker, [row.program, row.subject.id]);
    // A wrong answer ends everything: without all of them there is nothing to compare.
    this.#child.on('exit', (code) => {
      if (code === 0) return;
      console.error(`${row.program} failed at "${row.subject.title}".`);
      process.exit(1);
    });
  }

  started = () => once(this.#child, 'message');

  warmUp = () => this.#ask('warm up');

  async sample() {
    const { sample } = await this.#ask('sample');
    this.#row.speeds.push(sample * this.#row.subject.perInput);
  }

  async finish() {
    await this.#ask('check');
    this.#child.disconnect();
    await once(this.#child, 'exit');
  }

  async #ask(what) {
    this.#child.send(what);
    const [answer] = await once(this.#child, 'message');
    return answer;
  }
}
