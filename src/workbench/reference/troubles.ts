import type { Section } from '../../modbus/index.ts';

/** A sign that something is wrong on the line. */
export type Trouble = 'silence' | 'broadcast' | 'sometimes' | 'late' | 'echo' | 'checksum' | 'garbage' | 'otherDevice';

/** The place of the page that helps: the checklist of the Bus view, its settings, times, or the picture of the line. */
export type TroublePlace = 'checklist' | 'scan' | 'bus' | 'timing' | 'wire';

/** The signs: where the specification says something of them, and where the page helps. */
export const troubles: Readonly<
  Record<Trouble, { readonly sections: readonly Section[]; readonly place: TroublePlace }>
> = {
  silence: { sections: ['SL 2.4.1'], place: 'checklist' },
  broadcast: { sections: ['SL 2.1'], place: 'checklist' },
  sometimes: { sections: ['SL 3.4.5', 'SL 3.4.6'], place: 'checklist' },
  late: { sections: ['SL 2.4.1'], place: 'timing' },
  echo: { sections: ['SL 3.3.2'], place: 'bus' },
  checksum: { sections: ['SL 2.5.1.2'], place: 'wire' },
  garbage: { sections: ['SL 2.5.1', 'SL 3.2'], place: 'scan' },
  otherDevice: { sections: ['SL 2.2'], place: 'scan' },
};
