import { describe, expect, test } from 'vitest';
import { readTraceJson } from '../../../src/captures/index.ts';
import { readProfiles } from '../../../src/devices/index.ts';
import { readSequences, writeSequences } from '../../../src/sequences/index.ts';
import { profileCodec, readLink, readSaved, sequenceCodec, writeSaved } from '../../../src/workbench/index.ts';

/** A file of a format, in which a value that nests too deeply stands in place of each value in turn. */
const nestedIn = (template: string) =>
  [...template.matchAll(/"?\?"?/g)].flatMap(({ index }) =>
    ['[', '{"a":'].map((open) => {
      const deep = `${open.repeat(50_000)}1${(open === '[' ? ']' : '}').repeat(50_000)}`;
      return `${template.slice(0, index)}${deep}${template.slice(index + 1)}`.replaceAll('?', '1');
    }),
  );

const sequences =
  '{"format":"framewright-sequences","version":1,"sequences":[?,{"name":?,"about":?,"transport":?,"steps":[{"kind":?,"bytes":?,"link":?,"x":?},?],"finally":?}]}';
const devices =
  '{"format":"framewright-devices","version":1,"more":?,"profiles":[{"id":?,"name":?,"source":?,"convention":?,"serial":?,"traits":[?],"notes":?,"registers":[{"name":?,"names":[?],"address":?},?]}]}';
const frames = '{"format":"framewright-frames","version":1,"frames":[?,{"name":?,"link":?}]}';
const logs = [
  '{"format":"framewright log","version":1,"lines":[?,{"number":?,"time":?,"hex":?}]}',
  '{"format":"framewright trace","version":1,"records":[?,{"time":?,"known":?,"bytes":?}]}',
];
const unreadable = { kind: 'unreadable', fault: { code: 'too-deep' } };

describe('a value that nests 50,000 deep', () => {
  test.each(nestedIn(sequences))('in sequences: file %#', (text) => {
    expect(readSequences(text, () => undefined)).toMatchObject(unreadable);
    expect(sequenceCodec.read(text)).toMatchObject(unreadable);
  });

  test.each(nestedIn(devices))('in devices: file %#', (text) => {
    expect(readProfiles(text)).toMatchObject(unreadable);
    expect(profileCodec.read(text)).toMatchObject(unreadable);
  });

  test.each(nestedIn(frames))('in saved frames: file %#', (text) => {
    expect(readSaved(text)).toMatchObject(unreadable);
  });

  test.each(logs.flatMap(nestedIn))('in a log: file %#', (text) => {
    expect(readTraceJson(text)?.records ?? []).toEqual([]);
  });
});

test('what nests less is written again as it was read', () => {
  const deep: unknown = JSON.parse('['.repeat(80) + ']'.repeat(80));
  const list = readSaved(JSON.stringify({ format: 'framewright-frames', version: 1, frames: [deep] }));
  expect(list).toMatchObject({ kind: 'list', bad: [{ why: 'not-a-row' }] });
  expect(list.kind === 'list' && JSON.parse(writeSaved([], list.bad)).frames).toEqual([deep]);
  expect(JSON.parse(writeSequences([], [deep])).sequences).toEqual([deep]);
});

test('a link of brackets is read like any other text', () => {
  expect(() => readLink(`#rtu/request?data=${'['.repeat(50_000)}`)).not.toThrow();
});
