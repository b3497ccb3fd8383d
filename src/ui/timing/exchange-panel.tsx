import { type ExchangeTimes, exchangeTimes, pollingTime, type SerialMode } from '../../modbus/index.ts';
import type { TimingWords } from '../../words/index.ts';
import { writeLink } from '../../workbench/index.ts';
import { words } from '../language.ts';
import { draft, evaluation } from '../state.ts';
import type { SetLine } from './settings.ts';
import { Time } from './silence-panel.tsx';

/** All that an exchange is worked out from; nothing where something typed has to be corrected. */
export interface ExchangeInputs {
  readonly line: SetLine;
  readonly mode: SerialMode;
  readonly request: number;
  readonly reply: number;
  readonly delay: number;
}

interface ExchangeProps {
  readonly inputs: ExchangeInputs | undefined;
  readonly text: TimingWords;
}

const SECOND = 1_000_000;
const silentIn = ({ request, reply, total }: ExchangeTimes) => (total - request - reply) / total;

interface Step {
  readonly name: string;
  readonly time: number;
  readonly silent: boolean;
}

function stepsOf(
  { mode, request, reply, delay, line }: ExchangeInputs,
  times: ExchangeTimes,
  text: TimingWords,
): Step[] {
  const waits = mode === 'rtu' && delay <= line.silences.t35;
  const pause = reply === 0 ? text.turnaroundStep : waits ? text.silenceAndAnswer : text.answering;
  const steps = [
    { name: text.steppedRequest(request), time: times.request, silent: false },
    { name: pause, time: times.pause, silent: true },
  ];
  if (reply > 0) steps.push({ name: text.steppedReply(reply), time: times.reply, silent: false });
  if (times.after > 0) steps.push({ name: text.silence, time: times.after, silent: true });
  return steps;
}

/** How long the exchange takes, step by step, and how many of them fit into a second. */
export function ExchangePanel({ mode, inputs, text }: ExchangeProps & { mode: SerialMode }) {
  return (
    <section class="panel" aria-labelledby="timing-exchange">
      <h2 id="timing-exchange">{text.thisExchange}</h2>
      <FrameAtHand mode={mode} text={text} />
      {inputs ? <Steps inputs={inputs} text={text} /> : <p>{text.correct}</p>}
    </section>
  );
}

function FrameAtHand({ mode, text }: { mode: SerialMode; text: TimingWords }) {
  const { controls, frame } = evaluation.value;
  const { description, functionCode = 0, unitId } = frame?.reading ?? {};
  return (
    <p class="note">
      {description ? text.frameAtHand(draft.value.transport === mode) : text.noFrame}{' '}
      <a href={`#${writeLink(draft.value, controls)}`}>
        {description ? text.of(functionCode, description.name, unitId) : text.toFrame}
      </a>
    </p>
  );
}

function Steps({ inputs, text }: { inputs: ExchangeInputs; text: TimingWords }) {
  const times = exchangeTimes({ ...inputs, silences: inputs.line.silences });
  const { baud } = inputs.line;
  const steps = stepsOf(inputs, times, text);
  return (
    <>
      <p class="result" aria-live="polite">
        <b>{text.most(SECOND / times.total)}</b> {text.silent(silentIn(times))}
      </p>
      <div class="times" aria-hidden="true">
        {steps.map(({ name, time, silent }) => (
          <span
            key={name}
            data-silent={silent ? '' : undefined}
            style={{ flexGrow: time / times.total }}
            title={name}
          />
        ))}
      </div>
      <table class="steps" aria-label={text.steps}>
        <thead>
          <tr>
            <th scope="col">{text.step}</th>
            <th scope="col">{text.takes}</th>
            <th scope="col">{text.share}</th>
          </tr>
        </thead>
        <tbody>
          {steps.map(({ name, time }) => (
            <StepRow key={name} name={name} time={time} total={times.total} baud={baud} text={text} />
          ))}
        </tbody>
        <tfoot>
          <StepRow name={text.total} time={times.total} total={times.total} baud={baud} text={text} />
        </tfoot>
      </table>
    </>
  );
}

function StepRow(props: { name: string; time: number; total: number; baud: number; text: TimingWords }) {
  const { name, time, total, baud, text } = props;
  return (
    <tr>
      <th scope="row">{name}</th>
      <td>
        <Time time={time} baud={baud} text={text} />
      </td>
      <td class="mono">{text.percent(time / total)}</td>
    </tr>
  );
}

interface RoundProps extends ExchangeProps {
  readonly devices: number | undefined;
  readonly missing: number | undefined;
  readonly timeout: number | undefined;
}

/** How long it takes to ask every device once. */
export function RoundPanel({ inputs, devices, missing, timeout, text }: RoundProps) {
  const known = inputs !== undefined && devices !== undefined && missing !== undefined && timeout !== undefined;
  return (
    <section class="panel" aria-labelledby="timing-round">
      <h2 id="timing-round">{known ? text.round(devices) : text.devices}</h2>
      {known ? (
        <Round inputs={inputs} devices={devices} missing={missing} timeout={timeout} text={text} />
      ) : (
        <p>{text.correct}</p>
      )}
    </section>
  );
}

interface KnownRound {
  readonly inputs: ExchangeInputs;
  readonly devices: number;
  readonly missing: number;
  readonly timeout: number;
  readonly text: TimingWords;
}

function Round({ inputs, devices, missing, timeout, text }: KnownRound) {
  const exchange = exchangeTimes({ ...inputs, silences: inputs.line.silences });
  if (inputs.reply === 0) return <p class="result">{text.toAll(exchange.total)}</p>;
  const round = pollingTime({ exchange, devices, missing, timeout });
  const lost = pollingTime({ exchange, devices: missing, missing, timeout });
  return (
    <p class="result">
      <b>{text.roundTakes(round)}</b> {text.eachDevice(SECOND / round)}
      {missing > 0 && ` ${text.lostToMissing(lost, missing)}`}
      {inputs.reply > 0 && inputs.delay > timeout && <span class="error"> {text.tooLate}</span>}{' '}
      <span class="section">{words.section('SL 2.4.1')}</span>
    </p>
  );
}
