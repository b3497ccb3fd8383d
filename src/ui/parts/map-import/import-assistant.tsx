import { useEffect, useRef, useState } from 'preact/hooks';
import { lineName, type MapColumn, meanings, type Profile, type SheetRow } from '../../../devices/index.ts';
import type { MapImport } from '../../../store/index.ts';
import { type MapImportWay, mapImportWays } from '../../../workbench/index.ts';
import { Select } from '../../kit/choice.tsx';
import { disabledFor } from '../../kit/disabled-for.ts';
import { Fold } from '../../kit/fold.tsx';
import { Table } from '../../kit/table.tsx';
import { useWords } from '../words.ts';
import './import-assistant.css';

/** Registers that show how the map is read, and sentences of a kind that are shown at first. */
const FIRST = 8;
const MOST_SAID = 40;

interface AssistantProps {
  readonly of: MapImport;
  /** `wanted` is the name in the file. */
  readonly onKept: (profile: Profile, wanted: string) => void;
}

/** What a file was read as: what its columns mean, what it does not say, what comes of it. */
export function ImportAssistant({ of, onKept }: AssistantProps) {
  const words = useWords('library');
  const maps = useWords('registerMaps');
  const { refusals } = useWords('devices');
  const [way, choose] = useState<MapImportWay>('update');
  const [refused, refuse] = useState('');
  const heading = useRef<HTMLHeadingElement>(null);
  useEffect(() => heading.current?.focus(), [of.source.value]);
  const { value: reading } = of.reading;
  const { value: source } = of.source;
  if (!reading || !source) return null;
  const { profile, columns, faults, notices } = reading;
  const { value: questions } = of.questions;
  const { value: known } = of.known;
  const lost = new Set(faults.flatMap(({ rows }) => rows)).size;
  const doubtful = new Set(notices.filter(({ code }) => code !== 'heading').flatMap(({ rows }) => rows)).size;
  const keep = async () => {
    const kept = await of.keep(known ? way : 'add');
    if (typeof kept === 'string') refuse(refusals[kept]);
    else onKept(kept, known && way !== 'add' ? kept.name : profile.name);
  };
  return (
    <section class="panel assistant" aria-labelledby="assistant">
      <h2 id="assistant" ref={heading} tabIndex={-1}>
        {words.assistant(source.name)}
      </h2>
      <p role="status">
        <strong>{words.result(profile.registers.length, lost, doubtful)}</strong>
      </p>
      {questions.length > 0 && (
        <fieldset>
          <legend>{words.questions}</legend>
          {questions.map((question) => (
            <div key={question.code} class="question">
              <label for={`ask-${question.code}`}>{maps.question(question)}</label>
              <Select
                id={`ask-${question.code}`}
                value={question.assumed}
                options={question.options.map((value) => ({ value, name: maps.answer(value) }))}
                onChoose={(option) => of.answer(question.code, option)}
              />
              {question.example && <p class="mono soft">{question.example}</p>}
            </div>
          ))}
        </fieldset>
      )}
      {columns.length > 0 && (
        <>
          <h3>{words.columns}</h3>
          <Columns of={of} columns={columns} />
        </>
      )}
      {profile.registers.length > 0 && <FirstRegisters profile={profile} />}
      <Said title={words.notImported} lines={faults.map(maps.fault)} />
      <Said title={words.doubts} lines={notices.map(maps.notice)} />
      {known && (
        <fieldset>
          <legend>{words.way(known.name)}</legend>
          {mapImportWays.map((each) => (
            <label key={each} class="choice">
              <input type="radio" name="import-way" checked={way === each} onChange={() => choose(each)} />
              {words.ways[each]}
            </label>
          ))}
        </fieldset>
      )}
      {refused !== '' && (
        <p class="error" role="alert">
          {refused}
        </p>
      )}
      <p class="in-row">
        <button
          type="button"
          class="first"
          {...disabledFor(profile.registers.length === 0 ? words.nothing : undefined)}
          onClick={() => void keep()}
        >
          {words.keep}
        </button>
        <button type="button" onClick={of.close}>
          {words.cancel}
        </button>
      </p>
    </section>
  );
}

interface ColumnsProps {
  readonly of: MapImport;
  readonly columns: readonly MapColumn[];
}

/** The first rows of the file, and above each column what it was taken for, with the reason. */
function Columns({ of, columns }: ColumnsProps) {
  const words = useWords('library');
  const maps = useWords('registerMaps');
  const options = meanings.map((value) => ({ value, name: maps.meanings[value] }));
  return (
    <Table
      class="sheet"
      label={words.columns}
      narrow="scroll"
      rows={of.rows.value}
      keyOf={({ line }) => String(line)}
      columns={columns.map(({ header, meaning, why }, at) => ({
        name: words.column(at + 1, header),
        head: (
          <>
            <Select
              label={words.column(at + 1, header)}
              value={meaning}
              options={options}
              onChoose={(chosen) => of.answer(`column-${at + 1}`, chosen)}
            />
            <small>{maps.reasons[why]}</small>
          </>
        ),
        cell: ({ cells }: SheetRow) => cells[at],
      }))}
    />
  );
}

function FirstRegisters({ profile }: { readonly profile: Profile }) {
  const words = useWords('library');
  const device = useWords('devices');
  const [name = '', table = '', address = '', type = '', scale = '', access = ''] = words.registerColumns;
  return (
    <Fold summary={words.registers} open>
      <Table
        label={words.registers}
        narrow="scroll"
        rows={profile.registers.slice(0, FIRST)}
        keyOf={(register) => `${register.table} ${register.address} ${register.name}`}
        columns={[
          { name, cell: lineName },
          { name: table, cell: (register) => register.table },
          { name: address, class: 'number', cell: (register) => register.address },
          { name: type, cell: (register) => device.typeText(register) },
          { name: scale, cell: (register) => device.scaleText(register) },
          { name: access, cell: (register) => device.accesses[register.access] },
        ]}
      />
    </Fold>
  );
}

function Said({ title, lines }: { readonly title: string; readonly lines: readonly string[] }) {
  if (lines.length === 0) return null;
  return (
    <Fold summary={`${title} (${lines.length})`} open={lines.length <= FIRST}>
      <ul>
        {lines.slice(0, MOST_SAID).map((line) => (
          <li key={line}>{line}</li>
        ))}
      </ul>
    </Fold>
  );
}
