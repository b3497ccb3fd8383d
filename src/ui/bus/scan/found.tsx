import { useMemo } from 'preact/hooks';
import { countFindings, isFound, type ScanFinding, type ScanOrder } from '../../../bus/index.ts';
import { decodeFrame } from '../../../modbus/index.ts';
import { findingCells, findingColumns, findingsAsCsv, findingsAsMarkdown } from '../../../workbench/index.ts';
import { Copying } from '../../kit/copy-button.tsx';
import { page } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { scan } from '../jobs.ts';

/** Most lines drawn; the copy has all. */
const SHOWN = 500;

/** The findings, in a table that fills as the scan goes on. */
export function Findings({ order }: { readonly order: ScanOrder }) {
  const words = useWords('scan');
  const found = scan.found.value;
  if (found.length === 0) return null;
  return (
    <>
      <h3>{words.found[order.what](countFindings(found))}</h3>
      <section class="scroll" aria-label={words.results}>
        <table>
          <thead>
            <tr>
              {findingColumns(order).map((column) => (
                <th key={column} scope="col">
                  {words.columns[column]}
                </th>
              ))}
              <th scope="col">{words.columns.open}</th>
            </tr>
          </thead>
          <tbody>
            {found.slice(0, SHOWN).map((one, index) => (
              <Row key={index} found={one} transport={order.transport} />
            ))}
          </tbody>
        </table>
      </section>
      {found.length > SHOWN && <p class="said">{words.more(found.length - SHOWN)}</p>}
      <div class="tools in-row">
        <Copying copied={words.copied} refused={() => words.copyFailed} of={found}>
          {(copy) => (
            <>
              <button type="button" onClick={copy(() => findingsAsCsv(order, found, words))}>
                {words.copyCsv}
              </button>
              <button type="button" onClick={copy(() => findingsAsMarkdown(order, found, words))}>
                {words.copyMarkdown}
              </button>
            </>
          )}
        </Copying>
      </div>
    </>
  );
}

interface RowProps {
  readonly found: ScanFinding;
  readonly transport: ScanOrder['transport'];
}

/** A finding; a click anywhere opens its frame, the button is for the keyboard. */
function Row({ found, transport }: RowProps) {
  const words = useWords('scan');
  return useMemo(() => {
    const open = () => {
      if (found.what === 'not-opened') return;
      const { request, reply } = found;
      const reading = reply
        ? decodeFrame(reply, { transport, direction: 'response', request })
        : decodeFrame(request, { transport, direction: 'request' });
      page.showReading(reading, reply && request, 'step');
    };
    const cells = findingCells(found, words);
    const [name = ''] = cells;
    return (
      <tr data-found={isFound(found) ? '' : undefined} onClick={open}>
        {cells.map((cell, index) => (
          <td key={index}>{cell}</td>
        ))}
        <td>
          {found.what !== 'not-opened' && (
            <button type="button" aria-label={words.openOf(name)}>
              {words.open}
            </button>
          )}
        </td>
      </tr>
    );
  }, [found, transport, words]);
}
