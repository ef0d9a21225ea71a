/** \file
 * \brief The PCL class; the header most users include.
 */
#pragma once

#include <pcl/symmetry/export.h>
#include <pcl/symmetry/name_reference.h>
#include <pcl/symmetry/symmetry.h>

#include <pcl/PolygonMesh.h>
#include <pcl/correspondence.h>
#include <pcl/memory.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>
#include <pcl/search/search.h>

#include <array>
#include <memory>
#include <type_traits>
#include <vector>

// Eigen built for wider vectors lays out and allocates differently from the Eigen inside the distribution's libpcl:
// buffers that cross from one to the other crash. Better refused here than found out there.
#if !defined(PCL_SYMMETRY_ANY_ALIGNMENT) && (EIGEN_DEFAULT_ALIGN_BYTES != 16 || EIGEN_MALLOC_ALREADY_ALIGNED != 1)
#error                                                                                                                 \
    "This build's Eigen is not aligned as libpcl's (-march=native, -mavx?). Define PCL_SYMMETRY_ANY_ALIGNMENT if your PCL was built the same way."
#endif

namespace pcl {
namespace symmetry {
namespace detail {

template <typename PointT, typename... Others>
constexpr bool is_one_of = (std::is_same<PointT, Others>::value || ...);

/** \brief Whether the library holds the class for this type of points. */
template <typename PointT>
constexpr bool is_precompiled = is_one_of<PointT,
                                          PointXYZ,
                                          PointXYZI,
                                          PointXYZL,
                                          PointXYZRGB,
                                          PointXYZRGBA,
                                          PointXYZRGBL,
                                          PointNormal,
                                          PointXYZINormal,
                                          PointXYZRGBNormal>;

} // namespace detail
} // namespace symmetry

/** \brief Result of IntrinsicSymmetryEstimation::compute (). */
struct IntrinsicSymmetryResult : public symmetry::SymmetryResult {
  /** \brief The sparse matches as PCL's type: query is the source, match the target, distance the cost (no unit, not
   * squared). */
  pcl::Correspondences correspondences;
};

/** \brief Estimates the global intrinsic reflective symmetry of a triangle mesh or of a point cloud without faces.
 *
 * The symmetric map sends every point to its mirror partner (left hand to right hand) whatever the pose. On a mesh
 * distances run along its edges, on a cloud along the edges of a k-nearest-neighbour graph.
 *
 * \code
 * pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
 * estimation.setInputMesh (mesh);            // or setInputCloud (cloud)
 * pcl::IntrinsicSymmetryResult result;
 * estimation.compute (result);
 * if (pcl::symmetry::hasMap (result.status))
 *   std::cout << "the partner of point 0 is " << result.partners[0] << '\n';
 * \endcode
 *
 * Points that are not finite, not among the indices, of a mesh on no face, or not on the largest object (whose parts
 * touch or lie close) take no part: their partner is -1, their side Side::None. Of points at one place the first stands
 * for all. Indices of the result always refer to the input. The same input and parameters give the same bytes for any number of threads. One object must not be used from
 * two threads at a time.
 *
 * The class is instantiated for PointXYZ, PointXYZI, PointXYZL, PointXYZRGB, PointXYZRGBA, PointXYZRGBL, PointNormal,
 * PointXYZINormal and PointXYZRGBNormal; for other types define PCL_NO_PRECOMPILE before including this header.
 * \ingroup symmetry
 */
template <typename PointT>
class IntrinsicSymmetryEstimation : public PCLBase<PointT> {
  static_assert(traits::has_xyz<PointT>::value,
                "IntrinsicSymmetryEstimation needs points with x, y and z, registered as PCL's point types are");
#ifndef PCL_NO_PRECOMPILE
  static_assert(symmetry::detail::is_precompiled<PointT>,
                "IntrinsicSymmetryEstimation is not precompiled for this point type: define PCL_NO_PRECOMPILE before "
                "including its header");
#endif

public:
  /** \brief Shared pointer to an estimation. */
  using Ptr = shared_ptr<IntrinsicSymmetryEstimation<PointT>>;
  /** \brief Shared pointer to an estimation that is not changed. */
  using ConstPtr = shared_ptr<const IntrinsicSymmetryEstimation<PointT>>;
  using typename PCLBase<PointT>::PointCloud;
  using typename PCLBase<PointT>::PointCloudConstPtr;
  /** \brief Shared pointer to a neighbour search. */
  using SearchPtr = typename search::Search<PointT>::Ptr;

  /** \brief Sets a point cloud without faces; forgets a mesh.
   * \param[in] cloud may be organised and hold non-finite points, whatever is_dense says */
  void
  setInputCloud(const PointCloudConstPtr& cloud) override;

  /** \brief Sets a mesh; its points become the input cloud, polygons become triangle fans.
   * Of double positions far from the origin, as map coordinates are, an offset is subtracted, see getInputOffset ().
   * \param[in] mesh its cloud has float fields x, y, z, or double ones
   * \throws pcl::BadArgumentException no mesh, no float or double x y z, bytes that are not laid out as fields, sizes and steps
   * say, or a polygon refers to a point that is not there; the earlier input stays */
  void
  setInputMesh(const PolygonMesh::ConstPtr& mesh);

