// The page kit.html: every control in every state. It belongs to no build of the page; `npm run dev` shows it.
import './kit.css';
import { Component, type ComponentChildren, render } from 'preact';
import { Drafts } from './cell-input.tsx';
import { Choice, Select } from './choice.tsx';
import { Combobox } from './combobox.tsx';
import { CompletedInput } from './completed-input.tsx';
import { CopyButton } from './copy-button.tsx';
import { Dialog } from './dialog.tsx';
import { download } from './download.ts';
import { Field } from './field.tsx';
import { FileButton } from './file-button.tsx';
import { Fold, FoldPanel } from './fold.tsx';
import { Grid } from './grid.tsx';
import { Messages } from './messages.tsx';
import { NumberEntry } from './number-entry.tsx';
import { Popover } from './popover.tsx';
import { SearchBox } from './search-box.tsx';
import { Segments } from './segments.tsx';
import { Sheet } from './sheet.tsx';
import { Table } from './table.tsx';
import { Tabs } from './tabs.tsx';
import { TextField } from './text-field.tsx';
import { TextArea } from './text-input.tsx';
import { VirtualList } from './virtual-list.tsx';

const SPEEDS = ['9600', '19200', '38400'];
const LONG = 'What is typed here is not a number, and the whole of this long sentence says so again and again.';
const PARITIES = [
  { value: 'even', name: 'even' },
  { value: 'odd', name: 'odd' },
  { value: 'none', name: 'none, in place of which a second stop bit is sent', disabled: true },
] as const;

/** Holds a value, as the owner of a control does. */
class Holding<T> extends Component<{
  readonly first: T;
  readonly children: (value: T, set: (value: T) => void) => ComponentChildren;
}> {
  override state = { value: this.props.first };

  render() {
    return this.props.children(this.state.value, (value) => this.setState({ value }));
  }
}

const Part = ({ title, children }: { readonly title: string; readonly children: ComponentChildren }) => (
  <section class="panel" aria-label={title}>
    <h2>{title}</h2>
    {children}
  </section>
);

const wrongIf = (text: string) => (/^\d*$/.test(text) ? '' : `“${text}” is not a number`);

const whole = (text: string) => (/^\d+$/.test(text) ? Number(text) : undefined);

const Fields = () => (
  <Part title="Text">
    <Holding first="">
      {(text, set) => (
        <TextField id="empty" label="Empty" text={text} error={wrongIf(text)} hint="a number" onText={set} />
      )}
    </Holding>
    <TextField id="usual" label="With usual texts" text="19200" usual={SPEEDS} onText={() => undefined} />
    <TextField id="wrong" label="Wrong" text="fast" error={LONG} hint="never shown" onText={() => undefined} />
    <TextField id="bare" label="Without a hint" text="" onText={() => undefined} />
    <Field id="area" label="Of any length" hint="many numbers" more={<b> and more</b>}>
      <TextArea id="area" text={'1 2 3 '.repeat(40)} onText={() => undefined} />
    </Field>
    <Field id="wrong-area" label="Of any length, wrong" error={LONG}>
      <TextArea id="wrong-area" text={'x'.repeat(300)} wrong onText={() => undefined} />
    </Field>
    <Holding first={9600}>
      {(value, set) => (
        <NumberEntry
          id="number"
          label="Number"
          value={value}
          hint={`${value} bits a second`}
          usual={SPEEDS}
          read={whole}
          wrong="not a whole number"
          onValue={set}
        />
      )}
    </Holding>
    <Holding first={247}>
      {(value, set) => (
        <>
          <NumberEntry
            label="Number taken when it is finished"
            bare
            when="finished"
            value={value}
            read={whole}
            wrong="not a whole number"
            onValue={set}
          />
          <output>The number is {value}.</output>
        </>
      )}
    </Holding>
  </Part>
);

const Choices = () => (
  <Part title="Choices">
    <Holding first={'even' as 'even' | 'odd' | 'none'}>
      {(value, set) => <Choice id="choice" label="Parity" value={value} options={PARITIES} onChoose={set} />}
    </Holding>
    <Choice id="locked" label="Locked" value="odd" options={PARITIES} disabled onChoose={() => undefined} />
    <Select
      label="Without a label beside it"
      value={1}
      options={[{ value: 1, name: 'one' }]}
      onChoose={() => undefined}
    />
    <Holding first="rtu">
      {(value, set) => (
        <Segments
          label="Transport"
          value={value}
          options={[
            { value: 'rtu', name: 'RTU', hint: 'on a serial line' },
            { value: 'ascii', name: 'ASCII' },
            { value: 'tcp', name: 'TCP' },
          ]}
          onChoose={set}
        />
      )}
    </Holding>
  </Part>
);

