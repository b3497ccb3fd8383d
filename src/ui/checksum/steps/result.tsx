import { type CrcSteps, sentBytes } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import { registerHex } from '../../../workbench/index.ts';
import { useWords } from '../../parts/words.ts';

/** What becomes of the register after the last byte. */
export function Result({ steps }: { steps: CrcSteps }) {
  const words = useWords('checksumSteps');
  const { algorithm, form, unxored, value } = steps;
  const { width, refin, refout, xorout } = algorithm;
  const sent = sentBytes(algorithm, value);
  return (
    <p class="step-result">
      {words.result(registerHex(form.bits, steps.last))} {refin !== refout && words.turned(registerHex(width, unxored))}{' '}
      {xorout === 0 ? words.noFinalXor : words.finalXor(registerHex(width, xorout))} {words.value}{' '}
      <strong class="mono">{registerHex(width, value)}</strong>
      {sent && (
        <>
          , {words.sent} <strong class="mono">{formatBytes(sent)}</strong>
        </>
      )}
    </p>
  );
}