  /** \brief What setInputMesh () subtracted from double positions, zero otherwise: places of the result, as those of its
   * axis, are by so much nearer to the origin than the mesh; its mirror plane is that of the mesh. */
  const std::array<double, 3>&
  getInputOffset() const
  {
    return offset_;
  }

  /** \brief Search for the neighbours of a cloud's points; default: a kd-tree (FLANN).
   *
   * compute () sets its input cloud again and again: to the usable points, moved, scaled and in no raster. What it
   * throws leaves compute (); answers with more neighbours than were asked for, or with none of the points, are refused
   * there.
   * \throws pcl::BadArgumentException a search that needs a raster (search::OrganizedNeighbor) */
  void
  setSearchMethod(const SearchPtr& search);

  /** \brief The search that was set; null: the default. */
  SearchPtr
  getSearchMethod() const
  {
    return search_;
  }

  /** \brief Neighbours of a point in the graph of a cloud, [3, 256], default 10.
   * \throws pcl::BadArgumentException */
  void
  setKSearch(int k);

  /** \brief Neighbours of a point in the graph of a cloud. */
  int
  getKSearch() const
  {
    return parameters_.k_search;
  }

  /** \brief Worker threads, 0: all cores (default); the result does not depend on it. */
  void
  setNumberOfThreads(unsigned threads)
  {
    parameters_.threads = threads;
  }

  /** \brief Worker threads, 0: all cores. */
  unsigned
  getNumberOfThreads() const
  {
    return parameters_.threads;
  }

  /** \brief Robust (default), or the published staged matching.
   * \throws pcl::BadArgumentException neither of them */
  void
  setMethod(symmetry::Method method);

  /** \brief The method that is in force. */
  symmetry::Method
  getMethod() const
  {
    return parameters_.method;
  }

  /** \brief All parameters at once, those with a setter of their own as well: start from getParameters ().
   * \throws pcl::BadArgumentException one is out of its range */
  void
  setParameters(const symmetry::SymmetryParameters& parameters);

  /** \brief All parameters that are in force. */
  const symmetry::SymmetryParameters&
  getParameters() const
  {
    return parameters_;
  }

  /** \brief Names the sides as a reference does; null (default): by the shape alone, see SymmetryResult::sides.
   *
   * compute () then throws pcl::BadArgumentException where there is no dense map (sparse_only). */
  void
  setNameReference(const std::shared_ptr<const symmetry::NameReference>& reference)
  {
    name_reference_ = reference;
  }

  /** \brief The reference that was set; null: none. */
  std::shared_ptr<const symmetry::NameReference>
  getNameReference() const
  {
    return name_reference_;
  }

  /** \brief Called as each step starts and several times a second; returning false cancels, an exception of it leaves
   * compute () with the result as it was. */
  void
  setProgressCallback(const symmetry::ProgressCallback& callback)
  {
    progress_ = callback;
  }

  /** \brief Runs the estimation.
   * \param[out] result replaced as a whole; its status tells an outcome of the data (no symmetry, too few points,
   * cancelled)
   *
   * \throws pcl::InitFailedException no input was set
   *
   * \throws pcl::BadArgumentException an index is out of range or given twice, or given normals are asked for and there
   * are none
   */
  void
  compute(IntrinsicSymmetryResult& result);

protected:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;
  using PCLBase<PointT>::fake_indices_;

private:
  symmetry::Surface
  inputSurface() const;

  symmetry::SymmetryParameters parameters_;
  symmetry::ProgressCallback progress_;
  SearchPtr search_;
  std::shared_ptr<const symmetry::NameReference> name_reference_;
  std::vector<symmetry::Triangle> triangles_;
  std::array<double, 3> offset_{};
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/symmetry/impl/intrinsic_symmetry.hpp>
#else
namespace pcl {
extern template class PCL_SYMMETRY_EXPORTS IntrinsicSymmetryEstimation<PointXYZ>;
extern template class PCL_SYMMETRY_EXPORTS IntrinsicSymmetryEstimation<PointXYZI>;
extern template class PCL_SYMMETRY_EXPORTS IntrinsicSymmetryEstimation<PointXYZL>;
extern template class PCL_SYMMETRY_EXPORTS IntrinsicSymmetryEstimation<PointXYZRGB>;
extern template class PCL_SYMMETRY_EXPORTS IntrinsicSymmetryEstimation<PointXYZRGBA>;
extern template class PCL_SYMMETRY_EXPORTS IntrinsicSymmetryEstimation<PointXYZRGBL>;
extern template class PCL_SYMMETRY_EXPORTS IntrinsicSymmetryEstimation<PointNormal>;
extern template class PCL_SYMMETRY_EXPORTS IntrinsicSymmetryEstimation<PointXYZINormal>;
extern template class PCL_SYMMETRY_EXPORTS IntrinsicSymmetryEstimation<PointXYZRGBNormal>;
} // namespace pcl
#endif
