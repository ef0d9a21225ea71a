#!/usr/bin/python3
"""How objects made at random come out: mirrored ones, and the same with one more part on one side.

usage: random_objects.py BIN [--objects N] [--seed S] [--as-cloud] [--keep FOLDER] [-- OPTIONS]

BIN       folder with pcl_intrinsic_symmetry
N         pairs of objects (60): furniture, vehicles and other things of boxes, cylinders and ellipsoids that overlap,
          in any position, vertices and faces in any order
S         of the first object (1): an object is the same for the same number
--as-cloud  8,000 points at random places of the surfaces, without faces
--keep    leaves the files of the objects there
OPTIONS   of pcl_intrinsic_symmetry

A mirrored object is right where it is symmetric, whole or in part, and three quarters of its vertices have a partner within
2 % of the bounding box's diagonal of their mirror image. One with an odd part is right where the same holds of the rest and
the status is partly_symmetric. The odd part is at most a third of the diagonal long, its middle at least a tenth of it off
the plane of the rest.
"""
import argparse
import csv
import json
import math
import os
import random
import subprocess
import sys
import tempfile
from collections import Counter

POINTS_OF_CLOUD = 8000
CLOSE = 0.02  # of the diagonal


def box(half, centre):
    corners = [tuple(c + s * h for c, s, h in zip(centre, signs, half))
               for signs in ((x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1))]
    quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    return corners, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def lathe(rings, axis, half, centre):
    """A surface of revolution: rings of (height, radius) from pole to pole along an axis."""
    around = 24
    other = [k for k in range(3) if k != axis]

    def place(height, radius, angle):
        at = [0.0, 0.0, 0.0]
        at[axis] = height
        at[other[0]], at[other[1]] = radius * math.cos(angle), radius * math.sin(angle)
        return tuple(c + h * a for c, h, a in zip(centre, half, at))

    points = [place(-1.0, 0.0, 0.0)]
    points += [place(h, r, 2.0 * math.pi * (k + 0.5) / around) for h, r in rings for k in range(around)]
    points.append(place(1.0, 0.0, 0.0))
    faces = []
    for k in range(around):
        after = (k + 1) % around
        faces.append((0, 1 + after, 1 + k))
        for ring in range(len(rings) - 1):
            a, b = 1 + ring * around, 1 + (ring + 1) * around
            faces += [(a + k, a + after, b + after), (a + k, b + after, b + k)]
        last = 1 + (len(rings) - 1) * around
        faces.append((len(points) - 1, last + k, last + after))
    return points, faces


def cylinder(half, centre, axis):
    return lathe([(-1.0, 1.0), (1.0, 1.0)], axis, half, centre)


def ellipsoid(half, centre, axis=2):
    angles = [math.pi * (k + 1) / 12 for k in range(11)]
    return lathe([(-math.cos(a), math.sin(a)) for a in angles], axis, half, centre)


def any_shape(rng, half, centre):
    kind = rng.choice(("box", "cylinder", "ellipsoid"))
    return box(half, centre) if kind == "box" else cylinder(half, centre, rng.randrange(3)) if kind == "cylinder" \
        else ellipsoid(half, centre)


def twins(part):
    points, faces = part
    return [part, ([(-x, y, z) for x, y, z in points], [(a, c, b) for a, b, c in faces])]


def furniture(rng):
    """A seat on legs with a back, which leaves it one mirror plane, and arms or not."""
    width, depth = rng.uniform(0.4, 1.2), rng.uniform(0.35, 0.8)
    height, thick = rng.uniform(0.4, 1.0), rng.uniform(0.03, 0.1)
    parts = [box((width / 2, depth / 2, thick / 2), (0, 0, height))]
    leg, inset = rng.uniform(0.02, 0.06), rng.uniform(0.03, 0.1)
    for y in (-1, 1):
        at = (width / 2 - inset, y * (depth / 2 - inset), height / 2)
        half = (leg, leg, height / 2)
        parts += twins(box(half, at) if rng.random() < 0.5 else cylinder(half, at, 2))
    back = rng.uniform(0.3, 0.9)
    parts.append(box((width / 2 * rng.uniform(0.7, 1.0), thick / 2, back / 2), (0, depth / 2, height + back / 2)))
    if rng.random() < 0.5:
        arm = rng.uniform(0.02, 0.05)
        parts += twins(box((arm, depth / 2, arm), (width / 2, 0, height + rng.uniform(0.15, 0.3))))
        parts += twins(box((arm, arm, 0.16), (width / 2, -depth / 3, height + 0.12)))
    return parts


