#include "symmetry/staged/base_vertices.h"

#include "base/parallel.h"

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

void
append(DistanceFields& fields, const DistanceFields& more)
{
  fields.columns = more.columns;
  fields.values.insert(fields.values.end(), more.values.begin(), more.values.end());
}

} // namespace

void
BaseVertices::addPairs(std::vector<SymmetricMatch>& pairs)
{
  std::vector<Index> sources;
  std::vector<Index> targets;
  for (const SymmetricMatch& pair : pairs) {
    sources.push_back(pair.source);
    targets.push_back(pair.target);
  }
  const DistanceFields source_fields = metric_.fields(sources);
  const std::vector<Index> midpoints = metric_.midpoints(sources, source_fields, targets);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[i].midpoint = midpoints[i];
  }
  append(source_fields_, source_fields);
  append(target_fields_, metric_.fields(targets));
  append(midpoint_fields_, metric_.fields(midpoints));
}

void
BaseVertices::addMidpoint(Index midpoint)
{
  append(midpoint_fields_, metric_.fields({midpoint}));
}

std::vector<const float*>
BaseVertices::rows(Side side, FeatureSet set) const
{
  std::vector<const float*> rows;
  const DistanceFields& own = side == Side::Source ? source_fields_ : target_fields_;
  for (std::size_t i = 0; set == FeatureSet::OwnEndpointsAndMidpoints && i < own.rows(); ++i) {
    rows.push_back(own.row(i));
  }
  for (std::size_t i = 0; i < midpoint_fields_.rows(); ++i) {
    rows.push_back(midpoint_fields_.row(i));
  }
  return rows;
}

FeatureVectors
BaseVertices::features(const std::vector<Index>& vertices, Side side, FeatureSet set) const
{
  constexpr std::size_t block = 64; // vertices at a time: their part of a field stays in the cache
  const std::vector<const float*> fields = rows(side, set);
  FeatureVectors features;
  features.dimensions = fields.size();
  features.values.resize(vertices.size() * fields.size());
  parallelBlocks(vertices.size(), block, [&] {
    return [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = 0; f < fields.size(); ++f) {
        for (std::size_t i = begin; i < end; ++i) {
          features.values[i * fields.size() + f] = fields[f][vertices[i]];
        }
      }
    };
  });
  return features;
}

std::vector<float>
BaseVertices::floors(Side side, FeatureSet set) const
{
  const std::size_t n = midpoint_fields_.columns;
  std::vector<float> floors;
  for (const float* field : rows(side, set)) {
    floors.push_back(feature_floor_share * *std::max_element(field, field + n));
  }
  return floors;
}

} // namespace symmetry
} // namespace pcl
