#include "symmetry/sides/sides.h"

#include "symmetry/sides/side_settings.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr SideSettings settings{};

/** Connected vertices of one sign. */
struct Patches {
  std::vector<Index> patch_of;
  std::vector<std::size_t> sizes;
  std::vector<bool> positive;
};

Patches
findPatches(const SurfaceGraph& graph, const std::vector<float>& values)
{
  Patches patches;
  patches.patch_of.assign(graph.size(), no_index);
  std::vector<Index> stack;
  for (std::size_t seed = 0; seed < graph.size(); ++seed) {
    if (patches.patch_of[seed] != no_index) {
      continue;
    }
    const auto number = static_cast<Index>(patches.sizes.size());
    const bool positive = values[seed] > 0.0F;
    patches.patch_of[seed] = number;
    patches.sizes.push_back(0);
    patches.positive.push_back(positive);
    stack.assign(1, static_cast<Index>(seed));
    while (!stack.empty()) {
      const Index v = stack.back();
      stack.pop_back();
      ++patches.sizes[number];
      for (const Index w : graph.neighboursOf(v)) {
        if (patches.patch_of[w] == no_index && (values[w] > 0.0F) == positive) {
          patches.patch_of[w] = number;
          stack.push_back(w);
        }
      }
    }
  }
  return patches;
}

/** The patches that are specks and of the sign of the smallest speck: were both signs turned at once, a speck within a
 * speck would turn with it. */
std::vector<bool>
specksOfOneSign(const Patches& patches, std::size_t vertices)
{
  std::size_t largest[2] = {0, 0};
  for (std::size_t i = 0; i < patches.sizes.size(); ++i) {
    std::size_t& largest_of_sign = largest[patches.positive[i] ? 1 : 0];
    largest_of_sign = std::max(largest_of_sign, patches.sizes[i]);
  }
  const auto is_speck = [&](std::size_t i) {
    return patches.sizes[i] < largest[patches.positive[i] ? 1 : 0] &&
           static_cast<double>(patches.sizes[i]) < settings.speck_share * static_cast<double>(vertices);
  };
  // One sign at a time, that of the smallest speck first: a speck within a speck must not turn together with it.
  std::size_t smallest = vertices;
  bool sign = true;
  for (std::size_t i = 0; i < patches.sizes.size(); ++i) {
    if (is_speck(i) && patches.sizes[i] < smallest) {
      smallest = patches.sizes[i];
      sign = patches.positive[i];
    }
  }
  std::vector<bool> specks(patches.sizes.size(), false);
  for (std::size_t i = 0; i < patches.sizes.size(); ++i) {
    specks[i] = is_speck(i) && patches.positive[i] == sign;
  }
  return specks;
}

/** Marks partners together: first both where they may be, then neither where one may not. */
void
makeAlike(const std::vector<Index>& partners, const std::vector<char>& may_be, std::vector<char>& marks)
{
  // Each round reaches one map farther; a map that is nearly its own inverse is through after two.
  const auto sweep = [&](auto change) {
    bool changed = true;
    for (int round = 0; changed && round < settings.maximum_rounds; ++round) {
      changed = false;
      for (std::size_t v = 0; v < partners.size(); ++v) {
        changed = (partners[v] != no_index && marks[v] != marks[partners[v]] && change(v, partners[v])) || changed;
      }
    }
  };
  sweep([&](std::size_t v, Index partner) {
    const bool grows = may_be[v] != 0 && may_be[partner] != 0;
    if (grows) {
      marks[v] = 1;
      marks[partner] = 1;
    }
    return grows;
  });
  sweep([&](std::size_t v, Index) {
    const bool shrinks = marks[v] != 0;
    marks[v] = 0;
    return shrinks;
  });
}

} // namespace

std::vector<float>
sideFunction(const DistanceFields& source_fields, const DistanceFields& target_fields)
{
  const std::size_t n = source_fields.columns;
  std::vector<float> votes(n, 0.0F);
  std::vector<float> differences(n, 0.0F);
  std::vector<float> pairs(n, 0.0F);
  for (std::size_t i = 0; i < source_fields.rows(); ++i) {
    const float* to_source = source_fields.row(i);
    const float* to_target = target_fields.row(i);
    for (std::size_t v = 0; v < n; ++v) {
      const float sum = to_source[v] + to_target[v];
      if (sum > 0.0F && sum < unreachable) {
        const float difference = to_target[v] - to_source[v];
        votes[v] += static_cast<float>((difference > 0.0F) - (difference < 0.0F));
        differences[v] += difference / sum;
        pairs[v] += 1.0F;
      }
    }
  }
  for (std::size_t v = 0; v < n; ++v) {
    if (pairs[v] > 0.0F) {
      votes[v] =
          (votes[v] + settings.difference_weight * differences[v] / pairs[v]) / (pairs[v] + settings.difference_weight);
    }
  }
  return votes;
}

std::vector<float>
withoutZeros(const SurfaceGraph& graph, const std::vector<float>& side_function)
{
  constexpr float tiny = 1e-6F;
  std::vector<float> values = side_function;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    if (side_function[v] != 0.0F) {
      continue;
    }
    int balance = 0;
    for (const Index w : graph.neighboursOf(v)) {
      const float neighbour = side_function[w];
      balance += neighbour > 0.0F ? 1 : neighbour < 0.0F ? -1 : 0;
    }
    values[v] = balance < 0 ? -tiny : tiny;
  }
  return values;
}

std::vector<float>
absorbSpecks(const SurfaceGraph& graph, const std::vector<float>& side_function)
{
  std::vector<float> values = withoutZeros(graph, side_function);
  for (int round = 0; round < settings.maximum_rounds; ++round) {
    const Patches patches = findPatches(graph, values);
    const std::vector<bool> specks = specksOfOneSign(patches, graph.size());
    if (std::find(specks.begin(), specks.end(), true) == specks.end()) {
      break;
    }
    for (std::size_t v = 0; v < graph.size(); ++v) {
      if (specks[patches.patch_of[v]]) {
        values[v] = -values[v];
      }
    }
  }
  return values;
}

std::vector<Side>
labelSides(const std::vector<float>& side_function)
{
  std::vector<Side> sides;
  sides.reserve(side_function.size());
  for (const float value : side_function) {
    sides.push_back(value < 0.0F ? Side::Target : Side::Source);
  }
  return sides;
}

void
markAxis(const SurfaceGraph& graph,
         const std::vector<float>& side_function,
         const std::vector<Index>& partners,
         std::vector<Side>& sides)
{
  std::vector<char> at_border(graph.size(), 0); // points with a neighbour on the other side
  std::vector<char> on_axis(graph.size(), 0);
  for (std::size_t v = 0; v < graph.size(); ++v) {
    for (const Index w : graph.neighboursOf(v)) {
      if ((side_function[v] < 0.0F) != (side_function[w] < 0.0F)) {
        at_border[v] = 1;
        on_axis[v] = on_axis[v] != 0 || std::abs(side_function[v]) <= std::abs(side_function[w]) ? 1 : 0;
      }
    }
  }
  if (!partners.empty()) {
    makeAlike(partners, at_border, on_axis);
  }
  for (std::size_t v = 0; v < graph.size(); ++v) {
    sides[v] = on_axis[v] != 0 ? Side::Axis : sides[v];
  }
}

} // namespace symmetry
} // namespace pcl
