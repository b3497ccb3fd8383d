"""Runs programs in one process: each line it reads is {"file", "arguments"}, each it writes {"code", "out"}."""

import contextlib
import importlib.util
import io
import json
import logging
import sys

logging.disable(logging.CRITICAL)
modules = {}
for line in sys.stdin:
    told = json.loads(line)
    file = told["file"]
    out = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
        if file not in modules:
            spec = importlib.util.spec_from_file_location(f"program_{len(modules)}", file)
            modules[file] = importlib.util.module_from_spec(spec)
            spec.loader.exec_module(modules[file])
        module = modules[file]
        # `main` as from the command line, or another function with bytes in hexadecimal.
        call, given = told.get("call", "main"), told["arguments"]
        try:
            if call == "main":
                answer = module.main(given)
            else:
                fill = told.get("fill")
                frames = [bytes.fromhex(text) for text in given]
                values = [] if fill is None else [[0] * fill]
                answer = getattr(module, call)(*frames, *values)
                if fill is not None:
                    answer = [answer, [int(value) for value in values[0]]]
        except Exception as error:
            answer = repr(error)
    print(json.dumps({"code": answer, "out": out.getvalue()}), flush=True)
