/** \file
 * \brief Figures of lines with known extremities.
 */
#pragma once

#include "geodesic/surface_graph.h"

namespace pcl {
namespace symmetry {
namespace test {

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
  std::vector<GraphEdge> edges;
  Index count = 1; // vertex 0: the shoulder
  const auto grow = [&](Index from, int length) {
    for (int i = 0; i < length; ++i) {
      edges.push_back({from, count, 1.0F});
      from = count++;
    }
    return from;
  };
  StickFigure figure;
  const Index hip = grow(0, 4);
  grow(0, 2);
  figure.left_hand = grow(0, arm);
  figure.right_hand = grow(0, arm);
  figure.left_foot = grow(hip, leg);
  figure.right_foot = grow(hip, leg);
  figure.graph = buildGraph(static_cast<std::size_t>(count), edges);
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
  std::vector<GraphEdge> edges;
  Index count = 1; // vertex 0: the shoulder
  const auto grow = [&](Index from, int length) {
    for (int i = 0; i < length; ++i) {
      edges.push_back({from, count, 1.0F});
      from = count++;
    }
    return from;
  };
  StickAnimal animal;
  const Index hip = grow(0, 8);
  animal.head = grow(0, 9);
  animal.tail = grow(hip, 14);
  animal.left_fore = grow(0, foreleg);
  animal.right_fore = grow(0, foreleg);
  animal.left_hind = grow(hip, hindleg);
  animal.right_hind = grow(hip, hindleg);
  animal.graph = buildGraph(static_cast<std::size_t>(count), edges);
  return animal;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
