#include "neighbour_search.h"

#include "base/parallel.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>

namespace pcl {
namespace symmetry {

NeighbourLists
searchByKdTree(const std::vector<Vector3>& points, int k)
{
  const auto cloud = make_shared<PointCloud<PointXYZ>>();
  cloud->reserve(points.size());
  for (const Vector3& p : points) {
    cloud->push_back(PointXYZ(p[0], p[1], p[2]));
  }
  NeighbourLists lists;
  lists.k = std::min(static_cast<std::size_t>(k), points.size());
  lists.neighbours.assign(points.size() * lists.k, no_index);
  if (points.empty()) {
    return lists;
  }
  KdTreeFLANN<PointXYZ> tree;
  tree.setInputCloud(cloud);
  constexpr std::size_t grain = 512;
  parallelBlocks(points.size(), grain, [&] {
    return [&, found = Indices(), squared_distances = std::vector<float>()](std::size_t begin,
                                                                            std::size_t end) mutable {
      for (std::size_t i = begin; i < end; ++i) {
        const int count = tree.nearestKSearch((*cloud)[i], static_cast<unsigned>(lists.k), found, squared_distances);
        std::copy_n(found.begin(), count, lists.neighbours.begin() + static_cast<std::ptrdiff_t>(i * lists.k));
      }
    };
  });
  return lists;
}

} // namespace symmetry
} // namespace pcl
