// `npm start`: install if needed, build the page, and serve it on the first free port from 4173 on.
import { ensureInstalled } from './ensure-installed.mjs';
import { runScript } from './run.mjs';

await ensureInstalled();
const built = await runScript('build');
process.exitCode = built === 0 ? await runScript('preview', ['--port', '4173']) : built;
