/** \file
 * \brief Compares two results to the last bit.
 */
#pragma once

#include <pcl/symmetry/symmetry_result.h>

#include <gtest/gtest.h>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief Fails where anything that is delivered differs. */
inline void
expectSameBytes(const SymmetryResult& a, const SymmetryResult& b)
{
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.message, b.message);
  EXPECT_EQ(a.confidence, b.confidence);
  EXPECT_EQ(a.partners, b.partners);
  EXPECT_EQ(a.confidences, b.confidences);
  EXPECT_EQ(a.sides, b.sides);
  EXPECT_EQ(a.regions, b.regions);
  EXPECT_EQ(a.support, b.support);
  EXPECT_EQ(a.extremities, b.extremities);
  EXPECT_EQ(a.diameter, b.diameter);
  EXPECT_EQ(a.map.involution, b.map.involution);
  EXPECT_EQ(a.map.inverted_faces, b.map.inverted_faces);
  EXPECT_EQ(a.map.torn_faces, b.map.torn_faces);
  EXPECT_EQ(a.map.isometry_error, b.map.isometry_error);
  ASSERT_EQ(a.axis.size(), b.axis.size());
  for (std::size_t i = 0; i < a.axis.size(); ++i) {
    EXPECT_EQ(a.axis[i].points, b.axis[i].points);
    EXPECT_EQ(a.axis[i].closed, b.axis[i].closed);
    ASSERT_EQ(a.axis[i].curve.size(), b.axis[i].curve.size());
    for (std::size_t k = 0; k < a.axis[i].curve.size(); ++k) {
      EXPECT_EQ(a.axis[i].curve[k].position, b.axis[i].curve[k].position);
      EXPECT_EQ(a.axis[i].curve[k].across, b.axis[i].curve[k].across);
    }
  }
  ASSERT_EQ(a.matches.size(), b.matches.size());
  for (std::size_t i = 0; i < a.matches.size(); ++i) {
    EXPECT_EQ(a.matches[i].source, b.matches[i].source);
    EXPECT_EQ(a.matches[i].target, b.matches[i].target);
    EXPECT_EQ(a.matches[i].midpoint, b.matches[i].midpoint);
    EXPECT_EQ(a.matches[i].cost, b.matches[i].cost);
  }
}

} // namespace test
} // namespace symmetry
} // namespace pcl
