import type { ComponentChildren } from 'preact';
import type { Field, Layout } from '../../modbus/index.ts';
import { formatHex } from '../../notation/index.ts';
import type { ReferenceWords } from '../../words/index.ts';
import { fieldSize } from '../../workbench/index.ts';
import { words } from '../parts/page-words.ts';

export const labelOf = (name: string) => words.labels[name] ?? name;

/** A number as the bytes of a frame. */
export const digits = (value: number, width = 1) => formatHex(value, 2 * width).slice(2);

/** The fields of a layout, each in the colour of its kind, after the code that precedes them. */
export function layoutCell({ fields, then }: Layout, text: ReferenceWords, before?: string): ComponentChildren {
  return (
    <span class="fields">
      {before !== undefined && (
        <span class="chip" data-kind="function">
          <b class="mono">{before}</b>
        </span>
      )}
      {before === undefined && fields.length === 0 && <i>{text.nothingMore}</i>}
      {fields.map(chip)}
      {then && <i>{text.goesOnBy(labelOf(then.by))}</i>}
    </span>
  );
}

function chip(field: Field): ComponentChildren {
  const legal = legalOf(field);
  return (
    <span key={field.name} class="chip" data-kind={field.kind}>
      <span>{labelOf(field.name)}</span> <small class="mono size">{fieldSize(field)}</small>
      {legal !== undefined && <small class="legal mono">{legal}</small>}
      {field.group && <span class="fields">{field.group.map(chip)}</span>}
    </span>
  );
}

/** What a field may hold, where that is less than its bytes can. */
export function legalOf({ range, allowed, width, kind }: Field): string | undefined {
  if (range) return `${range.least}–${range.most}`;
  if (kind === 'flag') return `${words.page.on} / ${words.page.off}`;
  return allowed?.map((value) => digits(value, width)).join(' ');
}
