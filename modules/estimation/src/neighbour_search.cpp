#include "neighbour_search.h"

#include "base/parallel.h"

#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

using KdTree = flann::KDTreeSingleIndex<flann::L2_Simple<float>>;

/** The search of every point with results in one of FLANN's containers. Calls the search below its parallel region, in
 * which an exception (out of memory) would end the process. */
template <typename ResultSet>
void
searchAll(const KdTree& tree, const std::vector<Vector3>& points, NeighbourLists& lists)
{
  constexpr std::size_t grain = 512;
  const flann::SearchParams unlimited(flann::FLANN_CHECKS_UNLIMITED);
  parallelBlocks(points.size(), grain, [&] {
    return [&, results = ResultSet(lists.k), found = std::vector<std::size_t>(lists.k),
            squared_distances = std::vector<float>(lists.k)](std::size_t begin, std::size_t end) mutable {
      for (std::size_t i = begin; i < end; ++i) {
        results.clear();
        tree.findNeighbors(results, points[i].data(), unlimited);
        const std::size_t count = std::min(results.size(), lists.k);
        results.copy(found.data(), squared_distances.data(), count, true);
        std::transform(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count),
                       lists.neighbours.begin() + static_cast<std::ptrdiff_t>(i * lists.k),
                       [](std::size_t point) { return static_cast<Index>(point); });
      }
    };
  });
}

} // namespace

NeighbourLists
searchByKdTree(const std::vector<Vector3>& points, int k)
{
  NeighbourLists lists;
  lists.k = std::min(static_cast<std::size_t>(k), points.size());
  lists.neighbours.assign(points.size() * lists.k, no_index);
  if (points.empty()) {
    return lists;
  }
  // The leaf size, the container and with them the order of points equally far are those of pcl::KdTreeFLANN.
  constexpr int points_per_leaf = 15;
  std::vector<Vector3> copy = points; // FLANN asks for what it may write to
  KdTree tree(flann::Matrix<float>(copy.front().data(), copy.size(), 3),
              flann::KDTreeSingleIndexParams(points_per_leaf));
  tree.buildIndex();
  if (lists.k > KNN_HEAP_THRESHOLD) {
    searchAll<flann::KNNResultSet2<float>>(tree, points, lists);
  }
  else {
    searchAll<flann::KNNSimpleResultSet<float>>(tree, points, lists);
  }
  return lists;
}

} // namespace symmetry
} // namespace pcl
