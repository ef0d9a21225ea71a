#include "symmetry/names/name_comparison.h"

#include "base/parallel.h"
#include "symmetry/names/name_settings.h"
#include "symmetry/search/row_search.h"

#include <pcl/symmetry/symmetry_result.h>

#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

constexpr NameComparisonSettings settings{};

Eigen::MatrixXd
rowsOf(const Eigen::MatrixXd& matrix, const SampleMap& rows)
{
  Eigen::MatrixXd picked(static_cast<Eigen::Index>(rows.size()), matrix.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    picked.row(static_cast<Eigen::Index>(i)) = matrix.row(rows[i]);
  }
  return picked;
}

/** Maps of the landmarks of one surface to those of another, on as many even functions as a level has. */
class HalfMatching {
public:
  HalfMatching(const ComparableSurface& from, const ComparableSurface& to) : from_(from), to_(to)
  {
    addLevel(settings.signed_functions, settings.start_weight);
    for (const int d : settings.dimensions) {
      addLevel(d, settings.weight);
    }
    features_ = RowSearch(to.features.topRows(to.landmarks()).cast<float>());
    const Eigen::Index turning = std::min<Eigen::Index>(settings.turning_functions, functions());
    turning_ = to.even.functions.leftCols(turning);
    turns_ = turnsOf(to, turning_);
    pulled_back_.compute(from.even.functions.topLeftCorner(from.landmarks(), levels_.back().size));
  }

  std::size_t
  levels() const
  {
    return levels_.size();
  }

  Eigen::Index
  sizeOf(std::size_t level) const
  {
    return levels_[level].size;
  }

  /** By the features alone. */
  SampleMap
  byFeatures() const
  {
    return features_.nearest(from_.features.topRows(from_.landmarks()).cast<float>());
  }

  /** \param[in] matrix that carries the even functions of one surface to those of the other
   * \param[in] names 1: the map is to keep the orientation and carry source to source, -1: to target */
  SampleMap
  match(std::size_t level, const Eigen::MatrixXd& matrix, double names) const
  {
    const Level& here = levels_[level];
    const Eigen::Index rows = from_.landmarks();
    const Eigen::MatrixXd images = from_.even.functions.leftCols(here.size) * matrix;
    const Eigen::MatrixXd turns = turnsOf(from_, images.leftCols(here.turning));
    Eigen::MatrixXd queries(rows, here.size + turns.cols() + from_.features.cols());
    queries << images.topRows(rows) * here.scales.asDiagonal(), names * settings.turn_weight * turns.topRows(rows),
        here.weight * from_.features.topRows(rows);
    return here.search.nearest(queries.cast<float>());
  }

  /** The orthogonal matrix nearest to what a map does to the even functions. */
  Eigen::MatrixXd
  matrixOf(std::size_t level, const SampleMap& map) const
  {
    const Eigen::Index size = levels_[level].size;
    const Eigen::Index rows = from_.landmarks();
    const Eigen::MatrixXd product = from_.even.functions.topLeftCorner(rows, size).transpose() *
                                    from_.areas.head(rows).asDiagonal() *
                                    rowsOf(to_.even.functions.leftCols(size), map);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return svd.matrixU() * svd.matrixV().transpose();
  }

  /** Share of the surface that a map carries to the same side without mirroring it, less the share that it mirrors: in
   * [-1, 1]. */
  double
  orientation(const SampleMap& map) const
  {
    const Eigen::MatrixXd images = rowsOf(turning_, map);
    const Eigen::MatrixXd coefficients = pulled_back_.solve(images);
    const Eigen::MatrixXd here =
        turnsOf(from_, from_.even.functions.leftCols(coefficients.rows()) * coefficients).topRows(from_.landmarks());
    const Eigen::VectorXd agreement = here.cwiseProduct(rowsOf(turns_, map)).rowwise().sum();
    const double all = agreement.cwiseAbs().sum();
    return all > 0.0 ? agreement.sum() / all : 0.0;
  }

