"""The other end of a pseudo-terminal and of a connection: it keeps what is sent, and answers what it is told to.

Each line it reads is {"bytes": how many a request has, "replies": in hexadecimal, one for each request, "echo": whether to repeat
them, "same": whether to answer with the transaction of the request},
or {"wait": how many to wait for, a minute at most}. Each line it writes answers one: all that has come, in hexadecimal.
"""

import fcntl
import json
import os
import pty
import selectors
import socket
import sys
import termios
import time
import tty

master, slave = pty.openpty()
tty.setraw(slave)
# What was there to read may be thrown away before it is read.
os.set_blocking(master, False)
server = socket.create_server((sys.argv[1], int(sys.argv[2])))

got = b""
expected = 0
answered = 0
replies: list[bytes] = []
echo = False
same = False
waited: int | None = None
until = 0.0


def send(to: int, data: bytes) -> None:
    if data:
        os.write(to, data)


def take(data: bytes, to: int) -> None:
    global got, answered
    got += data
    while answered < len(replies) and len(got) >= expected * (answered + 1):
        request = got[expected * answered : expected * (answered + 1)]
        answer = replies[answered]
        answered += 1
        if echo:
            send(to, request)
        send(to, request[:2] + answer[2:] if same else answer)


def command(line: str) -> None:
    global got, expected, answered, replies, echo, same
    told = json.loads(line)
    if "bytes" in told:
        # What a program left behind, and that it had the port to itself.
        termios.tcflush(slave, termios.TCIOFLUSH)
        fcntl.ioctl(slave, termios.TIOCNXCL)
        got = b""
        expected, answered = told["bytes"], 0
        replies = [bytes.fromhex(reply) for reply in told["replies"]]
        echo = told["echo"]
        same = told["same"]
        print(flush=True)
    else:
        global waited, until
        waited, until = told["wait"], time.monotonic() + 60


print(json.dumps({"port": os.ttyname(slave)}), flush=True)
selector = selectors.DefaultSelector()
selector.register(sys.stdin, selectors.EVENT_READ)
selector.register(master, selectors.EVENT_READ)
selector.register(server, selectors.EVENT_READ)
while True:
    events = selector.select(None if waited is None else max(0.0, until - time.monotonic()))
    for key, _ in events:
        if key.fileobj is sys.stdin:
            line = sys.stdin.readline()
            if not line:
                sys.exit()
            command(line)
        elif key.fileobj is server:
            connection, _ = server.accept()
            selector.register(connection, selectors.EVENT_READ)
        else:
            try:
                data = os.read(key.fd, 4096)
            except OSError:
                data = b""
            if data:
                take(data, key.fd)
            elif key.fd != master:
                selector.unregister(key.fileobj)
                key.fileobj.close()
    if waited is not None and (len(got) >= waited or time.monotonic() >= until):
        print(got.hex(), flush=True)
        waited = None
