#include "symmetry/search/symmetry_hypotheses.h"

#include "symmetry/search/functional_map.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

/** An involution of the extremities: partner (its own number where stationary, -1 where left out) of each. */
struct Pairing {
  std::vector<int> partner;
  float value = 0.0F; ///< lower is better
};

/** Enumerates the involutions of a few extremities, cutting off what is clearly inconsistent. */
class PairingSearch {
public:
  PairingSearch(const LandmarkSurface& landmarks, std::size_t count) : landmarks_(landmarks), wanted_(count)
  {
    const std::size_t n = landmarks.extremities.size();
    partner_.assign(n, undecided);
    // Leaving one out costs what matching it badly would.
    constexpr float bad_change = 0.07F; // of a distance, share of the diameter: poses make 2 to 4 %; by hand
    left_out_cost_ = static_cast<float>(n) * bad_change * bad_change;
    largest_cost_ = static_cast<float>(n * n) * bad_change * bad_change;
  }

  std::vector<Pairing>
  run()
  {
    extend(0, 0.0F);
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Pairing& a, const Pairing& b) { return a.value < b.value; });
    if (found_.size() > wanted_) {
      found_.resize(wanted_);
    }
    return std::move(found_);
  }

private:
  static constexpr int undecided = -2;
  static constexpr int left_out = -1;

  float
  distance(std::size_t a, std::size_t b) const
  {
    return landmarks_.distances(landmarks_.extremities[a], landmarks_.extremities[b]) / landmarks_.diameter;
  }

  /** Squared change of distance between i and every extremity that is decided already. */
  float
  costOf(std::size_t i) const
  {
    float cost = 0.0F;
    const auto image = static_cast<std::size_t>(partner_[i]);
    for (std::size_t j = 0; j < partner_.size(); ++j) {
      if (partner_[j] >= 0 && j != i) {
        const float change = distance(i, j) - distance(image, static_cast<std::size_t>(partner_[j]));
        cost += change * change;
      }
    }
    const float outwardness = (landmarks_.average_distance[landmarks_.extremities[i]] -
                               landmarks_.average_distance[landmarks_.extremities[image]]) /
                              landmarks_.diameter;
    return cost + outwardness * outwardness;
  }

  void
  extend(std::size_t i, float cost)
  {
    if (cost > largest_cost_) {
      return;
    }
    while (i < partner_.size() && partner_[i] != undecided) {
      ++i;
    }
    if (i == partner_.size()) {
      keep(cost);
      return;
    }
    partner_[i] = static_cast<int>(i);
    extend(i + 1, cost + costOf(i));
    for (std::size_t j = i + 1; j < partner_.size(); ++j) {
      if (partner_[j] == undecided) {
        partner_[i] = static_cast<int>(j);
        partner_[j] = static_cast<int>(i);
        extend(i + 1, cost + costOf(i) + costOf(j));
        partner_[j] = undecided;
      }
    }
    partner_[i] = left_out;
    extend(i + 1, cost + left_out_cost_);
    partner_[i] = undecided;
  }

  void
  keep(float cost)
  {
    float moved = 0.0F;
    for (std::size_t i = 0; i < partner_.size(); ++i) {
      if (partner_[i] >= 0) {
        moved += std::pow(distance(i, static_cast<std::size_t>(partner_[i])), 2.0F);
      }
    }
    if (moved > 0.0F) {
      found_.push_back({partner_, std::log(cost + 1e-4F) - 0.5F * std::log(moved)});
    }
  }

  const LandmarkSurface& landmarks_;
  std::size_t wanted_;
  float left_out_cost_ = 0.0F;
  float largest_cost_ = 0.0F;
  std::vector<int> partner_;
  std::vector<Pairing> found_;
};

/** The map of all landmarks that carries distances to the extremities over to distances to their partners. */
SampleMap
mapFromPairing(const LandmarkSurface& landmarks, const Pairing& pairing)
{
  std::vector<Index> sources;
  std::vector<Index> targets;
  for (std::size_t i = 0; i < pairing.partner.size(); ++i) {
    if (pairing.partner[i] >= 0) {
      sources.push_back(landmarks.extremities[i]);
      targets.push_back(landmarks.extremities[static_cast<std::size_t>(pairing.partner[i])]);
    }
  }
  Eigen::MatrixXf from(landmarks.distances.rows(), static_cast<Eigen::Index>(sources.size()));
  Eigen::MatrixXf to(from.rows(), from.cols());
  for (std::size_t k = 0; k < sources.size(); ++k) {
    from.col(static_cast<Eigen::Index>(k)) = landmarks.distances.col(sources[k]);
    to.col(static_cast<Eigen::Index>(k)) = landmarks.distances.col(targets[k]);
  }
  return nearestRows(from, to);
}

} // namespace

std::vector<SymmetryHypothesis>
signPatternHypotheses(int dimensions)
{
  std::vector<SymmetryHypothesis> hypotheses;
  for (unsigned pattern = 1; pattern < (1U << static_cast<unsigned>(dimensions)); ++pattern) {
    Eigen::VectorXf signs(dimensions);
    for (int a = 0; a < dimensions; ++a) {
      signs(a) = (pattern >> static_cast<unsigned>(a) & 1U) != 0 ? -1.0F : 1.0F;
    }
    hypotheses.push_back({signs.asDiagonal()});
  }
  return hypotheses;
}

std::vector<SymmetryHypothesis>
extremityHypotheses(const LandmarkSurface& landmarks, const LaplacianBasis& basis, int dimensions, std::size_t count)
{
  const auto n = static_cast<Eigen::Index>(landmarks.size());
  const Eigen::MatrixXf functions =
      basis.functions.topLeftCorner(n, std::min<Eigen::Index>(dimensions + 1, basis.functions.cols()));
  const Eigen::MatrixXf gram = functions.transpose() * functions;
  const Eigen::MatrixXf pseudo_inverse = gram.ldlt().solve(functions.transpose());
  std::vector<SymmetryHypothesis> hypotheses;
  for (const Pairing& pairing : PairingSearch(landmarks, count).run()) {
    const SampleMap map = mapFromPairing(landmarks, pairing);
    Eigen::MatrixXf pulled_back(n, functions.cols());
    for (Eigen::Index i = 0; i < n; ++i) {
      pulled_back.row(i) = functions.row(map[static_cast<std::size_t>(i)]);
    }
    const Eigen::MatrixXf matrix = pseudo_inverse * pulled_back;
    const Eigen::Index d = functions.cols() - 1;
    hypotheses.push_back({nearestInvolution(matrix.bottomRightCorner(d, d))});
  }
  return hypotheses;
}

} // namespace symmetry
} // namespace pcl
