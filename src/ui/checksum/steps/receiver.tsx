import { type CrcSteps, receiverCheck, residueOf, sameBytes, sentBytes } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import { byteHex, registerHex } from '../../../workbench/index.ts';
import { Table } from '../../kit/table.tsx';
import { useWords } from '../../parts/words.ts';

/** The check at the receiver, and why the bytes of the CRC are sent in this order. */
export function Receiver({ steps }: { steps: CrcSteps }) {
  const { receiver: words, columns, table, byte } = useWords('checksumSteps');
  const { algorithm, bytes, form } = steps;
  const check = receiverCheck(algorithm, bytes);
  const hex = (value: number) => registerHex(algorithm.width, value);
  return (
    <section class="step-section">
      <h3>{words.title}</h3>
      {check === undefined ? (
        <p>{words.notBytes}</p>
      ) : (
        <>
          <p>{words.intro(formatBytes(check.sent))}</p>
          <Table
            class="numbers receiver"
            columns={[
              {
                name: columns.step,
                cell: ({ value }, i) => (
                  <>
                    {byte(bytes.length + i)} <b class="mono">{byteHex(value)}</b>
                  </>
                ),
              },
              { name: columns.before, class: 'mono', cell: ({ before }) => hex(before) },
              { name: table.index, class: 'mono', cell: ({ index }) => byteHex(index) },
              { name: columns.after, class: 'mono', cell: ({ after }) => hex(after) },
            ]}
            rows={check.steps}
            keyOf={(_, i) => i}
          />
          <p>
            <strong>{words.left(hex(check.residue))}</strong>{' '}
            {algorithm.xorout === 0 ? words.whyZero : words.whyConstant}
          </p>
          {endsInOwn(steps) && <p>{words.ends(check.sent.length)}</p>}
          {check.sent.length > 1 && (
            <>
              <h4>{form.reflected ? words.whyTitle : words.whyTitleHigh}</h4>
              <p>
                {form.reflected ? words.why.low : words.why.high}{' '}
                {!isPalindrome(check.sent) && words.swapped(formatBytes(check.sent.toReversed()), hex(check.swapped))}
              </p>
            </>
          )}
        </>
      )}
    </section>
  );
}

const isPalindrome = (bytes: Uint8Array) => sameBytes(bytes, bytes.toReversed());

/** Whether the bytes have their own CRC at their end already. */
function endsInOwn({ algorithm, bytes, unxored }: CrcSteps): boolean {
  const size = sentBytes(algorithm, 0)?.length ?? 0;
  return bytes.length > size && unxored === residueOf(algorithm);
}
