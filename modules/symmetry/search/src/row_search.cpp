#include "symmetry/search/row_search.h"

#include "base/parallel.h"
#include "kernels/kernels.h"

#include <algorithm>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

std::size_t
blocksOf(std::size_t count, std::size_t size)
{
  return (count + size - 1) / size;
}

} // namespace

RowSearch::RowSearch(const Eigen::MatrixXf& targets)
    : dimensions_(targets.cols()),
      half_norms_(blocksOf(static_cast<std::size_t>(targets.rows()), kernel_lanes) * kernel_lanes,
                  std::numeric_limits<float>::infinity())
{
  const auto count = static_cast<std::size_t>(targets.rows());
  const auto dimensions = static_cast<std::size_t>(dimensions_);
  targets_.assign(half_norms_.size() * dimensions, 0.0F);
  std::fill_n(half_norms_.begin(), count, 0.0F);
  for (std::size_t d = 0; d < dimensions; ++d) {
    const float* column = targets.col(static_cast<Eigen::Index>(d)).data();
    for (std::size_t t = 0; t < count; ++t) {
      targets_[(t / kernel_lanes * dimensions + d) * kernel_lanes + t % kernel_lanes] = column[t];
      half_norms_[t] += 0.5F * column[t] * column[t];
    }
  }
}

std::vector<Index>
RowSearch::nearest(const Eigen::MatrixXf& queries) const
{
  const auto count = static_cast<std::size_t>(queries.rows());
  const auto dimensions = static_cast<std::size_t>(dimensions_);
  const KernelTable& table = kernels();
  std::vector<Index> nearest(count);
  parallelBlocks(count, kernel_queries, [&] {
    return [&, packed = std::vector<float>(dimensions * kernel_queries)](std::size_t begin, std::size_t end) mutable {
      for (std::size_t d = 0; d < dimensions; ++d) {
        const float* column = queries.col(static_cast<Eigen::Index>(d)).data();
        std::copy(column + begin, column + end, packed.begin() + static_cast<std::ptrdiff_t>(d * kernel_queries));
      }
      std::int32_t found[kernel_queries];
      table.nearest_rows(packed.data(), targets_.data(), half_norms_.data(), half_norms_.size() / kernel_lanes,
                         dimensions, found);
      std::copy_n(found, end - begin, nearest.begin() + static_cast<std::ptrdiff_t>(begin));
    };
  });
  return nearest;
}

} // namespace symmetry
} // namespace pcl
