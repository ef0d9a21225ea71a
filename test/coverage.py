#!/usr/bin/env python3
"""Says how many lines of each module the tests run.

usage: coverage.py [BUILD]

BUILD (build/coverage) is a build folder of the preset `coverage` in which the tests have been run. Prints the share of lines
per module and the files below 80 %. Needs gcovr.
"""
import collections
import json
import os
import subprocess
import sys

LEAST = 80.0  # per cent of a file's lines


def module_of(path):
    folders = os.path.dirname(path).split("/")
    return "/".join(folder for folder in folders[:3] if folder != "src")


def line_counts(root, build):
    """(lines, lines that were run) of every file of the project's own code."""
    command = ["gcovr", "--root", root, "--filter", "modules/", "--filter", "apps/", "--filter", "include/",
               "--exclude-throw-branches", "--json-summary", "-", build]
    summary = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)
    return {file["filename"]: (file["line_total"], file["line_covered"]) for file in summary["files"]}


def main():
    if len(sys.argv) > 2 or (len(sys.argv) == 2 and sys.argv[1].startswith("-")):
        sys.exit(__doc__)
    root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    counts = line_counts(root, sys.argv[1] if len(sys.argv) == 2 else os.path.join(root, "build", "coverage"))
    modules = collections.defaultdict(lambda: [0, 0])
    for path, (lines, run) in counts.items():
        for name in (module_of(path), "all"):
            modules[name][0] += lines
            modules[name][1] += run
    print("module                           lines    run %")
    for name, (lines, run) in sorted(modules.items(), key=lambda entry: (entry[0] == "all", entry[0])):
        print(f"{name:30} {lines:7}   {100 * run / max(lines, 1):6.1f}")
    for path, (lines, run) in sorted(counts.items(), key=lambda entry: entry[1][1] / max(entry[1][0], 1)):
        if 100 * run < LEAST * lines:
            print(f"below {LEAST:.0f} %: {path} {100 * run / lines:.1f} of {lines}")


if __name__ == "__main__":
    main()
