#!/usr/bin/python3
"""How the animals of a game come out in the poses of its animations: low meshes of several parts, made by artists.

usage: posed_animals.py BIN ARCHIVE [--poses N] [--seed S] [--as-cloud] [--jobs J] [--keep FOLDER] [-- OPTIONS]

BIN       folder with pcl_intrinsic_symmetry
ARCHIVE   public.zip of the game 0 A.D. (measured: release 26); no file of it is part of this project
N         poses of each animal (2), each a frame of one of its animations
S         which ones (1)
--as-cloud  6,000 points at random places of the surfaces, without faces
--keep    leaves the files there
OPTIONS   of pcl_intrinsic_symmetry

An animal takes part if it is mirrored at rest but for a tenth of its vertices. A pose does if it leaves the edges about as
long as they are: some animations belong to another skeleton. A vertex is right where its partner lies within
sqrt (area / (20 pi)) of the mirror image at rest; an animal where three quarters of its vertices are. Needs numpy and scipy.
"""
import json
import os
import random
import struct
import tempfile
import zipfile
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from random_creatures import radius_of, read_arguments, run
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

MESHES = "art/meshes/skeletal/"
ANIMATIONS = "art/animation/"
LEAST_VERTICES = 150
POINTS_OF_CLOUD = 6000
TWIN = 0.005  # of the diagonal: how far from its mirror image a vertex has a twin
MIRRORED = 0.9  # share of the vertices that have one
# Quantiles of |log length ratio| of the edges and their bounds, by hand: with looser ones two elephants were torn.
LENGTHS = ((0.5, 0.05), (0.95, 0.5), (0.99, 0.8))


class Animal:
    """A mesh at rest with its skeleton: the format PSMD of the game."""

    def __init__(self, data):
        version, _, vertices = struct.unpack_from("<III", data, 4)
        at, textures = 16, 1
        if version >= 4:
            textures, = struct.unpack_from("<I", data, at)
            at += 4
        layout = np.dtype([("point", "<f4", 3), ("normal", "<f4", 3), ("texture", "<f4", (textures, 2)),
                           ("bone", "u1", 4), ("weight", "<f4", 4)])
        self.vertices = np.frombuffer(data, layout, vertices, at)
        at += vertices * layout.itemsize
        faces, = struct.unpack_from("<I", data, at)
        self.triangles = np.frombuffer(data, "<u2", 3 * faces, at + 4).reshape(-1, 3).astype(int)
        at += 4 + 6 * faces
        bones, = struct.unpack_from("<I", data, at)
        self.bones = np.frombuffer(data, "<f4", 7 * bones, at + 4).reshape(-1, 7).astype(float)
        self.points = self.vertices["point"].astype(float)

    def posed(self, states):
        """Linear blend skinning: every vertex goes along with its bones."""
        points = np.zeros_like(self.points)
        weights = np.zeros(len(points))
        for bone, (rest, state) in enumerate(zip(self.bones, states)):
            local = Rotation.from_quat(rest[3:]).inv().apply(self.points - rest[:3])
            moved = Rotation.from_quat(state[3:]).apply(local) + state[:3]
            weight = np.where(self.vertices["bone"] == bone, self.vertices["weight"], 0.0).sum(axis=1)
            points += weight[:, None] * moved
            weights += weight
        points[weights < 0.5] = self.points[weights < 0.5]
        return points

    def mirror_images(self):
        """At rest, in the coordinate plane that mirrors it; none where no plane does."""
        size = np.linalg.norm(np.ptp(self.points, axis=0))
        for axis in range(3):
            images = self.points * np.where(np.arange(3) == axis, -1.0, 1.0)
            if (cKDTree(self.points).query(images)[0] < TWIN * size).mean() >= MIRRORED:
                return images
        return None

    def keeps_lengths(self, points):
        edges = np.unique(np.sort(np.concatenate([np.roll(self.triangles, k, axis=1)[:, :2] for k in range(3)])), axis=0)

        def lengths(of):
            return np.linalg.norm(of[edges[:, 0]] - of[edges[:, 1]], axis=1)

        with np.errstate(divide="ignore", invalid="ignore"):
            change = np.abs(np.log(lengths(points) / lengths(self.points)))
        change = change[np.isfinite(change)]
        return all(np.quantile(change, share) <= bound for share, bound in LENGTHS)


def read_animation(data):
    """States of the bones, frame by frame: the format PSSA of the game."""
    name, = struct.unpack_from("<I", data, 12)
    _, bones, frames = struct.unpack_from("<fII", data, 16 + name)
    return np.frombuffer(data, "<f4", 7 * bones * frames, 28 + name).reshape(frames, bones, 7).astype(float)