const Buttons = () => (
  <Part title="Buttons">
    <div class="actions">
      <button type="button" class="first">
        The first
      </button>
      <button type="button">Another</button>
      <button type="button" disabled>
        Disabled
      </button>
      <CopyButton
        label="Copy"
        text={() => '01 03'}
        of="frame"
        copied="Copied."
        refused={(text) => `Not copied: ${text}`}
      />
      <button type="button" onClick={() => download('01 03', 'frame.txt', 'text/plain')}>
        Download
      </button>
      <Holding first="">
        {(name, set) => (
          <>
            <FileButton label="Open a file…" accept=".txt" onFile={(file) => set(file.name)} />
            <output>{name}</output>
          </>
        )}
      </Holding>
      <FileButton label="Open nothing…" disabledFor="There is nothing to open." onFile={() => undefined} />
    </div>
  </Part>
);

const Folds = () => (
  <>
    <FoldPanel title="Folded" hint="with a hint, which is so long that it does not stand on one line of a narrow page">
      {() => <p>What is in it is made when it is opened.</p>}
    </FoldPanel>
    <FoldPanel title="Open" open>
      {() => <Fold summary="A fold inside">{() => <p>Inside.</p>}</Fold>}
    </FoldPanel>
    <FoldPanel title="Always there">
      <TextField id="there" label="Always there" text="" onText={() => undefined} />
    </FoldPanel>
    <FoldPanel title="Kept" keep>
      {() => <Holding first="">{(text, set) => <TextField id="kept" label="Kept" text={text} onText={set} />}</Holding>}
    </FoldPanel>
  </>
);

const Lines = ({ count, label }: { readonly count: number; readonly label: string }) => (
  <Holding first={0}>
    {(chosen, choose) => (
      <VirtualList id={label} label={label} count={count} chosen={chosen} onChoose={choose}>
        {(index) => <span>Line {index + 1}</span>}
      </VirtualList>
    )}
  </Holding>
);

const Lists = () => (
  <Part title="Long lists">
    <Lines count={10_000} label="Ten thousand lines" />
    <Lines count={1_000_000} label="A million lines" />
    <Lines count={0} label="No line" />
  </Part>
);

const GRID_ROWS = Array.from({ length: 20_000 }, (_, row) => `Row ${row + 1}`);
const drafts = new Drafts();

const Grids = () => (
  <Part title="A grid whose names are edited">
    {[false, true].map((cards) => (
      <Grid
        key={String(cards)}
        label={cards ? 'Twenty thousand cards' : 'Twenty thousand rows'}
        rows={GRID_ROWS}
        keyOf={(row) => `${cards} ${row}`.replaceAll(' ', '_')}
        cards={cards}
        line={52}
        drafts={drafts}
        columns={[
          {
            id: 'name',
            name: 'Name',
            width: '1fr',
            cell: (row) => row,
            edit: (row) => ({
              id: `${cards} ${row}-name`.replaceAll(' ', '_'),
              label: `Name of ${row}`,
              text: row,
              hint: 'Any digits',
              fault: wrongIf,
              take: () => undefined,
            }),
          },
          { id: 'length', name: 'Length', width: '6rem', cell: ({ length }) => length },
        ]}
      />
    ))}
  </Part>
);

const FORMATS = { tsv: 'tab-separated', csv: 'CSV' } as const;
const SPEED_ROWS = [9600, 19_200, 115_200].map((speed) => ({ speed, bit: 1e6 / speed }));

const Tables = () => (
  <Part title="Tables">
    <Holding first={'tsv' as keyof typeof FORMATS}>
      {(format, onFormat) => (
        <Table
          caption="Rows that become cards"
          narrow="cards"
          columns={[
            { name: 'Speed', class: 'mono', cell: ({ speed }) => speed },
            {
              name: 'A bit',
              head: <button type="button">A bit ▴</button>,
              sorted: 'ascending',
              class: 'number',
              cell: ({ bit }) => `${bit.toFixed(1)} µs`,
            },
            { name: 'Empty', cell: () => '' },
          ]}
          rows={SPEED_ROWS}
          keyOf={({ speed }) => speed}
          copyAs={{
            label: 'Copy the table',
            as: 'as',
            formats: FORMATS,
            format,
            onFormat,
            text: (of) => SPEED_ROWS.map(({ speed, bit }) => [speed, bit].join(of === 'tsv' ? '\t' : ',')).join('\n'),
            copied: 'The table is copied.',
            refused: (text) => `The table is not copied: ${text}`,
          }}
        />
      )}
    </Holding>
    <Table
      label="Many columns"
      narrow="scroll"
      columns={Array.from({ length: 20 }, (_, at) => ({ name: `Column ${at + 1}`, cell: (row: number) => row * at }))}
      rows={[1, 2]}
      keyOf={(row) => row}
    />
  </Part>
);

