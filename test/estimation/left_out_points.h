/** \file
 * \brief What results say of points that take no part.
 */
#pragma once

#include <pcl/symmetry/symmetry_result.h>

#include <gtest/gtest.h>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief That a point took no part. */
inline void
expectNothingAbout(const SymmetryResult& result, std::size_t v)
{
  EXPECT_EQ(result.partners[v], no_index);
  EXPECT_EQ(result.confidences[v], 0.0F);
  EXPECT_EQ(result.sides[v], Side::None);
  EXPECT_EQ(result.regions[v], Region::None);
}

} // namespace test
} // namespace symmetry
} // namespace pcl
