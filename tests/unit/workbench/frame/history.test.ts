import { describe, expect, it } from 'vitest';
import { type HistoryAct, showPlan, stepPlan } from '../../../../src/workbench/frame/history.ts';

/** A browser's history: the addresses of its entries, and where it stands. */
class Entries {
  readonly addresses: string[];
  at = 0;

  constructor(first: string) {
    this.addresses = [first];
  }

  do(acts: readonly HistoryAct[]): void {
    for (const { kind, hash } of acts) {
      if (kind === 'push') this.addresses.splice(++this.at, Infinity, hash);
      else this.addresses[this.at] = hash;
    }
  }
}

describe('a step', () => {
  it('gives the entry before its own address back, and adds one', () => {
    expect(stepPlan('#b', '#a', false)).toEqual([
      { kind: 'replace', hash: '#a' },
      { kind: 'push', hash: '#b' },
    ]);
  });

  it('is none where nothing has changed, or another view is open', () => {
    expect(stepPlan('#a', '#a', false)).toEqual([]);
    expect(stepPlan('#b', '#a', true)).toEqual([]);
  });

  it('leaves Back at what stood before the typing, also when the address had followed it', () => {
    const entries = new Entries('#value=4096');
    for (const hash of ['#value=', '#value=1', '#value=12']) entries.do([{ kind: 'replace', hash }]);
    entries.do(stepPlan('#value=12', '#value=4096', false));
    entries.do([{ kind: 'replace', hash: '#value=12&unitId=7' }]);
    entries.do(stepPlan('#value=12&unitId=7', '#value=12', false));
    expect(entries.addresses).toEqual(['#value=4096', '#value=12', '#value=12&unitId=7']);
  });
});

describe('a frame that is shown', () => {
  it('ends what was typed and makes a step of its own, or changes in place', () => {
    expect(showPlan('step', false)).toEqual(['commit', 'edit', 'commit']);
    expect(showPlan('edit', false)).toEqual(['edit']);
  });

  it('is a step from another view, whose address Back returns to', () => {
    expect(showPlan('step', true)).toEqual(['close-view', 'edit', 'commit']);
    expect(showPlan('edit', true)).toEqual(['close-view', 'edit', 'commit']);
  });
});
