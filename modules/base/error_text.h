/** \file
 * \brief What an exception says, for a person.
 */
#pragma once

#include <exception>
#include <string>

namespace pcl {
namespace symmetry {

/** \brief The message of an exception, without the ": " that PCL's exceptions begin with where they name no function.
 */
inline std::string
errorText(const std::exception& error)
{
  const std::string text = error.what();
  return text.compare(0, 2, ": ") == 0 ? text.substr(2) : text;
}

} // namespace symmetry
} // namespace pcl
