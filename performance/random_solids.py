#!/usr/bin/python3
"""How smooth solids drawn at random come out: without any symmetry, mirrored, and mirrored but bent.

usage: random_solids.py BIN [--solids N] [--seed S] [--as-cloud] [--vertices V] [--jobs J] [--keep FOLDER]

BIN       folder with pcl_intrinsic_symmetry
N         of each kind (20): stones, whose radius is a random function of the direction with no detail finer than a
          sixth of a turn, and stars, balls with four to eight humps of random height and width
S         seed of the first (1)
--keep    leaves the files there

A solid without symmetry is right where it is refused or partly symmetric: what of it has a counterpart nobody knows. A
mirrored one is right where three quarters of its vertices have a partner within sqrt (area / (20 pi)) of their mirror image,
a bent one where its partners do before it was bent. Needs numpy and scipy.
"""
import argparse
import json
import os
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from random_creatures import radius_of, run
from scipy.spatial import ConvexHull
from scipy.special import sph_harm

SHAPES = ("stone", "star")
KINDS = ("asymmetric", "mirrored", "bent")
BEND = 0.5  # radians from one end to the other
MIRROR = np.array([-1.0, 1.0, 1.0])


def random_rotation(rng):
    q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    return q * np.sign(np.linalg.det(q))


def directions(rng, count):
    """Evenly spread over the sphere, along a spiral."""
    k = np.arange(count) + 0.5
    height, angle = 1.0 - 2.0 * k / count, np.pi * (1.0 + 5.0**0.5) * k
    flat = np.sqrt(1.0 - height**2)
    return np.c_[flat * np.cos(angle), flat * np.sin(angle), height] @ random_rotation(rng)


def stone(rng):
    """Logarithm of the radius: spherical harmonics up to the sixth, the higher ones smaller."""
    terms = [(degree, order, *(rng.normal(size=2) / degree**0.7)) for degree in range(1, 7) for order in range(degree + 1)]

    def value(unit):
        polar, around = np.arccos(np.clip(unit[:, 2], -1.0, 1.0)), np.arctan2(unit[:, 1], unit[:, 0])
        total = np.zeros(len(unit))
        for degree, order, cosine, sine in terms:
            harmonic = sph_harm(order, degree, around, polar)
            total += cosine * harmonic.real + sine * harmonic.imag
        return total

    return value, lambda values: np.exp(0.35 * (values - values.mean()) / values.std())


def star(rng):
    count = rng.integers(4, 9)
    middles = rng.normal(size=(count, 3))
    middles /= np.linalg.norm(middles, axis=1)[:, None]
    heights, widths = rng.uniform(0.4, 1.8, count), rng.uniform(0.18, 0.45, count)

    def value(unit):
        angles = np.arccos(np.clip(unit @ middles.T, -1.0, 1.0))
        return (heights * np.exp(-(angles / widths)**2)).sum(axis=1)

    return value, lambda values: 1.0 + values


def bent(points):
    """Turned about the y axis by an angle that grows along z; x is to the sides before, so that the sides stay alike."""
    angle = BEND * points[:, 2] / np.ptp(points[:, 2])
    cosine, sine = np.cos(angle), np.sin(angle)
    x, y, z = points.T
    return np.c_[cosine * x + sine * z, y, cosine * z - sine * x]


def solid(shape, kind, seed, vertices):
    """Rest pose, as it goes into the file, and triangles."""
    rng = np.random.default_rng(seed)
    unit = directions(rng, vertices)
    value, radius = (stone if shape == "stone" else star)(rng)
    values = value(unit)
    if kind != "asymmetric":
        values = 0.5 * (values + value(unit * MIRROR))
    rest = unit * radius(values)[:, None]
    posed = bent(rest) if kind == "bent" else rest
    triangles = ConvexHull(unit).simplices
    a, b, c = (unit[triangles[:, k]] for k in range(3))
    is_inward = np.einsum("ij,ij->i", np.cross(b - a, c - a), a) < 0.0
    triangles[is_inward] = triangles[is_inward][:, [0, 2, 1]]
    return rest, posed @ random_rotation(rng), triangles


def score(arguments, folder, shape, kind, seed):
    rest, posed, triangles = solid(shape, kind, seed, arguments.vertices)
    name = os.path.join(folder, f"{kind}-{shape}{seed}")
    with open(name + ".off", "w") as file:
        file.write(f"OFF\n{len(posed)} {len(triangles)} 0\n")
        np.savetxt(file, posed, "%.7g")
        np.savetxt(file, np.c_[np.full(len(triangles), 3), triangles], "%d")
    found = run([os.path.join(arguments.bin, "pcl_intrinsic_symmetry"), name + ".off", "--threads", "1", "--map",
                 name + ".csv", "--report", name + ".json", *(["--as-cloud"] if arguments.as_cloud else [])])
    with open(name + ".json") as file:
        report = json.load(file)
    share = 0.0
    if found.returncode == 0 and kind != "asymmetric":
        partners = np.loadtxt(name + ".csv", delimiter=",", skiprows=1)[:, 1].astype(int)
        error = np.linalg.norm(rest[np.maximum(partners, 0)] - rest * MIRROR, axis=1)
        share = ((partners >= 0) & (error <= radius_of(rest, triangles))).mean()
    right = report["status"] != "symmetric" if kind == "asymmetric" else share >= 0.75
    return {"shape": shape, "kind": kind, "seed": seed, "status": report["status"], "confidence": report["confidence"],
            "share": share, "right": right}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin")
    parser.add_argument("--solids", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--vertices", type=int, default=6000)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--as-cloud", action="store_true")
    parser.add_argument("--keep")
    arguments = parser.parse_args()
    jobs = [(shape, kind, arguments.seed + k) for kind in KINDS for shape in SHAPES for k in range(arguments.solids)]
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or temporary
        os.makedirs(folder, exist_ok=True)
        with ThreadPoolExecutor(arguments.jobs) as pool:
            results = list(pool.map(lambda job: score(arguments, folder, *job), jobs))
    for result in results:
        print(f"{result['kind'] + ' ' + result['shape']:18} {result['seed']:5}  {result['status']:17} "
              f"{result['confidence']:.2f} {result['share']:.2f}{'' if result['right'] else '  WRONG'}")
    for shape in SHAPES:
        for kind in KINDS:
            of_kind = [r for r in results if r["shape"] == shape and r["kind"] == kind]
            wrong = [r for r in of_kind if not r["right"] and r["status"] != "no_symmetry"]
            statuses = sorted(Counter(r["status"] for r in of_kind).items())
            print(f"{kind} {shape}: right {sum(r['right'] for r in of_kind)} of {len(of_kind)}, wrong above 0.5 "
                  f"{sum(r['confidence'] > 0.5 for r in wrong)}, {', '.join(f'{n} {status}' for status, n in statuses)}")


if __name__ == "__main__":
    main()
