import { join } from 'node:path';
import { expect } from 'vitest';
import { python as target } from '../../src/codegen/targets/python.ts';
import { testScripts } from './scripts.ts';
import { cache, runTool, strictTool, withTools } from './tools.ts';

withTools(['python3', 'python'], () => {
  const spaced = (hex: string) => hex.toLowerCase().replace(/..(?=.)/g, '$& ');
  testScripts(
    { target, language: 'python', ending: '.py', bytes: spaced, command: 'mypy --strict' },
    async (folder) => {
      const [mypy, ...strict] = strictTool('python');
      const { out, err } = await runTool(mypy, [...strict, '--cache-dir', join(cache, 'mypy'), folder], {
        sources: [folder],
      });
      expect(`${out}${err}`).toMatch(/^Success/);
    },
  );
});
