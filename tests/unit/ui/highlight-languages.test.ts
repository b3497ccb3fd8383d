import { expect, test } from 'vitest';
import { programTargets } from '../../../src/codegen/index.ts';
import { highlighting } from '../../../src/ui/parts/program/languages.ts';

const coloured = programTargets.filter(({ language }) => language !== 'plaintext');

test.each(coloured.map(({ id, language }) => [id, language]))(
  '%s: %s is a language that is highlighted',
  (_, language) => {
    expect(highlighting(language, '')).not.toBe(highlighting('plaintext', ''));
  },
);
