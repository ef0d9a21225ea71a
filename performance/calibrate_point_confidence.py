#!/usr/bin/env python3
"""Fits the weights of the points' confidence and judges them on sets they were not fitted to; needs numpy and scipy.

usage: calibrate_point_confidence.py VERTICES.csv ...

VERTICES.csv are tables of `pcl_symmetry_benchmark DIR --evidence FILE --vertex-evidence VERTICES.csv`, of meshes and
clouds. A partner counts as right within 5 % of the diameter of the true one. Only the first map of every model is taken:
further ones are made of those in doubt alone. One data set at a time is left out; at the end are the weights of a fit
to all, for PointCalibration in modules/symmetry/confidence/calibration.h, which holds the floors that are repeated here.
"""

import numpy as np

from calibrate_confidence import area_under_roc, fit_leaving_out, print_reliability, print_weights, read_tables

RIGHT = 0.05


def main():
    rows = [row for row in read_tables(__doc__) if row["number"] == "0"]

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
    left_out, weights = fit_leaving_out(named, right, np.ones(len(rows)), sets)
    print("set left out          vertices  wrong %    area")
    for name in sorted(set(sets)) + ["all, each left out"]:
        inside = sets == name if name in sets else np.ones(len(rows), dtype=bool)
        area = area_under_roc(left_out[inside], right[inside])
        print(f"{name:22}{inside.sum():8}{100 * (1 - right[inside].mean()):9.1f}{area:8.3f}")
    print_reliability(left_out, right)
    print_weights(weights)


if __name__ == "__main__":
    main()
