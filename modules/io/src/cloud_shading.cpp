#include "io/cloud_shading.h"

#include "geodesic/vector_math.h"

#include <Eigen/Eigenvalues>

#include <cstdint>
#include <unordered_map>

namespace pcl {
namespace symmetry {
namespace {

/** \brief Moments of the points of a cell, in cells from the corner of the grid. */
struct Cell {
  double count = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d outer = Eigen::Matrix3d::Zero();
};

using CellKey = std::uint64_t;
using CellMap = std::unordered_map<CellKey, Cell>;

/** \brief Cubic cells; a key holds 21 bits per axis. */
struct Grid {
  Vector3 corner = {0.0F, 0.0F, 0.0F};
  float cell_size = 1.0F;

  Vector3
  toCells(const Vector3& point) const
  {
    return (1.0F / cell_size) * (point - corner);
  }

  CellKey
  key(const Vector3& point) const
  {
    const Vector3 cell = toCells(point);
    return static_cast<CellKey>(cell[0]) << 42 | static_cast<CellKey>(cell[1]) << 21 | static_cast<CellKey>(cell[2]);
  }
};

CellMap
fillCells(const Grid& grid, const std::vector<Vector3>& points)
{
  CellMap cells;
  for (const Vector3& point : points) {
    if (!isFinite(point))
      continue;
    const Vector3 place = grid.toCells(point);
    const Eigen::Vector3d position(place[0], place[1], place[2]);
    Cell& cell = cells[grid.key(point)];
    cell.count += 1.0;
    cell.sum += position;
    cell.outer += position * position.transpose();
  }
  return cells;
}

/** \brief Direction of least spread of a cell's points and those of the 26 cells around it. */
Vector3
normalOfCell(const CellMap& cells, CellKey key)
{
  Cell moments;
  for (std::int64_t x = -1; x <= 1; ++x) {
    for (std::int64_t y = -1; y <= 1; ++y) {
      for (std::int64_t z = -1; z <= 1; ++z) {
        const auto step = static_cast<CellKey>(x * (std::int64_t{1} << 42) + y * (std::int64_t{1} << 21) + z);
        const auto found = cells.find(key + step);
        if (found == cells.end())
          continue;
        moments.count += found->second.count;
        moments.sum += found->second.sum;
        moments.outer += found->second.outer;
      }
    }
  }
  if (moments.count < 3.0)
    return {0.0F, 0.0F, 0.0F};
  const Eigen::Vector3d mean = moments.sum / moments.count;
  const Eigen::Matrix3d covariance = moments.outer / moments.count - mean * mean.transpose();
  const Eigen::Vector3f normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(0).cast<float>();
  return {normal[0], normal[1], normal[2]};
}

} // namespace

CloudShading
estimateCloudShading(const std::vector<Vector3>& points)
{
  CloudShading shading;
  shading.normals.assign(points.size(), Vector3{0.0F, 0.0F, 0.0F});
  Vector3 least = {0.0F, 0.0F, 0.0F};
  Vector3 most = least;
  double count = 0.0;
  for (const Vector3& point : points) {
    if (!isFinite(point))
      continue;
    for (std::size_t i = 0; i < 3; ++i) {
      least[i] = count == 0.0 ? point[i] : std::min(least[i], point[i]);
      most[i] = count == 0.0 ? point[i] : std::max(most[i], point[i]);
    }
    count += 1.0;
  }
  const float extent = distance(least, most);
  if (!(extent > 0.0F) || !std::isfinite(extent))
    return shading;

  // Cells of about four points hold enough of them, with their neighbours, for a normal, and still follow a limb.
  constexpr double points_per_cell = 4.0;
  Grid grid;
  grid.cell_size = std::max(extent / static_cast<float>(std::sqrt(count)), extent * 1e-5F);
  grid.corner = least - Vector3{2.0F * grid.cell_size, 2.0F * grid.cell_size, 2.0F * grid.cell_size};
  CellMap cells = fillCells(grid, points);
  while (count < points_per_cell * static_cast<double>(cells.size()) && grid.cell_size < extent) {
    grid.cell_size *= 1.3F;
    grid.corner = least - Vector3{2.0F * grid.cell_size, 2.0F * grid.cell_size, 2.0F * grid.cell_size};
    cells = fillCells(grid, points);
  }
  // A plane of random direction crosses about 1.5 cells per cell face of its area.
  const double area_per_point = static_cast<double>(cells.size()) / 1.5 / count;
  shading.spacing = grid.cell_size * static_cast<float>(std::sqrt(area_per_point));

  std::unordered_map<CellKey, Vector3> normals;
  for (const auto& entry : cells)
    normals.emplace(entry.first, normalOfCell(cells, entry.first));
  for (std::size_t i = 0; i < points.size(); ++i)
    if (isFinite(points[i]))
      shading.normals[i] = normals.at(grid.key(points[i]));
  return shading;
}

} // namespace symmetry
} // namespace pcl
