/** \file
 * \brief One vector register of the instruction set that the including file is compiled for.
 *
 * Vectors wider than the register would be taken apart into scalars: hence the native width, not kernel_lanes.
 */
#pragma once

#include <cstddef>
#include <cstdint>

namespace {

#if defined(__AVX512F__)
constexpr std::size_t lane_count = 16;
#elif defined(__AVX2__)
constexpr std::size_t lane_count = 8;
#else
constexpr std::size_t lane_count = 4;
#endif

using Lanes = float __attribute__((vector_size(lane_count * sizeof(float))));
using IndexLanes = std::int32_t __attribute__((vector_size(lane_count * sizeof(std::int32_t))));

// Loads and stores make no demand on alignment: a copy becomes one instruction. A type of vectors that asks for less
// alignment is no way, clang forgets about it when it stores.

inline Lanes
load(const float* from)
{
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

inline void
store(float* to, Lanes lanes)
{
  __builtin_memcpy(to, &lanes, sizeof lanes);
}

inline Lanes
broadcast(float value)
{
  return value - Lanes{};
}

inline IndexLanes
broadcast(std::int32_t value)
{
  return value - IndexLanes{};
}

// Four lanes, which every instruction set has.

using FourLanes = float __attribute__((vector_size(4 * sizeof(float))));

inline FourLanes
loadFour(const float* from)
{
  FourLanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

inline void
storeFour(float* to, FourLanes lanes)
{
  __builtin_memcpy(to, &lanes, sizeof lanes);
}

} // namespace
