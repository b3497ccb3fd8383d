// The page kit.html: every control in every state. It belongs to no build of the page; `npm run dev` shows it.
import { Component, type ComponentChildren, type RefObject, render } from 'preact';
import { Choice, Select } from './choice.tsx';
import { CopyButton } from './copy-button.tsx';
import { download } from './download.ts';
import { Field } from './field.tsx';
import { FileButton } from './file-button.tsx';
import { Fold, FoldPanel } from './fold.tsx';
import { NumberEntry } from './number-entry.tsx';
import { Segments } from './segments.tsx';
import { TextField } from './text-field.tsx';
import { TextArea } from './text-input.tsx';
import { VirtualLines } from './virtual-lines.ts';

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
          read={(text) => (/^\d+$/.test(text) ? Number(text) : undefined)}
          wrong="not a whole number"
          onValue={set}
        />
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
            <FileButton label="Open a file …" accept=".txt" onFile={(file) => set(file.name)} />
            <output>{name}</output>
          </>
        )}
      </Holding>
      <FileButton label="Open nothing …" disabled onFile={() => undefined} />
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

/** Ten thousand lines. */
class Lines extends VirtualLines<object, { readonly chosen: number }> {
  override state = { chosen: 0 };
  protected readonly line = 32;

  protected count() {
    return 10_000;
  }

  private readonly go = (event: KeyboardEvent) => {
    const chosen = this.placeFor(event, this.state.chosen);
    if (chosen === undefined) return;
    event.preventDefault();
    this.setState({ chosen });
    this.lines().scrollToIndex(chosen);
  };

  render() {
    const list = this.lines();
    const drawn = list.getVirtualItems();
    const { chosen } = this.state;
    return (
      <div
        class="virtual-lines"
        style={{ height: '10rem' }}
        ref={this.element as RefObject<HTMLDivElement>}
        role="listbox"
        aria-label="Ten thousand lines"
        aria-activedescendant={drawn.some(({ index }) => index === chosen) ? `line-${chosen}` : undefined}
        tabIndex={0}
        onKeyDown={this.go}
      >
        <div style={{ height: `${list.getTotalSize()}px` }} role="presentation">
          {drawn.map(({ index, start }) => (
            <div
              key={index}
              id={`line-${index}`}
              role="option"
              aria-selected={index === chosen}
              tabIndex={-1}
              style={{ transform: `translateY(${start}px)` }}
            >
              <span>Line {index + 1}</span>
            </div>
          ))}
        </div>
      </div>
    );
  }
}

const root = document.getElementById('app');
if (root) {
  render(
    <main>
      <h1>Every control of the kit</h1>
      <Fields />
      <Choices />
      <Buttons />
      <Folds />
      <Part title="Long lists">
        <Lines />
      </Part>
    </main>,
    root,
  );
}
