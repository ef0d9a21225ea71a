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

  /** \brief Integers below a line of a keyword and their type, as from version 5 on; METADATA may come before. */
  std::vector<std::int64_t>
  readNamedIntegers(const char* name, std::size_t count);

  /** \brief Passes over an array whose name has just been read: of numbers of any type, of bits or of strings.
   * \return its number of components */
  std::size_t
  passOverArray();

  /** \brief Passes over what VTK writes behind an array, the line of METADATA having been read: names of its components
   * and a list of keys. An empty line ends it.
   * \param[in] components of the array: each has a line, empty where the component has no name */
  void
  passOverMetadata(std::size_t components);

private:
  ScalarType
  typeOf(std::string_view name) const;

  void
  passOver(std::size_t count, ScalarType type);

  void
  passOverStrings(std::size_t count);

  void
  goTo(std::size_t byte);

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
