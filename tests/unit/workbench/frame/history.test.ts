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
    for (const { kind, entry } of acts) {
      if (kind === 'push') this.addresses.splice(++this.at, Infinity, entry.hash);
      else this.addresses[this.at] = entry.hash;
    }
  }
}

const at = (hash: string, input = '') => ({ hash, input });

describe('a step', () => {
  it('gives the entry before its own address back, and adds one', () => {
    expect(stepPlan(at('#b'), at('#a'), false)).toEqual([
      { kind: 'replace', entry: at('#a') },
      { kind: 'push', entry: at('#b') },
    ]);
  });

  it('is none where nothing has changed, or another view is open', () => {
    expect(stepPlan(at('#a'), at('#a'), false)).toEqual([]);
    expect(stepPlan(at('#b'), at('#a'), true)).toEqual([]);
  });

  it('is one where only the text of the input has changed', () => {
    expect(stepPlan(at('#a', 'hello'), at('#a'), false)).toEqual([
      { kind: 'replace', entry: at('#a') },
      { kind: 'push', entry: at('#a', 'hello') },
    ]);
  });

  it('leaves Back at what stood before the typing, also when the address had followed it', () => {
    const entries = new Entries('#value=4096');
    for (const hash of ['#value=', '#value=1', '#value=12']) entries.do([{ kind: 'replace', entry: at(hash) }]);
    entries.do(stepPlan(at('#value=12'), at('#value=4096'), false));
    entries.do([{ kind: 'replace', entry: at('#value=12&unitId=7') }]);
    entries.do(stepPlan(at('#value=12&unitId=7'), at('#value=12'), false));
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
