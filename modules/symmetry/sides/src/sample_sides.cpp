#include "symmetry/sides/sample_sides.h"

#include "base/vector_math.h"
#include "symmetry/sides/side_names.h"
#include "symmetry/sides/side_settings.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <functional>

namespace pcl {
namespace symmetry {
namespace {

constexpr SampleSideSettings settings{};

using Entry = Eigen::Triplet<double>;

float
squared(const Vector3& a)
{
  return dot(a, a);
}

/** What a map says of pairs of samples. */
class SideRelations {
public:
  SideRelations(const SampledSurface& sampled, const std::vector<Index>& partners)
      : sampled_(sampled), partners_(partners), spacing_(sampleSpacing(sampled.coarse))
  {
    for (std::size_t i = 0; i < partners.size(); ++i) {
      reliabilities_.push_back(reliability(static_cast<Index>(i)));
    }
  }

  /** 1: on one side; -1: on opposite sides; 0: cannot be told. */
  double
  operator()(Index i, Index j) const
  {
    const float apart = squared(sampled_.coarse.points[i] - sampled_.coarse.points[j]);
    const float to_partners = 0.5F * (squaredToPartner(i, j) + squaredToPartner(j, i));
    const float sum = apart + to_partners;
    return sum > 0.0F ? static_cast<double>(reliabilities_[i] * reliabilities_[j] * (to_partners - apart) / sum) : 0.0;
  }

private:
  /** From sample i to the partner of sample j. Straight, which is exact where it matters, near the axis; but where parts
   * of the two sides touch, the way over the surface, as far as the landmarks resolve it, says that the axis is far. */
  float
  squaredToPartner(Index i, Index j) const
  {
    const Index partner = partners_[j];
    const LandmarkSurface& landmarks = sampled_.landmarks;
    const Index landmark = landmarks.nearest_landmark[sampled_.coarse.cells.owner[partner]];
    const float over_surface =
        std::max(0.0F, landmarks.to_samples(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(landmark)) -
                           settings.landmark_blur * spacing_);
    return std::max(squared(sampled_.coarse.points[i] - sampled_.surface.points[partner]), over_surface * over_surface);
  }

  /** Of the partner of a sample: 1 where its own partner is the sample, nearly 0 where that lies spacings away. */
  float
  reliability(Index i) const
  {
    const Vector3& partner = sampled_.surface.points[partners_[i]];
    const Index there = sampled_.coarse.cells.owner[partners_[i]];
    const float astray = distance(sampled_.surface.points[partners_[there]], sampled_.coarse.points[i]);
    const float off_sample = distance(partner, sampled_.coarse.points[there]); // as the partner is no sample itself
    const float spacings = std::max(0.0F, astray - off_sample) / spacing_;
    return 1.0F / (1.0F + spacings * spacings * spacings * spacings);
  }

  const SampledSurface& sampled_;
  const std::vector<Index>& partners_;
  float spacing_;
  std::vector<float> reliabilities_;
};

/** Each sample related to those adjacent and to the one at its partner; every relation in both directions. */
std::vector<Entry>
relateSamples(const SampledSurface& sampled, const std::vector<Index>& partners)
{
  const SideRelations relation(sampled, partners);
  std::vector<Entry> entries;
  const auto relate = [&](Index i, Index j, double weight) {
    entries.emplace_back(i, j, weight);
    entries.emplace_back(j, i, weight);
  };
  for (Index i = 0; static_cast<std::size_t>(i) < sampled.coarse.size(); ++i) {
    for (const Index j : sampled.coarse.graph.neighboursOf(i)) {
      if (i < j) {
        relate(i, j, relation(i, j) + settings.adjacency);
      }
    }
    const Index at_partner = sampled.coarse.cells.owner[partners[i]];
    if (at_partner != i) {
      relate(i, at_partner, relation(i, at_partner));
    }
  }
  return entries;
}

/** Lowest eigenvector of the Laplacian of a signed graph, normalized by its degrees, by inverse iteration. */
Eigen::VectorXd
lowestEigenvector(const std::vector<Entry>& relations, const Eigen::VectorXd& start)
{
  Eigen::VectorXd degrees = Eigen::VectorXd::Zero(start.size());
  for (const Entry& entry : relations) {
    degrees(entry.row()) += std::abs(entry.value());
  }
  // What is hardly related to anything must not make an eigenvector of its own.
  const Eigen::VectorXd inverse_root = degrees.cwiseMax(settings.minimum_degree).cwiseSqrt().cwiseInverse();
  std::vector<Entry> entries;
  entries.reserve(relations.size() + static_cast<std::size_t>(start.size()));
  for (const Entry& entry : relations) {
    entries.emplace_back(entry.row(), entry.col(),
                         -entry.value() * inverse_root(entry.row()) * inverse_root(entry.col()));
  }
  for (int i = 0; i < static_cast<int>(start.size()); ++i) {
    entries.emplace_back(i, i, 1.0 + settings.shift);
  }
  Eigen::SparseMatrix<double> laplacian(start.size(), start.size());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(laplacian);

  Eigen::VectorXd vector = start.cwiseQuotient(inverse_root).normalized();
  for (int round = 0; round < settings.maximum_rounds; ++round) {
    const Eigen::VectorXd next = factor.solve(vector).normalized();
    const double change = (next - vector).norm();
    vector = next;
    if (change < settings.tolerance) {
      break;
    }
  }
  return vector.cwiseProduct(inverse_root);
}

/** The first sample that moves at least half as far as the one that moves most; no_index where none moves. */
Index
firstFarMover(const SampledSurface& sampled, const std::vector<Index>& partners)
{
  std::vector<float> ways;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    ways.push_back(distance(sampled.coarse.points[i], sampled.surface.points[partners[i]]));
  }
  const float farthest = *std::max_element(ways.begin(), ways.end());
  const auto first = std::find_if(ways.begin(), ways.end(), [&](float way) { return way >= 0.5F * farthest; });
  return farthest > 0.0F ? static_cast<Index>(first - ways.begin()) : no_index;
}

} // namespace

std::vector<float>
sampleSides(const SampledSurface& sampled, const std::vector<Index>& partners)
{
  const Index mover = firstFarMover(sampled, partners);
  if (mover == no_index) {
    return std::vector<float>(partners.size(), 0.0F);
  }
  // Started from what is nearer to the mover than to its partner.
  Eigen::VectorXd start(static_cast<Eigen::Index>(partners.size()));
  for (std::size_t i = 0; i < partners.size(); ++i) {
    const Vector3& point = sampled.coarse.points[i];
    start(static_cast<Eigen::Index>(i)) =
        squared(point - sampled.surface.points[partners[mover]]) - squared(point - sampled.coarse.points[mover]);
  }
  Eigen::VectorXd sides = lowestEigenvector(relateSamples(sampled, partners), start);
  sides *= (sides(mover) < 0.0 ? -1.0 : 1.0) * std::sqrt(static_cast<double>(partners.size())) / sides.norm();
  const Eigen::VectorXf rounded = sides.cast<float>();
  std::vector<float> named(rounded.data(), rounded.data() + rounded.size());
  if (chirality(sampled, named) < 0.0) {
    std::transform(named.begin(), named.end(), named.begin(), std::negate<>());
  }
  return named;
}

} // namespace symmetry
} // namespace pcl
