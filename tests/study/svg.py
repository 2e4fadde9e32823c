"""Draws plots as SVG, without libraries, so that the same numbers give the same bytes."""
import math

FONT = 'font-family="sans-serif"'


def marks(low, high):
    """The powers of ten between two numbers; where there are fewer than two, also their doubles and
    fivefolds."""
    powers = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    for factors in ((1,), (1, 2, 5)):
        values = [f * 10.0 ** p for p in powers for f in factors if low <= f * 10.0 ** p <= high]
        if len(values) >= 2:
            break
    return values


class Drawing:
    def __init__(self, width, height):
        self.width, self.height = width, height
        self.parts = [f'<rect width="{width}" height="{height}" fill="white"/>']

    def line(self, points, colour, width=1.5, dash="", closed=False):
        """A line through points, or a single dot."""
        if len(points) == 1:
            self.dot(points[0], colour)
            return
        text = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        tag = "polygon" if closed else "polyline"
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<{tag} points="{text}" fill="none" stroke="{colour}" '
                          f'stroke-width="{width}" stroke-linejoin="round"{dashes}/>')

    def segments(self, segments, colour, width=1.5):
        """Many lines of two points each, as one element."""
        path = "".join(f"M{p[0]:.1f} {p[1]:.1f}L{q[0]:.1f} {q[1]:.1f}" for p, q in segments)
        self.parts.append(f'<path d="{path}" fill="none" stroke="{colour}" '
                          f'stroke-width="{width}" stroke-linecap="round"/>')

    def dot(self, point, colour, radius=2):
        self.parts.append(f'<circle cx="{point[0]:.1f}" cy="{point[1]:.1f}" r="{radius}" '
                          f'fill="{colour}"/>')

    def text(self, x, y, text, size=11, anchor="start", colour="#222"):
        text = text.replace("&", "&amp;").replace("<", "&lt;")
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" {FONT} font-size="{size}" '
                          f'text-anchor="{anchor}" fill="{colour}">{text}</text>')

    def save(self, path):
        body = "\n".join(self.parts)
        path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" '
                        f'height="{self.height}" viewBox="0 0 {self.width} {self.height}">\n'
                        f"{body}\n</svg>\n", encoding="utf-8")


class Panel:
    """A part of a drawing with its own axes; both may be logarithmic."""

    def __init__(self, drawing, left, top, width, height, xs, ys, logarithmic=True):
        self.drawing, self.logarithmic = drawing, logarithmic
        self.left, self.top, self.width, self.height = left, top, width, height
        self.xs, self.ys = xs, ys

    def _part(self, value, limits):
        low, high = limits
        if self.logarithmic:
            value, low, high = (math.log10(v) for v in (value, low, high))
        return (value - low) / (high - low)

    def at(self, x, y):
        return (self.left + self.width * self._part(x, self.xs),
                self.top + self.height * (1 - self._part(y, self.ys)))

    def axes(self):
        """A frame with grid lines and their labels."""
        d = self.drawing
        for limits, is_x in ((self.xs, True), (self.ys, False)):
            for value in marks(*limits):
                ends = ([self.at(value, y) for y in self.ys] if is_x
                        else [self.at(x, value) for x in self.xs])
                d.line(ends, "#ddd", 1)
                label = f"{value:g}" if 1 <= value < 1e4 else f"{value:.0e}".replace("e+0", "e")
                label = label.replace("e-0", "e-")
                if is_x:
                    d.text(ends[0][0], self.top + self.height + 12, label, 9, "middle")
                else:
                    d.text(self.left - 4, ends[0][1] + 3, label, 9, "end")
        d.line([(self.left, self.top), (self.left + self.width, self.top),
                (self.left + self.width, self.top + self.height),
                (self.left, self.top + self.height)], "#888", 1, closed=True)

    def curve(self, points, colour, width=1.5, dash=""):
        """Points beyond the axes are left out."""
        inside = [(x, y) for x, y in points
                  if self.xs[0] <= x <= self.xs[1] and self.ys[0] <= y <= self.ys[1]]
        if inside:
            self.drawing.line([self.at(x, y) for x, y in inside], colour, width, dash)
