"""Plays a device on a pseudo-terminal: prints its name, then answers each request that comes.

Each argument is `length:reply` or `length:reply,reply`: how long the request is, and the bytes in hexadecimal, given with a short
pause between two parts. What was received is printed at last.
"""

import os
import pty
import sys
import time
import tty

device, slave = pty.openpty()
tty.setraw(slave)
print(os.ttyname(slave), flush=True)
for argument in sys.argv[1:]:
    length, replies = argument.split(":")
    request = b""
    while len(request) < int(length):
        request += os.read(device, int(length) - len(request))
    print(request.hex(), flush=True)
    for reply in filter(None, replies.split(",")):
        time.sleep(0.02)
        os.write(device, bytes.fromhex(reply))
sys.stdin.read()