def stem_of(path):
    return os.path.basename(path).split(".")[0]


def poses_of(archive, poses, seed):
    """Animals with a name and the points of a pose, the same for the same seed."""
    animations = defaultdict(list)
    names = sorted(archive.namelist())
    for path in names:
        if path.startswith(ANIMATIONS) and path.endswith(".psa"):
            states = read_animation(archive.read(path))
            if len(states):
                animations[states.shape[1]].append((stem_of(path), states))
    chance = random.Random(seed)
    for path in names:
        if not path.startswith(MESHES) or not path.endswith(".pmd") or "marker" in path:
            continue
        animal = Animal(archive.read(path))
        if len(animal.points) < LEAST_VERTICES or animal.mirror_images() is None:
            continue
        fitting = list(animations[len(animal.bones)])
        chance.shuffle(fitting)
        taken = 0
        for name, states in fitting:
            frame = chance.randrange(len(states))
            points = animal.posed(states[frame])
            if taken < poses and np.isfinite(points).all() and animal.keeps_lengths(points):
                taken += 1
                yield f"{stem_of(path)}-{name}-{frame}", animal, points


def scattered(animal, points, images, seed):
    """The same random places on the surface: in the pose, at rest, and mirrored at rest."""
    rng = np.random.default_rng(seed)
    a, b, c = (points[animal.triangles[:, k]] for k in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    corners = animal.triangles[rng.choice(len(areas), POINTS_OF_CLOUD, p=areas / areas.sum())]
    weights = rng.dirichlet((1.0, 1.0, 1.0), POINTS_OF_CLOUD)
    return [(weights[:, :, None] * of[corners]).sum(axis=1) for of in (points, animal.points, images)]


def score(arguments, folder, job):
    number, (name, animal, points) = job
    rest, images = animal.points, animal.mirror_images()
    takes_part = cKDTree(rest).query(images)[0] < TWIN * np.linalg.norm(np.ptp(rest, axis=0))
    path = os.path.join(folder, name)
    extension = ".xyz" if arguments.as_cloud else ".obj"
    if arguments.as_cloud:
        points, rest, images = scattered(animal, points, images, arguments.seed + number)
        takes_part = np.full(len(points), True)
    with open(path + extension, "w") as file:
        prefix = "" if arguments.as_cloud else "v "
        file.writelines(f"{prefix}{x:.7g} {y:.7g} {z:.7g}\n" for x, y, z in points)
        if not arguments.as_cloud:
            file.writelines(f"f {a} {b} {c}\n" for a, b, c in animal.triangles + 1)
    found = run([os.path.join(arguments.bin, "pcl_intrinsic_symmetry"), path + extension, "--threads", "1", "--map",
                 path + ".csv", "--report", path + ".json", *arguments.options])
    with open(path + ".json") as file:
        report = json.load(file)
    result = {"name": name, "status": report["status"], "confidence": report["confidence"], "rate": 0.0, "matched": 0.0}
    if found.returncode == 0:
        partners = np.loadtxt(path + ".csv", delimiter=",", skiprows=1)[:, 1].astype(int)
        error = np.linalg.norm(rest[np.maximum(partners, 0)] - images, axis=1)
        is_right = (partners >= 0) & (error <= radius_of(animal.points, animal.triangles))
        result["rate"] = is_right[takes_part].mean()
        result["matched"] = (partners >= 0).mean()
    return result


def main():
    arguments = read_arguments(__doc__, ["bin", "archive"], {"poses": 2})
    with zipfile.ZipFile(arguments.archive) as archive:
        jobs = list(enumerate(poses_of(archive, arguments.poses, arguments.seed)))
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or temporary
        os.makedirs(folder, exist_ok=True)
        with ThreadPoolExecutor(arguments.jobs) as pool:
            results = list(pool.map(lambda job: score(arguments, folder, job), jobs))
    for result in results:
        print("{name:60} {status:17} {confidence:.2f}  rate {rate:.2f}  matched {matched:.2f}".format(**result),
              "" if result["rate"] >= 0.75 else " WRONG")
    wrong = [result for result in results if result["rate"] < 0.75]
    refused = sum(result["status"] == "no_symmetry" for result in results)
    print(f"right {len(results) - len(wrong)} of {len(results)}, refused {refused}, wrong above 0.5 "
          f"{sum(r['confidence'] > 0.5 for r in wrong)}, mean rate {np.mean([r['rate'] for r in results]):.3f}, matched "
          f"{np.mean([r['matched'] for r in results]):.3f}")


if __name__ == "__main__":
    main()
