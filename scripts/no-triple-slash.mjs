// Refuses `/// <reference … />` in the sources: one line of it gives a pure layer the DOM behind its tsconfig's back.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

const sources = readdirSync('src', { recursive: true, encoding: 'utf8' }).filter((name) => /\.tsx?$/.test(name));
const offences = sources.flatMap((name) =>
  readFileSync(join('src', name), 'utf8')
    .split('\n')
    .flatMap((line, index) => (/^\s*\/\/\/\s*</.test(line) ? [`src/${name}:${index + 1}: ${line.trim()}`] : [])),
);
for (const offence of offences) console.error(`noTripleSlashReference: ${offence}`);
process.exitCode = offences.length === 0 ? 0 : 1;
