#!/usr/bin/python3
"""How far the axis curve runs from the true one, and in how many pieces.

usage: axis_accuracy.py BIN [FOLDER ...] [--as-cloud] [-- OPTIONS]

BIN     folder with pcl_intrinsic_symmetry and pcl_symmetry_model
FOLDER  with MODEL.off and MODEL_side.txt: per vertex 1 or 2 for the side, 3 on the axis; or with MODEL.off or MODEL.obj
        and MODEL.json: {"planes": [[nx, ny, nz, d], ...]}, mirror planes, of which the nearest to the curve is the true
        one. Without any: generated bodies
OPTIONS of pcl_intrinsic_symmetry

The true curve: edges between vertices on the axis, and the middles of edges from one side to the other, or where edges
cross the plane. All figures are
shares of the surface's diameter, in %: the mean over the places of the curve of the distance from the true one, that of
the places of the true one from the curve, and the largest of either (Hausdorff). Straight lines, which near the curve are
as long as those over the surface.
"""
import csv
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile

BODIES = [(body, bend, seed) for body in ("human", "quadruped", "bird", "spider") for bend, seed in
          ((0.0, 1), (0.5, 2), (1.0, 3))]


def read_off(path):
    with open(path) as file:
        words = file.read().split()
    points, faces = int(words[1]), int(words[2])
    numbers = words[4:4 + 3 * points]
    places = [tuple(map(float, numbers[3 * v:3 * v + 3])) for v in range(points)]
    corners, at = [], 4 + 3 * points
    for _ in range(faces):
        count = int(words[at])
        corners.append(tuple(map(int, words[at + 1:at + 1 + count])))
        at += 1 + count
    return places, corners


def read_obj(path):
    places, corners = [], []
    with open(path) as file:
        for words in map(str.split, file):
            if words[:1] == ["v"]:
                places.append(tuple(map(float, words[1:4])))
            elif words[:1] == ["f"]:
                numbers = [int(word.split("/")[0]) for word in words[1:]]
                corners.append(tuple(n - 1 if n > 0 else len(places) + n for n in numbers))
    return places, corners


def read_mesh(path):
    return read_obj(path) if path.endswith(".obj") else read_off(path)


def sides_by_file(path):
    with open(path) as file:
        return [int(word) for word in file.read().split()]


def sides_by_partners(map_file, rest_file):
    """Vertices that are their own partners (counted from 1) are on the axis; the others are where they are in the rest pose."""
    places, _ = read_off(rest_file)
    sides = [1 if place[0] > 0 else 2 for place in places]
    with open(map_file) as file:
        for line in file:
            words = line.replace(",", " ").split()
            if words and words[0].isdigit() and words[0] == words[1]:
                sides[int(words[0]) - 1] = 3
    return sides


def true_places(places, corners, sides, step):
    """Places of the true curve, no farther apart along an edge than a step."""
    found = []
    for a, b in {tuple(sorted((f[k - 1], f[k]))) for f in corners for k in range(len(f))}:
        if sides[a] == 3 and sides[b] == 3:
            found += between(places[a], places[b], step)
        elif {sides[a], sides[b]} == {1, 2}:
            found.append(tuple((p + q) / 2 for p, q in zip(places[a], places[b])))
    return found


def heights(places, plane):
    return [sum(n * x for n, x in zip(plane, place)) - plane[3] for place in places]


def places_in_plane(places, corners, plane):
    """Where edges cross a plane."""
    over = heights(places, plane)
    found = []
    for a, b in {tuple(sorted((f[k - 1], f[k]))) for f in corners for k in range(len(f))}:
        if over[a] * over[b] < 0.0:
            share = over[a] / (over[a] - over[b])
            found.append(tuple(p + share * (q - p) for p, q in zip(places[a], places[b])))
    return found


def to_nearest(queries, places):
    return [min(math.dist(q, p) for p in places) for q in queries]


def between(p, q, step):
    """From one place to the other, no farther apart than a step."""
    count = max(1, math.ceil(math.dist(p, q) / step))
    return [tuple(a + (b - a) * k / count for a, b in zip(p, q)) for k in range(count + 1)]


