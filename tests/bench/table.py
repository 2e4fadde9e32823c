#!/usr/bin/env python3
"""Prints the table of scripts/bench from build/bench.json: each promise with its ratio, then every
benchmark's median."""
import json
import sys

# Description, our benchmark with counter, the other benchmark with counter or a number, required ratio
# of ours to the other. The counter "time" is the time of an iteration.
FRAME = "frame of 10,000 active vertices, 5.2 M faces : 80 k"
PROMISES = [
    (FRAME, ("locality/resolution:9", "time"), ("locality/resolution:6", "time"), "<= 1.2"),
    ("positions and normals : copy, 1 thread", ("deform/threads:1/real_time", "bytes_per_second"),
     ("deform_copy/threads:1/real_time", "bytes_per_second"), ">= 0.7"),
    ("positions and normals : copy, 2 threads", ("deform/threads:2/real_time", "bytes_per_second"),
     ("deform_copy/threads:2/real_time", "bytes_per_second"), ">= 0.7"),
    ("4x4x4 positions : 12 M/s", ("textbook_positions", "M_per_s"), 12.0, ">= 4"),
    ("4x4x4 with normals : 12 M/s", ("textbook_with_normals", "M_per_s"), 12.0, ">= 2"),
    ("whole 1.3 M faces : copy, 1 thread", ("whole_object_frame/threads:1", "time"),
     ("whole_object_copy/threads:1/real_time", "time"), "<= 8"),
    ("whole 1.3 M faces : copy, 2 threads", ("whole_object_frame/threads:2", "time"),
     ("whole_object_copy/threads:2/real_time", "time"), "<= 8"),
    ("whole 1.3 M faces : 129 ns a vertex", ("whole_object_frame/threads:2", "time"),
     655362 * 129e-9, "<= 0.1"),
    ("positions and normals : 129 ns a vertex", ("deform/threads:2/real_time", "time"),
     655362 * 129e-9, "<= 0.1"),
    ("splits : OpenMesh", ("refine_to_half_mean/mirrored:0/manual_time", "M_per_s"),
     ("openmesh_refine", "M_per_s"), ">= 2.5"),
    ("splits of a first drag : OpenMesh",
     ("split/resolution:5/centidegrees:125/memory:2/manual_time", "M_splits_per_s"),
     ("openmesh_refine", "M_per_s"), ">= 2.5"),
    ("splits : CGAL's remeshing", ("refine_to_half_mean/mirrored:0/manual_time", "M_per_s"),
     ("cgal_remesh", "M_per_s"), ""),
    ("unsplits : OpenMesh's collapses", ("unsplit_all/manual_time", "M_per_s"),
     ("openmesh_decimate", "M_per_s"), ""),
    ("unsplits : meshoptimizer's collapses", ("unsplit_all/manual_time", "M_per_s"),
     ("meshoptimizer_simplify", "M_per_s"), ">= 5"),
    ("edges through the queue : through a binary heap", ("longest_first<LengthClasses>", "M_per_s"),
     ("longest_first<BinaryHeap>", "M_per_s"), ""),
    ("brush step, 650 vertices : 0.1 ms", ("brush_step/resolution:6/vertices:650", "time"), 1e-4,
     "<= 1"),
    ("brush step, 9,400 vertices : 1.5 ms", ("brush_step/resolution:8/vertices:9400", "time"),
     1.5e-3, "<= 1"),
    ("bytes a loaded triangle : 140", ("loaded_bytes/resolution:8", "bytes_per_triangle"), 140.0,
     "<= 1"),
    ("undo bytes a vertex : 100", ("undo_bytes_a_vertex", "bytes_per_vertex"), 100.0, "<= 1"),
    ("undo bytes a split : 32", ("undo_bytes_an_operation/removes:0",
     "bytes_per_operation"), 32.0, "<= 1"),
    ("undo bytes a removal : 32", ("undo_bytes_an_operation/removes:1",
     "bytes_per_operation"), 32.0, "<= 1"),
]
SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}


def figure(results, of):
    if isinstance(of, float):
        return of
    result = results.get(of[0])
    if result is None:
        return None
    if of[1] == "time":
        return result["real_time"] * SECONDS[result["time_unit"]]
    return result.get(of[1])


def shown(value):
    return "-" if value is None else f"{value:.4g}"


def print_hand(results):
    """What the hand feels: milliseconds, and multiples of the deformation of the same vertices."""
    steps = ["press", "frame", "release", "undo", "redo"]
    faces = {"6": "82 k", "8": "1.3 M", "9": "5.2 M"}
    brushes = {"0": "small brush", "1": "default brush", "2": "whole object"}
    print(f"\n{'what the hand feels':28}{'vertices':>10}{'deform':>9}" +
          "".join(f"{step:>17}" for step in steps))
    for name, result in results.items():
        if not name.startswith("hand/"):
            continue
        arguments = dict(part.split(":") for part in name.split("/")[1:] if ":" in part)
        deform = result["deform"]
        row = f"{faces[arguments['resolution']] + ', ' + brushes[arguments['brush']]:28}"
        row += f"{result['vertices']:10.0f}{deform:6.2f} ms"
        for step in steps:
            row += f"{result[step]:9.1f} ms" + (f"{result[step] / deform:5.0f}" if deform else "")
        print(row)


def main():
    results = {}
    for path in sys.argv[1:]:
        with open(path, encoding="utf-8") as file:
            for result in json.load(file)["benchmarks"]:
                if result.get("aggregate_name", "median") == "median":
                    results[result["run_name"]] = result
    print(f"\n{'benchmark':44}{'median':>12}")
    for name, result in results.items():
        seconds = result["real_time"] * SECONDS[result["time_unit"]]
        print(f"{name:44}{1e6 * seconds:9.1f} us")
    print(f"\n{'promise':52}{'ours':>12}{'beside':>12}{'wanted':>9}{'ratio':>11}")
    for what, ours, beside, wanted in PROMISES:
        x, y = figure(results, ours), figure(results, beside)
        ratio = x / y if x is not None and y else None
        print(f"{what:52}{shown(x):>12}{shown(y):>12}{wanted:>9}{shown(ratio):>11}")
    print_hand(results)


main()