def vehicle(rng):
    """A body with a cabin on wheels or runners, with lamps and wings or not."""
    length, width, height = rng.uniform(1.2, 3.0), rng.uniform(0.6, 1.2), rng.uniform(0.25, 0.6)
    parts = [any_shape(rng, (width / 2, length / 2, height / 2), (0, 0, 0))]
    cabin = rng.uniform(0.15, 0.4)
    middle = (0, rng.uniform(-0.15, 0.15) * length, height * 0.8)
    parts.append(any_shape(rng, (width * 0.4, length * cabin, height / 2), middle))
    wheel = rng.uniform(0.12, 0.3)
    for y in rng.sample((-0.35, -0.1, 0.15, 0.38), rng.randint(2, 3)):
        parts += twins(cylinder((0.06, wheel, wheel), (width / 2, y * length, -height / 2), 0))
    if rng.random() < 0.5:
        parts += twins(ellipsoid((0.07, 0.05, 0.07), (width * 0.3, length / 2, 0)))
    if rng.random() < 0.4:
        parts += twins(box((rng.uniform(0.3, 0.9), 0.15, 0.02), (width * 0.7, 0, height * 0.2)))
    return parts


def thing(rng):
    """Shapes one on the other along a stem, with pairs beside them."""
    parts, at = [], 0.0
    for _ in range(rng.randint(2, 4)):
        half = tuple(rng.uniform(0.12, 0.5) for _ in range(3))
        centre = (0, rng.uniform(-0.1, 0.1), at)
        parts.append(any_shape(rng, half, centre))
        if rng.random() < 0.7:
            side = tuple(rng.uniform(0.05, 0.3) for _ in range(3))
            beside = (half[0] + 0.6 * side[0], rng.uniform(-0.5, 0.5) * half[1], at + rng.uniform(-0.4, 0.4) * half[2])
            parts += twins(any_shape(rng, side, beside))
        at += half[2] * rng.uniform(1.2, 1.8)
    return parts


def bounds(points):
    low = [min(p[k] for p in points) for k in range(3)]
    high = [max(p[k] for p in points) for k in range(3)]
    return low, high


def odd_part(rng, parts):
    """On the surface of a part, clearly on one side."""
    diagonal = math.dist(*bounds([p for points, _ in parts for p in points]))
    half = tuple(diagonal * rng.uniform(0.03, 0.16) for _ in range(3))
    while True:
        points, faces = rng.choice(parts)
        a, b, c = (points[v] for v in rng.choice(faces))
        u, v = sorted((rng.random(), rng.random()))
        at = tuple(u * p + (v - u) * q + (1 - v) * r for p, q, r in zip(a, b, c))
        if abs(at[0]) > 0.1 * diagonal:
            return any_shape(rng, half, at)


