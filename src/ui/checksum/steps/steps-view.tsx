import { Component } from 'preact';
import { type CrcAlgorithm, CrcSteps, sameBytes } from '../../../modbus/index.ts';
import './checksum-steps.css';
import { registerHex } from '../../../workbench/index.ts';
import { EntriesPanel } from './entries-panel.tsx';
import { ExamplePanel } from './example-panel.tsx';
import { LrcPanel } from './lrc-panel.tsx';
import { Receiver } from './receiver.tsx';
import { Result } from './result.tsx';
import { stepWords as words } from './step-words.ts';
import { Stepper } from './stepper.tsx';

export { loadWords } from './step-words.ts';

/** Bytes that are gone through: four times the longest frame. */
const MOST = 1024;

export interface StepsProps {
  readonly bytes: Uint8Array;
  readonly algorithm: CrcAlgorithm;
}

/** How the CRC of these bytes comes about, bit by bit and with the table, and the LRC beside it. */
export class StepsView extends Component<StepsProps> {
  private held: CrcSteps | undefined;

  /** The steps, the same ones as long as bytes and algorithm are the same. */
  private steps(): CrcSteps {
    const { algorithm } = this.props;
    const bytes = this.props.bytes.subarray(0, MOST);
    if (!this.held || !sameAlgorithm(this.held.algorithm, algorithm) || !sameBytes(this.held.bytes, bytes)) {
      this.held = new CrcSteps(algorithm, bytes);
    }
    return this.held;
  }

  render() {
    const { bytes, algorithm } = this.props;
    const steps = this.steps();
    const { form } = steps;
    const hex = (value: number) => registerHex(form.bits, value);
    return (
      <div class="checksum-steps-body">
        <p class="introduction">
          {words.form(form.bits, hex(form.initial))} {algorithm.width < form.bits && words.roomForByte(algorithm.width)}{' '}
          {words.moves(form.reflected, hex(form.poly))}
        </p>
        {bytes.length > MOST && <p class="said">{words.firstOnly(MOST, bytes.length)}</p>}
        {steps.bytes.length > 0 ? (
          <Stepper steps={steps} />
        ) : (
          <>
            <p class="said">{words.nothing}</p>
            <Result steps={steps} />
            <Receiver steps={steps} />
            <EntriesPanel steps={steps} />
          </>
        )}
        <LrcPanel bytes={steps.bytes} />
        <ExamplePanel />
      </div>
    );
  }
}

const PARAMETERS = ['width', 'poly', 'init', 'refin', 'refout', 'xorout'] as const;

const sameAlgorithm = (one: CrcAlgorithm, other: CrcAlgorithm) => PARAMETERS.every((name) => one[name] === other[name]);
