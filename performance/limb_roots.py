#!/usr/bin/python3
"""How well rules find the root of a limb: of creatures without one limb, the limb that is left over.

usage: limb_roots.py BIN [--bodies N] [--seed S] [--vertices V] [--jobs J]

BIN  folder with pcl_symmetry_model
N    bodies (100)
S    seed of the first (101): the body and its pose

A rule has the half width of the band whose area tells the length of a curve, in spacings of 1,500 samples, and the factor
by which the isoperimetric ratio of the root may exceed the least one (see modules/symmetry/surface/limb.h). What it cuts
off is compared with the vertices that have no mirror image in the rest pose: area of both over area of either. Needs numpy
and scipy.
"""
import argparse
import os
import tempfile
from concurrent.futures import ProcessPoolExecutor

import numpy as np
from random_creatures import ODD, make, read_off
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra
from scipy.spatial import cKDTree

RULES = [(width, factor) for width in (1.0, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0) for factor in (1.0, 1.1, 1.25, 1.5)]
SAMPLES = 1500


def edge_graph(points, triangles):
    sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    sides = np.unique(np.sort(sides, axis=1), axis=0)
    lengths = np.linalg.norm(points[sides[:, 0]] - points[sides[:, 1]], axis=1)
    both_ways = np.concatenate([sides, sides[:, ::-1]])
    return coo_matrix((np.tile(lengths, 2), both_ways.T), shape=(len(points),) * 2).tocsr()


def vertex_areas(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    thirds = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 6.0
    return np.bincount(triangles.ravel(), np.repeat(thirds, 3), minlength=len(points))


def root_by(rule, distances, areas):
    width, factor = rule
    order = np.argsort(distances, kind="stable")
    within = np.concatenate([[0.0], np.cumsum(areas[order])])
    spacing = np.sqrt(areas.sum() / SAMPLES)
    width = width * spacing

    def area_at(d):
        return within[np.searchsorted(distances[order], d, side="right")]

    curves = np.arange(width, distances.max(), 0.5 * spacing)
    curves = curves[(area_at(curves) > 0.0) & (area_at(curves) <= 0.5 * areas.sum())]
    girths = (area_at(curves + width) - area_at(curves - width)) / (2.0 * width)
    ratios = girths**2 / area_at(curves)
    root = int(np.argmin(ratios))
    least = ratios[root]
    while root + 1 < len(ratios) and ratios[root + 1] <= factor * least:
        root += 1
    return curves[root]


def overlaps(job):
    binaries, seed, vertices = job
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "body")
        make(binaries, name + ".off", "lame-creature", seed, vertices)
        make(binaries, name + ".rest.off", "lame-creature", seed, vertices, "--bend", "0")
        points, triangles = read_off(name + ".off")
        rest, _ = read_off(name + ".rest.off")
    gaps, _ = cKDTree(rest).query(rest * np.array([-1.0, 1.0, 1.0]))
    is_odd = gaps > ODD * np.linalg.norm(np.ptp(rest, axis=0))
    if not is_odd.any():
        return None
    graph = edge_graph(points, triangles)
    areas = vertex_areas(points, triangles)
    end = int(np.argmax(dijkstra(graph, indices=np.flatnonzero(~is_odd), min_only=True)))
    distances = dijkstra(graph, indices=end)
    found = []
    for rule in RULES:
        is_cut = distances <= root_by(rule, distances, areas)
        found.append(areas[is_cut & is_odd].sum() / areas[is_cut | is_odd].sum())
    return found


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1][len("usage: "):])
    parser.add_argument("bin")
    parser.add_argument("--bodies", type=int, default=100)
    parser.add_argument("--seed", type=int, default=101)
    parser.add_argument("--vertices", type=int, default=7000)
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()
    jobs = [(arguments.bin, arguments.seed + k, arguments.vertices) for k in range(arguments.bodies)]
    with ProcessPoolExecutor(arguments.jobs) as pool:
        table = np.array([row for row in pool.map(overlaps, jobs) if row is not None])
    for (width, factor), column in zip(RULES, table.T):
        print(f"half width {width:3.1f}  factor {factor:4.2f}  median {np.median(column):.2f}  mean {column.mean():.3f}  "
              f"lowest tenth {np.quantile(column, 0.1):.2f}  below 0.8: {(column < 0.8).sum()} of {len(column)}")


if __name__ == "__main__":
    main()
