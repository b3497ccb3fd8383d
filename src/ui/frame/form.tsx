import { codeRange, vendorOf } from '../../modbus/index.ts';
import { formatHex, readNumber } from '../../notation/index.ts';
import type { Words } from '../../words/index.ts';
import {
  type FoundFunction,
  findFunctions,
  frameKinds,
  functionsByUse,
  functionWith,
  transports,
} from '../../workbench/index.ts';
import { Combobox } from '../kit/combobox.tsx';
import { Segments } from '../kit/segments.tsx';
import { TextInput } from '../kit/text-input.tsx';
import { DeviceMenu } from '../parts/device/device-menu.tsx';
import { idOf, Labelled } from '../parts/labelled.tsx';
import { part, Slot } from '../parts/slot.tsx';
import { draft, fields, page, step } from '../parts/store.ts';
import { useWords } from '../parts/words.ts';
import { DerivedField } from './derived-field.tsx';
import { FieldControl } from './field-control.tsx';
import './form.css';
import { useField } from './use-field.ts';

const answeredRequest = part(
  ['stripMore'],
  () => import('./answering.tsx'),
  ({ Answering }) => Answering,
);

/** The form: everything a person chooses, laid out by the description of the function. Enter takes what was typed, Escape gives back what stood there. */
export function Form() {
  const { page: words } = useWords('page');
  return (
    <form
      class="panel build"
      aria-labelledby="build"
      onSubmit={(event) => event.preventDefault()}
      onFocusIn={fields.enter}
      onFocusOut={fields.take}
      onKeyDown={(event) => {
        if (event.defaultPrevented || event.isComposing) return;
        if (event.key === 'Enter') fields.take();
        else if (event.key === 'Escape' && fields.giveBack()) event.preventDefault();
      }}
    >
      <h2 id="build" class="unseen">
        {words.build}
      </h2>
      <TransportChoice />
      <KindChoice />
      <div class="control device-line">
        <span class="label">{words.device.label}</span>
        <DeviceMenu />
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
      bare
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
      bare
      options={frameKinds.map((value) => ({ value, name: words.kinds[value] }))}
      value={page.kind.value}
      onChoose={page.chooseKind}
    />
  );
}

/** Every public function by its use, or any code: found by a name or by digits. */
function FunctionChoice() {
  const { page: words } = useWords('page');
  const { labelled, input, text } = useField('functionCode');
  const meiType = readNumber(fields.at('meiType').text.value);
  const code = input.wrong ? undefined : readNumber(text);
  const shown = functionWith(code, meiType);
  const name = (found: FoundFunction) => words.functionIn(found);
  const options = (query: string) =>
    (query.trim() === '' ? functionsByUse : findFunctions(query)).map((value) => ({
      key: `${value.code}/${value.part}`,
      name: name(value),
      value,
    }));
  return (
    <Labelled
      path="functionCode"
      label={page.kind.value === 'exception' ? words.exceptionTo : words.functionLabel}
      hint={shown === undefined ? codeHint(code, words) : undefined}
      error={labelled.error}
      section="AP 4.1"
    >
      <Combobox
        id={idOf('functionCode')}
        text={shown ? name(shown) : code === undefined ? text : name({ code, texts: {} })}
        wrong={input.wrong}
        find={options}
        nothing={words.noFunction}
        onChoose={({ texts }) => fields.chooseAll(texts)}
      />
    </Labelled>
  );
}

/** Who a code without a description is for. */
function codeHint(code: number | undefined, words: Words['page']): string | undefined {
  if (code === undefined || !(code >= 0 && code <= 0xff)) return undefined;
  const vendor = vendorOf(code);
  return `${words.codeRanges[codeRange(code)]}${vendor ? `, ${vendor}` : ''}`;
}

/** The fields of the frame, as its function lays them out. */
function FieldList() {
  const { envelope, fields: paths, answering, derived } = fields.layout.value;
  return (
    <>
      {envelope.map((path) => (
        <EnvelopeField key={path} path={path} />
      ))}
      {paths.map((path) => (
        <FieldControl key={path} path={path} />
      ))}
      {answering && <Slot part={answeredRequest} with={{}} />}
      {derived.map((name) => (
        <DerivedField key={name} name={name} />
      ))}
    </>
  );
}

/** A number of the frame's envelope. */
function EnvelopeField({ path }: { readonly path: string }) {
  const { labelled, input, text } = useField(path);
  const value = input.wrong ? undefined : readNumber(text);
  const hint = value === undefined ? undefined : `${value}, ${formatHex(value, path === 'unitId' ? 2 : 4)}`;
  return (
    <Labelled {...labelled} class="short" hint={hint}>
      <TextInput {...input} />
    </Labelled>
  );
}