def turned(rng):
    """A random rotation and shift."""
    q = [rng.gauss(0, 1) for _ in range(4)]
    norm = math.sqrt(sum(c * c for c in q))
    w, x, y, z = (c / norm for c in q)
    rows = ((1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
            (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
            (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)))
    shift = [rng.uniform(-2, 2) for _ in range(3)]
    return lambda p: tuple(s + sum(r * c for r, c in zip(row, p)) for row, s in zip(rows, shift))


def area_of(a, b, c):
    u, v = ([q - p for p, q in zip(a, other)] for other in (b, c))
    return 0.5 * math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def scattered(rng, points, faces, count):
    """Points at random places of the faces, and the face of each."""
    areas = [area_of(*(points[v] for v in face)) for face in faces]
    chosen = rng.choices(range(len(faces)), areas, k=count)
    places = []
    for face in chosen:
        u, v = sorted((rng.random(), rng.random()))
        corners = [points[k] for k in faces[face]]
        places.append(tuple(u * p + (v - u) * q + (1 - v) * r for p, q, r in zip(*corners)))
    return places, chosen


class Object:
    """Points and faces as they go into the file, and where the mirror image of each point is, None of the odd part."""

    def __init__(self, parts, odd, seed, as_cloud):
        rng = random.Random(seed)
        points, faces, is_odd = [], [], []
        for part, (places, corners) in enumerate(parts + odd):
            faces += [tuple(v + len(points) for v in face) for face in corners]
            points += places
            is_odd += [part >= len(parts)] * len(places)
        if as_cloud:
            points, chosen = scattered(rng, points, faces, POINTS_OF_CLOUD)
            is_odd = [is_odd[faces[face][0]] for face in chosen]
            faces = []
        order = list(range(len(points)))
        rng.shuffle(order)
        number = {old: new for new, old in enumerate(order)}
        move = turned(rng)
        self.points = [move(points[v]) for v in order]
        self.images = [None if is_odd[v] else move((-points[v][0], *points[v][1:])) for v in order]
        self.faces = [tuple(number[v] for v in face) for face in faces]
        rng.shuffle(self.faces)

    def write(self, path):
        with open(path, "w") as file:
            file.write(f"OFF\n{len(self.points)} {len(self.faces)} 0\n")
            file.writelines("{:.9g} {:.9g} {:.9g}\n".format(*p) for p in self.points)
            file.writelines("3 {} {} {}\n".format(*f) for f in self.faces)

    def share_of_right(self, partners):
        close = CLOSE * math.dist(*bounds(self.points))
        known = [v for v, image in enumerate(self.images) if image is not None]
        right = [v for v in known if partners[v] >= 0 and math.dist(self.points[partners[v]], self.images[v]) < close]
        return len(right) / len(known)


def outcome(program, made, stem, options):
    """Status, confidence and share of right partners."""
    made.write(stem + ".off")
    command = [program, stem + ".off", "--quiet", "--map", stem + ".csv", "--report", stem + ".json", *options]
    subprocess.run(command, check=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    if not os.path.exists(stem + ".json"):
        return "failed", 0.0, 0.0
    with open(stem + ".json") as file:
        report = json.load(file)
    if not os.path.exists(stem + ".csv"):
        return report["status"], report["confidence"], 0.0
    with open(stem + ".csv") as file:
        partners = [int(row["partner"]) for row in csv.DictReader(file)]
    return report["status"], report["confidence"], made.share_of_right(partners)


def main():
    words = sys.argv[1:]
    cut = words.index("--") if "--" in words else len(words)
    options = words[cut + 1:]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin")
    parser.add_argument("--objects", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--as-cloud", action="store_true")
    parser.add_argument("--keep")
    args = parser.parse_args(words[:cut])
    program = os.path.join(args.bin, "pcl_intrinsic_symmetry")
    counts = Counter()
    with tempfile.TemporaryDirectory() as scratch:
        folder = args.keep or scratch
        os.makedirs(folder, exist_ok=True)
        for seed in range(args.seed, args.seed + args.objects):
            rng = random.Random(seed)
            parts = (furniture, vehicle, thing)[seed % 3](rng)
            for kind, odd in (("mirrored", []), ("odd", [odd_part(rng, parts)])):
                stem = os.path.join(folder, f"{kind}{seed}")
                status, confidence, share = outcome(program, Object(parts, odd, seed, args.as_cloud), stem, options)
                wanted = ("symmetric", "partly_symmetric") if kind == "mirrored" else ("partly_symmetric",)
                counts[kind, "right" if status in wanted and share >= 0.75 else status] += 1
                print(f"{kind + str(seed):12} {status:18} {confidence:5.2f} {share:6.3f}", flush=True)
    for (kind, what), count in sorted(counts.items()):
        print(f"{kind:9} {what:18} {count:4d}")


if __name__ == "__main__":
    main()
