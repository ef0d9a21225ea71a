/** \file
 * \brief Names the sides of a surface as those of another one: left stays left, from pose to pose and body to body.
 */
#pragma once

#include <pcl/symmetry/export.h>
#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_result.h>

#include <memory>
#include <vector>

namespace pcl {
namespace symmetry {

struct ComparableSurface;

/** \brief A labelled surface that others of its kind take the names of their sides from.
 *
 * Another pose of the same body, or another body of the same kind: of the two ways to lay a surface over the reference,
 * one turns it inside out as a mirror does; the other one tells which side is which. Neither position, size nor
 * triangles matter. A surface whose faces or normals point inwards is taken as one whose point outwards; an open sheet
 * bulges outwards. A mirror image of the reference gets its names exchanged, as the left hand of a body is the right
 * hand of its mirror image.
 *
 * Copies share what was prepared; const functions may be called from several threads at once.
 * \ingroup symmetry
 */
class PCL_SYMMETRY_EXPORTS NameReference {
public:
  /** \brief Prepares a surface; takes about as long as half an estimation.
   * \param[in] surface mesh or cloud; points without a partner are left out
   * \param[in] sides one per point, as SymmetryResult::sides, of both sides
   * \param[in] partners one per point, as SymmetryResult::partners
   * \param[in] threads 0: all cores; the result does not depend on it
   * \throws pcl::BadArgumentException the arrays do not belong to the surface, label but one side, or leave less than
   * can be compared */
  NameReference(const Surface& surface,
                const std::vector<Side>& sides,
                const std::vector<Index>& partners,
                unsigned threads = 0);

  /** \brief Exchanges source and target of a result where the reference calls for it: sides, regions, matches,
   * extremities, directions of axis and mirror plane; fills in SymmetryResult::naming.
   *
   * What cannot be compared (too few points) keeps its names, with margin 0. Takes about as long as half an estimation.
   * \param[in] surface that the result is of
   * \param[in,out] result with a map, see hasMap (); without one nothing is done
   * \throws pcl::BadArgumentException the result does not belong to the surface, or has no dense map (sparse_only) */
  void
  nameSides(const Surface& surface, SymmetryResult& result, unsigned threads = 0) const;

private:
  std::shared_ptr<const ComparableSurface> reference_;
};

} // namespace symmetry
} // namespace pcl