  /** How badly a map fits: 0 is best. */
  double
  misfit(const SampleMap& map) const
  {
    const Eigen::Index rows = from_.landmarks();
    const auto compared = std::min<std::size_t>(settings.compared_landmarks, map.size());
    double change = 0.0;
    for (std::size_t l = 0; l < compared; ++l) {
      const Index image = to_.nearest_landmark[map[l]];
      for (Eigen::Index i = 0; i < rows; ++i) {
        change += static_cast<double>(
            std::abs(from_.distances(i, static_cast<Eigen::Index>(l)) - to_.distances(map[i], image)));
      }
    }
    change /= static_cast<double>(rows) * static_cast<double>(compared);
    const double unlike = (from_.features.topRows(rows) - rowsOf(to_.features, map)).squaredNorm() /
                          static_cast<double>(rows * from_.features.cols());
    return change + settings.feature_share * unlike;
  }

private:
  struct Level {
    Eigen::Index size = 0;
    Eigen::Index turning = 0; ///< functions whose turns are compared
    double weight = 0.0;      ///< of the features
    Eigen::VectorXd scales;   ///< of the functions: low ones weigh more
    RowSearch search;
  };

  Eigen::Index
  functions() const
  {
    return std::min(from_.even.functions.cols(), to_.even.functions.cols());
  }

  void
  addLevel(int dimensions, double weight)
  {
    Level level;
    level.size = std::min<Eigen::Index>(dimensions, functions());
    level.weight = weight / std::sqrt(static_cast<double>(to_.features.cols()));
    const Eigen::VectorXd frequencies =
        (0.5 * (from_.even.eigenvalues.head(level.size) + to_.even.eigenvalues.head(level.size))).cwiseMax(1e-9);
    level.scales = frequencies.cwiseSqrt().cwiseInverse();
    const Eigen::Index rows = to_.landmarks();
    level.turning = std::min<Eigen::Index>(settings.turning_functions, level.size);
    const Eigen::MatrixXd turns = turnsOf(to_, to_.even.functions.leftCols(level.turning));
    Eigen::MatrixXd targets(rows, level.size + turns.cols() + to_.features.cols());
    targets << to_.even.functions.topLeftCorner(rows, level.size) * level.scales.asDiagonal(),
        settings.turn_weight * turns.topRows(rows), level.weight * to_.features.topRows(rows);
    // All functions together have mean square 1, as have the features.
    const double length =
        std::sqrt(targets.leftCols(level.size).squaredNorm() / static_cast<double>(rows)); // not 0: no function is
    level.scales /= length;
    targets.leftCols(level.size) /= length;
    level.search = RowSearch(targets.cast<float>());
    levels_.push_back(std::move(level));
  }

  const ComparableSurface& from_;
  const ComparableSurface& to_;
  std::vector<Level> levels_; ///< the first one is that of the starts
  RowSearch features_;
  Eigen::MatrixXd turning_; ///< lowest even functions of the other surface
  Eigen::MatrixXd turns_;   ///< and their turns
  Eigen::HouseholderQR<Eigen::MatrixXd> pulled_back_;
};

/** A map there and one back. */
struct HalfMap {
  SampleMap map;
  double misfit = 0.0;
  double orientation = 0.0; ///< positive where source goes to source
};

/** Makes maps from starts. */
class HalfSearch {
public:
  HalfSearch(const ComparableSurface& first, const ComparableSurface& second)
      : there_(first, second), back_(second, first), patterns_(std::size_t{1} << there_.sizeOf(0))
  {
  }

  /** Patterns of signs of the lowest even functions, and the features alone. */
  std::size_t
  starts() const
  {
    return patterns_ + 1;
  }

