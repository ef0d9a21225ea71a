#include "io/read/scalar_type.h"

#include <limits>

namespace pcl {
namespace symmetry {
namespace {

/** \brief Calls visit with a zero of the C++ type that \a type stands for. */
template <typename Visitor>
auto
visitType(ScalarType type, Visitor visit)
{
  switch (type) {
  case ScalarType::Int8:
    return visit(std::int8_t{});
  case ScalarType::UInt8:
    return visit(std::uint8_t{});
  case ScalarType::Int16:
    return visit(std::int16_t{});
  case ScalarType::UInt16:
    return visit(std::uint16_t{});
  case ScalarType::Int32:
    return visit(std::int32_t{});
  case ScalarType::UInt32:
    return visit(std::uint32_t{});
  case ScalarType::Int64:
    return visit(std::int64_t{});
  case ScalarType::UInt64:
    return visit(std::uint64_t{});
  case ScalarType::Float32:
    return visit(float{});
  default:
    return visit(double{});
  }
}

/** \brief \a value less \a origin, subtracted before it is rounded. */
template <typename Number>
float
relativeTo(double origin, Number value)
{
  return origin == 0.0 ? static_cast<float>(value) : static_cast<float>(static_cast<double>(value) - origin);
}

} // namespace

std::size_t
sizeOf(ScalarType type)
{
  return visitType(type, [](auto zero) { return sizeof(zero); });
}

char
kindOf(ScalarType type)
{
  return visitType(type, [](auto zero) {
    using Limits = std::numeric_limits<decltype(zero)>;
    return !Limits::is_integer ? 'F' : Limits::is_signed ? 'I' : 'U';
  });
}

void
storeScalar(char* bytes, ScalarType type, double value)
{
  visitType(type, [=](auto zero) {
    using Number = decltype(zero);
    Number number = 0;
    if constexpr (!std::numeric_limits<Number>::is_integer)
      number = static_cast<Number>(value);
    else if (value >= static_cast<double>(std::numeric_limits<Number>::max()))
      number = std::numeric_limits<Number>::max();
    else if (value <= static_cast<double>(std::numeric_limits<Number>::min()))
      number = std::numeric_limits<Number>::min();
    else if (value == value)
      number = static_cast<Number>(value);
    std::memcpy(bytes, &number, sizeof(number));
  });
}

float
loadFloat(const char* bytes, ScalarType type, bool swap_bytes, double origin)
{
  return visitType(type, [=](auto zero) { return relativeTo(origin, loadScalar<decltype(zero)>(bytes, swap_bytes)); });
}

std::int64_t
loadInteger(const char* bytes, ScalarType type, bool swap_bytes)
{
  return visitType(type, [=](auto zero) {
    const auto value = loadScalar<decltype(zero)>(bytes, swap_bytes);
    if constexpr (sizeof(value) == 8 && std::numeric_limits<decltype(zero)>::is_integer &&
                  !std::numeric_limits<decltype(zero)>::is_signed) {
      constexpr auto largest = std::numeric_limits<std::int64_t>::max();
      return value > static_cast<std::uint64_t>(largest) ? largest : static_cast<std::int64_t>(value);
    }
    else {
      return static_cast<std::int64_t>(value);
    }
  });
}

void
copyColumn(const ScalarColumn& column, std::size_t component, std::vector<Vector3>& vectors, double origin)
{
  visitType(column.type, [&](auto zero) {
    const char* bytes = column.first;
    for (Vector3& vector : vectors) {
      vector[component] = relativeTo(origin, loadScalar<decltype(zero)>(bytes, column.swap_bytes));
      bytes += column.stride;
    }
  });
}

} // namespace symmetry
} // namespace pcl
