/** \file
 * \brief PCL's exceptions without what PCL puts before their texts; not for direct use.
 */
#pragma once

namespace pcl {
namespace symmetry {
namespace detail {

/** \brief One of PCL's exceptions that says its text and nothing else: PCL begins with ": " where no function is named.
 */
template <typename Exception>
class PlainException : public Exception {
public:
  using Exception::Exception;

  const char*
  what() const noexcept override
  {
    const char* const text = Exception::what();
    return text[0] == ':' && text[1] == ' ' ? text + 2 : text;
  }
};

} // namespace detail
} // namespace symmetry
} // namespace pcl
