// Runs programs in one process: each line it reads is {"file", "arguments"}, each it writes {"code", "out"}.
import { createInterface } from 'node:readline';
import { pathToFileURL } from 'node:url';

let out = '';
console.log = (...given) => {
  out += `${given.map((one) => (typeof one === 'object' ? JSON.stringify(one) : String(one))).join(' ')}\n`;
};

for await (const line of createInterface({ input: process.stdin })) {
  const { file, arguments: given, call = 'main', fill } = JSON.parse(line);
  out = '';
  let code;
  try {
    const module = await import(pathToFileURL(file).href);
    if (call === 'main') code = await module.main(given);
    else {
      const values = fill === undefined ? [] : [new Array(fill).fill(0)];
      code = module[call](...given.map((text) => Buffer.from(text, 'hex')), ...values);
      if (fill !== undefined) code = [code, values[0].map(Number)];
    }
  } catch (error) {
    code = String(error);
  }
  process.stdout.write(`${JSON.stringify({ code, out })}\n`);
}
