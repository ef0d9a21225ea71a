#!/usr/bin/env python3
"""Fits the weights of the map's confidence and judges them on data that they were not fitted to; needs numpy and scipy.

usage: calibrate_confidence.py EVIDENCE.csv ...

EVIDENCE.csv are tables of `pcl_symmetry_benchmark DIR --evidence FILE`, of meshes and clouds, whole and with
`--cut-limb`. A map counts as right where its Correspondence Rate is above 75 % and no limb was cut off.

One data set at a time is left out, the weights are fitted to the others and judged on it: area under the ROC curve, right
maps refused (below 0.35), wrong maps and maps of cut bodies delivered with more than 0.5, and how often maps of a
confidence are right. Weights may not point against the meaning of a measure (monotone). At the end the weights of a fit
to all, for modules/symmetry/confidence/calibration.h, which holds the floors and bounds that are repeated here.
"""
import csv
import sys
from collections import Counter

import numpy as np
from scipy.optimize import minimize

REFUSED, SURE, RIGHT = 0.35, 0.5, 0.75
REGULARISATION = 1e-3  # of weights of standardised measures: keeps those finite that one set alone decides


def features(column):
    """Columns of evidence, turned so that more speaks for the map; name -> values."""
    log = np.log
    return {
        "stretch": -log(column("stretch") + 0.01),
        "worst_distance": -log(column("worst_distance") + 4e-3),
        "fit_distance": -log(column("fit_distance") + 1e-3),
        "curvature": -np.minimum(column("rough_curvature"), 1.5),
        "fixed": -np.clip(column("fixed"), 0.2, 0.35),
        "distorted": -np.maximum(0, column("distorted") - 0.2),
        "turn": log(np.minimum(column("fit_turn"), 0.15) + 0.005) - log(np.maximum(1, column("fit_turn") / 0.15)),
        "average_distance": log(np.minimum(column("average_distance"), 0.18) + 4e-3),
        "involution": log(np.minimum(column("relaxed_involution"), 0.06) + 1e-3),
        "holes": np.clip((column("at_holes") - 0.02) / 0.06, 0, 1),
        "noise": column("noisy"),
        "gaps": np.clip((column("irregularity") - 1.4) / 0.4, 0, 1) * log(np.maximum(1, column("sparse") / 0.011)),
    }


def fit(x, right, weight):
    """Intercept and weights, none below 0, of a logistic function."""
    x = np.c_[np.ones(len(x)), x]

    def loss(b):
        z = x @ b
        value = (weight * np.where(right, np.logaddexp(0, -z), np.logaddexp(0, z))).sum() / weight.sum()
        slope = x.T @ (weight * (1 / (1 + np.exp(-z)) - right)) / weight.sum()
        return value + REGULARISATION * (b[1:] ** 2).sum(), slope + 2 * REGULARISATION * np.r_[0, b[1:]]

    bounds = [(None, None)] + [(0, None)] * (x.shape[1] - 1)
    return minimize(loss, np.zeros(x.shape[1]), jac=True, method="L-BFGS-B", bounds=bounds).x


def fit_leaving_out(named, right, weight, sets):
    """Confidences by fits to all sets but the one they are of; the weights of a fit to all, by name, in plain units."""
    x = np.stack(list(named.values()), axis=1)
    mean, deviation = x.mean(axis=0), x.std(axis=0) + 1e-9
    x = (x - mean) / deviation
    left_out = np.zeros(len(x))
    for name in sorted(set(sets)):
        others = sets != name
        b = fit(x[others], right[others], weight[others])
        left_out[~others] = 1 / (1 + np.exp(-(b[0] + x[~others] @ b[1:])))
    b = fit(x, right, weight)
    weights = {"bias": b[0] - (b[1:] * mean / deviation).sum(), **dict(zip(named, b[1:] / deviation))}
    return left_out, weights


def print_weights(weights):
    print("\nfit to all")
    for name, value in weights.items():
        print(f"{name:18}{value:8.3f}")


def area_under_roc(score, right):
    if right.all() or not right.any():
        return float("nan")
    _, place, count = np.unique(score, return_inverse=True, return_counts=True)
    rank = (np.cumsum(count) - (count - 1) / 2)[place]
    hits = right.sum()
    return (rank[right].sum() - hits * (hits + 1) / 2) / (hits * (len(right) - hits))


def judge(name, confidence, right, cut):
    def share(which, of):
        return f"{100 * which[of].mean():6.1f}" if of.any() else "     -"

    print(f"{name:22}{len(right):6}{area_under_roc(confidence, right):8.3f}  {share(confidence < REFUSED, right)}"
          f"  {share(confidence > SURE, ~right & ~cut)}  {share(confidence > SURE, cut)}")


def print_reliability(confidence, right):
    print("\nconfidence   maps  right %")
    for low in np.arange(0, 1, 0.1):
        inside = (confidence >= low) & (confidence < low + 0.1 + (low > 0.85))
        if inside.any():
            print(f"{low:.1f} to {low + 0.1:.1f} {inside.sum():6}   {100 * right[inside].mean():6.1f}")


def read_tables(usage):
    """The rows of all tables of the command line, each with the name of its table."""
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(usage)
    rows = []
    for path in sys.argv[1:]:
        with open(path, newline="") as table:
            rows += [{**row, "table": path} for row in csv.DictReader(table)]
    return rows


def main():
    rows = read_tables(__doc__)
    sets = np.array([row["set"] for row in rows])
    cut = np.array([row["cut"] == "1" for row in rows])
    right = np.array([float(row["rate"]) > RIGHT for row in rows]) & ~cut
    present = np.array([float(row["confidence"]) for row in rows])
    # A model that is understood in ten ways counts no more than one that is understood in one.
    ways = Counter((row["table"], row["set"], row["model"]) for row in rows)
    weight = np.array([1 / ways[row["table"], row["set"], row["model"]] for row in rows])

    named = features(lambda name: np.array([float(row[name]) for row in rows]))
    left_out, weights = fit_leaving_out(named, right, weight, sets)

    print("set left out            maps    area  right refused %  wrong > 0.5 %  cut > 0.5 %")
    for name in sorted(set(sets)):
        judge(name, left_out[sets == name], right[sets == name], cut[sets == name])
    judge("all, each left out", left_out, right, cut)
    judge("all, present weights", present, right, cut)
    print_reliability(left_out, right)

    print_weights(weights)


if __name__ == "__main__":
    main()
