import { pollingTime, type SerialMode } from '../../modbus/index.ts';
import type { TimingWords } from '../../words/index.ts';
import { type ExchangeInputs, type ExchangeStep, timedExchange, writeLink } from '../../workbench/index.ts';
import { words } from '../parts/page-words.ts';
import { draft, evaluation } from '../parts/store.ts';
import { Time } from './silence-panel.tsx';

interface ExchangeProps {
  readonly inputs: ExchangeInputs | undefined;
  readonly text: TimingWords;
}

const SECOND = 1_000_000;

function stepName({ kind }: ExchangeStep, { request, reply }: ExchangeInputs, text: TimingWords): string {
  switch (kind) {
    case 'request':
      return text.steppedRequest(request);
    case 'reply':
      return text.steppedReply(reply);
    default:
      return text.silentSteps[kind];
  }
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
  const { times, silent: silence, ...timed } = timedExchange(inputs);
  const { baud } = inputs.line;
  const steps = timed.steps.map((step) => ({ ...step, name: stepName(step, inputs, text) }));
  return (
    <>
      <p class="result" aria-live="polite">
        <b>{text.most(SECOND / times.total)}</b> {text.silent(silence)}
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
  const exchange = timedExchange(inputs).times;
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
