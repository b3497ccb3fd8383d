import { LrcSteps } from '../../../modbus/index.ts';
import { byteHex } from '../../../workbench/index.ts';
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
        <table class="numbers lrc">
          <thead>
            <tr>
              <th scope="col">{columns.byte}</th>
              <th scope="col">{columns.before}</th>
              <th scope="col">{columns.value}</th>
              <th scope="col">{columns.after}</th>
            </tr>
          </thead>
          <tbody>
            {Array.from(bytes, (byte, at) => (
              <tr key={at}>
                <th scope="row">{at}</th>
                <td class="mono">{byteHex(sums[at] as number)}</td>
                <td class="mono">{byteHex(byte)}</td>
                <td class="mono">{byteHex(sums[at + 1] as number)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
      <p>
        {said(byteHex(sum))} {twos(byteHex(inverted), byteHex(value))}
      </p>
    </>
  );
}
