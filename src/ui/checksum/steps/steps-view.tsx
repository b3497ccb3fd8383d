import { useMemo } from 'preact/hooks';
import { type CrcAlgorithm, CrcSteps } from '../../../modbus/index.ts';
import { registerHex } from '../../../workbench/index.ts';
import { useWords } from '../../parts/words.ts';
import { EntriesPanel } from './entries-panel.tsx';
import { ExamplePanel } from './example-panel.tsx';
import { LrcPanel } from './lrc-panel.tsx';
import { Receiver } from './receiver.tsx';
import { Result } from './result.tsx';
import { StepByStep } from './step-by-step.tsx';
import './checksum-steps.css';

/** Bytes that are gone through: four times the longest frame. */
const MOST = 1024;

interface StepsProps {
  readonly bytes: Uint8Array;
  readonly algorithm: CrcAlgorithm;
}

/** How the CRC of these bytes comes about, bit by bit and with the table, and the LRC beside it. */
export function StepsView({ bytes, algorithm }: StepsProps) {
  const words = useWords('checksumSteps');
  const gone = bytes.subarray(0, MOST);
  const { width, poly, init, refin, refout, xorout } = algorithm;
  const steps = useMemo(() => new CrcSteps(algorithm, gone), [gone.join(), width, poly, init, refin, refout, xorout]);
  const { form } = steps;
  const hex = (value: number) => registerHex(form.bits, value);
  return (
    <div class="checksum-steps-body">
      <p class="introduction">
        {words.form(form.bits, hex(form.initial))} {width < form.bits && words.roomForByte(width)}{' '}
        {words.moves(form.reflected, hex(form.poly))}
      </p>
      {bytes.length > MOST && <p class="said">{words.firstOnly(MOST, bytes.length)}</p>}
      {gone.length > 0 ? (
        <StepByStep steps={steps} />
      ) : (
        <>
          <p class="said">{words.nothing}</p>
          <Result steps={steps} />
          <Receiver steps={steps} />
          <EntriesPanel steps={steps} />
        </>
      )}
      <LrcPanel bytes={gone} />
      <ExamplePanel />
    </div>
  );
}
