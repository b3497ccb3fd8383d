import { type CarriedField, type CarriedFrame, inEveryTransport } from '../../../../workbench/index.ts';
import { CopyButton } from '../../../kit/copy-button.tsx';
import { Table } from '../../../kit/table.tsx';
import type { CurrentFrame } from '../../current-frame.ts';
import { show } from '../../store.ts';
import { useWords } from '../../words.ts';
import { useLabel } from './difference-list.tsx';
import './transports.css';

/** The frame in every transport, side by side and aligned by field: what changes, and what stays. */
export function Transports({ draft, frame }: CurrentFrame) {
  const words = useWords('compare');
  const page = useWords('page');
  const labelOf = useLabel();
  if (frame === undefined) return null;
  const { frames, fields } = inEveryTransport(draft, frame);
  return (
    <section class="transports" aria-labelledby="transports">
      <h3 id="transports">{words.transports}</h3>
      <p class="said">{words.transportsHint}</p>
      <Table<CarriedField>
        label={words.transports}
        narrow="scroll"
        columns={[
          { name: words.field, cell: ({ name }) => labelOf(name) },
          ...frames.map((carried, index) => ({
            name: page.page.transports[carried.transport],
            head: <Head carried={carried} current={carried.transport === draft.transport} />,
            class: 'mono',
            cell: ({ texts }: CarriedField) => texts[index] ?? <span class="soft">{words.lacks}</span>,
          })),
          { name: words.change, cell: ({ stays }) => (stays ? words.stays : <b>{words.changes}</b>) },
        ]}
        rows={fields}
        keyOf={({ name }) => name}
        attributes={({ kind, from, to, stays }) => ({
          'data-kind': kind,
          'data-stays': stays ? '' : undefined,
          'data-from': from?.toString(),
          'data-to': to?.toString(),
        })}
      />
    </section>
  );
}

interface HeadProps {
  readonly carried: CarriedFrame;
  readonly current: boolean;
}

/** A transport, how long its frame is, and what can be done with it. */
function Head({ carried: { transport, draft, frame, text }, current }: HeadProps) {
  const words = useWords('compare');
  const { transports } = useWords('page').page;
  const { copied, copyFailed } = useWords('page').strip;
  const name = transports[transport];
  return (
    <>
      {name} <span class="said">{frame ? words.size(frame.bytes.length, transport) : words.notCarried}</span>
      {frame && (
        <span class="in-row">
          <CopyButton
            label={words.copy}
            name={words.copyAs(name)}
            text={() => text}
            of={text}
            copied={copied}
            refused={(failed) => `${copyFailed} ${failed}`}
          />
          {current ? (
            <span class="said">{words.current}</span>
          ) : (
            <button type="button" aria-label={words.useAs(name)} onClick={() => show(draft, 'step')}>
              {words.use}
            </button>
          )}
        </span>
      )}
    </>
  );
}
