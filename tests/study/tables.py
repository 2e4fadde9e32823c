"""The tables of docs/study.md, in Markdown."""
import math

from curves import ended, faces_needed, median, ratio_to_best_other, trigger_of

# The paper's figure 5: operations (additions, multiplications, divisions, square roots) and cost.
PAPER = {
    "endpoint normals, before the trigger": (3, 3, 0, 0, 6.21),
    "endpoint normals, after the trigger": (225, 296, 6, 0, 553.18),
    "midpoint distance, before the trigger": (255, 320, 15, 2, 629.81),
}
# Errors, in diagonals of the object's box, by which methods are compared.
ERRORS = (3e-3, 1e-3)
# The distances that tests/study/true_error.h explains.
MEASURES = {"from_mesh": "from the mesh", "from_face": "from the face",
            "from_interpolation": "from interpolation"}
# Runs with errors beyond these say nothing: coarser than anybody wants, or finer than floats.
LEAST_ERROR, LARGEST_ERROR = 1e-5, 1e-2


def table(header, rows):
    """Cells are texts. Columns of numbers are aligned to the right."""
    right = [all(cell[:1].isdigit() or cell in ("–", "alone") for cell in column)
             for column in zip(*rows)]
    right[0] = False
    lines = ["| " + " | ".join(header) + " |",
             "|" + "|".join("---:" if r else "---" for r in right) + "|"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)


def count(value):
    return "–" if value is None else f"{value:,.0f}"


def number(value, digits=2):
    """With so many significant digits; never in exponents."""
    if value is None:
        return "–"
    if value == 0:
        return "0"
    decimals = max(0, digits - 1 - math.floor(math.log10(abs(value))))
    return f"{value:,.{decimals}f}"


def small(value):
    return "–" if value is None else f"{value:.1e}"


def milliseconds(seconds):
    return number(1e3 * seconds, 3)


# --- 1. Tests of an edge.

def operations(d):
    rows = []
    for test in d["textbook"]:
        o, p = test["operations"], PAPER[test["what"]]
        counted = [o[k] for k in ("additions", "multiplications", "divisions", "square_roots")]
        rows.append([test["what"], " / ".join(map(str, p[:4])), " / ".join(map(str, counted)),
                     number(p[4], 4), number(o["cost"], 4), number(test["ns"], 3)])
    return table(["test of an edge", "paper: + / × / ÷ / √", "here: + / × / ÷ / √",
                  "paper's cost", "cost here", "ns"], rows)


def program_tests(d):
    rows = []
    for scene in d["program"]:
        for test in scene["tests"]:
            rows.append([scene["drag"], test["what"], number(test["ns"], 3),
                         f"{100 * test['triggering'] / scene['edges']:.2f} %"])
        rows.append([scene["drag"], "the image of a midpoint (after the trigger)",
                     number(scene["image_ns"], 3), "–"])
        for part in scene.get("certificate", []):
            rows.append([scene["drag"], part["what"], number(part["ns"], 3), "–"])
    return table(["drag", "what", "ns", "edges that need refinement"], rows)


def break_even(d):
    """The share of triggering tests at which both tests of the figure cost the same."""
    rows = []

    def add(what, before, after, midpoint):
        share = (midpoint - before) / after
        rows.append([what, number(before, 3), number(after, 3), number(midpoint, 3),
                     f"{100 * share:.0f} %"])

    cost = {name: values[4] for name, values in PAPER.items()}
    add("the paper's costs", *cost.values())
    add("the operations counted here, at the paper's costs",
        *(t["operations"]["cost"] for t in d["textbook"]))
    add("the textbook's code, ns", *(t["ns"] for t in d["textbook"]))
    for scene in d["program"]:
        time = {t["what"]: t["ns"] for t in scene["tests"]}
        add(f"the program, {scene['drag']}, ns", time["normals"], scene["image_ns"],
            time["midpoint"])
    t = d["triggering"]
    return (table(["", "normals, before", "normals, after", "midpoint, before",
                   "equal if so many tests trigger"], rows) +
            f"\n\nIn the first refinement of the twelve cases of section 4 by the printed rules at "
            f"the default angle without L_max, {t['splits']:,} of {t['tests']:,} tests trigger: "
            f"{100 * t['splits'] / t['tests']:.0f} %.")


def bit_index(d):
    rows = []
    for r in d["bit_index"]:
        rows.append([f"{r['altered_control_points']} of {r['control_points']}",
                     f"{100 * r['altered_vertices']:.0f} %", f"{100 * r['altered_edges']:.0f} %",
                     number(r["ns_without"], 3), number(r["ns_with"], 3),
                     number(r["ns_index"], 2), number(r["ns_with"] / r["ns_without"], 2),
                     number(r["ns_program"], 3)])
    return table(["altered control points", "vertices in altered cells", "edges with an end there",
                  "ns a vertex without", "with the index", "asking alone", "with : without",
                  "the program, normals included"], rows)


