import type { VNode } from 'preact';
import { useEffect, useLayoutEffect, useMemo, useState } from 'preact/hooks';
import type { CrcSteps, ShiftStep } from '../../../modbus/index.ts';
import type { StepPlace, StepRows } from '../../../workbench/index.ts';
import { binaryWidth, byteHex, registerHex } from '../../../workbench/index.ts';
import { useVirtualLines } from '../../kit/virtual-list.tsx';
import { useWords } from '../../parts/words.ts';
import { Bits } from './registers.tsx';

/** The height in pixels of a row and of the head, of one, two or three lines as the window is wide; the style sheet has the same. */
const LAYOUTS = [
  { media: matchMedia('(max-width: 480px)'), row: 68 },
  { media: matchMedia('(max-width: 860px)'), row: 48 },
];
const ONE_LINE = 28;
const rowNow = () => LAYOUTS.find(({ media }) => media.matches)?.row ?? ONE_LINE;

/** The height of a row, and of the head, in the window as it is. */
function useRowHeight(): number {
  const [height, setHeight] = useState(rowNow);
  useEffect(() => {
    const follow = () => setHeight(rowNow());
    for (const { media } of LAYOUTS) media.addEventListener('change', follow);
    return () => {
      for (const { media } of LAYOUTS) media.removeEventListener('change', follow);
    };
  }, []);
  return height;
}

interface ListProps {
  readonly steps: CrcSteps;
  readonly rows: StepRows;
  /** The row chosen. */
  readonly chosen: number;
  readonly describedBy: string;
  readonly onChoose: (row: number) => void;
  readonly onFold: (at: number) => void;
  readonly onKey: (event: KeyboardEvent) => void;
}

/** The steps, a row each: only those in sight are drawn. */
export function StepList({ steps, rows, chosen, describedBy, onChoose, onFold, onKey }: ListProps) {
  const words = useWords('checksumSteps');
  const line = useRowHeight();
  const list = useVirtualLines<HTMLTableElement>({ count: rows.length, line, head: line });
  useLayoutEffect(() => list.show(chosen), [chosen, rows]);

  // What a row says never changes: made once, it is drawn once, and a step costs its two rows alone.
  const cells = useMemo(() => new Map<string, VNode>(), [steps]);
  const cellsOf = (place: StepPlace) => {
    const key = `${place.at}.${place.shift}`;
    const made =
      cells.get(key) ??
      (place.shift === 0 ? <ByteCells steps={steps} at={place.at} /> : <ShiftCells steps={steps} place={place} />);
    cells.set(key, made);
    return made;
  };

  const take = ({ target }: MouseEvent) => {
    const row = target instanceof Element ? target.closest<HTMLElement>('[data-row]') : null;
    if (!row) return;
    const index = Number(row.dataset['row']);
    const onMark = target instanceof Element && target.closest('.mark');
    if (onMark) onFold(rows.place(index).at);
    else onChoose(index);
  };
  const { bits } = steps.form;
  return (
    <table
      {...list.scroller}
      class="step-list"
      style={{ '--hex': `${Math.ceil(bits / 4) + 2}ch`, '--bits': `${binaryWidth(bits)}ch` }}
      // biome-ignore lint/a11y/noNoninteractiveElementToInteractiveRole: rows that unfold are a tree as well as a table.
      role="treegrid"
      aria-label={words.list}
      aria-describedby={describedBy}
      aria-rowcount={rows.length + 1}
      aria-activedescendant={`step-${chosen}`}
      tabIndex={0}
      onKeyDown={onKey}
      onClick={take}
    >
      <thead>
        <tr aria-rowindex={1}>
          {Object.entries(words.columns).map(([name, label]) => (
            <th key={name} scope="col" class={name}>
              {label}
            </th>
          ))}
        </tr>
      </thead>
      <tbody style={{ height: `${list.height}px` }}>
        {list.lines.map(({ index, top }) => {
          const place = rows.place(index);
          const isByte = place.shift === 0;
          return (
            <tr
              key={index}
              id={`step-${index}`}
              class={isByte ? 'of-byte' : 'of-shift'}
              data-row={index}
              aria-level={isByte ? 1 : 2}
              aria-expanded={isByte ? rows.open(place.at) : undefined}
              aria-selected={index === chosen}
              aria-rowindex={index + 2}
              style={{ transform: `translateY(${top}px)` }}
            >
              {cellsOf(place)}
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}

function ByteCells({ steps, at }: { steps: CrcSteps; at: number }) {
  const words = useWords('checksumSteps');
  const { form } = steps;
  const hex = (value: number) => registerHex(form.bits, value);
  const { value, before, mixed, after } = steps.byte(at);
  return (
    <>
      <th scope="row" class="step">
        <span class="mark" aria-hidden="true" />
        {words.byte(at)} <b class="mono">{byteHex(value)}</b>
      </th>
      <td class="before mono">
        {hex(before)} <Bits form={form} value={before} />
      </td>
      <td class="mix mono" colSpan={2}>
        {words.mix(byteHex(value), hex(mixed))}
      </td>
      <td class="after mono">
        {hex(after)} <Bits form={form} value={after} />
      </td>
    </>
  );
}

function ShiftCells({ steps, place: { at, shift } }: { steps: CrcSteps; place: StepPlace }) {
  const words = useWords('checksumSteps');
  const { form } = steps;
  const hex = (value: number) => registerHex(form.bits, value);
  const { before, out, after } = steps.shifts(at)[shift - 1] as ShiftStep;
  return (
    <>
      <th scope="row" class="step">
        {words.shift(shift)}
      </th>
      <td class="before mono">
        {hex(before)} <Bits form={form} value={before} leaving />
      </td>
      <td class="out mono">{out}</td>
      <td class={out ? 'xor mono' : 'xor mono none'}>{out ? words.xor(hex(form.poly)) : words.noXor}</td>
      <td class="after mono">
        {hex(after)} <Bits form={form} value={after} />
      </td>
    </>
  );
}
