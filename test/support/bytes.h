/** \file
 * \brief Content of binary files.
 */
#pragma once

#include <cstring>
#include <string>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief The bytes of numbers, one after the other, in this machine's byte order or the other one. */
class Bytes {
public:
  explicit Bytes(bool big_endian = false) : big_endian_(big_endian)
  {
  }

  template <typename... Numbers>
  Bytes&
  add(Numbers... numbers)
  {
    (append(numbers), ...);
    return *this;
  }

  const std::string&
  str() const
  {
    return bytes_;
  }

private:
  template <typename Number>
  void
  append(Number number)
  {
    std::string bytes(sizeof(number), '\0');
    std::memcpy(bytes.data(), &number, sizeof(number));
    bytes_ += big_endian_ ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
  }

  bool big_endian_;
  std::string bytes_;
};

} // namespace test
} // namespace symmetry
} // namespace pcl
