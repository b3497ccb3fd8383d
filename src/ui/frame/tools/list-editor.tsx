import { Component } from 'preact';
import { readBits, readNumber, readNumbers } from '../../../notation/index.ts';
import type { ToolWords } from '../../../words/index.ts';
import { Fold } from '../../kit/fold.tsx';

/** Items shown at a time: enough to see, few enough to draw while typing. */
const PAGE = 16;
/** Longest list that any field can hold. */
const MOST = 2000;

interface ListProps {
  readonly text: string;
  readonly bits: boolean;
  /** Address of the first item, where it is known. */
  readonly first: number | undefined;
  readonly words: ToolWords;
  /** Takes the new list; `done` says that it is a step of its own and not typing. */
  readonly onText: (text: string, done: boolean) => void;
}

interface ListState {
  /** What is folded away is not drawn. */
  readonly page?: number;
  readonly count?: string;
  readonly value?: string;
  readonly step?: string;
}

/** The items of a list with their addresses: change, add, remove, move and fill them. */
export class ListEditor extends Component<ListProps, ListState> {
  /** The words of the list as typed: an item that is not touched keeps its notation. */
  private get items(): string[] {
    const { text, bits } = this.props;
    const list = bits ? readBits(text) : readNumbers(text);
    if (list.kind === 'wrong') return text.split(/[\s,;]+/).filter((word) => word !== '');
    return bits ? list.items.map(String) : text.split(/[\s,;]+/).filter((word) => word !== '');
  }

  private put(items: readonly string[], done: boolean): void {
    this.props.onText(items.join(' '), done);
  }

  private move(from: number, to: number): void {
    const items = this.items;
    const [item] = items.splice(from, 1);
    if (item !== undefined) this.put(items.toSpliced(to, 0, item), true);
  }

  private fill(): void {
    const { count = '', value = '0', step = '0' } = this.state;
    const many = Math.min(readNumber(count) ?? this.items.length, MOST);
    const start = readNumber(value) ?? 0;
    const by = readNumber(step) ?? 0;
    const item = (index: number) => (this.props.bits ? Number(start !== 0) : start + index * by);
    this.put(
      Array.from({ length: Math.max(0, many) }, (_, index) => String(item(index))),
      true,
    );
  }

  render() {
    const { words } = this.props;
    return (
      <Fold class="list-editor" summary={words.items}>
        {() => this.body()}
      </Fold>
    );
  }

  private body() {
    const { words, first } = this.props;
    const { items } = this;
    const pages = Math.max(1, Math.ceil(items.length / PAGE));
    const page = Math.min(this.state.page ?? 0, pages - 1);
    const shown = items.slice(page * PAGE, (page + 1) * PAGE);
    return (
      <>
        <ol start={page * PAGE + 1}>
          {shown.map((item, offset) => this.item(item, page * PAGE + offset, items, first))}
        </ol>
        {pages > 1 && (
          <p class="pages">
            <button type="button" disabled={page === 0} onClick={() => this.setState({ page: page - 1 })}>
              {words.earlier}
            </button>{' '}
            {words.pageOf(page * PAGE + 1, page * PAGE + shown.length, items.length)}{' '}
            <button type="button" disabled={page === pages - 1} onClick={() => this.setState({ page: page + 1 })}>
              {words.later}
            </button>
          </p>
        )}
        <button
          type="button"
          onClick={() => {
            this.put([...items, '0'], true);
            this.setState({ page: Math.floor(items.length / PAGE) });
          }}
        >
          {words.add}
        </button>
        <fieldset class="fill">
          <legend>{words.fill}</legend>
          {this.number('count', words.fillCount, String(items.length))}
          {this.number('value', words.fillValue, '0')}
          {!this.props.bits && this.number('step', words.fillStep, '0')}
          <button type="button" onClick={() => this.fill()}>
            {words.fill}
          </button>
        </fieldset>
      </>
    );
  }

  private item(item: string, index: number, items: readonly string[], first: number | undefined) {
    const { words } = this.props;
    const address = first === undefined ? undefined : first + index;
    return (
      <li key={index}>
        <span class="mono">{words.itemShort(index, address)}</span>
        <input
          class="mono"
          autocomplete="off"
          spellcheck={false}
          aria-label={words.item(index, address)}
          value={item}
          onInput={({ currentTarget }) => this.put(items.with(index, currentTarget.value.trim() || '0'), false)}
        />
        <button
          type="button"
          aria-label={words.up(index)}
          disabled={index === 0}
          onClick={() => this.move(index, index - 1)}
        >
          ↑
        </button>
        <button
          type="button"
          aria-label={words.down(index)}
          disabled={index === items.length - 1}
          onClick={() => this.move(index, index + 1)}
        >
          ↓
        </button>
        <button
          type="button"
          aria-label={words.remove(index)}
          onClick={() => this.put(items.toSpliced(index, 1), true)}
        >
          ×
        </button>
      </li>
    );
  }

  private number(name: 'count' | 'value' | 'step', label: string, initial: string) {
    return (
      <label>
        {label}
        <input
          class="mono"
          autocomplete="off"
          value={this.state[name] ?? initial}
          onInput={({ currentTarget }) => this.setState({ [name]: currentTarget.value })}
        />
      </label>
    );
  }
}
