import { formatBytes } from '../../notation/index.ts';
import type { ChecksumView } from '../../store/index.ts';
import { type AlgorithmRow, CRC_MODBUS, registerHex, valueBytes } from '../../workbench/index.ts';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import { CopiedValue } from './copied-value.tsx';

/** The frame is shown with its checksum up to so many bytes. */
const MOST_SHOWN = 256;

/** The checksums that matter most, as numbers and as they are sent. */
export function ResultPanel({ view }: ViewProps<ChecksumView>) {
  const words = useWords('checksum');
  const bytes = view.bytes.value;
  return (
    <section class="panel results stack" aria-label={words.result}>
      {view.results.value.map((row) => (
        <div key={row.key} class="result">
          <h2>{row.name}</h2>
          {row.value === undefined ? (
            <p class="said">{view.computing.value ? words.computing : words.none}</p>
          ) : (
            <Result row={row} value={row.value} bytes={bytes} />
          )}
        </div>
      ))}
    </section>
  );
}

interface ResultProps {
  readonly row: AlgorithmRow;
  readonly value: number;
  readonly bytes: Uint8Array | undefined;
}

function Result({ row: { checksum, name }, value, bytes }: ResultProps) {
  const words = useWords('checksum');
  const { width } = checksum;
  const highFirst = valueBytes(value, width);
  const lowFirst = highFirst.toReversed();
  const modbus = checksum === CRC_MODBUS;
  const ends = modbus && value === 0 && bytes !== undefined && bytes.length > 2;
  const copied = (said: string, ...texts: readonly string[]) => (
    <>
      <dt>{said}</dt>
      <dd>
        {texts.map((text) => (
          <>
            <CopiedValue text={text} of={name} />{' '}
          </>
        ))}
      </dd>
    </>
  );
  return (
    <>
      <dl>
        {copied(words.number, registerHex(width, value), String(value))}
        {highFirst.length > 1 && copied(modbus ? words.wire : words.lowFirst, formatBytes(lowFirst))}
        {highFirst.length > 1 && copied(modbus ? words.swapped : words.highFirst, formatBytes(highFirst))}
        {modbus &&
          bytes &&
          !ends &&
          bytes.length <= MOST_SHOWN &&
          copied(words.withIt, formatBytes(Uint8Array.of(...bytes, ...lowFirst)))}
      </dl>
      {ends && <p class="said">{words.endsWithCrc}</p>}
      <p class="said">{words.about(checksum.name)}</p>
    </>
  );
}