def found_curves(path, step):
    """Places of each curve, with those between them, and whether it is closed."""
    curves = {}
    with open(path) as file:
        for row in csv.DictReader(file):
            place = tuple(float(row[k]) for k in "xyz")
            curves.setdefault(row["curve"], ([], row["closed"] == "1"))[0].append(place)
    filled = []
    for line, closed in curves.values():
        ends = line[1:] + line[:1] if closed else line[1:]
        filled.append(([place for p, q in zip(line, ends) for place in between(p, q, step)], closed))
    return filled


def measure(program, model, truth, options, folder):
    """Nothing where no curve was found."""
    axis, report = os.path.join(folder, "axis.csv"), os.path.join(folder, "report.json")
    run = subprocess.run([program, model, "--axis", axis, "--report", report, "--quiet", *options], check=False)
    if run.returncode != 0:
        return None
    with open(report) as file:
        diameter = json.load(file)["diameter"]
    places, corners = read_mesh(model)
    step = 0.002 * diameter
    curves = found_curves(axis, 2.0 * step)
    curve = [place for line, _ in curves for place in line]
    if not curve:
        return None
    if isinstance(truth, dict):
        candidates = [(list(map(abs, heights(curve, plane))), plane) for plane in truth["planes"]]
        there, plane = min(candidates, key=lambda candidate: statistics.fmean(candidate[0]))
        back = to_nearest(places_in_plane(places, corners, plane), curve)
    else:
        true = true_places(places, corners, truth, step)
        there, back = to_nearest(curve, true), to_nearest(true, curve)
    share = 100.0 / diameter
    return [share * statistics.fmean(there), share * statistics.fmean(back), share * max(there + back), len(curves),
            sum(1 for _, closed in curves if not closed)]


def generated(bin_folder, folder):
    grow = os.path.join(bin_folder, "pcl_symmetry_model")
    for body, bend, seed in BODIES:
        model, truth, rest = (os.path.join(folder, name) for name in ("model.off", "truth.txt", "rest.off"))
        for output, strength, more in ((model, bend, ["--truth", truth]), (rest, 0.0, [])):
            subprocess.run([grow, output, "--body", body, "--bend", str(strength), "--seed", str(seed), *more],
                           check=True, stdout=subprocess.DEVNULL)
        yield f"{body} {bend}", model, sides_by_partners(truth, rest)


def given(folders):
    for folder in folders:
        for name in sorted(os.listdir(folder)):
            stem, kind = os.path.splitext(os.path.join(folder, name))
            if kind in (".off", ".obj") and os.path.exists(stem + "_side.txt"):
                yield os.path.basename(stem), stem + kind, sides_by_file(stem + "_side.txt")
            elif kind in (".off", ".obj") and os.path.exists(stem + ".json"):
                with open(stem + ".json") as file:
                    yield os.path.basename(stem), stem + kind, json.load(file)


def main():
    words = sys.argv[1:]
    options = words[words.index("--") + 1:] if "--" in words else []
    words = words[:words.index("--")] if "--" in words else words
    if "--as-cloud" in words:
        words.remove("--as-cloud")
        options.append("--as-cloud")
    if not words:
        sys.exit(__doc__)
    program = os.path.join(words[0], "pcl_intrinsic_symmetry")
    print(f"{'model':24} {'mean':>6} {'back':>6} {'Hausdorff':>9} {'curves':>6} {'open':>4}")
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name, model, sides in given(words[1:]) if words[1:] else generated(words[0], folder):
            row = measure(program, model, sides, options, folder)
            if row is None:
                print(f"{name:24} no curve found", flush=True)
                continue
            rows.append(row)
            print(f"{name:24} {row[0]:6.2f} {row[1]:6.2f} {row[2]:9.2f} {row[3]:6d} {row[4]:4d}", flush=True)
    columns = list(zip(*rows))
    print(f"{'mean':24} " + " ".join(f"{statistics.fmean(c):{w}}" for c, w in zip(columns, ("6.2f", "6.2f", "9.2f", "6.2f",
                                                                                         "4.2f"))))
    print(f"{'median':24} " + " ".join(f"{statistics.median(c):{w}}" for c, w in zip(columns, ("6.2f", "6.2f", "9.2f",
                                                                                             "6.2f", "4.2f"))))


if __name__ == "__main__":
    main()
