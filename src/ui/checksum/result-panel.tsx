import type { Checksum } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import { registerHex, valueBytes } from '../../workbench/index.ts';
import { checksumWords as words } from './checksum-words.ts';
import { CopiedValue } from './copied-value.tsx';
import type { Digest } from './digest.ts';

interface ResultProps {
  readonly digest: Digest;
  /** CRC-16/MODBUS, the LRC, and the chosen one, each with its name here. */
  readonly shown: readonly { readonly checksum: Checksum; readonly name: string; readonly value: number | undefined }[];
}

/** The frame is shown with its checksum up to so many bytes. */
const MOST_SHOWN = 256;

/** The checksums that matter most, as numbers and as they are sent. */
export function ResultPanel({ digest, shown }: ResultProps) {
  const bytes = digest.kind === 'done' ? digest.reading?.bytes : undefined;
  return (
    <section class="panel results" aria-label={words.result}>
      {shown.map(({ checksum, name, value }) => (
        <div key={checksum.name} class="result">
          <h2>{name}</h2>
          {value === undefined ? (
            <p class="said">{digest.kind === 'computing' ? words.computing : words.none}</p>
          ) : (
            <One checksum={checksum} name={name} value={value} bytes={bytes} />
          )}
        </div>
      ))}
    </section>
  );
}

interface OneProps {
  readonly checksum: Checksum;
  readonly name: string;
  readonly value: number;
  readonly bytes: Uint8Array | undefined;
}

function One({ checksum, name, value, bytes }: OneProps) {
  const { width } = checksum;
  const highFirst = valueBytes(value, width);
  const lowFirst = highFirst.toReversed();
  const modbus = checksum.name === 'CRC-16/MODBUS';
  const ends = modbus && value === 0 && bytes !== undefined && bytes.length > 2;
  return (
    <>
      <dl>
        <dt>{words.number}</dt>
        <dd>
          <CopiedValue text={registerHex(width, value)} of={name} /> <CopiedValue text={String(value)} of={name} />
        </dd>
        {highFirst.length > 1 && (
          <>
            <dt>{modbus ? words.wire : words.lowFirst}</dt>
            <dd>
              <CopiedValue text={formatBytes(lowFirst)} of={name} />
            </dd>
            <dt>{modbus ? words.swapped : words.highFirst}</dt>
            <dd>
              <CopiedValue text={formatBytes(highFirst)} of={name} />
            </dd>
          </>
        )}
        {modbus && bytes && !ends && bytes.length <= MOST_SHOWN && (
          <>
            <dt>{words.withIt}</dt>
            <dd>
              <CopiedValue text={formatBytes(Uint8Array.of(...bytes, ...lowFirst))} of={name} />
            </dd>
          </>
        )}
      </dl>
      {ends && <p class="said">{words.endsWithCrc}</p>}
      <p class="said">{words.about(checksum.name)}</p>
    </>
  );
}
