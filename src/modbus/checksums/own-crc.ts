import { crc, demandWidth, reflect } from '../crc.ts';
import type { CatalogueCrc, CrcAlgorithm } from '../crc-catalogue.ts';
import { timesX } from './join.ts';

const CHECK_INPUT = Uint8Array.from('123456789', (character) => character.charCodeAt(0));

/**
 * A user's parameters as a row of the catalogue: with a name, and with the check value and residue that follow from them.
 * Throws as `crc` does.
 */
export const ownCrc = (name: string, algorithm: CrcAlgorithm): CatalogueCrc => ({
  ...algorithm,
  name,
  aliases: [],
  check: crc(algorithm, CHECK_INPUT),
  residue: residueOf(algorithm),
});

/**
 * The register, without the final xor, after any message and its CRC: what `xorout` alone leaves in a register of zero. Throws
 * as `crc` does.
 */
export function residueOf(algorithm: CrcAlgorithm): number {
  const { width, refout, xorout } = algorithm;
  demandWidth(width);
  let register = refout ? reflect(xorout, width) : xorout;
  for (let bit = 0; bit < width; bit++) register = timesX(register, algorithm);
  return refout ? reflect(register, width) : register;
}
