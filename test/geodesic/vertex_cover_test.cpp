#include "geodesic/vertex_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using pcl::symmetry::VertexCover;

namespace {

using Edges = std::vector<std::vector<std::uint32_t>>; // right vertices per left one

Edges
randomEdges(std::size_t left, std::size_t right, double density, unsigned seed)
{
  std::mt19937 random(seed);
  Edges edges(left);
  for (std::vector<std::uint32_t>& of_vertex : edges) {
    for (std::uint32_t r = 0; r < right; ++r) {
      if (static_cast<double>(random() % 1000U) < 1000.0 * density) {
        of_vertex.push_back(r);
      }
    }
  }
  return edges;
}

struct Cover {
  std::vector<std::uint32_t> left;
  std::vector<std::uint32_t> right;
};

Cover
findCover(VertexCover& finder, const Edges& edges, std::size_t right)
{
  Cover cover;
  const auto edges_of = [&](std::uint32_t l, auto use) {
    std::for_each(edges[l].begin(), edges[l].end(), use);
  };
  finder.find(edges.size(), right, edges_of, cover.left, cover.right);
  return cover;
}

bool
covers(const Edges& edges, unsigned left_set, unsigned right_set)
{
  for (std::size_t l = 0; l < edges.size(); ++l) {
    for (const std::uint32_t r : edges[l]) {
      if ((left_set >> l & 1U) == 0 && (right_set >> r & 1U) == 0) {
        return false;
      }
    }
  }
  return true;
}

unsigned
asSet(const std::vector<std::uint32_t>& vertices)
{
  unsigned set = 0;
  for (const std::uint32_t v : vertices) {
    set |= 1U << v;
  }
  return set;
}

} // namespace

TEST(VertexCover, IsTheSmallestOfAllCovers)
{
  VertexCover finder; // one for all
  for (unsigned seed = 0; seed < 60; ++seed) {
    const std::size_t left = 1 + seed % 6;
    const std::size_t right = 1 + seed / 6 % 7;
    const Edges edges = randomEdges(left, right, 0.15 + 0.01 * seed, seed);
    const Cover cover = findCover(finder, edges, right);
    EXPECT_TRUE(std::is_sorted(cover.left.begin(), cover.left.end()));
    EXPECT_TRUE(covers(edges, asSet(cover.left), asSet(cover.right)));
    std::size_t smallest = left;
    for (unsigned l = 0; l < 1U << left; ++l) {
      for (unsigned r = 0; r < 1U << right; ++r) {
        if (covers(edges, l, r)) {
          smallest =
              std::min<std::size_t>(smallest, static_cast<std::size_t>(__builtin_popcount(l) + __builtin_popcount(r)));
        }
      }
    }
    EXPECT_EQ(cover.left.size() + cover.right.size(), smallest) << "seed " << seed;
  }
}

TEST(VertexCover, OfAFanIsItsCentre)
{
  VertexCover finder;
  const Cover at_left = findCover(finder, {{0, 1, 2, 3, 4}}, 5);
  EXPECT_EQ(at_left.left, std::vector<std::uint32_t>{0});
  EXPECT_TRUE(at_left.right.empty());
  const Cover at_right = findCover(finder, {{0}, {0}, {0}, {0}}, 1);
  EXPECT_TRUE(at_right.left.empty());
  EXPECT_EQ(at_right.right, std::vector<std::uint32_t>{0});
  EXPECT_TRUE(findCover(finder, {{}, {}}, 3).left.empty());
}
