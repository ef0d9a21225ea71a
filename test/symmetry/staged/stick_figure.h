/** \file
 * \brief Figures of lines with known extremities.
 */
#pragma once

#include "geodesic/surface_graph.h"

namespace pcl {
namespace symmetry {
namespace test {

/** \brief Lines of vertices at unit distance that grow from one another. */
class StickGraph {
public:
  /** \brief Adds a line of so many edges. \return its end */
  Index
  grow(Index from, int length)
  {
    for (int i = 0; i < length; ++i) {
      edges_.push_back({from, count_, 1.0F});
      from = count_++;
    }
    return from;
  }

  SurfaceGraph
  graph() const
  {
    return buildGraph(static_cast<std::size_t>(count_), edges_);
  }

private:
  std::vector<GraphEdge> edges_;
  Index count_ = 1; // vertex 0 is there from the beginning
};

/** \brief A stick figure: arms of length \a arm from the shoulder, legs of length \a leg from the hip, a spine of length 4
 * between the two and a neck of length 2; one vertex per unit. */
struct StickFigure {
  SurfaceGraph graph;
  Index left_hand = no_index;
  Index right_hand = no_index;
  Index left_foot = no_index;
  Index right_foot = no_index;
};

inline StickFigure
stickFigure(int arm, int leg)
{
  StickGraph sticks;
  constexpr Index shoulder = 0;
  StickFigure figure;
  const Index hip = sticks.grow(shoulder, 4);
  sticks.grow(shoulder, 2);
  figure.left_hand = sticks.grow(shoulder, arm);
  figure.right_hand = sticks.grow(shoulder, arm);
  figure.left_foot = sticks.grow(hip, leg);
  figure.right_foot = sticks.grow(hip, leg);
  figure.graph = sticks.graph();
  return figure;
}

/** \brief A four-legged animal of lines: legs from the shoulder and from the hip, a neck, a tail longer than all of
 * them; one vertex per unit. */
struct StickAnimal {
  SurfaceGraph graph;
  Index head = no_index;
  Index tail = no_index;
  Index left_fore = no_index;
  Index right_fore = no_index;
  Index left_hind = no_index;
  Index right_hind = no_index;
};

inline StickAnimal
stickAnimal(int foreleg, int hindleg)
{
  StickGraph sticks;
  constexpr Index shoulder = 0;
  StickAnimal animal;
  const Index hip = sticks.grow(shoulder, 8);
  animal.head = sticks.grow(shoulder, 9);
  animal.tail = sticks.grow(hip, 14);
  animal.left_fore = sticks.grow(shoulder, foreleg);
  animal.right_fore = sticks.grow(shoulder, foreleg);
  animal.left_hind = sticks.grow(hip, hindleg);
  animal.right_hind = sticks.grow(hip, hindleg);
  animal.graph = sticks.graph();
  return animal;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
