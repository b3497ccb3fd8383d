"""The sniffer of modbus-connector (PyPI): bytes on the standard input, seconds and its frames as JSON on the output."""

import json
import sys
import time

from modbus_connector.sniffer_backend import RtuFrameParser

CHUNK = 256  # what its serial reader takes at a time


class Placed(RtuFrameParser):
    """Notes where in the stream each frame was found, which the parser itself does not say."""

    def __init__(self):
        super().__init__()
        self.fed = 0
        self.found = []

    def _scan(self):
        answer = super()._scan()
        if answer is not None:
            place, frame, length = answer
            at = self.fed - len(self._buffer) + place
            direction = "request" if frame.direction == "tx" else "response"
            self.found.append({"from": at, "to": at + length, "direction": direction})
        return answer


stream = sys.stdin.buffer.read()
parser = Placed()
begin = time.perf_counter()
for start in range(0, len(stream), CHUNK):
    chunk = stream[start : start + CHUNK]
    parser.fed += len(chunk)
    parser.feed(chunk)
print(json.dumps({"seconds": time.perf_counter() - begin, "found": parser.found}))
