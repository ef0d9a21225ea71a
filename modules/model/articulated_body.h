/** \file
 * \brief Synthetic bodies with exact ground truth.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What is grown. */
enum class Body {
  Human,        ///< head with nose and ears, mitten hands, feet
  Quadruped,    ///< four-legged, with muzzle, ears and tail
  Spider,       ///< eight-legged
  Bird,         ///< wings, tail, beak and two legs
  MissingArm,   ///< human without the left arm: no symmetry, as all below
  ThirdArm,     ///< human with a third arm
  MissingLeg,   ///< four-legged without the left foreleg
  Hand,         ///< five fingers
  Helix,        ///< a coiled tube that grows towards one end, with bumps
  Terrain,      ///< a patch of random hills with a boundary
  Creature,     ///< as the seed has it: trunk, two to four pairs of limbs, head, tail; its own mirror image
  LameCreature, ///< the creature of the same seed without one of its left limbs
  AskewCreature ///< a creature whose limbs are other ones on either side
};

/** \brief Every body, in the order of the enumeration. */
const std::vector<Body>&
allBodies();

/** \brief Name of a body as programs spell it: human, quadruped, spider, bird, missing-arm, third-arm, ... */
const char*
toString(Body body);

/** \brief The body of this name.
 *  \throws std::invalid_argument there is none; the message lists those there are */
Body
bodyFromName(const std::string& name);

/** \brief Whether the rest pose of a body is its own mirror image. */
bool
isSymmetric(Body body);

/** \brief What a model is to be like; plain data. */
struct ModelParameters {
  Body body = Body::Human;
  /** Number of vertices, met to within one on bodies and 2 % on terrain; [1000, 4000000]. */
  std::size_t vertices = 12500;
  /** Strength of the pose: 0 is the rest pose, which is exactly mirror symmetric, 1 draws every angle from the whole
   * range of its joint; [0, 1.5]. */
  double bend = 1.0;
  /** Of the pose, the re-triangulation, the jitter, the hills, and of creatures the whole body. */
  std::uint64_t seed = 1;
  /** Share of the right half's edges that are flipped, where the two triangles allow, so that the triangles of the
   * halves are no mirror image of each other; [0, 1]. */
  double retriangulate = 0.3;
  /** How far the vertices of the right half slide along the surface at most, in their mean edge lengths; the true
   * partner is exact for 0, within this distance otherwise; [0, 0.4]. */
  double jitter = 0.0;
  /** Vertices per area at the dense end of the body over those at the other end; [1, 100]. Has no effect on terrain. */
  double density_ratio = 1.0;
};

/** \brief A surface and what is known about it. */
struct Model {
  Surface surface;
  /** Per point: its true mirror partner, itself on the symmetry axis, -1 where there is none. */
  std::vector<Index> partners;
};

/** \brief Grows a body: skin around bones in the rest pose, triangulated, mirrored, then bent at the joints.
 *
 * All bodies are closed, oriented manifolds of genus 0, terrain is a disc. Left and right differ in a bent pose, while
 * lengths along the skin change little. The same parameters give the same bytes.
 * \throws std::invalid_argument a parameter is out of its range; the message names it, its value and the range
 * \throws std::runtime_error the vertices are too few for the body's details
 *
 * Cost: n log n; about 10 microseconds per vertex.
 */
Model
makeModel(const ModelParameters& parameters);

} // namespace symmetry
} // namespace pcl
