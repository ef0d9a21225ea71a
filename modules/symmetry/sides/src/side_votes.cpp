#include "symmetry/sides/side_votes.h"

#include "symmetry/sides/side_settings.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

constexpr VoteSettings settings{};

/** Landmarks that move at least half as far as the one that moves most, evenly spread: landmarks come in the order of
 * farthest-point sampling. Of two landmarks that are each other's partners only the first is taken. */
std::vector<Index>
farMovers(const LandmarkSurface& landmarks, const SampleMap& map)
{
  float farthest = 0.0F;
  for (std::size_t i = 0; i < map.size(); ++i) {
    farthest = std::max(farthest, landmarks.distances(static_cast<Eigen::Index>(i), map[i]));
  }
  std::vector<Index> movers;
  std::vector<char> taken(map.size(), 0);
  for (const float share : settings.moved) {
    for (std::size_t i = 0; i < map.size() && movers.size() < settings.maximum_pairs; ++i) {
      const float moved = landmarks.distances(static_cast<Eigen::Index>(i), map[i]);
      if (taken[i] == 0 && moved > 0.0F && moved >= share * farthest) {
        taken[i] = 1;
        taken[static_cast<std::size_t>(map[i])] = 1;
        movers.push_back(static_cast<Index>(i));
      }
    }
  }
  return movers;
}

} // namespace

OrderedPairs
orderPairs(const LandmarkSurface& landmarks, const SampleMap& map)
{
  OrderedPairs pairs;
  pairs.sources = farMovers(landmarks, map);
  const auto count = static_cast<Eigen::Index>(pairs.sources.size());
  if (count == 0) {
    return pairs;
  }
  Eigen::MatrixXf votes(landmarks.distances.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Index source = pairs.sources[static_cast<std::size_t>(k)];
    const Index target = map[static_cast<std::size_t>(source)];
    pairs.targets.push_back(target);
    votes.col(k) =
        (landmarks.distances.col(target) - landmarks.distances.col(source)) / landmarks.distances(source, target);
  }
  const Eigen::MatrixXf agreement = votes.transpose() * votes;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXf> solver(agreement);
  const Eigen::VectorXf order = solver.eigenvectors().col(count - 1);
  const float first = order(0); // the first pair keeps its order, so that the sides do not swap at random
  for (Eigen::Index k = 0; k < count; ++k) {
    if (order(k) * first < 0.0F) {
      std::swap(pairs.sources[static_cast<std::size_t>(k)], pairs.targets[static_cast<std::size_t>(k)]);
    }
  }
  return pairs;
}

} // namespace symmetry
} // namespace pcl
