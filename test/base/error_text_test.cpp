#include "base/error_text.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace pcl::symmetry;

namespace {

TEST(ErrorText, LeavesOutWhatPclPutsInFrontWithoutAFunction)
{
  EXPECT_EQ(errorText(std::runtime_error(": a.ply: no such file")), "a.ply: no such file");
  EXPECT_EQ(errorText(std::runtime_error("a.ply: no such file")), "a.ply: no such file");
  EXPECT_EQ(errorText(std::runtime_error("")), "");
  EXPECT_EQ(errorText(std::runtime_error(":")), ":");
}

} // namespace
