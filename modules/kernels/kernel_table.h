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

/** \brief Rows of min_plus are a multiple of this. */
constexpr std::size_t min_plus_rows = 4;

struct KernelTable {
  /** \brief For each of kernel_queries vectors the target t of the least half_norm (t) - target (t) . query.
   *
   * The product is summed up in the order of the coordinates; ties go to the lowest target. With half the
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

  /** \brief Lowers result (i, j) to the least left (k, i) + right (k, j) over all k < depth, where that is less.
   *
   * The product of matrices over the (min, +) semiring. Entry (r, c) of a matrix is [r * stride + c].
   * \param[in,out] result rows x columns; overlaps with no operand
   * \param[in] left depth x rows: the transpose of the left factor
   * \param[in] right depth x columns
   * \param[in] rows a multiple of min_plus_rows
   *
   * \param[in] columns a multiple of kernel_lanes */
  void (*min_plus)(float* result,
                   std::size_t result_stride,
                   const float* left,
                   std::size_t left_stride,
                   const float* right,
                   std::size_t right_stride,
                   std::size_t rows,
                   std::size_t depth,
                   std::size_t columns);

  /** \brief As min_plus, with row picked[k] of \a right as its row k; the strides of \a right and \a result are the
   * number of columns. */
  void (*min_plus_picked)(float* result,
                          const float* left,
                          std::size_t left_stride,
                          const float* right,
                          const std::uint32_t* picked,
                          std::size_t rows,
                          std::size_t depth,
                          std::size_t columns);

  /** \brief Shortest paths between all pairs of kernel_lanes vertices from the lengths of their edges, in place
   * (R. W. Floyd: Algorithm 97, shortest path. CACM 5(6), 1962 \cite floyd1962algorithm). Entries are not negative. */
  void (*close_tile)(float* tile, std::size_t stride);

  /** \brief Writes entry j of rows[i] to entry i of columns[j], for all i and j below kernel_lanes. */
  void (*transpose_tile)(const float* const* rows, float* const* columns);

  /** \brief For each candidate the sum over all i of ((query_i - candidate_i) weight_i)^2.
   *
   * Added up in kernel_lanes interleaved sums, these by halves. Rounding is monotone: where every difference is
   * smaller, so is the sum.
   *
   * \param[in] candidates count x padded
   *
   * \param[in] padded number of features, a multiple of
   * kernel_lanes
   *
   * \param[out] distances count values */
  void (*weighted_distances)(const float* query,
                             const float* candidates,
                             std::size_t count,
                             const float* weights,
                             std::size_t padded,
                             float* distances);

  /** \brief The same to the nearest point of each box [lower, upper]: a lower bound of the distance to whatever is in
   * it, even after rounding. */
  void (*weighted_box_distances)(const float* query,
                                 const float* lower,
                                 const float* upper,
                                 std::size_t count,
                                 const float* weights,
                                 std::size_t padded,
                                 float* distances);

  /** \brief Moments of the points in a ball, or where a slab meets it, about its centre.
   *
   * A point at the offset x from the centre, in radii, has the weight (1 - |x|^2)^2 (1 - (x . normal)^2)^2, or none
   * where either factor would be the square of a negative number. Each moment is added up in kernel_lanes interleaved
   * sums, these by halves.
   *
   * \param[in] points the x, then the y, then the z of all, padded of each
   * \param[in] padded a multiple of kernel_lanes
   * \param[in] centre three coordinates
   * \param[in] normal of the slab, over half its thickness in radii; 0: no slab
   * \param[out] moments sums of the weights, of x, y, z, and of xx, xy, xz, yy, yz, zz, each times the weight */
  void (*slab_moments)(
      const float* points, std::size_t padded, const float* centre, float radius, const float* normal, float* moments);
};

/** \brief Number of moments that slab_moments gives. */
constexpr std::size_t slab_moment_count = 10;

} // namespace symmetry
} // namespace pcl
