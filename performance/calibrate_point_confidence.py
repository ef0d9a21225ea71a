#!/usr/bin/env python3
"""Fits the weights of the points' confidence and judges them on sets they were not fitted to; needs numpy and scipy.

usage: calibrate_point_confidence.py VERTICES.csv ...

VERTICES.csv are tables of `pcl_symmetry_benchmark DIR --evidence FILE --vertex-evidence VERTICES.csv`, of meshes and
clouds. A partner counts as right within 5 % of the diameter of the true one. Only the first map of every model is taken:
further ones are made of those in doubt alone. One data set at a time is left out; at the end are the weights of a fit
to all, for PointCalibration in modules/symmetry/confidence/calibration.h, which holds the floors that are repeated here.
"""
import csv
import sys

import numpy as np

from calibrate_confidence import area_under_roc, fit, print_reliability

RIGHT = 0.05


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    rows = []
    for path in sys.argv[1:]:
        with open(path, newline="") as table:
            rows += [row for row in csv.DictReader(table) if row["number"] == "0"]

    def column(name):
        return np.array([float(row[name]) for row in rows])

    sets = np.array([row["set"] for row in rows])
    right = column("error") < RIGHT
    of_map = np.clip(column("map_confidence"), 1e-3, 1 - 1e-3)
    named = {
        "map": np.log(of_map / (1 - of_map)),
        "local_change": -np.log(column("local_change") + 0.03),
        "fit_distance": -np.log(column("fit_distance") + 1e-3),
        "reversal": column("reversal"),
    }
    x = np.stack(list(named.values()), axis=1)
    mean, deviation = x.mean(axis=0), x.std(axis=0) + 1e-9
    x = (x - mean) / deviation
    weight = np.ones(len(rows))

    left_out = np.zeros(len(rows))
    for name in sorted(set(sets)):
        others = sets != name
        b = fit(x[others], right[others], weight[others])
        left_out[~others] = 1 / (1 + np.exp(-(b[0] + x[~others] @ b[1:])))
    print("set left out          vertices  wrong %    area")
    for name in sorted(set(sets)) + ["all, each left out"]:
        inside = sets == name if name in sets else np.ones(len(rows), dtype=bool)
        area = area_under_roc(left_out[inside], right[inside])
        print(f"{name:22}{inside.sum():8}{100 * (1 - right[inside].mean()):9.1f}{area:8.3f}")
    print_reliability(left_out, right)
    b = fit(x, right, weight)
    print(f"\nfit to all\n{'bias':18}{b[0] - (b[1:] * mean / deviation).sum():8.3f}")
    for name, value in zip(named, b[1:] / deviation):
        print(f"{name:18}{value:8.3f}")


if __name__ == "__main__":
    main()
