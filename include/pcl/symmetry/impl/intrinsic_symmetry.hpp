#pragma once

#include <pcl/symmetry/impl/plain_exception.h>
#include <pcl/symmetry/impl/surface_estimation.h>
#include <pcl/symmetry/intrinsic_symmetry.h>

#include <pcl/conversions.h>
#include <pcl/exceptions.h>
#include <pcl/point_types.h>

#include <type_traits>
#include <utility>

namespace pcl {
namespace symmetry {
namespace detail {

/** \brief Normal of a point whose type has one. */
template <typename PointT>
std::enable_if_t<traits::has_normal<PointT>::value>
appendNormal(const PointT& point, std::vector<Vector3>& normals)
{
  normals.push_back({point.normal_x, point.normal_y, point.normal_z});
}

template <typename PointT>
std::enable_if_t<!traits::has_normal<PointT>::value>
appendNormal(const PointT&, std::vector<Vector3>&)
{
}

/** \brief Makes a PCL search answer for plain points. */
template <typename PointT>
std::vector<Index>
searchNeighbours(search::Search<PointT>& search, const std::vector<Vector3>& points, int k)
{
  const auto cloud = make_shared<PointCloud<PointT>>();
  cloud->resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    (*cloud)[i].x = points[i][0];
    (*cloud)[i].y = points[i][1];
    (*cloud)[i].z = points[i][2];
  }
  search.setInputCloud(cloud);
  std::vector<Index> neighbours;
  neighbours.reserve(points.size() * static_cast<std::size_t>(k));
  Indices found;
  std::vector<float> squared_distances;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int count = search.nearestKSearch((*cloud)[i], k, found, squared_distances);
    appendNeighbours(points, k, count, found, squared_distances, neighbours);
  }
  return neighbours;
}

} // namespace detail
} // namespace symmetry

template <typename PointT>
void
IntrinsicSymmetryEstimation<PointT>::setInputCloud(const PointCloudConstPtr& cloud)
{
  PCLBase<PointT>::setInputCloud(cloud);
  triangles_.clear();
  offset_ = {};
}

template <typename PointT>
void
IntrinsicSymmetryEstimation<PointT>::setInputMesh(const PolygonMesh::ConstPtr& mesh)
{
  if (!mesh) {
    throw symmetry::detail::PlainException<BadArgumentException>("setInputMesh: no mesh");
  }
  symmetry::detail::checkLayout(mesh->cloud);
  auto triangles = symmetry::detail::triangulatePolygons(*mesh);
  const auto cloud = make_shared<PointCloud>();
  const auto moved = symmetry::detail::withFloatPositions(mesh->cloud);
  if (!mesh->cloud.data.empty()) {
    fromPCLPointCloud2(moved ? moved->cloud : mesh->cloud, *cloud);
  }
  PCLBase<PointT>::setInputCloud(cloud);
  triangles_ = std::move(triangles);
  offset_ = moved ? moved->offset : std::array<double, 3>{};
}

template <typename PointT>
void
IntrinsicSymmetryEstimation<PointT>::setSearchMethod(const SearchPtr& search)
{
  if (search && search->getName() == "OrganizedNeighbor") {
    throw symmetry::detail::PlainException<BadArgumentException>(
        "setSearchMethod: OrganizedNeighbor searches rasters only");
  }
  search_ = search;
}

template <typename PointT>
void
IntrinsicSymmetryEstimation<PointT>::setKSearch(int k)
{
  symmetry::SymmetryParameters parameters = parameters_;
  parameters.k_search = k;
  setParameters(parameters);
}

template <typename PointT>
void
IntrinsicSymmetryEstimation<PointT>::setMethod(symmetry::Method method)
{
  symmetry::SymmetryParameters parameters = parameters_;
  parameters.method = method;
  setParameters(parameters);
}

template <typename PointT>
void
IntrinsicSymmetryEstimation<PointT>::setParameters(const symmetry::SymmetryParameters& parameters)
{
  symmetry::checkParameters(parameters);
  parameters_ = parameters;
}

template <typename PointT>
symmetry::Surface
IntrinsicSymmetryEstimation<PointT>::inputSurface() const
{
  symmetry::Surface surface;
  surface.points.reserve(input_->size());
  for (const PointT& point : *input_) {
    surface.points.push_back({point.x, point.y, point.z});
    symmetry::detail::appendNormal(point, surface.normals);
  }
  surface.triangles = triangles_;
  surface.offset = offset_;
  return surface;
}

template <typename PointT>
void
IntrinsicSymmetryEstimation<PointT>::compute(IntrinsicSymmetryResult& result)
{
  if (!input_) {
    throw symmetry::detail::PlainException<InitFailedException>(
        "compute: neither setInputCloud nor setInputMesh was called");
  }
  symmetry::detail::NeighbourSearchFunction search;
  if (search_) {
    search = [this](const std::vector<symmetry::Vector3>& points, int k) {
      return symmetry::detail::searchNeighbours(*search_, points, k);
    };
  }
  const bool all_points = !indices_ || fake_indices_;
  const symmetry::Surface surface = inputSurface();
  symmetry::SymmetryResult found = symmetry::detail::estimateSelected(surface, all_points ? nullptr : indices_.get(),
                                                                      parameters_, search, progress_);
  if (name_reference_) {
    name_reference_->nameSides(surface, found, parameters_.threads);
  }
  static_cast<symmetry::SymmetryResult&>(result) = std::move(found);
  result.correspondences.clear();
  for (const symmetry::SymmetricMatch& match : result.matches) {
    result.correspondences.emplace_back(match.source, match.target, match.cost);
  }
}

} // namespace pcl

// NOLINTNEXTLINE(readability-identifier-naming): PCL names these macros so
#define PCL_INSTANTIATE_IntrinsicSymmetryEstimation(T) template class pcl::IntrinsicSymmetryEstimation<T>;
