"""Reads the curves of error over triangles that pectin_study has measured."""
import math
import statistics


def ended(curve):
    return [p for p in curve["points"] if p["has_ended"]]


def faces_needed(points, error, measure):
    """The triangles by which a method reaches an error, between its runs by straight lines in
    logarithms; None if no run reaches it. Points have faces and the error by a measure."""
    best = None
    points = sorted(points, key=lambda p: p["faces"])
    for i, p in enumerate(points):
        if p[measure] > error:
            continue
        needed = float(p["faces"])
        if i > 0 and points[i - 1][measure] > error and p[measure] > 0:
            before = points[i - 1]
            part = (math.log(before[measure] / error) / math.log(before[measure] / p[measure]))
            needed = math.exp(math.log(before["faces"]) +
                              part * math.log(p["faces"] / before["faces"]))
        best = needed if best is None else min(best, needed)
        break
    return best


def median(values):
    values = [v for v in values if v is not None]
    return statistics.median(values) if values else None


def trigger_of(curve):
    return curve["name"].split(",")[0]


def ratio_to_best_other(case, trigger, measure, least_error, largest_error):
    """For each run of a trigger's default form that refines anything: its triangles over the fewest
    by which another trigger has the same true error; 0 if no other one reaches that error. The
    median over the runs with errors in the range; None if there is no such run."""
    own = next(c for c in case["curves"] if c["name"] == trigger)
    others = [c for c in case["curves"] if trigger_of(c) not in (trigger, "uniform", "printed")]
    ratios = []
    for run in ended(own):
        if (run["faces"] == case["faces_at_rest"] or
                not least_error <= run[measure] <= largest_error):
            continue
        needed = [faces_needed(ended(c), run[measure], measure) for c in others]
        needed = [n for n in needed if n is not None]
        ratios.append(run["faces"] / min(needed) if needed else 0.0)
    return median(ratios)
