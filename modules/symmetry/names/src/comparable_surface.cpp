#include "symmetry/names/comparable_surface.h"

#include "symmetry/names/name_settings.h"
#include "symmetry/sides/intrinsic_functions.h"
#include "symmetry/sides/side_names.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

constexpr ComparisonFeatures settings{};

/** Way over the surface from each sample to its partner, as far as the landmarks resolve it. */
Eigen::VectorXd
waysToPartners(const LandmarkSurface& landmarks, const SampleMap& map)
{
  Eigen::VectorXd ways(static_cast<Eigen::Index>(map.size()));
  for (std::size_t i = 0; i < map.size(); ++i) {
    ways(static_cast<Eigen::Index>(i)) =
        static_cast<double>(landmarks.to_samples(map[i], landmarks.nearest_landmark[i]));
  }
  return ways;
}

/** What a symmetry keeps: how far all else is, heat, curvature as seen from outside, and the way to the partner. */
std::vector<Eigen::VectorXd>
functionsOfShape(const SampledSurface& sampled, const SampleMap& map)
{
  const Eigen::MatrixXf& distances = sampled.landmarks.to_samples;
  std::vector<Eigen::VectorXd> functions = {distances.rowwise().mean().cast<double>(),
                                            distances.rowwise().maxCoeff().cast<double>()};
  for (const double time : settings.heat_times) {
    functions.push_back(heatSignature(sampled.basis, time));
  }
  const double out = outwards(sampled.coarse);
  for (Eigen::Index scale = 0; scale < sampled.descriptor.curvature.cols(); ++scale) {
    functions.emplace_back(out * sampled.descriptor.curvature.col(scale).cast<double>());
  }
  functions.push_back(waysToPartners(sampled.landmarks, map));
  return functions;
}

Eigen::MatrixXd
featuresOf(const SampledSurface& sampled, const SampleMap& map)
{
  const std::vector<Eigen::VectorXd> functions = functionsOfShape(sampled, map);
  Eigen::MatrixXd features(static_cast<Eigen::Index>(map.size()), static_cast<Eigen::Index>(functions.size()));
  for (std::size_t k = 0; k < functions.size(); ++k) {
    const Eigen::VectorXd function = standardized(functions[k], sampled.coarse);
    for (std::size_t i = 0; i < map.size(); ++i) {
      features(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          0.5 * (function(static_cast<Eigen::Index>(i)) + function(map[i]));
    }
  }
  return features;
}

Eigen::MatrixXf
evenDistances(const LandmarkSurface& landmarks, const SampleMap& map)
{
  Eigen::MatrixXf distances = landmarks.to_samples;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    distances.row(row) = distances.row(row).cwiseMin(landmarks.to_samples.row(map[i]));
  }
  const float mean = distances.mean();
  return mean > 0.0F ? Eigen::MatrixXf(distances / mean) : distances;
}

/** The triangles of the samples, counter-clockwise as seen from outside. */
std::vector<Triangle>
trianglesFromOutside(const CoarseSurface& coarse)
{
  std::vector<Triangle> triangles = coarse.triangles;
  const double out = outwards(coarse);
  for (Triangle& t : triangles) {
    if (out * turnOf(t, coarse) < 0.0) {
      std::swap(t[1], t[2]);
    }
  }
  return triangles;
}

} // namespace

ComparableSurface
comparableSurface(const SampledSurface& sampled, const SampleMap& map, const std::vector<float>& sides)
{
  ComparableSurface surface;
  const auto samples = static_cast<Eigen::Index>(map.size());
  if (!sampled.isSearchable() || sampled.descriptor.curvature.rows() != samples) {
    return surface;
  }
  surface.even = evenFunctions(sampled.basis, map);
  surface.features = featuresOf(sampled, map);
  surface.distances = evenDistances(sampled.landmarks, map);
  surface.nearest_landmark = sampled.landmarks.nearest_landmark;
  surface.areas = Eigen::Map<const Eigen::VectorXf>(sampled.coarse.areas.data(), samples).cast<double>();
  surface.triangles = trianglesFromOutside(sampled.coarse);
  surface.sides = Eigen::Map<const Eigen::VectorXf>(sides.data(), samples).cast<double>();
  surface.chirality = chirality(sampled, sides, settings.chirality);
  return surface;
}

Eigen::MatrixXd
turnsOf(const ComparableSurface& surface, const Eigen::MatrixXd& functions)
{
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Index count = functions.cols();
  Eigen::MatrixXd turns = Eigen::MatrixXd::Zero(functions.rows(), count * (count - 1) / 2);
  // One triangle after another, as they come: by rows in memory.
  const Matrix by_sample = functions;
  Matrix sums = Matrix::Zero(functions.rows(), turns.cols());
  std::vector<double> along(static_cast<std::size_t>(count));
  std::vector<double> across(static_cast<std::size_t>(count));
  for (const Triangle& t : surface.triangles) {
    const double* const corner = by_sample.row(t[0]).data();
    const double* const second = by_sample.row(t[1]).data();
    const double* const third = by_sample.row(t[2]).data();
    for (std::size_t k = 0; k < along.size(); ++k) {
      along[k] = second[k] - corner[k];
      across[k] = third[k] - corner[k];
    }
    std::array<double*, 3> at = {sums.row(t[0]).data(), sums.row(t[1]).data(), sums.row(t[2]).data()};
    for (std::size_t a = 0; a < along.size(); ++a) {
      for (std::size_t b = a + 1; b < along.size(); ++b) {
        const double turn = along[a] * across[b] - along[b] * across[a];
        for (double*& sum : at) {
          *sum++ += turn;
        }
      }
    }
  }
  turns = sums;
  turns = surface.areas.cwiseMax(1e-12).cwiseInverse().asDiagonal() * turns;
  const Eigen::VectorXd lengths = turns.rowwise().norm();
  const double typical = settings.steep * lengths.mean();
  const Eigen::VectorXd factors =
      typical > 0.0 ? surface.sides.cwiseQuotient(lengths + Eigen::VectorXd::Constant(lengths.size(), typical)).eval()
                    : surface.sides;
  return factors.asDiagonal() * turns;
}

} // namespace symmetry
} // namespace pcl
