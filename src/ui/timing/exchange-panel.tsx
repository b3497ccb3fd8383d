import type { TimingView } from '../../store/index.ts';
import { type ExchangeInputs, timedExchange } from '../../workbench/index.ts';
import { SectionNames } from '../parts/section-names.tsx';
import { page } from '../parts/store.ts';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import { Time } from './silence-panel.tsx';

const SECOND = 1_000_000;

/** How long the exchange takes, step by step, and how many of them fit into a second. */
export function ExchangePanel({ view }: ViewProps<TimingView>) {
  const text = useWords('timing');
  const { mode, exchange } = view.reading.value;
  const { description, functionCode = 0, unitId } = page.evaluation.value.frame?.reading ?? {};
  return (
    <section class="panel" aria-labelledby="timing-exchange">
      <h2 id="timing-exchange">{text.thisExchange}</h2>
      <p class="note soft">
        {description ? text.currentFrame(page.transport.value === mode) : text.noFrame}{' '}
        <a href={`#${page.link.value}`}>
          {description ? text.of(functionCode, description.name, unitId) : text.toFrame}
        </a>
      </p>
      {exchange ? <Steps inputs={exchange} /> : <p>{text.correct}</p>}
    </section>
  );
}

function Steps({ inputs }: { readonly inputs: ExchangeInputs }) {
  const text = useWords('timing');
  const { times, silent: silence, ...timed } = timedExchange(inputs);
  const { baud } = inputs.line;
  const nameOf = {
    ...text.silentSteps,
    request: text.steppedRequest(inputs.request),
    reply: text.steppedReply(inputs.reply),
  };
  const steps = timed.steps.map((step) => ({ ...step, name: nameOf[step.kind] }));
  const row = (name: string, time: number) => (
    <tr key={name}>
      <th scope="row">{name}</th>
      <td>
        <Time time={time} baud={baud} />
      </td>
      <td class="mono">{text.percent(time / times.total)}</td>
    </tr>
  );
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
            {[text.step, text.takes, text.share].map((name) => (
              <th key={name} scope="col">
                {name}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>{steps.map(({ name, time }) => row(name, time))}</tbody>
        <tfoot>{row(text.total, times.total)}</tfoot>
      </table>
    </>
  );
}

/** How long it takes to ask every device once. */
export function RoundPanel({ view }: ViewProps<TimingView>) {
  const text = useWords('timing');
  const { round } = view.reading.value;
  return (
    <section class="panel" aria-labelledby="timing-round">
      <h2 id="timing-round">{round ? text.round(round.devices) : text.noRound}</h2>
      {round === undefined ? (
        <p>{text.correct}</p>
      ) : round.toAll ? (
        <p class="result">{text.toAll(round.time)}</p>
      ) : (
        <p class="result">
          <b>{text.roundTakes(round.time)}</b> {text.eachDevice(SECOND / round.time)}
          {round.missing > 0 && ` ${text.lostToMissing(round.lost, round.missing)}`}
          {round.tooLate && <span class="error"> {text.tooLate}</span>} <SectionNames of="SL 2.4.1" />
        </p>
      )}
    </section>
  );
}
