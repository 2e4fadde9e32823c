"""Writes a digest of what the display shows between two points.

usage: screen_digest.py FILE LEFT TOP RIGHT BOTTOM; the display is that of the environment.
"""

import hashlib
import sys

from Xlib import X, display

left, top, right, bottom = map(int, sys.argv[2:])
root = display.Display().screen().root
image = root.get_image(left, top, right - left, bottom - top, X.ZPixmap, 0xFFFFFFFF)
with open(sys.argv[1], "w", encoding="ascii") as file:
    file.write(hashlib.sha256(image.data).hexdigest())
