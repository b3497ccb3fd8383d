import { describe, expect, it } from 'vitest';
import { codeRange, type FunctionCode, functionCodes, vendorOf } from '../../../../src/modbus/index.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { codeRuns } from '../../../../src/workbench/reference/code-runs.ts';
import { fieldSize, layoutAfter, limitedFields } from '../../../../src/workbench/reference/field-facts.ts';
import { misprints } from '../../../../src/workbench/reference/misprints.ts';
import { openPoints } from '../../../../src/workbench/reference/open-points.ts';
import { referenceDraft, sectionOfProblem } from '../../../../src/workbench/reference/reference-frame.ts';

const functionBy = (code: number): FunctionCode => functionCodes.find((description) => description.code === code)!;

describe('the limits of fields', () => {
  const limitsOf = (code: number) =>
    limitedFields(functionBy(code)).map(({ direction, field, section, typed }) => [
      direction,
      field.name,
      field.range?.least,
      field.range?.most,
      section,
      typed,
    ]);

  it('are those that the specification prints', () => {
    expect(limitsOf(0x01)).toEqual(expect.arrayContaining([['request', 'quantity', 1, 2000, 'AP 6.1', true]]));
    expect(limitsOf(0x10)).toEqual(expect.arrayContaining([['request', 'quantity', 1, 123, 'AP 6.12', false]]));
  });

  it('are listed once if the reply repeats the request', () => {
    const description = functionBy(0x10);
    const directions = (response: FunctionCode['response']) =>
      limitedFields({ ...description, response }).map(({ direction }) => direction);
    expect(new Set(directions(description.response))).toEqual(new Set(['request', 'response']));
    expect(new Set(directions(description.request))).toEqual(new Set(['request']));
  });

  it('are also those of groups, which are not typed on their own', () => {
    const inGroups = limitsOf(0x14).filter(([, name]) => name === 'recordLength' || name === 'recordNumber');
    expect(inGroups.length).toBeGreaterThan(0);
    expect(inGroups.every(([, , , , , typed]) => typed === false)).toBe(true);
  });
});

describe('the sizes of fields', () => {
  it('are bytes, or follow from the number of items', () => {
    const sizes = (code: number, direction: 'request' | 'response') =>
      functionBy(code)[direction].fields.map((field) => [field.name, fieldSize(field)]);
    expect(sizes(0x10, 'request')).toEqual([
      ['startAddress', 2],
      ['quantity', 2],
      ['byteCount', 1],
      ['registers', '2×n'],
    ]);
    expect(sizes(0x01, 'response')).toContainEqual(['bits', 'n/8']);
    expect(sizes(0x11, 'response')).toContainEqual(['data', 'n']);
  });

  it('stand in the layout that a choice leads to', () => {
    const { request } = functionBy(0x08);
    expect(layoutAfter(request, 4).fields.length).toBeGreaterThan(0);
    expect(() => layoutAfter(functionBy(0x03).request, 4)).toThrow(RangeError);
  });
});

describe('the runs of function codes', () => {
  it('cover all 256, each of one range and one user', () => {
    const runs = codeRuns();
    expect(runs.flatMap(([first, last]) => Array.from({ length: last - first + 1 }, (_, at) => first + at))).toEqual(
      Array.from({ length: 256 }, (_, code) => code),
    );
    for (const [first, last] of runs) {
      for (let code = first; code <= last; code++) {
        expect([codeRange(code), vendorOf(code)]).toEqual([codeRange(first), vendorOf(first)]);
      }
    }
    expect(runs.at(-1)).toEqual([128, 255]);
    expect(runs).toContainEqual([90, 90]);
  });
});

describe('the frame of a row', () => {
  it.each(functionCodes.map(({ code, name }) => [name, code] as const))(
    'of %s breaks no rule, as a request, a reply and an exception',
    (_name, functionCode) => {
      for (const kind of ['request', 'reply', 'exception'] as const) {
        const { frame, errors } = evaluate(referenceDraft({ kind, texts: { functionCode } }));
        expect([...errors], kind).toEqual([]);
        const broken = frame!.reading.problems.filter(({ severity }) => severity === 'error');
        expect(broken, kind).toEqual([]);
      }
    },
  );
});

describe('what the specification leaves open, and misprints', () => {
  it('have frames that come to bytes', () => {
    for (const [point, { frame, sections }] of Object.entries(openPoints)) {
      expect(sections.length, point).toBeGreaterThan(0);
      if (frame) expect(evaluate(referenceDraft(frame)).frame?.bytes.length, point).toBeGreaterThan(0);
    }
  });

  it('say where they stand', () => {
    for (const { sections } of [...Object.values(misprints), ...Object.values(openPoints)]) {
      for (const section of sections) expect(section).toMatch(/^(AP|SL|TG|PI) \S/);
    }
    expect(misprints.crcLabel).toEqual({ sections: ['SL 6.2.2', 'SL Appendix B'], gravity: 'wrong' });
  });

  it('have the section of the problem that a frame has', () => {
    // Exception code 07 is not in the specification, but in the Modicon guide.
    expect(sectionOfProblem({ kind: 'exception', texts: { functionCode: 3, exceptionCode: 2 } }, 'exceptionCode')).toBe(
      undefined,
    );
    expect(sectionOfProblem({ texts: { functionCode: 8, subFunction: 0x13 } }, 'subFunction')).toMatch(/^(AP|PI) /);
  });
});
