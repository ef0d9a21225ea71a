/** \file
 * \brief Numbers in binary files: types, byte order, and columns of them.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pcl {
namespace symmetry {

enum class ScalarType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };

/** \brief Bytes of one number. */
std::size_t
sizeOf(ScalarType type);

/** \brief F, I or U, as PointField::kind. */
char
kindOf(ScalarType type);

inline bool
isInteger(ScalarType type)
{
  return type != ScalarType::Float32 && type != ScalarType::Float64;
}

/** \brief One number of type T at any alignment. */
template <typename T>
T
loadScalar(const char* bytes, bool swap_bytes)
{
  char buffer[sizeof(T)];
  std::memcpy(buffer, bytes, sizeof(T));
  if (swap_bytes)
    std::reverse(buffer, buffer + sizeof(T));
  T value;
  std::memcpy(&value, buffer, sizeof(T));
  return value;
}

/** \brief The number at \a bytes less \a origin, rounded to float; a double beyond the range of float becomes
 * infinite. */
float
loadFloat(const char* bytes, ScalarType type, bool swap_bytes, double origin = 0.0);

/** \brief The number at \a bytes; \a type must be an integer. What exceeds std::int64_t becomes its largest value. */
std::int64_t
loadInteger(const char* bytes, ScalarType type, bool swap_bytes);

/** \brief Stores \a value as \a type at any alignment: what an integer cannot hold becomes its nearest, NaN zero. */
void
storeScalar(char* bytes, ScalarType type, double value);

/** \brief Numbers of one type at equal distances in memory. */
struct ScalarColumn {
  const char* first = nullptr; ///< nullptr: there is no such column
  std::size_t stride = 0;      ///< bytes from one number to the next
  ScalarType type = ScalarType::Float32;
  bool swap_bytes = false;
};

/** \brief Copies the first vectors.size() numbers of a column, less \a origin, into component \a component of
 * \a vectors. */
void
copyColumn(const ScalarColumn& column, std::size_t component, std::vector<Vector3>& vectors, double origin = 0.0);

} // namespace symmetry
} // namespace pcl
