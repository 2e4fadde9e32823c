"""Drops a file on the program's window, as a file manager does (XDND version 5).

usage: drop_file.py PATH; the display is that of the environment. Exit 0 once the window has
taken the file, 1 where it has not answered in time.
"""

import sys
import time
from pathlib import Path

from Xlib import X, Xatom, display
from Xlib.protocol import event

PATIENCE = 10.0  # seconds


class Source:
    def __init__(self, path):
        self.display = display.Display()
        self.root = self.display.screen().root
        self.window = self.root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
        self.uri_list = (Path(path).absolute().as_uri() + "\r\n").encode()
        self.target = self.find_target(self.root)
        if self.target is None:
            sys.exit("no window takes drops")

    def atom(self, name):
        return self.display.intern_atom(name)

    def find_target(self, window):
        """The first window that says it takes drops."""
        if window.get_full_property(self.atom("XdndAware"), Xatom.ATOM):
            return window
        for child in window.query_tree().children:
            found = self.find_target(child)
            if found:
                return found
        return None

    def send(self, name, data):
        message = event.ClientMessage(window=self.target, client_type=self.atom(name),
                                      data=(32, data))
        self.target.send_event(message)
        self.display.flush()

    def wait_for(self, name):
        """Answers what the target asks until its message of this name comes."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if not self.display.pending_events():
                time.sleep(0.01)
                continue
            asked = self.display.next_event()
            if asked.type == X.SelectionRequest:
                self.hand_over(asked)
            elif asked.type == X.ClientMessage and asked.client_type == self.atom(name):
                return
        sys.exit(f"no {name} from the window")

    def hand_over(self, asked):
        asked.requestor.change_property(asked.property, asked.target, 8, self.uri_list)
        asked.requestor.send_event(event.SelectionNotify(
            time=asked.time, requestor=asked.requestor, selection=asked.selection,
            target=asked.target, property=asked.property))
        self.display.flush()

    def drop(self):
        selection = self.atom("XdndSelection")
        self.window.set_selection_owner(selection, X.CurrentTime)
        at = self.target.translate_coords(self.root, 0, 0)
        x, y = 300 - at.x, 300 - at.y
        me = self.window.id
        self.send("XdndEnter", [me, 5 << 24, self.atom("text/uri-list"), 0, 0])
        self.send("XdndPosition", [me, 0, x << 16 | y, X.CurrentTime, self.atom("XdndActionCopy")])
        self.wait_for("XdndStatus")
        self.send("XdndDrop", [me, 0, X.CurrentTime, 0, 0])
        self.wait_for("XdndFinished")


if __name__ == "__main__":
    Source(sys.argv[1]).drop()
