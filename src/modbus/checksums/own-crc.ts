import { crc, reflect } from '../crc.ts';
import type { CatalogueCrc, CrcAlgorithm } from '../crc-catalogue.ts';

const CHECK_INPUT = Uint8Array.from('123456789', (character) => character.charCodeAt(0));

/** Parameters of one's own as a row of the catalogue: with a name, and the check value and residue that follow from them. */
export const ownCrc = (name: string, algorithm: CrcAlgorithm): CatalogueCrc => ({
  ...algorithm,
  name,
  aliases: [],
  check: crc(algorithm, CHECK_INPUT),
  residue: residueOf(algorithm),
});

/** The register after any message and its CRC: what `xorout` alone leaves in a register of zero. */
function residueOf({ width, poly, refout, xorout }: CrcAlgorithm): number {
  const top = 2 ** (width - 1);
  const mask = 2 * top - 1;
  let register = refout ? reflect(xorout, width) : xorout;
  for (let bit = 0; bit < width; bit++) {
    const shifted = (register * 2) % (mask + 1);
    register = register >= top ? (shifted ^ poly) >>> 0 : shifted;
  }
  return refout ? reflect(register, width) : register;
}