# --- 2. Figures 4 and 6.

def figure4(d):
    rows = []
    for u in d["undulations"]:
        for r in u["results"]:
            rows.append([f"{u['waves']} in each edge", r["name"], count(r["splits"]),
                         count(r["faces"]), number(r["from_mesh"] / u["tolerance"], 2)])
    return table(["waves", "trigger", "splits", "faces", "error, in default tolerances"], rows)


# --- 3. Figure 7.

def figure7(d):
    paper = {"b": ("200", "0", "16.8"), "d": ("32", "92", "9.5")}
    printed = dict(zip(("b", "d"), d["by_print"]))
    rows = []
    for drag in d["drags"]:
        p = paper.get(drag["picture"], ("–", "–", "–"))
        q = printed.get(drag["picture"])
        rows.append([
            f"[{drag['picture'].upper()}] {drag['what']}", f"{p[0]} / {p[1]}",
            f"{q['refinements']} / {q['decimations']}" if q else "–",
            f"{drag['refinements']} / {drag['decimations']}", count(drag["faces"]), p[2],
            milliseconds(drag["deform"] + drag["refine"] + drag["decimate"]),
            milliseconds(drag["whole"])])
    return table(["", "paper: + / −", "printed rules: + / −", "pectin: + / −", "faces after",
                  "paper, ms", "deform and adapt, ms", "the whole drag, ms"], rows)


# --- 4. Errors.

def name_of(case):
    steps = f", {case['steps']} steps" if case["steps"] > 1 else ""
    return f"{case['object']}, {case['drag']}{steps}"


def by_default(d):
    names = [r["trigger"] for r in d["cases"][0]["defaults"]]
    rows = []
    for case in d["cases"]:
        row = [name_of(case), count(case["faces_at_rest"])]
        for r in case["defaults"]:
            row += [count(r["faces"]), small(r["from_mesh"]), milliseconds(r["seconds"])]
        rows.append(row)
    header = ["case", "faces at rest"]
    for name in names:
        header += [f"{name}: faces", "error", "ms"]
    return table(header, rows)


def needed(d, error, measure="from_mesh"):
    names = [c["name"] for c in d["cases"][0]["curves"]]
    rows, ratios = [], {name: [] for name in names}
    for case in d["cases"]:
        values = {c["name"]: faces_needed(ended(c), error, measure) for c in case["curves"]}
        rows.append([name_of(case)] + [count(values[n]) for n in names])
        known = [v for v in values.values() if v is not None]
        for n in names:
            if known:
                ratios[n].append(values[n] / min(known) if values[n] else math.inf)
    rows.append(["times the least, median"] +
                ["–" if math.isinf(median(r)) else number(median(r), 3) for r in ratios.values()])
    rows.append(["cases in which it is reached"] +
                [str(sum(1 for v in r if not math.isinf(v))) for r in ratios.values()])
    return table(["case"] + names, rows)


def equal_error(d):
    """The triangles of each trigger, over the fewest of the other triggers for the same error."""
    triggers = [r["trigger"] for r in d["cases"][0]["defaults"]]
    rows, medians = [], []
    columns = [(t, m) for m in MEASURES for t in triggers]
    for case in d["cases"]:
        ratios = [ratio_to_best_other(case, t, m, LEAST_ERROR, LARGEST_ERROR) for t, m in columns]
        rows.append([name_of(case)] + ["alone" if r == 0 else number(r, 3) for r in ratios])
    for t, m in columns:
        medians.append(median([ratio_to_best_other(case, t, m, LEAST_ERROR, LARGEST_ERROR)
                               for case in d["cases"]]))
    rows.append(["median"] + [number(v, 3) for v in medians])
    return (table(["case"] + [f"{t}, {MEASURES[m]}" for t, m in columns], rows),
            dict(zip(columns, medians)))


def about_certified(edges, medians):
    """A paragraph about the certified trigger, where there is one."""
    if ("certified", "from_mesh") not in medians:
        return ""
    bounds = [part["ns"] for scene in edges["program"] for part in scene.get("certificate", [])
              if "bound" in part["what"]]
    time = f" Its bound takes {count(max(bounds))} ns for a face." if bounds else ""
    ratio = {m: number(medians["certified", m], 2) for m in MEASURES}
    return ("The certificate is asked for the distance from interpolation. For that it needs "
            f"{ratio['from_interpolation']} times as many faces as the best other trigger, in the "
            f"median, and {ratio['from_face']} times for the distance from the face. For the "
            f"distance from the mesh it needs {ratio['from_mesh']} times as many, as it also "
            f"refines where a face is only distorted within its plane.{time} It needs no L_max, "
            "and nothing escapes it.")


