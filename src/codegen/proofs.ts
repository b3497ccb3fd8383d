/** How the programs of a target are proved in our tests. */
export interface TargetProof {
  /**
   * Compiled or checked by a strict tool and run, or run by an interpreter of the tests: their bytes and what they find in
   * replies are compared with the library's. What is sent only has its bytes compared, as they come out of the line.
   */
  readonly how: 'compiled' | 'checked' | 'interpreted' | 'sent';
  /** The tool, if there is one; a warning fails the test. */
  readonly command?: string;
  /** The requests that were tried. */
  readonly frames: number;
}

/** The requests of `tests/programs/cases.ts`, over RTU, ASCII and TCP. */
const ALL = 159;
/** Those over RTU and ASCII. */
const SERIAL = 106;

const compiled = (command: string): TargetProof => ({ how: 'compiled', command, frames: ALL });
const checked = (command: string): TargetProof => ({ how: 'checked', command, frames: ALL });
const sent = (frames: number): TargetProof => ({ how: 'sent', frames });

const proofs: ReadonlyMap<string, TargetProof> = new Map<string, TargetProof>([
  ['structured-text', { how: 'interpreted', frames: ALL }],
  ['c', compiled('gcc -std=c99 -O2 -Wall -Wextra -Werror -pedantic')],
  ['arduino', compiled('g++ -std=c++11 -O2 -Wall -Wextra -Werror')],
  ['csharp', compiled('mcs -warnaserror')],
  ['java', compiled('javac -Xlint:all -Werror')],
  ['go', compiled('go vet')],
  ['rust', compiled('rustc -D warnings')],
  ['python', checked('mypy --strict')],
  ['javascript', checked('node --check')],
  ['pymodbus', sent(ALL)],
  ['minimalmodbus', sent(SERIAL)],
  ['modbus-serial', sent(66)],
  ['framewright', sent(ALL)],
  ['mbpoll', sent(23)],
  ['printf', sent(57)],
]);

/** What our tests did with programs of a target, by its id; `undefined` if no test has said it. The tests hold it true. */
export const targetProof = (target: string): TargetProof | undefined => proofs.get(target);
