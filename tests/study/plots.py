"""The plots of docs/study.md."""
from curves import ended
from svg import Drawing, Panel

# Colour and dashes by method; others take the next ones of MORE.
STYLES = {
    "uniform": ("#999999", ""),
    "printed": ("#e07b00", ""), "printed, first come": ("#e07b00", "3,2"),
    "normals": ("#1f6fb4", ""), "normals, no L_max": ("#1f6fb4", "3,2"),
    "midpoint": ("#2f9e44", ""), "midpoint, no L_max": ("#2f9e44", "3,2"),
    "certified": ("#c2185b", ""),
}
MORE = [("#6f42c1", ""), ("#795548", ""), ("#00838f", "")]


def style_of(name, names):
    if name in STYLES:
        return STYLES[name]
    unknown = [n for n in names if n not in STYLES]
    return MORE[unknown.index(name) % len(MORE)]


def errors(d, path):
    """Error over triangles, a panel for each case."""
    columns, width, height, gap = 3, 250, 170, 48
    rows = -(-len(d["cases"]) // columns)
    drawing = Drawing(columns * (width + gap) + 20, rows * (height + gap + 4) + 64)
    names = [c["name"] for c in d["cases"][0]["curves"]]
    for i, case in enumerate(d["cases"]):
        left = 46 + (i % columns) * (width + gap)
        top = 24 + (i // columns) * (height + gap + 4)
        points = {c["name"]: [(p["faces"], p["from_mesh"]) for p in ended(c)
                              if p["from_mesh"] > 0] for c in case["curves"]}
        every = [p for some in points.values() for p in some]
        xs = (0.9 * min(x for x, _ in every), 1.1 * max(x for x, _ in every))
        ys = (0.8 * min(y for _, y in every), 1.25 * max(y for _, y in every))
        panel = Panel(drawing, left, top, width, height, xs, ys)
        panel.axes()
        for name in names:
            colour, dash = style_of(name, names)
            panel.curve(points[name], colour, 1.6, dash)
        drawing.text(left, top - 6, f"{case['object']}, {case['drag']}", 11)
    x, y = 46, rows * (height + gap + 4) + 34
    for name in names:
        colour, dash = style_of(name, names)
        wide = 42 + 6.2 * len(name)
        if x + wide > drawing.width:
            x, y = 46, y + 18
        drawing.line([(x, y - 4), (x + 24, y - 4)], colour, 2, dash)
        drawing.text(x + 28, y, name, 11)
        x += wide + 6
    drawing.save(path / "errors.svg")
    return "![Error over triangles, by method, for each of the twelve cases](study/errors.svg)"


def figure4(d, path):
    """Sections of the undulating surface and of each mesh."""
    width, height, gap = 430, 54, 30
    rows = max(len(u["results"]) for u in d["undulations"])
    drawing = Drawing(len(d["undulations"]) * (width + 20) + 10, rows * (height + gap) + 14)
    for column, u in enumerate(d["undulations"]):
        for row, result in enumerate(u["results"]):
            left, top = 10 + column * (width + 20), 22 + row * (height + gap)
            ys = [y for _, y in u["surface"]]
            panel = Panel(drawing, left, top, width, height, (-1, 1),
                          (min(ys) - 0.02, max(ys) + 0.02), logarithmic=False)
            panel.curve(u["surface"], "#bbbbbb", 4)
            segments = [[panel.at(*p) for p in line] for line in result["lines"]]
            drawing.segments(segments, "#1f6fb4", 1.3)
            if len(segments) < 40:
                for p in (p for segment in segments for p in segment):
                    drawing.dot(p, "#1f6fb4", 1.6)
            plural = "" if u["waves"] == 1 else "s"
            drawing.text(left, top - 5, f"{u['waves']} wave{plural} in an edge: {result['name']}, "
                                        f"{result['splits']} splits", 11)
    drawing.save(path / "figure4.svg")
    return "![Sections of an undulation and of the meshes for it](study/figure4.svg)"


def figure6(d, path):
    """The order of decimation."""
    order, size, gap = d["order"], 150, 40
    panels = [("[A] before", order["before"], "pq"),
              ("[B] p first: q has three edges", order["illegal"], "q"),
              ("[C] q first", order["legal"], "p"), ("then p", order["then"], "")]
    drawing = Drawing(len(panels) * (size + gap) + 10, size + 50)
    for i, (title, lines, vertices) in enumerate(panels):
        panel = Panel(drawing, 20 + i * (size + gap), 30, size, size, (-1, 1), (-1, 1),
                      logarithmic=False)
        for line in lines:
            drawing.line([panel.at(*p) for p in line], "#444", 1.4)
        for name in vertices:
            at = panel.at(*order[name])
            drawing.dot(at, "#c2185b", 3.5)
            drawing.text(at[0] + 6, at[1] + 14, name, 13, colour="#c2185b")
        drawing.text(panel.left - 8, 18, title, 11)
    drawing.save(path / "figure6.svg")
    return "![The order of decimation](study/figure6.svg)"


def all_plots(parts, path):
    return {"errors_plot": errors(parts["errors"], path),
            "figure4_plot": figure4(parts["figures"], path),
            "figure6_plot": figure6(parts["figures"], path)}