const Searches = () => (
  <Part title="Search">
    <Holding first="">
      {(text, set) => (
        <SearchBox id="search" label="Search" text={text} hint="speed" found={`${text.length} found`} onText={set} />
      )}
    </Holding>
    <SearchBox id="bare-search" label="Search without a label beside it" bare text="" onText={() => undefined} />
  </Part>
);

const MessageLines = () => (
  <Part title="Messages">
    <Messages lines={['The list is changed.', LONG]}>
      <button type="button">Undo</button>
    </Messages>
  </Part>
);

const Dialogs = () => (
  <Part title="Dialog">
    <Holding first={false}>
      {(open, set) => (
        <>
          <button type="button" onClick={() => set(true)}>
            Ask
          </button>
          {open && (
            <Dialog
              title="Is it to be sent?"
              onClose={() => set(false)}
              actions={
                <button type="button" class="first" onClick={() => set(false)}>
                  Yes
                </button>
              }
            >
              <p>{LONG}</p>
            </Dialog>
          )}
        </>
      )}
    </Holding>
  </Part>
);

const Sheets = () => (
  <Part title="Sheet">
    <Holding first={false}>
      {(open, set) => (
        <>
          <button type="button" onClick={() => set(true)}>
            Open a sheet
          </button>
          {open && (
            <Sheet title="A sheet" close="Close the sheet" onClose={() => set(false)}>
              <p>{LONG}</p>
            </Sheet>
          )}
        </>
      )}
    </Holding>
  </Part>
);

const Opened = () => (
  <Part title="Popover">
    <Popover summary="More">
      {(close) => (
        <>
          <p>{LONG}</p>
          <button type="button" onClick={close}>
            Done
          </button>
        </>
      )}
    </Popover>
  </Part>
);

const Found = () => (
  <Part title="Combobox">
    <Holding first="speed: fast">
      {(text, set) => (
        <div class="control">
          <label for="completed">Completed while it is typed</label>
          <CompletedInput
            id="completed"
            text={text}
            offered="Speeds"
            complete={(typed, to) => {
              const from = typed.lastIndexOf(' ', to - 1) + 1;
              const word = typed.slice(from, to);
              return SPEEDS.filter((speed) => speed.startsWith(word)).map((speed) => ({
                text: speed,
                from,
                to,
                hint: 'bits a second',
                goesOn: false,
              }));
            }}
            wrong={[...text.matchAll(/fast/g)].map(({ index }) => ({ from: index, to: index + 4 }))}
            describedBy="completed-said"
            onText={set}
            onCaret={() => undefined}
          />
          <p id="completed-said" class="said">
            A word that is wrong is underlined.
          </p>
        </div>
      )}
    </Holding>
    <Holding first="9600">
      {(chosen, choose) => (
        <Field id="found-speed" label="Speed" hint={`Chosen: ${chosen}`}>
          <Combobox
            id="found-speed"
            text={`${chosen} baud`}
            nothing="No speed matches."
            find={(text) =>
              SPEEDS.filter((speed) => speed.startsWith(text)).map((value) => ({
                key: value,
                name: `${value} baud`,
                value,
              }))
            }
            onChoose={choose}
          />
        </Field>
      )}
    </Holding>
  </Part>
);

const TABS = ['Bytes', 'Waveform', 'Values', 'Comparison', 'Device', 'Examples'];

const TabPanels = () => (
  <Part title="Tabs">
    <Holding first="Bytes">
      {(chosen, choose) => (
        <Tabs
          label="What is shown"
          chosen={chosen}
          onChoose={choose}
          tabs={TABS.map((id) => ({
            id,
            name: id,
            panel: () => (
              <Holding first="">
                {(text, set) => <TextField id={`tab-${id}`} label={`Inside of ${id}`} text={text} onText={set} />}
              </Holding>
            ),
          }))}
        />
      )}
    </Holding>
  </Part>
);

const root = document.getElementById('app');
if (root) {
  render(
    <main>
      <h1>Every control of the kit</h1>
      <Fields />
      <Choices />
      <Buttons />
      <Folds />
      <Lists />
      <Grids />
      <Tables />
      <Searches />
      <MessageLines />
      <Dialogs />
      <Sheets />
      <Opened />
      <Found />
      <TabPanels />
    </main>,
    root,
  );
}
