/** \file
 * \brief The inner loops that are compiled once per instruction set, as a table of functions.
 *
 * Only plain pointers pass through here: what is compiled for wider vectors than the baseline must not see a template
 * of the standard library or of Eigen, whose copies the linker would merge with those of everyone else. Every function
 * gives the same bits on every instruction set: the operations of one result are the same and in the same order, only
 * how many results are worked on at a time differs, and a product is never fused with a sum.
 */
#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl {
namespace symmetry {

/** \brief Width of the blocks in which data is handed to kernels: the floats of the widest vector register. */
constexpr std::size_t kernel_lanes = 16;

/** \brief Queries that nearest_rows takes at a time. */
constexpr std::size_t kernel_queries = 12;

struct KernelTable {
  /** \brief For each of kernel_queries vectors the target t of the least half_norm (t) - target (t) . query.
   *
   * The difference is formed as ((half_norm - t_0 q_0) - t_1 q_1) - ...; ties go to the lowest target. With half the
   * squared norms of the targets this is the target at the least Euclidean distance.
   * \param[in] queries dimensions x kernel_queries: coordinate d of query q is entry [d * kernel_queries + q]
   * \param[in] targets blocks x dimensions x kernel_lanes: coordinate d of target t is entry
   *            [((t / kernel_lanes) * dimensions + d) * kernel_lanes + t % kernel_lanes]
   * \param[in] half_norms blocks x kernel_lanes; infinite where a block has no target
   * \param[out] nearest kernel_queries numbers of targets */
  void (*nearest_rows)(const float* queries,
                       const float* targets,
                       const float* half_norms,
                       std::size_t blocks,
                       std::size_t dimensions,
                       std::int32_t* nearest);
};

} // namespace symmetry
} // namespace pcl
