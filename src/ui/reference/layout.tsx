import type { ComponentChildren } from 'preact';
import type { Field, Layout } from '../../modbus/index.ts';
import { formatHex } from '../../notation/index.ts';
import { fieldSize } from '../../workbench/index.ts';
import type { Say } from './entry.tsx';

export const labelOf = ({ page }: Say, name: string) => page.labels[name] ?? name;

/** A number as the bytes of a frame. */
export const digits = (value: number, width = 1) => formatHex(value, 2 * width).slice(2);

/** The fields of a layout, each in the colour of its kind, after the code that precedes them. */
export function layoutCell({ fields, then }: Layout, say: Say, before?: string) {
  return (
    <span class="fields in-row">
      {before !== undefined && (
        <span class="chip" data-kind="function">
          <b class="mono">{before}</b>
        </span>
      )}
      {before === undefined && fields.length === 0 && <i>{say.text.nothingMore}</i>}
      {fields.map((field) => chip(field, say))}
      {then && <i>{say.text.goesOnBy(labelOf(say, then.by))}</i>}
    </span>
  );
}

function chip(field: Field, say: Say): ComponentChildren {
  const legal = legalOf(field, say);
  return (
    <span key={field.name} class="chip" data-kind={field.kind}>
      <span>{labelOf(say, field.name)}</span> <small class="mono size">{fieldSize(field)}</small>
      {legal !== undefined && <small class="legal mono">{legal}</small>}
      {field.group && <span class="fields in-row">{field.group.map((inner) => chip(inner, say))}</span>}
    </span>
  );
}

/** What a field may hold, where that is less than its bytes can. */
export function legalOf({ range, allowed, width, kind }: Field, { page: { page } }: Say): string | undefined {
  if (range) return `${range.least}–${range.most}`;
  if (kind === 'flag') return `${page.on} / ${page.off}`;
  return allowed?.map((value) => digits(value, width)).join(' ');
}
