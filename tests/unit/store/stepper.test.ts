import { beforeEach, describe, expect, it } from 'vitest';
import { KeptChoice, Stepper, type StepSpeed, stepSpeeds } from '../../../src/store/index.ts';
import { flag, oneOf } from '../../../src/workbench/index.ts';
import { TestBrowser } from './window.ts';

let browser: TestBrowser;
/** What is called every so often, and how often a second. */
let ticking: { readonly act: () => void; readonly milliseconds: number } | undefined;

beforeEach(() => {
  browser = new TestBrowser();
  ticking = undefined;
});

function stepperOf(bytes: number): Stepper {
  const storage = browser.tab();
  return new Stepper(
    bytes,
    {
      folded: new KeptChoice(storage, 'folded', false, flag),
      speed: new KeptChoice<StepSpeed>(storage, 'speed', 2, oneOf(stepSpeeds)),
    },
    (milliseconds, act) => {
      const mine = { act, milliseconds };
      ticking = mine;
      return () => {
        if (ticking === mine) ticking = undefined;
      };
    },
  );
}

const at = ({ place }: Stepper) => [place.value.at, place.value.shift];

describe('keys', () => {
  it('go row by row and stay within the rows', () => {
    const stepper = stepperOf(2);
    stepper.press('ArrowUp');
    expect(at(stepper)).toEqual([0, 0]);
    stepper.press('ArrowDown');
    expect(at(stepper)).toEqual([0, 1]);
    stepper.press('End');
    expect(at(stepper)).toEqual([1, 8]);
    expect(stepper.atLast.value).toBe(true);
    stepper.press('ArrowDown');
    expect(at(stepper)).toEqual([1, 8]);
    stepper.press('Home');
    expect(at(stepper)).toEqual([0, 0]);
  });

  it('go byte by byte: from a shift to its byte first, and to the next byte', () => {
    const stepper = stepperOf(3);
    stepper.go({ at: 1, shift: 4 });
    stepper.press('PageUp');
    expect(at(stepper)).toEqual([1, 0]);
    stepper.press('PageUp');
    expect(at(stepper)).toEqual([0, 0]);
    stepper.press('PageUp');
    expect(at(stepper)).toEqual([0, 0]);
    stepper.press('PageDown');
    stepper.press('PageDown');
    stepper.press('PageDown');
    expect(at(stepper)).toEqual([2, 0]);
  });

  it('leave, fold, unfold and enter a byte, as in any tree', () => {
    const stepper = stepperOf(2);
    stepper.go({ at: 1, shift: 4 });
    stepper.press('ArrowLeft');
    expect(at(stepper)).toEqual([1, 0]);
    stepper.press('ArrowLeft');
    expect(stepper.rows.value.open(1)).toBe(false);
    expect(stepper.rows.value.length).toBe(10);
    stepper.press('ArrowLeft');
    expect(stepper.rows.value.open(1)).toBe(false);
    stepper.press('ArrowRight');
    expect(stepper.rows.value.open(1)).toBe(true);
    expect(at(stepper)).toEqual([1, 0]);
    stepper.press('ArrowRight');
    expect(at(stepper)).toEqual([1, 1]);
    stepper.press('ArrowRight');
    expect(at(stepper)).toEqual([1, 1]);
  });

  it('fold all, which is remembered; a shift that is folded away is at its byte', () => {
    const stepper = stepperOf(2);
    stepper.go({ at: 1, shift: 4 });
    stepper.press('Shift ArrowLeft');
    expect(stepper.rows.value.length).toBe(2);
    expect(at(stepper)).toEqual([1, 0]);
    expect(stepperOf(3).rows.value.length).toBe(3);
    stepper.press('Shift ArrowRight');
    expect(stepper.rows.value.length).toBe(18);
    expect(stepperOf(3).rows.value.length).toBe(27);
  });

  it('that mean nothing here do nothing', () => {
    const stepper = stepperOf(2);
    for (const key of ['Enter', 'Shift ArrowDown', 'constructor']) expect(stepper.press(key)).toBe(false);
    expect(at(stepper)).toEqual([0, 0]);
    expect(stepper.press('ArrowDown')).toBe(true);
  });
});

it('a shift that is gone to is unfolded', () => {
  const stepper = stepperOf(2);
  stepper.foldAll(true);
  stepper.go({ at: 1, shift: 3 });
  expect(at(stepper)).toEqual([1, 3]);
  expect(stepper.rows.value.open(0)).toBe(false);
  expect(stepper.row.value).toBe(4);
});

describe('by itself', () => {
  it('it goes on at the chosen speed, to the last row', () => {
    const stepper = stepperOf(1);
    stepper.press(' ');
    expect(stepper.playing.value).toBe(true);
    expect(ticking?.milliseconds).toBe(500);
    for (let tick = 0; tick < 8; tick++) ticking?.act();
    expect(at(stepper)).toEqual([0, 8]);
    expect(stepper.playing.value).toBe(true);
    ticking?.act();
    expect(stepper.playing.value).toBe(false);
    expect(ticking).toBeUndefined();
    stepper.play();
    expect(stepper.playing.value).toBe(false);
  });

  it('it goes faster and slower within the speeds, at once and the next time', () => {
    const stepper = stepperOf(1);
    stepper.press('+');
    expect(ticking).toBeUndefined();
    stepper.play();
    expect(ticking?.milliseconds).toBe(250);
    for (let press = 0; press < 5; press++) stepper.press('Shift +');
    expect(ticking?.milliseconds).toBeCloseTo(1000 / 30, 9);
    expect(stepperOf(1).speed).toBe(30);
    for (let press = 0; press < 9; press++) stepper.press('-');
    expect(ticking?.milliseconds).toBe(1000);
  });

  it('it stops when it is told to, and when a row is chosen by hand', () => {
    for (const stop of ['play', 'stop', 'move', 'go'] as const) {
      const stepper = stepperOf(2);
      stepper.play();
      const acts = {
        play: stepper.play,
        stop: stepper.stop,
        move: () => stepper.move(1),
        go: () => stepper.go({ at: 1, shift: 0 }),
      };
      acts[stop]();
      expect(stepper.playing.value, stop).toBe(false);
      expect(ticking, stop).toBeUndefined();
    }
  });
});
