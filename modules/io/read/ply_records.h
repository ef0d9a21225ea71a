/** \file
 * \brief The records behind the header of a PLY file, value by value: the same calls for text and binary data.
 */
#pragma once

#include "io/read/ply_header.h"
#include "io/read/surface_builder.h"
#include "io/read/text_scanner.h"

#include <algorithm>
#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Delivers the values of ascii records, one record a line. */
class TextRecords {
public:
  TextRecords(const FileContent& file, const PlyHeader& header) : text_(file, {}, header.end_byte, header.end_line)
  {
  }

  void
  beginRecord()
  {
    text_.needLine("a further record");
  }

  /** \brief Ends a line; \a lenient: what is left of it is passed over and counted. */
  void
  endRecord(bool lenient)
  {
    if (lenient && !text_.atLineEnd()) {
      first_surplus_ = surplus_ == 0 ? text_.line() : first_surplus_;
      ++surplus_;
    }
    else {
      text_.needLineEnd();
    }
  }

  float
  number(ScalarType /*type*/, double origin)
  {
    return text_.numberFrom(origin);
  }

  std::int64_t
  integer(ScalarType /*type*/)
  {
    return text_.integer();
  }

  /** \brief Stores the next number; floats are rounded once. */
  void
  store(ScalarType type, char* to)
  {
    storeScalar(to, type, type == ScalarType::Float32 ? double{text_.number()} : text_.preciseNumber());
  }

  void
  skip(ScalarType /*type*/, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
      text_.number();
  }

  bool
  mayHold(ScalarType /*type*/, std::uint64_t count) const
  {
    return fitsInto(count, 2, text_.remaining());
  }

  void
  finish(std::vector<std::string>& notes)
  {
    if (text_.nextLine())
      text_.fail("unexpected " + quoted(text_.word()) + " behind the last record");
    if (surplus_ > 0)
      notes.push_back("line " + std::to_string(first_surplus_) +
                      ": values behind those that the header announces were " + "passed over, here and in " +
                      std::to_string(surplus_ - 1) + " further lines");
  }

  /** \brief Most records of an element that the rest of the file can hold. */
  std::size_t
  mostRecords(const PlyElement& element) const
  {
    return text_.remaining() / (2 * element.properties.size() + 6); // the least face is "3 0 1 2"
  }

  [[noreturn]] void
  fail(const std::string& reason) const
  {
    text_.fail(reason);
  }

private:
  TextScanner text_;
  std::size_t surplus_ = 0; ///< lines with more values than announced
  std::size_t first_surplus_ = 0;
};

/** \brief Delivers the values of binary records. */
class BinaryRecords {
public:
  BinaryRecords(const FileContent& file, const PlyHeader& header)
      : file_(file), position_(header.end_byte), swap_bytes_(header.format == PlyFormat::BigEndian)
  {
  }

  void
  beginRecord()
  {
  }

  void
  endRecord(bool /*lenient*/)
  {
  }

  float
  number(ScalarType type, double origin)
  {
    return loadFloat(take(type, 1), type, swap_bytes_, origin);
  }

  std::int64_t
  integer(ScalarType type)
  {
    return loadInteger(take(type, 1), type, swap_bytes_);
  }

  void
  store(ScalarType type, char* to)
  {
    char* const end = std::copy_n(take(type, 1), sizeOf(type), to);
    if (swap_bytes_)
      std::reverse(to, end);
  }

  void
  skip(ScalarType type, std::size_t count)
  {
    take(type, count);
  }

  bool
  mayHold(ScalarType type, std::uint64_t count) const
  {
    return fitsInto(count, sizeOf(type), file_.size() - position_);
  }

  std::size_t
  mostRecords(const PlyElement& element) const
  {
    return (file_.size() - position_) / std::max<std::size_t>(element.properties.size(), 4); // three corners of a byte
  }

  void
  finish(std::vector<std::string>& /*notes*/)
  {
    // Bytes behind the last record are padding of some writers.
  }

  /** \brief All records of an element without lists at once.
   * \return one column per property */
  std::vector<ScalarColumn>
  takeColumns(const PlyElement& element)
  {
    std::size_t record_bytes = 0;
    for (const PlyProperty& property : element.properties)
      record_bytes += sizeOf(property.type);
    const char* first = take(ScalarType::UInt8, element.count * record_bytes);
    std::vector<ScalarColumn> columns;
    for (const PlyProperty& property : element.properties) {
      columns.push_back({first, record_bytes, property.type, swap_bytes_});
      first += sizeOf(property.type);
    }
    return columns;
  }

  [[noreturn]] void
  fail(const std::string& reason) const
  {
    file_.failAtByte(position_, reason);
  }

private:
  const char*
  take(ScalarType type, std::size_t count)
  {
    if (!mayHold(type, count))
      file_.failAtByte(file_.size(), "the file ends within a record");
    const char* const bytes = file_.data() + position_;
    position_ += count * sizeOf(type);
    return bytes;
  }

  const FileContent& file_;
  std::size_t position_;
  bool swap_bytes_;
};

} // namespace symmetry
} // namespace pcl
