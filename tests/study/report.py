#!/usr/bin/env python3
"""Writes docs/study.md from its template, tests/study/study.md.in, and the results of pectin_study.

usage: tests/study/report.py RESULTS DOCS
  RESULTS  the folder of the JSON files, one for each part of the study
  DOCS     where study.md goes, and its plots to study/

A line {{name}} of the template is replaced by the table or the picture of this name. Every figure
in the text comes from here, so the template contains none of its own.
"""
import json
import pathlib
import re
import sys

import plots
import tables


def main(arguments):
    if len(arguments) != 2:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    results, docs = map(pathlib.Path, arguments)
    parts = {path.stem: json.loads(path.read_text(encoding="utf-8"))
             for path in sorted(results.glob("*.json"))}
    (docs / "study").mkdir(exist_ok=True)
    made = {**tables.all_tables(parts), **plots.all_plots(parts, docs / "study")}
    template = pathlib.Path(__file__).with_name("study.md.in").read_text(encoding="utf-8")
    unknown = set(re.findall(r"\{\{(\w+)\}\}", template)) - set(made)
    if unknown:
        print(f"report.py: nothing is called {', '.join(sorted(unknown))}", file=sys.stderr)
        return 1
    text = re.sub(r"\{\{(\w+)\}\}", lambda match: made[match[1]], template)
    (docs / "study.md").write_text(text, encoding="utf-8")
    print(made["summary"])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
