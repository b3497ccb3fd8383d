import { formatBytes, formatHex } from '../../../notation/index.ts';
import { addressOf } from '../../../store/index.ts';
import { characters, type FrameChecksum, frameChecksum } from '../../../workbench/index.ts';
import { Table } from '../../kit/table.tsx';
import type { TabProps } from '../current-frame.ts';
import { useWords } from '../words.ts';

/** How the checksum of a frame comes about, or why it has none. */
export function CrcTab({ of }: TabProps) {
  const words = useWords('crc');
  const { frame } = of.value;
  if (frame === undefined) return <p class="said">{words.noFrame}</p>;
  const checksum = frameChecksum(frame.reading, frame.bytes);
  if (checksum.kind === 'none') return <p>{words.none[checksum.why]}</p>;
  return (
    <div class="stack crc-tab">
      {checksum.kind === 'crc' ? <Crc {...checksum} /> : <Lrc {...checksum} />}
      <p>
        <a href={addressOf('checksum', stepsOf(checksum))}>{words.steps}</a>
      </p>
    </div>
  );
}

type Kind<K extends FrameChecksum['kind']> = Extract<FrameChecksum, { readonly kind: K }>;

/** What the Checksum view shows of these bytes. */
const stepsOf = ({ kind, covered }: Kind<'crc' | 'lrc'>) => ({
  bytes: formatBytes(covered),
  ...(kind === 'lrc' && { algorithm: 'LRC' }),
});

function Crc({ covered, initial, last, register, sent, got }: Kind<'crc'>) {
  const words = useWords('crc');
  const skipped = covered.length - last.length;
  const begins = { name: skipped > 0 ? words.earlier(skipped) : words.initial, hex: '', register: initial };
  const before = skipped > 0 ? [] : [begins];
  const rows = [
    ...before,
    ...last.map(({ at, value, register: after }) => ({
      name: String(at),
      hex: formatHex(value, 2).slice(2),
      register: after,
    })),
  ];
  return (
    <>
      <p>{words.crcCovers(covered.length)}</p>
      <p class="mono bytes-line" data-from={0} data-to={covered.length}>
        {formatBytes(covered)}
      </p>
      <Table
        class="crc-registers"
        label={words.columns.register}
        columns={[
          { name: words.columns.byte, class: 'mono', cell: ({ name }) => name },
          { name: words.columns.hex, class: 'mono', cell: ({ hex }) => hex },
          { name: words.columns.register, class: 'mono', cell: ({ register: after }) => formatHex(after, 4) },
        ]}
        rows={rows}
        keyOf={(_, index) => index}
        attributes={({ name, hex }) =>
          hex === '' ? {} : { 'data-kind': 'number', 'data-from': name, 'data-to': String(Number(name) + 1) }
        }
      />
      <p>
        <b>{words.register(register)}</b> <b>{words.sent(sent)}</b>{' '}
        <Verdict got={got && formatBytes(got)} wanted={formatBytes(sent)} />
      </p>
    </>
  );
}

function Lrc({ covered, sum, lrc, got }: Kind<'lrc'>) {
  const words = useWords('crc');
  return (
    <>
      <p>{words.lrcCovers(covered.length)}</p>
      <p class="mono bytes-line">{formatBytes(covered)}</p>
      <p>
        <b>{words.sum(sum, lrc)}</b> <Verdict got={got && characters(got)} wanted={formatHex(lrc, 2).slice(2)} />
      </p>
    </>
  );
}

/** Whether the frame has the checksum that it should have. */
function Verdict({ got, wanted }: { readonly got: string | undefined; readonly wanted: string }) {
  const words = useWords('crc');
  if (got === undefined || got === '') return <>{words.missing}</>;
  return got === wanted ? words.holds : <span class="error">{words.wrong(got)}</span>;
}
