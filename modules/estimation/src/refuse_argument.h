/** \file
 * \brief How this module refuses what a caller passed.
 */
#pragma once

#include <pcl/symmetry/impl/plain_exception.h>

#include <pcl/exceptions.h>

#include <sstream>

namespace pcl {
namespace symmetry {

/** \brief Throws a BadArgumentException whose message is all parts in a row.
 *
 * Without the function and source file that PCL_THROW_EXCEPTION puts in front: programs show the message to people.
 */
template <typename... Parts>
[[noreturn]] void
refuseArgument(const Parts&... parts)
{
  std::ostringstream message;
  (message << ... << parts);
  throw detail::PlainException<BadArgumentException>(message.str());
}

} // namespace symmetry
} // namespace pcl
