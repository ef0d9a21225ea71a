#include "base/coincident_points.h"

#include <cstdint>
#include <cstring>

namespace pcl {
namespace symmetry {
namespace {

std::uint64_t
hashOf(const Vector3& p)
{
  constexpr std::uint64_t odd = 0x9E3779B97F4A7C15ULL; // 2^64 over the golden ratio (Knuth, TAOCP 3, section 6.4)
  std::uint64_t hash = 0;
  for (const float coordinate : p) {
    const float without_sign_of_zero = coordinate + 0.0F;
    std::uint32_t bits = 0;
    std::memcpy(&bits, &without_sign_of_zero, sizeof bits);
    hash = (hash ^ bits) * odd;
    hash ^= hash >> 32U;
  }
  return hash;
}

} // namespace

std::vector<Index>
firstCoincident(const std::vector<Vector3>& points)
{
  std::size_t slots = 2;
  while (slots < 2 * points.size()) {
    slots *= 2;
  }
  std::vector<Index> table(slots, no_index); // open addressing, the next slot where one is taken
  std::vector<Index> first(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    std::size_t slot = hashOf(points[v]) & (slots - 1);
    while (table[slot] != no_index && points[table[slot]] != points[v]) {
      slot = (slot + 1) & (slots - 1);
    }
    if (table[slot] == no_index) {
      table[slot] = static_cast<Index>(v);
    }
    first[v] = table[slot];
  }
  return first;
}

} // namespace symmetry
} // namespace pcl
