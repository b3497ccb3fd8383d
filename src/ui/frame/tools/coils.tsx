import { useRef, useState } from 'preact/hooks';
import { formatBytes, readBits, readNumber } from '../../../notation/index.ts';
import { bitsOfBytes, bytesOfBits, withCount } from '../../../workbench/index.ts';
import { fields } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import './coils.css';
import { firstOf } from './first-of.ts';
import { usePages } from './pages.tsx';

/** Coils shown at a time: enough for most devices, few enough to draw while typing. */
const PAGE = 64;
/** Coils of a byte, and of a row. */
const ROW = 8;

/** Bits one by one, with their addresses, a row a byte; how many, and as bytes. Space turns one over, the arrows move. */
export function Coils({ path }: { readonly path: string }) {
  const words = useWords('oneByOne').coils;
  const text = fields.at(path).text.value;
  const first = firstOf(path) ?? 0;
  const list = readBits(text);
  const bits = list.kind === 'list' ? list.items : [];
  const bytes = bytesOfBits(bits);
  /** The bits when their number or their bytes began to be typed: on the way to 10 stands 1, and on the way to CD 01 stands CD. */
  const before = useRef(bits);
  const enter = () => {
    before.current = bits;
  };
  const put = (next: readonly number[]) => fields.choose(path, next.join(' '));
  const { start, end, turning } = usePages(bits.length, PAGE, words);
  const rows = Array.from({ length: Math.ceil(bits.length / ROW) }, (_, row) => row).slice(
    start / ROW,
    Math.ceil(end / ROW),
  );
  return (
    <div class="coils own-row">
      <span class="label">{words.oneByOne}</span>
      <div>
        {rows.length > 0 && (
          // biome-ignore lint/a11y/useSemanticElements: a fieldset would frame it.
          <div role="group" aria-label={words.oneByOne} onKeyDown={moveByArrows}>
            {rows.map((row) => (
              <div key={row} class="coil-row">
                {bits.slice(row * ROW, (row + 1) * ROW).map((bit, offset) => {
                  const index = row * ROW + offset;
                  return (
                    <button
                      key={index}
                      type="button"
                      class="coil"
                      data-bit={bit}
                      aria-pressed={bit === 1}
                      aria-label={words.coil(first + index)}
                      tabIndex={index === start ? 0 : -1}
                      onClick={() => put(bits.with(index, bit === 1 ? 0 : 1))}
                    >
                      <small data-address={first + index} />
                    </button>
                  );
                })}
                <span class="coil-byte mono" title={words.byteOf(row + 1)}>
                  {formatBytes(bytes.subarray(row, row + 1))}
                </span>
              </div>
            ))}
          </div>
        )}
        {turning}
        <div class="in-row coil-texts">
          <Typed
            label={words.count}
            text={String(bits.length)}
            onEnter={enter}
            onText={(typed) => {
              const count = readNumber(typed);
              if (count === undefined || count < 1) return false;
              put(withCount(before.current, count));
              return true;
            }}
          />
          <Typed
            label={words.asBytes}
            text={formatBytes(bytes)}
            onEnter={enter}
            onText={(typed) => {
              const next = bitsOfBytes(typed, before.current.length);
              if (next === undefined || next.length === 0) return false;
              put(next);
              return true;
            }}
          />
        </div>
        <Order first={first} byte={bytes[0] ?? 0} />
        <p class="said">{words.orderIs}</p>
      </div>
    </div>
  );
}

/** The arrows, Home and End give the focus to another coil. */
function moveByArrows(event: KeyboardEvent): void {
  const { currentTarget, target, key } = event;
  if (!(currentTarget instanceof HTMLElement) || !(target instanceof HTMLButtonElement)) return;
  const coils = [...currentTarget.querySelectorAll<HTMLButtonElement>('.coil')];
  const at = coils.indexOf(target);
  const to = {
    ArrowRight: at + 1,
    ArrowLeft: at - 1,
    ArrowDown: at + ROW,
    ArrowUp: at - ROW,
    Home: 0,
    End: coils.length - 1,
  }[key];
  if (to === undefined) return;
  event.preventDefault();
  coils[to]?.focus();
}

interface TypedProps {
  readonly label: string;
  /** What stands here while nothing is typed. */
  readonly text: string;
  /** Takes what was typed; answers whether it could. */
  readonly onText: (text: string) => boolean;
  readonly onEnter: () => void;
}

/** A text that is another way to write the bits: it stays as typed until the field is left. */
function Typed({ label, text, onText, onEnter }: TypedProps) {
  const [typed, setTyped] = useState<string | undefined>(undefined);
  const [wrong, setWrong] = useState(false);
  return (
    <label>
      {label}
      <input
        class="mono"
        autocomplete="off"
        spellcheck={false}
        aria-invalid={wrong}
        value={typed ?? text}
        onFocusIn={onEnter}
        onInput={({ currentTarget: { value } }) => {
          setTyped(value);
          setWrong(!onText(value));
        }}
        onFocusOut={() => {
          setTyped(undefined);
          setWrong(false);
        }}
      />
    </label>
  );
}

/** Which bit of the first byte the lowest address is, as a picture: a byte is printed with its highest bit first. */
function Order({ first, byte }: { readonly first: number; readonly byte: number }) {
  const words = useWords('oneByOne').coils;
  return (
    <div class="coil-order" role="img" aria-label={words.order(first, byte)}>
      {Array.from({ length: ROW }, (_, place) => ROW - 1 - place).map((bit) => (
        <span key={bit} class={bit === 0 ? 'lowest' : undefined}>
          <small>{first + bit}</small>
          <b class="mono">{(byte >>> bit) & 1}</b>
        </span>
      ))}
      <span aria-hidden="true">
        <small>{words.firstByte}</small>
        <b class="mono">= {formatBytes(Uint8Array.of(byte))}</b>
      </span>
    </div>
  );
}
