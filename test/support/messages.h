/** \file
 * \brief What calls say when they throw.
 */
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief Message of the exception that a call throws; empty where it throws none. */
template <typename Exception, typename Call>
std::string
messageOf(Call call)
{
  try {
    call();
  }
  catch (const Exception& error) {
    return error.what();
  }
  return {};
}

inline void
expectInMessage(const std::string& message, const std::vector<std::string>& parts)
{
  for (const std::string& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos) << '"' << part << "\" is not in \"" << message << '"';
  }
}

} // namespace test
} // namespace symmetry
} // namespace pcl
