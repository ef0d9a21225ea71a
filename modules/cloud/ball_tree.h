/** \file
 * \brief Balls of different sizes in a tree of boxes, for searches that most of them are too far for.
 */
#pragma once

#include "base/bounding_box.h"

#include <pcl/symmetry/surface.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Finds the balls that may matter at a place, however unevenly they are spread and however large a few of them
 * are; holds numbers and boxes, neither centres nor radii. */
class BallTree {
public:
  /** \param[in] centres all finite
   * \param[in] radii of as many */
  BallTree(const std::vector<Vector3>& centres, const std::vector<float>& radii);

  /** \brief Calls visit (i) for balls around a place, about in the order of the distances of their centres, and leaves out
   * those that are too far.
   * \param[in] reach called again and again as visits change what it returns: how far the centre of a ball may be whose
   * radius is at most the one that it is called with, not falling as that grows */
  template <typename Reach, typename Visit>
  void
  visitNearest(const Vector3& place, Reach reach, Visit visit) const
  {
    if (!balls_.empty()) {
      visitNode(nodes_.front(), nodes_.front().box.straightDistanceTo(place), place, reach, visit);
    }
  }

private:
  struct Node {
    BoundingBox box;         ///< of the centres
    float radius = 0.0F;     ///< the largest
    std::uint32_t begin = 0; ///< of its balls
    std::uint32_t end = 0;
    std::uint32_t children = 0; ///< the first of two; 0: none
  };

  void
  build(std::size_t node, const std::vector<Vector3>& centres, const std::vector<float>& radii);

  template <typename Reach, typename Visit>
  void
  visitNode(const Node& node, double distance, const Vector3& place, Reach& reach, Visit& visit) const
  {
    constexpr double rounding = 0.99999; // of floats, a hundred times over: nothing is left out for it
    if (rounding * distance > double{reach(node.radius)}) {
      return;
    }
    if (node.children == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        visit(balls_[i]);
      }
      return;
    }
    const Node* near = &nodes_[node.children];
    const Node* far = &nodes_[node.children + 1];
    double to_near = near->box.straightDistanceTo(place);
    double to_far = far->box.straightDistanceTo(place);
    if (to_far < to_near) {
      std::swap(near, far);
      std::swap(to_near, to_far);
    }
    visitNode(*near, to_near, place, reach, visit);
    visitNode(*far, to_far, place, reach, visit);
  }

  std::vector<Index> balls_; ///< by node
  std::vector<Node> nodes_;
};

} // namespace symmetry
} // namespace pcl
