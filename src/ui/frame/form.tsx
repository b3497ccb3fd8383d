import { codeRange, envelopeSection, functionCodes, type Reading, vendorOf } from '../../modbus/index.ts';
import { formatHex, readNumber } from '../../notation/index.ts';
import type { Control, Evaluation, InputError } from '../../workbench/index.ts';
import { type Draft, frameKinds, headerText, transports, withText } from '../../workbench/index.ts';
import { Segments } from '../kit/segments.tsx';
import { TextInput } from '../kit/text-input.tsx';
import { idOf, Labelled } from '../parts/labelled.tsx';
import { words } from '../parts/page-words.ts';
import { Slot } from '../parts/slot.tsx';
import { commit, draft, edit, evaluation, page, step } from '../parts/store.ts';
import { DerivedField, FieldControl } from './field-control.tsx';
import { tools } from './loaded-tools.ts';
import { loadWriteValues } from './panels.ts';

const GROUPS = ['bits', 'registers', 'files', 'diagnostics', 'identification'] as const;

/** The form: everything a person chooses, laid out by the description of the function. */
export const Form = () => (
  <form class="panel" aria-labelledby="build" onSubmit={(event) => event.preventDefault()} onFocusOut={commit}>
    <h2 id="build">{words.page.build}</h2>
    <TransportChoice />
    <KindChoice />
    <div class="finder">
      <FinderPlace />
    </div>
    <FunctionChoice />
    <Fields />
  </form>
);

const transportOptions = transports.map((value) => ({
  value,
  name: words.page.transports[value],
  hint: words.page.transportHints[value],
}));

const TransportChoice = () => (
  <Segments
    label={words.page.transport}
    options={transportOptions}
    value={page.transport.value}
    onChoose={(transport) => step({ ...draft.value, transport })}
  />
);

const kindOptions = frameKinds.map((value) => ({ value, name: words.page.kinds[value] }));

const KindChoice = () => (
  <Segments
    label={words.page.kind}
    options={kindOptions}
    value={page.kind.value}
    onChoose={(kind) => step({ ...draft.value, kind })}
  />
);

const FinderPlace = () => tools.value && <tools.value.views.Finder words={tools.value.words} />;

/** The fields of the frame, as its function lays them out. */
function Fields() {
  const { value: current } = draft;
  const { controls, errors, frame } = evaluation.value;
  const reading = frame?.reading;
  const header = { draft: current, errors, reading };
  return (
    <>
      {current.transport === 'tcp' && <Header name="transactionId" {...header} />}
      {current.transport !== 'pdu' && <Header name="unitId" {...header} />}
      {controls
        .filter(({ derived, path }) => !derived && !Object.hasOwn(current.force, path))
        .map((control) => (
          <FieldControl key={control.path} control={control} {...header} />
        ))}
      <Slot part={loadWriteValues} with={{ draft: current, evaluation: evaluation.value }} />
      {current.kind !== 'request' && (
        <Labelled
          path="answering"
          label={words.page.answering}
          hint={words.page.answeringHint}
          error={errors.get('answering')}
        >
          <TextInput
            id={idOf('answering')}
            text={current.answering}
            wrong={errors.has('answering')}
            onText={(answering) => edit({ ...draft.value, answering })}
          />
        </Labelled>
      )}
      <Derived draft={current} evaluation={evaluation.value} />
    </>
  );
}

interface HeaderProps {
  readonly name: 'unitId' | 'transactionId';
  readonly draft: Draft;
  readonly errors: ReadonlyMap<string, InputError>;
  readonly reading: Reading | undefined;
}

/** A number of the frame's envelope. */
function Header({ name, draft, errors, reading }: HeaderProps) {
  if (Object.hasOwn(draft.force, name)) return null;
  const text = headerText(draft, name);
  const error = errors.get(name);
  const value = error === undefined ? readNumber(text) : undefined;
  const also = value === undefined ? undefined : `${value}, ${formatHex(value, name === 'unitId' ? 2 : 4)}`;
  return (
    <Labelled
      path={name}
      label={words.labels[name] ?? name}
      hint={also}
      error={error}
      section={envelopeSection(draft.transport, name)}
      reading={reading}
    >
      <TextInput
        id={idOf(name)}
        text={text}
        wrong={error !== undefined}
        onText={(typed) => edit(withText(draft, name, typed))}
      />
    </Labelled>
  );
}

const OTHER = 'other';

/** The same elements each time: typing draws none of them again. */
const functionOptions = GROUPS.map((group) => (
  <optgroup key={group} label={words.page.groups[group]}>
    {functionCodes
      .filter((description) => description.group === group)
      .map((description) => (
        <option key={description.code} value={String(description.code)}>
          {formatHex(description.code, 2).slice(2)} {description.name}
          {'serialOnly' in description ? ` (${words.page.serialOnly})` : ''}
        </option>
      ))}
  </optgroup>
));

/** Every public function by group, or any code as a number. */
function FunctionChoice() {
  const text = page.functionText.value;
  const error = page.functionError.value;
  const code = readNumber(text);
  const known = functionCodes.some((description) => description.code === code);
  const label = page.kind.value === 'exception' ? words.page.exceptionTo : words.page.functionLabel;
  return (
    <>
      <Labelled path="function" label={label}>
        <select
          id={idOf('function')}
          value={known ? String(code) : OTHER}
          onChange={({ currentTarget }) =>
            step(withText(draft.value, 'functionCode', currentTarget.value === OTHER ? '65' : currentTarget.value))
          }
        >
          {functionOptions}
          <option value={OTHER}>{words.page.otherFunction}</option>
        </select>
      </Labelled>
      {!known && (
        <Labelled
          path="functionCode"
          label={words.page.otherCode}
          hint={describeCode(code)}
          error={error}
          section="AP 4.1"
        >
          <TextInput
            id={idOf('functionCode')}
            text={text}
            wrong={error !== undefined}
            onText={(typed) => edit(withText(draft.value, 'functionCode', typed))}
          />
        </Labelled>
      )}
    </>
  );
}

function describeCode(code: number | undefined): string | undefined {
  if (code === undefined || !(code >= 0 && code <= 0xff)) return undefined;
  const vendor = vendorOf(code);
  return `${code}, ${formatHex(code, 2)}, ${words.page.codeRanges[codeRange(code)]}${vendor ? `, ${vendor}` : ''}`;
}

/** What the encoder works out, each of which can be sent wrong on purpose. */
function Derived({ draft, evaluation }: { draft: Draft; evaluation: Evaluation }) {
  const { controls, errors, frame } = evaluation;
  const names = [
    ...(draft.transport === 'tcp' ? ['protocolId', 'length'] : []),
    ...controls.filter(({ derived }: Control) => derived).map(({ path }) => path),
    ...(draft.transport === 'rtu' || draft.transport === 'ascii' ? ['checksum'] : []),
  ];
  // What a link forces and the form does not offer is shown all the same.
  const others = Object.keys(draft.force).filter((name) => !names.includes(name));
  if (names.length + others.length === 0) return null;
  return (
    <fieldset class="derived">
      <legend>{words.page.derived}</legend>
      {[...names, ...others].map((name) => (
        <DerivedField
          key={name}
          name={name}
          draft={draft}
          error={errors.get(name)}
          section={controls.find(({ path }) => path === name)?.section ?? envelopeSection(draft.transport, name)}
          reading={frame?.reading}
        />
      ))}
    </fieldset>
  );
}
