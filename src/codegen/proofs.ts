/** How the programs of a target are proved in our tests, beside being run. */
export interface TargetProof {
  /** The command that compiles them; a warning fails it. */
  readonly compiler?: string;
  /** The command that checks them where nothing is compiled; a warning fails it. */
  readonly checker?: string;
  /** The requests whose bytes and replies are compared with those of the library. */
  readonly frames: number;
}

/** The requests of `tests/programs/cases.ts`, which programs of every target are tried with. */
const FRAMES = 159;

const proofs: ReadonlyMap<string, TargetProof> = new Map<string, TargetProof>([
  ['structured-text', { frames: FRAMES }],
  ['c', { compiler: 'gcc -std=c99 -O2 -Wall -Wextra -Werror -pedantic', frames: FRAMES }],
  ['arduino', { compiler: 'g++ -std=c++11 -O2 -Wall -Wextra -Werror', frames: FRAMES }],
]);

/** What our tests did with programs of a target, by its id; `undefined` if no test has said it. The tests hold it true. */
export const targetProof = (target: string): TargetProof | undefined => proofs.get(target);
