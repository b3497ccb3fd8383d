"""A pseudo-terminal: prints its path, then passes bytes between it and the standard streams."""

import os
import threading
import tty

master, slave = os.openpty()
tty.setraw(slave)
os.write(1, os.ttyname(slave).encode() + b"\n")


def give_on() -> None:
    while data := os.read(master, 4096):
        os.write(1, data)


threading.Thread(target=give_on, daemon=True).start()
while data := os.read(0, 4096):
    os.write(master, data)
