#include "picture/cloud_shading.h"

#include "base/vector_math.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
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

/** \brief What the points of one cell are drawn with. */
struct CellShading {
  Vector3 normal = {0.0F, 0.0F, 0.0F};
  float spacing = 0.0F;
};

/** \brief Direction of least spread and spacing of the points of a cell and of the 26 cells around it. */
CellShading
shadeCell(const CellMap& cells, CellKey key, float cell_size)
{
  Cell moments;
  double occupied = 0.0;
  for (std::int64_t x = -1; x <= 1; ++x) {
    for (std::int64_t y = -1; y <= 1; ++y) {
      for (std::int64_t z = -1; z <= 1; ++z) {
        const auto step = static_cast<CellKey>(x * (std::int64_t{1} << 42) + y * (std::int64_t{1} << 21) + z);
        const auto found = cells.find(key + step);
        if (found == cells.end())
          continue;
        occupied += 1.0;
        moments.count += found->second.count;
        moments.sum += found->second.sum;
        moments.outer += found->second.outer;
      }
    }
  }
  // A plane of random direction crosses about 1.5 cells per cell face of its area.
  CellShading shading;
  shading.spacing = cell_size * static_cast<float>(std::sqrt(occupied / 1.5 / moments.count));
  if (moments.count < 3.0)
    return shading;
  const Eigen::Vector3d mean = moments.sum / moments.count;
  const Eigen::Matrix3d covariance = moments.outer / moments.count - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3f normal = solver.eigenvectors().col(0).cast<float>();
  shading.normal = {normal[0], normal[1], normal[2]};
  return shading;
}

/** \brief Corners of the box around all finite points. */
struct Box {
  Vector3 least = {0.0F, 0.0F, 0.0F};
  Vector3 most = {0.0F, 0.0F, 0.0F};
  std::size_t points = 0;
};

Box
boundingBox(const std::vector<Vector3>& points)
{
  Box box;
  for (const Vector3& point : points) {
    if (!isFinite(point))
      continue;
    for (std::size_t i = 0; i < 3; ++i) {
      box.least[i] = box.points == 0 ? point[i] : std::min(box.least[i], point[i]);
      box.most[i] = box.points == 0 ? point[i] : std::max(box.most[i], point[i]);
    }
    ++box.points;
  }
  return box;
}

Grid
makeGrid(const Box& box, float cell_size)
{
  const float margin = 2.0F * cell_size; // keeps the cells around all points at numbers from 0
  return {box.least - Vector3{margin, margin, margin}, cell_size};
}

} // namespace

CloudShading
estimateCloudShading(const std::vector<Vector3>& points)
{
  CloudShading shading;
  shading.normals.assign(points.size(), Vector3{0.0F, 0.0F, 0.0F});
  shading.spacings.assign(points.size(), 0.0F);
  const Box box = boundingBox(points);
  const float extent = distance(box.least, box.most);
  if (!(extent > 0.0F) || !std::isfinite(extent))
    return shading;

  // Cells of about four points hold enough of them, with their neighbours, for a normal, and still follow a limb.
  constexpr std::size_t points_per_cell = 4;
  Grid grid = makeGrid(box, extent * std::max(1.0F / std::sqrt(static_cast<float>(box.points)), 1e-5F));
  CellMap cells = fillCells(grid, points);
  while (box.points < points_per_cell * cells.size() && grid.cell_size < extent) {
    grid = makeGrid(box, 1.3F * grid.cell_size);
    cells = fillCells(grid, points);
  }

  std::unordered_map<CellKey, CellShading> shadings;
  for (const auto& entry : cells)
    shadings.emplace(entry.first, shadeCell(cells, entry.first, grid.cell_size));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!isFinite(points[i]))
      continue;
    const CellShading& cell = shadings.at(grid.key(points[i]));
    shading.normals[i] = cell.normal;
    shading.spacings[i] = cell.spacing;
  }
  return shading;
}

} // namespace symmetry
} // namespace pcl
