/** \file
 * \brief Runs of the class on a mesh of a human.
 */
#pragma once

#include "support/known_body.h"
#include "support/pcl_input.h"

#include <pcl/symmetry/intrinsic_symmetry.h>

#include <gtest/gtest.h>

namespace pcl {
namespace symmetry {
namespace test {

inline const pcl::PolygonMesh::Ptr&
humanMesh()
{
  static const pcl::PolygonMesh::Ptr mesh = meshOf(bentHuman().surface);
  return mesh;
}

/** \brief The staged method: a quarter of the robust one's time, and what is tested here is the class. */
inline SymmetryParameters
staged()
{
  SymmetryParameters parameters;
  parameters.method = Method::Staged;
  return parameters;
}

template <typename PointT = pcl::PointXYZ>
pcl::IntrinsicSymmetryResult
compute(const pcl::PolygonMesh::ConstPtr& mesh, const pcl::IndicesPtr& indices = {})
{
  pcl::IntrinsicSymmetryEstimation<PointT> estimation;
  estimation.setParameters(staged());
  estimation.setInputMesh(mesh);
  if (indices) {
    estimation.setIndices(indices);
  }
  pcl::IntrinsicSymmetryResult result;
  estimation.compute(result);
  return result;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
