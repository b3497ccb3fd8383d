import { LrcSteps } from '../../../modbus/index.ts';
import { byteHex } from '../../../workbench/index.ts';
import { Table } from '../../kit/table.tsx';
import { useWords } from '../../parts/words.ts';
import { Folded } from '../remembered-fold.tsx';

/** The LRC of the bytes: a sum, and what brings it to zero. */
export function LrcPanel({ bytes }: { bytes: Uint8Array }) {
  const words = useWords('checksumSteps').lrc;
  return (
    <Folded name="checksum-lrc-steps" title={words.title} hint={words.hint}>
      {() => <Sum steps={new LrcSteps(bytes)} />}
    </Folded>
  );
}

function Sum({ steps: { bytes, sums, sum, inverted, value } }: { steps: LrcSteps }) {
  const { columns, sum: said, twos } = useWords('checksumSteps').lrc;
  return (
    <>
      {bytes.length > 0 && (
        <Table
          class="numbers lrc"
          columns={[
            { name: columns.byte, cell: (at) => at },
            { name: columns.before, class: 'mono', cell: (at) => byteHex(sums[at] as number) },
            { name: columns.value, class: 'mono', cell: (at) => byteHex(bytes[at] as number) },
            { name: columns.after, class: 'mono', cell: (at) => byteHex(sums[at + 1] as number) },
          ]}
          rows={[...bytes.keys()]}
          keyOf={(at) => at}
        />
      )}
      <p>
        {said(byteHex(sum))} {twos(byteHex(inverted), byteHex(value))}
      </p>
    </>
  );
}
