/** \file
 * \brief For a place, the nearest point of every part of a surface.
 */
#pragma once

#include "base/bounding_box.h"

#include <pcl/symmetry/surface.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A tree of boxes around the points of a surface in parts.
 *
 * A search leaves out boxes that hold only what is passed over, or what is nearer elsewhere. However many points lie
 * near, it takes about the logarithm of their number for each part that it finds. Of a part of which a thousand points
 * have been looked at, all about equally far then, one of these is taken. */
class NearestOfParts {
public:
  /** \brief The nearest point of a part. */
  struct Found {
    Index part;
    Index point;
    float distance;
    int looked_at; ///< points of the part
  };

  /** \param[in] points, part_of referred to, not copied
   * \param[in] parts more than the highest number of a part */
  NearestOfParts(const std::vector<Vector3>& points, const std::vector<Index>& part_of, std::size_t parts);

  /** \brief Of points equally far that one is taken which comes first here; before the call the lowest. */
  void
  setOrder(const std::vector<Index>& order);

  /** \brief Puts parts into groups; before the call each is one.
   * \param[in] group_of of every part, less than the number of parts
   * \param[in] farthest of every group: how far away it is found at most */
  void
  setGroups(const std::vector<Index>& group_of, const std::vector<float>& farthest);

  /** \brief Parts that are found at most: where boxes are stacked, eight meet in a corner. */
  static constexpr std::size_t most_parts = 32;

  /** \brief Nearest points of all parts outside a group, no farther than \a reach away, in no particular order; of the
   * nearest \a most_parts parts if there are more. */
  const std::vector<Found>&
  search(const Vector3& place, Index group, float reach);

private:
  struct Node {
    BoundingBox box;
    std::uint64_t parts = 0;     ///< a bit each, if there are not too many
    Index only_part = no_index;  ///< that all of its points belong to; no_index: there are several
    Index only_group = no_index; ///< the same of groups
    float farthest = 0.0F;       ///< of its groups
    std::uint32_t begin = 0;     ///< of its entries
    std::uint32_t end = 0;
    std::uint32_t children = 0; ///< the first of two; 0: none
  };

  struct Query {
    const Vector3& place;
    Index group;
    float reach; ///< less as soon as there are parts enough
  };

  void
  build(std::size_t node);

  void
  setGroup(Node& node) const;

  bool
  isOfUse(Index part, double nearest, const Query& query) const;

  bool
  isOfUse(const Node& node, const Query& query) const;

  void
  visit(const Node& node, Query& query);

  void
  offer(Index point, Query& query);

  void
  keepNearest(Query& query);

  const std::vector<Vector3>& points_;
  const std::vector<Index>& part_of_;
  std::vector<Index> group_of_; ///< by part
  std::vector<float> farthest_; ///< by group
  std::vector<Index> ranks_;    ///< of the points, in case of ties
  std::vector<Index> entries_;  ///< points by node
  std::vector<Node> nodes_;
  std::vector<Found> found_;
  std::vector<Index> place_in_found_; ///< by part; no_index: not found
};

} // namespace symmetry
} // namespace pcl
