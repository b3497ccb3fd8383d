import { useState } from 'preact/hooks';
import { lineName, type Profile, printedNumber, type Register } from '../../devices/index.ts';
import { compareProfiles } from '../../workbench/index.ts';
import { Select } from '../kit/choice.tsx';
import { Table } from '../kit/table.tsx';
import { allDevices } from '../parts/device/chosen.ts';
import { useWords } from '../parts/words.ts';

/** Most differences that are drawn. */
const SHOWN = 200;

/** The chosen map beside another one: what only one of them has, and what differs. */
export function MapComparison({ profile }: { readonly profile: Profile }) {
  const words = useWords('library');
  const [id, choose] = useState('');
  const others = allDevices.all.value.filter((each) => each !== profile);
  const other = others.find((each) => each.id === id);
  const differences = other ? compareProfiles(profile, other) : [];
  return (
    <section class="panel" aria-labelledby="compare-maps">
      <h2 id="compare-maps">
        <label for="compared-map">{words.compare}</label>
      </h2>
      <Select
        id="compared-map"
        value={other?.id ?? ''}
        options={[{ value: '', name: words.compareNone }, ...others.map(({ id: value, name }) => ({ value, name }))]}
        onChoose={choose}
      />
      {other && (
        <p class="said" role="status">
          {differences.length === 0 ? words.same : words.differences(differences.length)}
        </p>
      )}
      {other && differences.length > 0 && (
        <Table
          labelledBy="compare-maps"
          narrow="scroll"
          rows={differences.slice(0, SHOWN)}
          keyOf={({ place }) => place}
          columns={[
            { name: words.place, class: 'mono', cell: ({ one, other: there }) => numberIn(profile, one ?? there) },
            { name: profile.name, cell: ({ one }) => <Line of={one} /> },
            { name: other.name, cell: ({ other: there }) => <Line of={there} /> },
          ]}
        />
      )}
    </section>
  );
}

const numberIn = ({ convention }: Profile, register: Register | undefined) =>
  register && printedNumber(convention, register.table, register.address);

function Line({ of }: { readonly of: Register | undefined }) {
  const words = useWords('library');
  const device = useWords('devices');
  if (of === undefined) return <span class="soft">{words.missing}</span>;
  return (
    <>
      {[lineName(of), device.typeText(of), device.scaleText(of)]
        .filter((text) => text !== '')
        .map((text) => (
          <span key={text} class="part">
            {text}
          </span>
        ))}
    </>
  );
}
