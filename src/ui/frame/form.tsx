import { codeRange, functionCodes, vendorOf } from '../../modbus/index.ts';
import { formatHex, readNumber } from '../../notation/index.ts';
import type { Words } from '../../words/index.ts';
import { frameKinds, transports } from '../../workbench/index.ts';
import { Select } from '../kit/choice.tsx';
import { Segments } from '../kit/segments.tsx';
import { TextInput } from '../kit/text-input.tsx';
import { idOf, Labelled } from '../parts/labelled.tsx';
import { useSteady } from '../parts/steady.ts';
import { commit, draft, edit, fields, page, step } from '../parts/store.ts';
import { useWords } from '../parts/words.ts';
import { DerivedField } from './derived-field.tsx';
import { FieldControl } from './field-control.tsx';
import { Finder } from './tools/finder.tsx';
import { useField } from './use-field.ts';
import { WriteValues } from './values/write-values.tsx';

const GROUPS = ['bits', 'registers', 'files', 'diagnostics', 'identification'] as const;

/** The form: everything a person chooses, laid out by the description of the function. */
export function Form() {
  const { page: words } = useWords('page');
  return (
    <form class="panel build" aria-labelledby="build" onSubmit={(event) => event.preventDefault()} onFocusOut={commit}>
      <h2 id="build">{words.build}</h2>
      <TransportChoice />
      <KindChoice />
      <div class="finder">
        <Finder />
      </div>
      <FunctionChoice />
      <FieldList />
    </form>
  );
}

function TransportChoice() {
  const { page: words } = useWords('page');
  return (
    <Segments
      label={words.transport}
      options={transports.map((value) => ({
        value,
        name: words.transports[value],
        hint: words.transportHints[value],
      }))}
      value={page.transport.value}
      onChoose={(transport) => step({ ...draft.value, transport })}
    />
  );
}

function KindChoice() {
  const { page: words } = useWords('page');
  return (
    <Segments
      label={words.kind}
      options={frameKinds.map((value) => ({ value, name: words.kinds[value] }))}
      value={page.kind.value}
      onChoose={(kind) => step({ ...draft.value, kind })}
    />
  );
}

const OTHER = 'other';

/** Every public function by group, or any code as a number. */
function FunctionChoice() {
  const { page: words } = useWords('page');
  const { labelled, input, text } = useField('functionCode');
  const code = readNumber(text);
  const known = functionCodes.some((description) => description.code === code);
  const options = GROUPS.flatMap((group) =>
    functionCodes
      .filter((description) => description.group === group)
      .map((description) => ({
        value: String(description.code),
        name: `${formatHex(description.code, 2).slice(2)} ${description.name}${'serialOnly' in description ? ` (${words.serialOnly})` : ''}`,
        group: words.groups[group],
      })),
  );
  const label = page.kind.value === 'exception' ? words.exceptionTo : words.functionLabel;
  return (
    <>
      <Labelled path="function" label={label}>
        <Select
          id={idOf('function')}
          value={known ? String(code) : OTHER}
          options={[...options, { value: OTHER, name: words.otherFunction }]}
          onChoose={(value) => fields.choose('functionCode', value === OTHER ? '65' : value)}
        />
      </Labelled>
      {!known && (
        <Labelled
          path="functionCode"
          label={words.otherCode}
          hint={codeHint(code, words)}
          error={labelled.error}
          section="AP 4.1"
        >
          <TextInput {...input} />
        </Labelled>
      )}
    </>
  );
}

function codeHint(code: number | undefined, words: Words['page']): string | undefined {
  if (code === undefined || !(code >= 0 && code <= 0xff)) return undefined;
  const vendor = vendorOf(code);
  return `${code}, ${formatHex(code, 2)}, ${words.codeRanges[codeRange(code)]}${vendor ? `, ${vendor}` : ''}`;
}

/** The fields of the frame, as its function lays them out. */
function FieldList() {
  const { page: words } = useWords('page');
  const { envelope, fields: paths, answering, derived } = fields.layout.value;
  return (
    <>
      {envelope.map((path) => (
        <EnvelopeField key={path} path={path} />
      ))}
      {paths.map((path) => (
        <FieldControl key={path} path={path} />
      ))}
      <WriteValues />
      {answering && <Answering />}
      {derived.length > 0 && (
        <fieldset class="derived">
          <legend>{words.derived}</legend>
          {derived.map((name) => (
            <DerivedField key={name} name={name} />
          ))}
        </fieldset>
      )}
    </>
  );
}

/** A number of the frame's envelope. */
function EnvelopeField({ path }: { readonly path: string }) {
  const { labelled, input, text } = useField(path);
  const value = input.wrong ? undefined : readNumber(text);
  const hint = value === undefined ? undefined : `${value}, ${formatHex(value, path === 'unitId' ? 2 : 4)}`;
  return (
    <Labelled {...labelled} hint={hint}>
      <TextInput {...input} />
    </Labelled>
  );
}

/** The request that a reply answers. */
function Answering() {
  const { page: words } = useWords('page');
  const text = useSteady(() => draft.value.answering).value;
  const error = fields.at('answering').error.value;
  return (
    <Labelled path="answering" label={words.answering} hint={words.answeringHint} error={error}>
      <TextInput
        id={idOf('answering')}
        text={text}
        wrong={error !== undefined}
        onText={(answering) => edit({ ...draft.value, answering })}
      />
    </Labelled>
  );
}
