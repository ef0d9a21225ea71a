/** \file
 * \brief The surfaces on which the steps are timed: generated humans, grown once for each size.
 */
#pragma once

#include "symmetry/samples/sampled_surface.h"
#include "symmetry/surface/prepared_surface.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace pcl {
namespace symmetry {
namespace performance {

/** \brief A human with its true partners, prepared. */
struct Human {
  Surface input;
  std::vector<Index> partners;
  PreparedSurface surface;
};

/** \brief A human of so many vertices. */
const Human&
human(std::int64_t vertices);

/** \brief What the robust method works on, with its default settings and one thread. */
const SampledSurface&
sampledHuman(std::int64_t vertices);

/** \brief Numbers of vertices that every step is timed at. */
inline void
onAllSizes(benchmark::internal::Benchmark* step)
{
  step->ArgName("vertices")->Arg(12500)->Arg(27000)->Arg(52000)->Arg(60000)->Unit(benchmark::kMillisecond);
}

} // namespace performance
} // namespace symmetry
} // namespace pcl
