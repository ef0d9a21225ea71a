#!/usr/bin/python3
"""How bodies made at random come out: creatures, the same without one limb, and creatures with other limbs on either side.

usage: random_creatures.py BIN [--bodies N] [--seed S] [--as-cloud] [--vertices V] [--jobs J] [--keep FOLDER] [-- OPTIONS]

BIN       folder with pcl_symmetry_model and pcl_intrinsic_symmetry
N         bodies of each kind (40)
S         seed of the first (1): the body and its pose
--keep    leaves the files there
OPTIONS   of pcl_intrinsic_symmetry

A vertex is right where its partner lies within sqrt (area / (20 pi)) of the true one, which the rest pose tells. A creature
is right where three quarters of its vertices are; one without a limb where the same holds of what has a partner and half of
the limb that lost its twin has none, or where it is refused. What of a creature with other limbs on either side is symmetric
nobody knows: delivered as a whole it is wrong. Needs numpy and scipy.
"""
import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from scipy.spatial import cKDTree

KINDS = ("creature", "lame-creature", "askew-creature")
NO_SYMMETRY = 3  # exit status
ODD = 0.03  # of the diagonal: what is farther from the mirror image has no partner


def read_off(path):
    with open(path) as file:
        file.readline()
        vertices, faces, _ = (int(word) for word in file.readline().split())
        points = np.loadtxt(file, max_rows=vertices)
        triangles = np.loadtxt(file, max_rows=faces, dtype=int)[:, 1:]
    return points, triangles


def radius_of(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
    return math.sqrt(area / (20.0 * math.pi))


def run(command):
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode not in (0, NO_SYMMETRY):
        raise RuntimeError(f"{' '.join(command)}: exit status {done.returncode}: {done.stderr}")
    return done


def make(binaries, path, kind, seed, vertices, *more):
    run([os.path.join(binaries, "pcl_symmetry_model"), path, "--body", kind, "--seed", str(seed), "--vertices",
         str(vertices), *more])


def score(arguments, folder, kind, seed):
    name = os.path.join(folder, f"{kind}{seed}")
    make(arguments.bin, name + ".off", kind, seed, arguments.vertices)
    make(arguments.bin, name + ".rest.off", kind, seed, arguments.vertices, "--bend", "0")
    found = run([os.path.join(arguments.bin, "pcl_intrinsic_symmetry"), name + ".off", "--threads", "1", "--map",
                 name + ".csv", "--report", name + ".json", *(["--as-cloud"] if arguments.as_cloud else []),
                 *arguments.options])
    with open(name + ".json") as file:
        report = json.load(file)
    result = {"kind": kind, "seed": seed, "status": report["status"], "confidence": report["confidence"],
              "rest": 0.0, "odd": 0.0, "odd_named": 0.0}
    posed, triangles = read_off(name + ".off")
    rest, _ = read_off(name + ".rest.off")
    mirrored = rest * np.array([-1.0, 1.0, 1.0])
    distance, truth = cKDTree(rest).query(mirrored)
    is_odd = distance > ODD * np.linalg.norm(np.ptp(rest, axis=0))
    result["odd"] = is_odd.mean()
    if found.returncode == 0:
        partners = np.loadtxt(name + ".csv", delimiter=",", skiprows=1)[:, 1].astype(int)
        has_partner = partners >= 0
        error = np.linalg.norm(posed[np.maximum(partners, 0)] - posed[truth], axis=1)
        is_right = has_partner & (error <= radius_of(posed, triangles))
        result["rest"] = is_right[~is_odd].mean()
        result["odd_named"] = (~has_partner)[is_odd].mean() if is_odd.any() else 0.0
    result["right"] = is_right_outcome(result)
    return result


def is_right_outcome(result):
    if result["kind"] == "creature":
        return result["rest"] >= 0.75
    if result["status"] == "no_symmetry":
        return True
    if result["kind"] == "lame-creature":
        return result["rest"] >= 0.75 and result["odd_named"] >= 0.5
    return result["status"] == "partly_symmetric"


def read_arguments(document, words, numbers):
    """The arguments that are words, numbers with their defaults, and what all of these programs have."""
    parser = argparse.ArgumentParser(usage=document.split("\n\n")[1][len("usage: "):])
    for name in words:
        parser.add_argument(name)
    for name, default in {**numbers, "seed": 1, "jobs": 2}.items():
        parser.add_argument(f"--{name}", type=int, default=default)
    parser.add_argument("--as-cloud", action="store_true")
    parser.add_argument("--keep")
    given = sys.argv[1:]
    cut = given.index("--") if "--" in given else len(given)
    arguments = parser.parse_args(given[:cut])
    arguments.options = given[cut + 1:]
    return arguments


def main():
    arguments = read_arguments(__doc__, ["bin"], {"bodies": 40, "vertices": 7000})
    jobs = [(kind, arguments.seed + k) for kind in KINDS for k in range(arguments.bodies)]
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or temporary
        os.makedirs(folder, exist_ok=True)
        with ThreadPoolExecutor(arguments.jobs) as pool:
            results = list(pool.map(lambda job: score(arguments, folder, *job), jobs))
    for kind in KINDS:
        of_kind = [result for result in results if result["kind"] == kind]
        for result in of_kind:
            print(f"{kind:15} {result['seed']:5}  {result['status']:17} {result['confidence']:.2f}  rest right "
                  f"{result['rest']:.2f}  odd {result['odd']:.2f}, named {result['odd_named']:.2f}"
                  f"{'' if result['right'] else '  WRONG'}")
        statuses = Counter(result["status"] for result in of_kind)
        wrong = [result for result in of_kind if not result["right"] and result["status"] != "no_symmetry"]
        print(f"{kind}: right {sum(r['right'] for r in of_kind)} of {len(of_kind)}, wrong above 0.5 "
              f"{sum(r['confidence'] > 0.5 for r in wrong)}, mean of the rest right "
              f"{np.mean([r['rest'] for r in of_kind]):.3f}, "
              f"{', '.join(f'{n} {status}' for status, n in sorted(statuses.items()))}")


if __name__ == "__main__":
    main()
