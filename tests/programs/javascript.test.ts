import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect } from 'vitest';
import { javascript as target } from '../../src/codegen/targets/javascript.ts';
import { testScripts } from './scripts.ts';
import { run } from './tools.ts';

/** Parses each file as a module, as `node --check` does, all in one process. */
const CHECK = `
const { readFileSync } = require('node:fs');
const { SourceTextModule } = require('node:vm');
for (const file of process.argv.slice(1)) new SourceTextModule(readFileSync(file, 'utf8'), { identifier: file });`;

const command = 'node --check';
testScripts(
  { target, language: 'javascript', ending: '.mjs', bytes: (hex) => hex.toLowerCase(), command },
  async (folder) => {
    const files = readdirSync(folder).map((name) => join(folder, name));
    const flags = ['--experimental-vm-modules', '--no-warnings', '-e', CHECK, '--'];
    expect(await run(process.execPath, [...flags, ...files])).toEqual({ code: 0, out: '', err: '' });
    const [first = ''] = files;
    expect(await run(process.execPath, ['--check', first])).toEqual({ code: 0, out: '', err: '' });
  },
);
