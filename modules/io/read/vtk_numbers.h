/** \file
 * \brief Words and arrays of numbers of a VTK file of the legacy form.
 */
#pragma once

#include "io/read/file_content.h"
#include "io/read/scalar_type.h"
#include "io/read/text_scanner.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A file whose lines of words are followed by numbers, as text or in binary, then big-endian.
 *
 * A count is checked against the bytes that are left before there is memory for it. All functions throw pcl::IOException. */
class VtkNumbers {
public:
  /** \param[in] file referred to */
  explicit VtkNumbers(const FileContent& file) : file_(file)
  {
    text_.emplace(file_);
  }

  /** \brief The words; another scanner after numbers have been read. */
  TextScanner&
  text()
  {
    return *text_;
  }

  void
  setBinary(bool is_binary)
  {
    is_binary_ = is_binary;
  }

  /** \brief The next word of the line as a number of points, faces or values. */
  std::size_t
  readCount();

  /** \brief The next word of the line as the type of numbers. */
  ScalarType
  readType();

  /** \brief Numbers below the line, three for each point.
   * \param[in] origin is subtracted */
  std::vector<Vector3>
  readPoints(std::size_t count, ScalarType type, const std::array<double, 3>& origin);

  /** \brief Integers below the line. \param[in] type in a binary file */
  std::vector<std::int64_t>
  readIntegers(std::size_t count, ScalarType type);

  /** \brief Integers below a line of a keyword and their type, as from version 5 on. */
  std::vector<std::int64_t>
  readNamedIntegers(const char* name, std::size_t count);

  /** \brief Passes over numbers below the line. */
  void
  passOver(std::size_t count, ScalarType type);

private:
  ScalarColumn
  takeBinary(std::size_t count, ScalarType type);

  void
  expectText(std::size_t count);

  void
  toNumber();

  const FileContent& file_;
  std::optional<TextScanner> text_;
  bool is_binary_ = false;
};

} // namespace symmetry
} // namespace pcl
