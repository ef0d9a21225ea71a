/** \file
 * \brief Random numbers that are the same on every machine and with every standard library.
 */
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief SplitMix64 (Steele, Lea and Flood 2014 \cite steele2014splittable); the distributions of the header random
 * differ between standard libraries. */
class RandomNumbers {
public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed)
  {
  }

  /** \brief The next 64 bits. */
  std::uint64_t
  next()
  {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t bits = state_;
    bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBULL;
    return bits ^ (bits >> 31U);
  }

  /** \brief Uniform in [0, 1). */
  double
  uniform()
  {
    return static_cast<double>(next() >> 11U) * 0x1.0p-53;
  }

  /** \brief Uniform in [low, high). */
  double
  uniform(double low, double high)
  {
    return low + (high - low) * uniform();
  }

  /** \brief Uniform among 0 ... count - 1; count must not be 0. The bias is below count / 2^64. */
  std::size_t
  index(std::size_t count)
  {
    return static_cast<std::size_t>(next() % count);
  }

  /** \brief Standard normal (Box and Muller). */
  double
  normal()
  {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(6.283185307179586 * uniform());
  }

  /** \brief Puts the items into random order (Fisher and Yates). */
  template <typename Item>
  void
  shuffle(std::vector<Item>& items)
  {
    for (std::size_t i = items.size(); i > 1; --i)
      std::swap(items[i - 1], items[index(i)]);
  }

private:
  std::uint64_t state_;
};

} // namespace symmetry
} // namespace pcl
