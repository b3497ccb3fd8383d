"""Pseudo-terminals, as many as the argument says: prints the path of each, then passes bytes between them and the standard streams.

Each line of these is the number of a terminal and bytes in hexadecimal.
"""

import os
import sys
import threading
import tty


def give_on(number: int, master: int) -> None:
    while data := os.read(master, 4096):
        os.write(1, f"{number} {data.hex()}\n".encode())


masters = []
for number in range(int(sys.argv[1])):
    master, slave = os.openpty()
    tty.setraw(slave)
    os.write(1, os.ttyname(slave).encode() + b"\n")
    masters.append(master)
for number, master in enumerate(masters):
    threading.Thread(target=give_on, args=(number, master), daemon=True).start()
for line in sys.stdin:
    number, data = line.split()
    os.write(masters[int(number)], bytes.fromhex(data))
