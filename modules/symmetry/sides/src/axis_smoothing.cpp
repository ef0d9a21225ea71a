#include "symmetry/sides/axis_smoothing.h"

#include "base/heartbeat.h"
#include "base/vector_math.h"
#include "geodesic/shortest_paths.h"
#include "symmetry/sides/side_settings.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr AxisSmoothingSettings settings{};

using Entry = Eigen::Triplet<double>;

/** Points at an end of an edge along which the sign changes, and the mean length of these edges. */
struct SignChanges {
  std::vector<Index> points;
  float edge_length = 0.0F;
};

SignChanges
findSignChanges(const SurfaceGraph& graph, const std::vector<float>& values)
{
  SignChanges changes;
  double sum = 0.0;
  std::size_t edges = 0;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    const std::size_t before = edges;
    for (const auto [w, length] : graph.edges(v)) {
      if ((values[v] < 0.0F) != (values[w] < 0.0F)) {
        sum += length;
        ++edges;
      }
    }
    if (edges > before) {
      changes.points.push_back(static_cast<Index>(v));
    }
  }
  changes.edge_length = edges == 0 ? 0.0F : static_cast<float>(sum / static_cast<double>(edges));
  return changes;
}

/** Solves systems of one matrix: by its factor, or where that would be far denser than those of surfaces are, because
 * faces join what is far apart, step by step. */
class HeatSolver {
public:
  void
  compute(const Eigen::SparseMatrix<double>& matrix)
  {
    factor_.analyzePattern(matrix);
    is_direct_ = factor_.entries() <= densestFactor(static_cast<double>(matrix.rows()));
    if (is_direct_) {
      factor_.factorize(matrix);
      return;
    }
    matrix_ = matrix;
    steps_.setMaxIterations(most_steps);
    steps_.setTolerance(tolerance);
    steps_.compute(matrix_);
  }

  /** Of no use where the matrix cannot be factorized, or there is no end to the steps. */
  bool
  solve(Eigen::VectorXd& x) const
  {
    if (is_direct_) {
      x = factor_.solve(x).eval();
      return factor_.info() == Eigen::Success && x.allFinite();
    }
    x = steps_.solve(x).eval();
    return steps_.info() == Eigen::Success && x.allFinite();
  }

private:
  using Matrix = Eigen::SparseMatrix<double>;

  class Factor : public Eigen::SimplicialLDLT<Matrix> {
  public:
    /** Numbers other than 0, once the pattern is analyzed. */
    double
    entries() const
    {
      return static_cast<double>(m_matrix.data().size());
    }
  };

  static constexpr int most_steps = 500;
  static constexpr double tolerance = 1e-6; // what floats tell

  /** Entries of the factor of a grid in the plane, 31 n log2 (n) / 4 by A. George: Nested dissection of a regular finite
   * element mesh. SIAM Journal on Numerical Analysis 10(2), 1973 \cite george1973nested. */
  static double
  densestFactor(double n)
  {
    return 7.75 * n * std::log2(n + 2.0);
  }

  bool is_direct_ = true;
  Factor factor_;
  Matrix matrix_; ///< referred to by the next
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> steps_;
};

/** Heat flow on a part of a surface, whose border lets none through. */
class HeatFlow {
public:
  HeatFlow(const PreparedSurface& surface, std::vector<Index> part, double time)
      : part_(std::move(part)), masses_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(part_.size())))
  {
    std::vector<Index> number(surface.size(), no_index);
    for (std::size_t i = 0; i < part_.size(); ++i) {
      number[part_[i]] = static_cast<Index>(i);
    }
    std::vector<Entry> entries;
    for (const Triangle& t : surface.triangles) {
      const Triangle inside{number[t[0]], number[t[1]], number[t[2]]};
      if (std::find(inside.begin(), inside.end(), no_index) == inside.end()) {
        addTriangle(surface, t, inside, time, entries);
      }
    }
    // What has no triangle keeps its value.
    const double least = std::max(masses_.mean(), 1e-12) * 1e-6;
    masses_ = masses_.cwiseMax(least);
    for (Eigen::Index i = 0; i < masses_.size(); ++i) {
      entries.emplace_back(static_cast<int>(i), static_cast<int>(i), masses_(i));
    }
    Eigen::SparseMatrix<double> matrix(masses_.size(), masses_.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver_.compute(matrix);
  }

  /** Lets the values of the part flow; leaves them where the system cannot be solved. */
  void
  flow(std::vector<float>& values, int steps) const
  {
    Eigen::VectorXd heat(masses_.size());
    for (std::size_t i = 0; i < part_.size(); ++i) {
      heat(static_cast<Eigen::Index>(i)) = values[part_[i]];
    }
    for (int step = 0; step < steps; ++step) {
      heartbeat();
      heat = masses_.cwiseProduct(heat).eval();
      if (!solver_.solve(heat)) {
        return;
      }
    }
    for (std::size_t i = 0; i < part_.size(); ++i) {
      values[part_[i]] = static_cast<float>(heat(static_cast<Eigen::Index>(i)));
    }
  }

private:
  void
  addTriangle(const PreparedSurface& surface,
              const Triangle& t,
              const Triangle& inside,
              double time,
              std::vector<Entry>& entries)
  {
    const auto side = [&](std::size_t from, std::size_t to) {
      return surface.points[t[to % 3]] - surface.points[t[from % 3]];
    };
    const double twice_area = norm(cross(side(0, 1), side(0, 2)));
    for (std::size_t k = 0; k < 3; ++k) {
      if (twice_area * settings.thinnest <= dot(side(k, k + 1), side(k, k + 1))) {
        return; // a sliver: it has no area that counts
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = inside[(k + 1) % 3];
      const Index b = inside[(k + 2) % 3];
      const double weight = 0.5 * time * dot(side(k, k + 1), side(k, k + 2)) / twice_area;
      entries.emplace_back(a, b, -weight);
      entries.emplace_back(b, a, -weight);
      entries.emplace_back(a, a, weight);
      entries.emplace_back(b, b, weight);
      masses_(inside[k]) += twice_area / 6.0;
    }
  }

  std::vector<Index> part_;
  Eigen::VectorXd masses_;
  HeatSolver solver_;
};

} // namespace

std::vector<float>
smoothedNearAxis(const PreparedSurface& surface, const std::vector<float>& side_function)
{
  const SignChanges changes = findSignChanges(surface.graph, side_function);
  std::vector<float> values = side_function;
  if (changes.points.empty()) {
    return values;
  }
  const float radius = std::max(settings.edges * changes.edge_length, settings.share);
  const std::vector<float> away = distanceField(surface.graph, changes.points);
  std::vector<Index> near;
  for (std::size_t v = 0; v < away.size(); ++v) {
    if (away[v] <= settings.reach * radius) {
      near.push_back(static_cast<Index>(v));
    }
  }
  // The standard deviation of heat after a time t is the root of 2 t.
  const double time = 0.5 * static_cast<double>(radius) * static_cast<double>(radius) / settings.steps;
  HeatFlow(surface, std::move(near), time).flow(values, settings.steps);
  return values;
}

} // namespace symmetry
} // namespace pcl
