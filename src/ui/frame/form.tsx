import { codeRange, envelopeSection, functionCodes, type Reading, vendorOf } from '../../modbus/index.ts';
import { formatHex, readNumber } from '../../notation/index.ts';
import type { Control, Evaluation, InputError } from '../../workbench/index.ts';
import { type Draft, frameKinds, headerText, transports, withText } from '../../workbench/index.ts';
import { Segments } from '../kit/segments.tsx';
import { TextInput } from '../kit/text-input.tsx';
import { idOf, Labelled } from '../parts/labelled.tsx';
import { words } from '../parts/page-words.ts';
import { Slot } from '../parts/slot.tsx';
import { commit, edit, step } from '../state/draft.ts';
import { DerivedField, FieldControl } from './field-control.tsx';
import { tools } from './loaded-tools.ts';
import { loadWriteValues } from './panels.ts';

const GROUPS = ['bits', 'registers', 'files', 'diagnostics', 'identification'] as const;

/** The form: everything a person chooses, laid out by the description of the function. */
export function Form({ draft, evaluation }: { draft: Draft; evaluation: Evaluation }) {
  const { page } = words;
  const { controls, errors, frame } = evaluation;
  const reading = frame?.reading;
  return (
    <form class="panel" aria-labelledby="build" onSubmit={(event) => event.preventDefault()} onFocusOut={commit}>
      <h2 id="build">{page.build}</h2>
      <Segments
        label={page.transport}
        options={transports.map((value) => ({ value, name: page.transports[value], hint: page.transportHints[value] }))}
        value={draft.transport}
        onChoose={(transport) => step({ ...draft, transport })}
      />
      <Segments
        label={page.kind}
        options={frameKinds.map((value) => ({ value, name: page.kinds[value] }))}
        value={draft.kind}
        onChoose={(kind) => step({ ...draft, kind })}
      />
      <div class="finder">{tools.value && <tools.value.views.Finder draft={draft} words={tools.value.words} />}</div>
      <FunctionChoice draft={draft} error={errors.get('functionCode')} />
      {draft.transport === 'tcp' && <Header name="transactionId" draft={draft} errors={errors} reading={reading} />}
      {draft.transport !== 'pdu' && <Header name="unitId" draft={draft} errors={errors} reading={reading} />}
      {controls
        .filter(({ derived, path }) => !derived && !Object.hasOwn(draft.force, path))
        .map((control) => (
          <FieldControl key={control.path} control={control} draft={draft} errors={errors} reading={reading} />
        ))}
      <Slot load={loadWriteValues} with={{ draft, evaluation }} />
      {draft.kind !== 'request' && (
        <Labelled path="answering" label={page.answering} hint={page.answeringHint} error={errors.get('answering')}>
          <TextInput
            id={idOf('answering')}
            text={draft.answering}
            wrong={errors.has('answering')}
            onText={(answering) => edit({ ...draft, answering })}
          />
        </Labelled>
      )}
      <Derived draft={draft} evaluation={evaluation} />
    </form>
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
function FunctionChoice({ draft, error }: { draft: Draft; error: InputError | undefined }) {
  const { page } = words;
  const text = headerText(draft, 'functionCode');
  const code = readNumber(text);
  const known = functionCodes.some((description) => description.code === code);
  const label = draft.kind === 'exception' ? page.exceptionTo : page.functionLabel;
  return (
    <>
      <Labelled path="function" label={label}>
        <select
          id={idOf('function')}
          value={known ? String(code) : OTHER}
          onChange={({ currentTarget }) =>
            step(withText(draft, 'functionCode', currentTarget.value === OTHER ? '65' : currentTarget.value))
          }
        >
          {functionOptions}
          <option value={OTHER}>{page.otherFunction}</option>
        </select>
      </Labelled>
      {!known && (
        <Labelled path="functionCode" label={page.otherCode} hint={describeCode(code)} error={error} section="AP 4.1">
          <TextInput
            id={idOf('functionCode')}
            text={text}
            wrong={error !== undefined}
            onText={(typed) => edit(withText(draft, 'functionCode', typed))}
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
