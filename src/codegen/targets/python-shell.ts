/** The parts of a Python program that no frame changes: how it speaks over a line, and how it says what came of it. */

const SEND_SERIAL = `
def send(line: serial.Serial, request: bytes) -> None:
    """Sends a request, after the silence that parts it from what was sent before."""
    time.sleep(PAUSE)
    line.reset_input_buffer()
    line.write(request)
    line.flush()
`;

const exchangeSerial = (echo: boolean) => `
def exchange(line: serial.Serial, request: bytes, wanted: Callable[[bytes], int]) -> bytes:
    """Sends a request and gives what comes back, until all of it is there or the time is over."""
    send(line, request)
    deadline = time.monotonic() + TIMEOUT
${
  echo
    ? `    # The adapter gives back what is sent.
    line.timeout = TIMEOUT
    reply: bytes = line.read(len(request))
    if reply == request:
        reply = b""`
    : '    reply = b""'
}
    while (length := wanted(reply)) == 0 or len(reply) < length:
        left = max(0.0, deadline - time.monotonic())
        # Where no byte says how long the reply is, silence ends it.
        line.timeout = min(left, SILENCE) if length == 0 and reply else left
        more = line.read(max(1, length - len(reply)))
        if not more:
            break
        reply += more
    return reply
`;

const SEND_TCP = `
def send(line: socket.socket, request: bytes) -> None:
    """Sends a request."""
    line.sendall(request)
`;

const EXCHANGE_TCP = `
def exchange(line: socket.socket, request: bytes, wanted: Callable[[bytes], int]) -> bytes:
    """Sends a request and gives what comes back, until all of it is there or the time is over."""
    send(line, request)
    deadline = time.monotonic() + TIMEOUT
    reply = b""
    while (length := wanted(reply)) > len(reply):
        line.settimeout(max(0.001, deadline - time.monotonic()))
        try:
            more = line.recv(length - len(reply))
        except TimeoutError:
            break
        if not more:
            break
        reply += more
    return reply
`;

export const exchangeParts = (isTcp: boolean, echo: boolean, answered: boolean): readonly string[] => [
  isTcp ? SEND_TCP : SEND_SERIAL,
  ...(answered ? [isTcp ? EXCHANGE_TCP : exchangeSerial(echo)] : []),
];

export const VERDICT = `
def verdict(result: int) -> str:
    """Says in words what a check gives."""
    if result > 0:
        return f"exception {result}: {exception_name(result)}"
    if result < 0:
        return f"fault {result}: {fault_name(result)}"
    return "good"
`;

export const FAILED = `
class Failed(Exception):
    """A step that ends the sequence."""
`;

export const WAIT_UNTIL = `
def wait_until(holds: Callable[[], bool], interval: float, timeout: float) -> bool:
    """Asks every interval, in seconds, whether something holds, and gives up after the time-out."""
    begin = due = time.monotonic()
    while not holds():
        due += interval
        if due > begin + timeout:
            return False
        time.sleep(max(0.0, due - time.monotonic()))
    return True
`;

const REMARK = /^\s*(#.*|""".*""")$/;

/** The lines of a part; without comments and docstrings, if there are to be none. */
export const partLines = (part: string, comments: boolean): readonly string[] => {
  const lines = part.trim().split('\n');
  if (comments) return lines;
  const kept = lines.filter((line) => !REMARK.test(line)).map((line) => line.replace(/ {2}# .*$/, ''));
  return kept.length === 1 ? [...kept, '    pass'] : kept;
};
