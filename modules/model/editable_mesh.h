/** \file
 * \brief A triangle mesh whose edges can be collapsed and flipped without ever ceasing to be a manifold.
 */
#pragma once

#include "model/polygonize.h"

#include <pcl/symmetry/surface.h>

#include <Eigen/Geometry>

#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Triangles with the star of every vertex.
 *
 * Vertices on the boundary stay there, and no edge between two of them may run through the inside: such an edge would
 * have four triangles once a half body is mirrored.
 */
class EditableMesh {
public:
  /** \param[in] mesh an oriented manifold, closed or with boundary */
  explicit EditableMesh(TriangleMesh mesh);

  const std::vector<Eigen::Vector3d>&
  points() const
  {
    return mesh_.points;
  }

  Eigen::Vector3d&
  point(Index vertex)
  {
    return mesh_.points[static_cast<std::size_t>(vertex)];
  }

  const Eigen::Vector3d&
  point(Index vertex) const
  {
    return mesh_.points[static_cast<std::size_t>(vertex)];
  }

  bool
  onBoundary(Index vertex) const
  {
    return on_boundary_[static_cast<std::size_t>(vertex)] != 0;
  }

  /** \brief Vertices that are still in use. */
  std::size_t
  countVertices() const
  {
    return vertices_;
  }

  /** \brief Those of them that are on the boundary. */
  std::size_t
  countBoundaryVertices() const
  {
    return boundary_vertices_;
  }

  /** \brief Whether the vertex is still in use. */
  bool
  alive(Index vertex) const
  {
    return !star(vertex).empty();
  }

  /** \brief Neighbours of a vertex, ascending. */
  std::vector<Index>
  neighbours(Index vertex) const;

  /** \brief How many neighbours a vertex has. */
  int
  valence(Index vertex) const
  {
    return static_cast<int>(star(vertex).size()) + (onBoundary(vertex) ? 1 : 0);
  }

  /** \brief All edges (a, b) with a < b, ascending. */
  std::vector<std::pair<Index, Index>>
  edges() const;

  /** \brief Mean area-weighted normal of the triangles around a vertex, not of unit length. */
  Eigen::Vector3d
  normal(Index vertex) const;

  /** \brief Merges vertex \a gone into vertex \a kept, which moves to \a position, unless that would make the mesh no
   * manifold, join parts of the boundary or turn a triangle over.
   * \return whether it was done */
  bool
  collapse(Index kept, Index gone, const Eigen::Vector3d& position);

  /** \brief The two vertices opposite to an edge; no_index for each that is not there. */
  std::pair<Index, Index>
  opposite(Index a, Index b) const;

  /** \brief Replaces the edge (a, b) by the other diagonal of its two triangles, unless that edge exists, joins
   * boundary vertices, or would turn a triangle over.
   *
   * \return whether it was done */
  bool
  flip(Index a, Index b);

  /** \brief The mesh without the vertices and triangles that are gone; order is kept. */
  TriangleMesh
  compact() const;

private:
  std::vector<Index>&
  star(Index vertex)
  {
    return stars_[static_cast<std::size_t>(vertex)];
  }

  const std::vector<Index>&
  star(Index vertex) const
  {
    return stars_[static_cast<std::size_t>(vertex)];
  }

  Triangle&
  triangle(Index face)
  {
    return mesh_.triangles[static_cast<std::size_t>(face)];
  }

  const Triangle&
  triangle(Index face) const
  {
    return mesh_.triangles[static_cast<std::size_t>(face)];
  }

  bool
  mayCollapse(Index kept, Index gone) const;
  bool
  turnsOver(Index moved, Index without, const Eigen::Vector3d& position) const;
  void
  markBoundary();

  TriangleMesh mesh_;
  std::vector<std::vector<Index>> stars_; ///< per vertex: its triangles; empty for a vertex that is gone
  std::vector<char> on_boundary_;
  std::size_t vertices_ = 0;
  std::size_t boundary_vertices_ = 0;
};

} // namespace symmetry
} // namespace pcl
