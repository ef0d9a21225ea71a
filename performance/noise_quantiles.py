#!/usr/bin/env python3
"""Says how the quantiles of the thickness of neighbourhoods relate where a plane has noise and nothing else; needs numpy, scipy.

usage: noise_quantiles.py [SEED]

Points at even distances on a plane, jittered in it by a third of their spacing and off it by noise of 0.15 to 0.25 spacings.
Each neighbourhood has a radius of 2.2 spacings, of which thickness is the standard deviation off its best plane. Prints for each
noise the lower quartile and the median of thickness over radius, and their ratio: that between the two limits of noise in
modules/cloud/cloud_settings.h, 0.09 at the median and SmoothingSettings::flat at the lower quartile.
"""
import sys

import numpy as np
from scipy.spatial import cKDTree

RADIUS = 2.2  # spacings, SmoothingSettings::first_radius
SIDE = 80     # points along a side of the plane


def thicknesses(points):
    tree = cKDTree(points)
    inner = [i for i, p in enumerate(points) if np.all(np.abs(p[:2] - SIDE / 2) < SIDE / 2 - RADIUS - 1)]
    result = []
    for i in inner:
        around = points[tree.query_ball_point(points[i], RADIUS)]
        weights = (1 - ((around - points[i]) ** 2).sum(axis=1) / RADIUS**2) ** 2
        weights /= weights.sum()
        centred = around - weights @ around
        result.append(np.sqrt(np.linalg.eigvalsh(centred.T @ (weights[:, None] * centred))[0]) / RADIUS)
    return np.array(result)


def main():
    if len(sys.argv) > 2 or (len(sys.argv) == 2 and not sys.argv[1].isdigit()):
        sys.exit(__doc__)
    random = np.random.default_rng(int(sys.argv[1]) if len(sys.argv) == 2 else 1)
    grid = np.stack(np.meshgrid(np.arange(SIDE), np.arange(SIDE)), axis=-1).reshape(-1, 2).astype(float)
    print("noise  quartile  median  ratio")
    for noise in (0.15, 0.2, 0.25):
        flat = grid + random.uniform(-1 / 3, 1 / 3, grid.shape)
        points = np.c_[flat, noise * random.standard_normal(len(flat))]
        quartile, median = np.quantile(thicknesses(points), [0.25, 0.5])
        print(f"{noise:5.2f}  {quartile:8.4f}  {median:6.4f}  {quartile / median:5.3f}")


if __name__ == "__main__":
    main()