  HalfMap
  fromStart(std::size_t start, double names) const
  {
    if (start == patterns_) {
      return refined(there_.byFeatures(), 1, names);
    }
    Eigen::MatrixXd signs = Eigen::MatrixXd::Identity(there_.sizeOf(0), there_.sizeOf(0));
    for (Eigen::Index k = 0; k < signs.cols(); ++k) {
      signs(k, k) = ((start >> k) & 1U) != 0 ? -1.0 : 1.0;
    }
    return refined(there_.match(0, signs, names), 1, names);
  }

  /** Goes up through the even functions, from a level on. */
  HalfMap
  refined(SampleMap map, std::size_t first_level, double names) const
  {
    Eigen::MatrixXd matrix;
    for (std::size_t level = first_level; level < there_.levels(); ++level) {
      matrix = there_.matrixOf(level, map);
      map = there_.match(level, matrix, names);
    }
    const SampleMap reverse = back_.match(back_.levels() - 1, matrix.transpose(), names);
    const double misfit = there_.misfit(map) + back_.misfit(reverse);
    const double orientation = there_.orientation(map) + back_.orientation(reverse);
    return {std::move(map), misfit, orientation};
  }

private:
  HalfMatching there_;
  HalfMatching back_;
  std::size_t patterns_;
};

/** The maps of one kind that fit best, the best first. */
std::vector<const HalfMap*>
bestOf(const std::vector<HalfMap>& maps, double names, std::size_t count)
{
  std::vector<const HalfMap*> best;
  for (const HalfMap& map : maps) {
    if ((map.orientation >= 0.0) == (names > 0.0)) {
      best.push_back(&map);
    }
  }
  std::stable_sort(best.begin(), best.end(), [](const HalfMap* a, const HalfMap* b) { return a->misfit < b->misfit; });
  best.resize(std::min(best.size(), count));
  return best;
}

} // namespace

double
NameComparison::margin() const
{
  const double worse = std::max(same, opposite);
  const double by_maps = worse > 0.0 ? (opposite - same) / worse : 0.0;
  const double together = std::clamp(by_maps + settings.chirality_share * chiralities, -1.0, 1.0);
  const bool is_doubtful = std::abs(together) < static_cast<double>(SideNaming::doubtful);
  return is_doubtful && chiralities != 0.0 ? std::copysign(together, chiralities) : together;
}

NameComparison
compareNames(const ComparableSurface& first, const ComparableSurface& second)
{
  if (!first.isComparable() || !second.isComparable()) {
    return {};
  }
  const HalfSearch search(first, second);
  std::vector<HalfMap> maps(2 * search.starts());
  parallelFor(maps.size(), [&](std::size_t k) { maps[k] = search.fromStart(k / 2, k % 2 == 0 ? 1.0 : -1.0); });
  // Thin bodies have a front and a back that are alike to the low functions: what was found with one orientation is a
  // start for the other.
  std::vector<std::pair<const HalfMap*, double>> again;
  for (const double names : {1.0, -1.0}) {
    for (const HalfMap* map : bestOf(maps, -names, settings.turned_over)) {
      again.emplace_back(map, names);
    }
  }
  std::vector<HalfMap> more(again.size());
  parallelFor(more.size(), [&](std::size_t k) { more[k] = search.refined(again[k].first->map, 1, again[k].second); });
  constexpr double none = std::numeric_limits<double>::infinity();
  NameComparison best{none, none, 0.0};
  double worst = 0.0;
  for (const std::vector<HalfMap>* found : {&maps, &more}) {
    for (const HalfMap& map : *found) {
      double& here = map.orientation >= 0.0 ? best.same : best.opposite;
      here = std::min(here, map.misfit);
      worst = std::max(worst, map.misfit);
    }
  }
  // No start led to such a map: it is at least as bad as any that was found.
  best.same = std::min(best.same, worst);
  best.opposite = std::min(best.opposite, worst);
  best.chiralities = std::clamp(first.chirality * second.chirality, -1.0, 1.0);
  return best;
}

} // namespace symmetry
} // namespace pcl
