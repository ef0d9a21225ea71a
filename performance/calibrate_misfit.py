#!/usr/bin/env python3
"""Fits the weights by which refined maps of one surface are compared, and judges them on data that they were not fitted
to; needs numpy.

usage: calibrate_misfit.py CONTENDERS.csv ...

CONTENDERS.csv are tables of `pcl_symmetry_benchmark DIR --evidence FILE --contenders`, best of the models as they are
and with `--bend` and several seeds: in most models that no one disturbed all contenders are right.

Two weights are fitted, of the median turn of the patches and of the displacement (RefinementSettings), then a third one,
of the ends of limbs that go elsewhere, the others as in the tree: of a grid those that take the best maps, by the mean
Correspondence Rate. One data set at a time is left out, the weights are fitted to the others and judged on it: rate and
Mesh Rate (share of the models with a rate above 75 %) of the maps that are taken without them, with those of the fit,
with those in the tree, and of the best contender there is. The floors of modules/symmetry/refine/src/map_misfit.cpp are
repeated here. Which maps are refined, and where limbs are exchanged, follows from the weights in the tree: the fit does
not see which others would have been made.
"""
import sys

import numpy as np

from calibrate_confidence import read_tables

RIGHT = 0.75
MEDIAN_TURNS = (0.0, 0.5, 1.0, 2.0, 4.0)
DISPLACEMENTS = (0.0, 0.25, 0.5, 0.75, 1.0)
TREE = (1.0, 0.5)
MOVED_ENDS = (0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0)
TREE_MOVED_ENDS = 1.0


def columns(rows):
    """What the value of a contender is made of: the part without weights, and those to be weighted."""
    def column(name):
        return np.array([float(row[name]) for row in rows])

    plain = column("score") + 0.5 * np.log(column("fit_distance") + 2e-3) + np.log(column("fit_turn") + 0.01)
    return plain, np.log(column("turn") + 0.005), column("log_displacement"), column("moved_ends")


def taken(parts, first, weights, of_moved_ends=TREE_MOVED_ENDS):
    """For every surface the row of the contender that is taken."""
    plain, turn, displacement, moved_ends = parts
    value = plain + weights[0] * turn - weights[1] * displacement - of_moved_ends * moved_ends
    return np.array([a + np.argmin(value[a:b]) for a, b in zip(first, np.r_[first[1:], len(value)])])


def figures(rates):
    return f"{100 * rates.mean():6.1f}/{100 * (rates > RIGHT).mean():5.1f}"


def print_left_out(sets, rates, in_the_tree, without, best):
    """For every set the weights fitted to the others, and what they take of it; `rates` are those of each choice."""
    print("set left out   surfaces   weights of the fit   without       fit           in the tree   best there is")
    for name in sorted(set(sets)):
        left_out = sets == name
        fit = max(rates, key=lambda weights: rates[weights][~left_out].mean())
        print(f"{name:15}{left_out.sum():8}   {str(fit):>17}     {figures(rates[without][left_out])}"
              f"  {figures(rates[fit][left_out])}  {figures(rates[in_the_tree][left_out])}  {figures(best[left_out])}")


def main():
    rows = read_tables(__doc__)
    rate = np.array([float(row["rate"]) for row in rows])
    first = np.array([i for i, row in enumerate(rows) if row["number"] == "0"])
    sets = np.array([rows[i]["set"] for i in first])
    parts = columns(rows)
    best = np.array([rate[a:b].max() for a, b in zip(first, np.r_[first[1:], len(rate)])])
    pairs = [(t, d) for t in MEDIAN_TURNS for d in DISPLACEMENTS]
    rates = {pair: rate[taken(parts, first, pair)] for pair in pairs}

    differ = sum(rate[a:b].max() > RIGHT >= rate[a:b].min() for a, b in zip(first, np.r_[first[1:], len(rate)]))
    print(f"{len(first)} surfaces, in {differ} of which right and wrong maps compete\n")
    print_left_out(sets, rates, TREE, (0.0, 0.0), best)
    print()
    by_ends = {weight: rate[taken(parts, first, TREE, weight)] for weight in MOVED_ENDS}
    print_left_out(sets, by_ends, TREE_MOVED_ENDS, 0.0, best)

    print("\nmean rate of all, fitted and judged on the same; rows: median turn, columns: displacement")
    print("        " + "".join(f"{d:8}" for d in DISPLACEMENTS))
    for t in MEDIAN_TURNS:
        print(f"{t:8}" + "".join(f"{100 * rates[t, d].mean():8.2f}" for d in DISPLACEMENTS))
    print("moved ends: " + "".join(f"  {w} {100 * by_ends[w].mean():.2f}" for w in MOVED_ENDS))


if __name__ == "__main__":
    main()