def orders(d):
    """The printed rules with the heap and without, at the angles at which both end."""
    rows = []
    for case in d["cases"]:
        curve = {c["name"]: c["points"] for c in case["curves"]}
        first, second = curve["printed"], curve["printed, first come"]
        other = {p["detail"]: p for p in second if p["has_ended"]}
        pairs = [(p, other[p["detail"]]) for p in first
                 if p["has_ended"] and p["detail"] in other]
        end = [sum(1 for p in points if p["has_ended"]) for points in (first, second)]
        if not pairs:
            rows.append([name_of(case), f"{end[0]} / {end[1]}"] + ["–"] * 5)
            continue
        p, q = pairs[-1]
        rows.append([name_of(case), f"{end[0]} / {end[1]}", number(p["detail"], 2) + "°",
                     f"{p['faces']:,} / {q['faces']:,}",
                     f"{small(p['from_mesh'])} / {small(q['from_mesh'])}",
                     f"{p['smallest_angle']:.1f}° / {q['smallest_angle']:.1f}°",
                     f"{p['median_angle']:.1f}° / {q['median_angle']:.1f}°"])
    return table(["case", "angles that end", "finest common angle", "faces", "error",
                  "smallest angle", "median of the smallest angles"], rows)


def propagation(d):
    rows, base = [], d["factors"][0]["cases"]
    for f in d["factors"]:
        def ratio(key):
            return median([c[key] / b[key] for c, b in zip(f["cases"], base) if b[key] > 0])
        angles = [c["smallest_angle"] / b["smallest_angle"] for c, b in zip(f["cases"], base)]
        rows.append([f"{f['factor']:g}", number(ratio("splits"), 3), number(ratio("from_mesh"), 3),
                     number(ratio("seconds"), 3), number(min(angles), 2),
                     f"{median([c['smallest_angle'] for c in f['cases']]):.1f}°",
                     f"{median([c['median_angle'] for c in f['cases']]):.1f}°"])
    return table(["factor", "splits", "error", "time", "smallest angle, worst case",
                  "smallest angle, median of the cases", "median angle, median of the cases"], rows)


# --- 5. Decimation.

def decimation(d):
    rows = []
    for c in d["comparisons"]:
        for m in c["methods"]:
            rows.append([c["object"], c["aim"], f"{c['faces_before']:,} → {m['faces']:,}",
                         m["method"], count(m["ns_per_removal"]), small(m["largest"]),
                         small(m["rms"]),
                         f"{m['returned_base_faces']:,} of {m['split_base_faces']:,}",
                         f"{m['kept_base_vertices']:,} of {m['base_vertices']:,}"])
    return table(["object", "down to", "faces", "method", "ns a removal", "error, largest",
                  "error, rms", "base faces that return", "base vertices that stay"], rows)


def all_tables(parts):
    edges, figures, extrusion = parts["edge_tests"], parts["figures"], parts["extrusion"]
    errors, factors, decimated = parts["errors"], parts["propagation"], parts["decimation"]
    equal, medians = equal_error(errors)
    summary = ["For the same true error, triangles over the fewest of the other triggers "
               "(median of twelve cases):"]
    for (trigger, measure), value in medians.items():
        summary.append(f"  {trigger}, {MEASURES[measure]}: {number(value, 3)}")
    if not any(t == "certified" for t, _ in medians):
        summary.append("  certified: not among the triggers of this build")
    made = {
        "operations": operations(edges), "program_tests": program_tests(edges),
        "break_even": break_even(edges), "bit_index": bit_index(edges),
        "figure4": figure4(figures), "figure7": figure7(extrusion),
        "by_default": by_default(errors), "equal_error": equal, "orders": orders(errors),
        "propagation": propagation(factors), "decimation": decimation(decimated),
        "summary": "\n".join(summary),
        "objects": ("Eight objects are shapes of the program, four are models." if
                    errors["has_models"] else
                    "The folder of models was absent, so all objects are shapes of the program."),
        "peers": ("" if decimated["has_peers"] else
                  "The peers were left out of this run (`scripts/study --peers` adds them)."),
        "about_certified": about_certified(edges, medians),
        "most_faces": f"{errors['most_faces']:,}",
        "machine": parts["machine"]["text"],
    }
    for i, error in enumerate(ERRORS):
        made[f"needed_{i + 1}"] = needed(errors, error)
        made[f"error_{i + 1}"] = f"{error:g}"
    return made
