#include "symmetry/staged/regions.h"

#include <array>

namespace pcl {
namespace symmetry {

std::vector<Region>
limbRegions(const DistanceFields& source_fields, const DistanceFields& target_fields, Index m_h, Index m_f)
{
  struct Limb {
    Region region;
    const float* field;
    float radius;
  };
  const std::array<Limb, 4> limbs = {
      Limb{Region::Source1, source_fields.row(0), source_fields.row(0)[m_h]},
      Limb{Region::Target1, target_fields.row(0), target_fields.row(0)[m_h]},
      Limb{Region::Source2, source_fields.row(1), source_fields.row(1)[m_f]},
      Limb{Region::Target2, target_fields.row(1), target_fields.row(1)[m_f]},
  };
  std::vector<Region> regions(source_fields.columns, Region::Centre);
  for (std::size_t v = 0; v < regions.size(); ++v) {
    float closest = 1.0F;
    for (const Limb& limb : limbs) {
      if (limb.field[v] < limb.radius && limb.field[v] / limb.radius < closest) {
        closest = limb.field[v] / limb.radius;
        regions[v] = limb.region;
      }
    }
  }
  return regions;
}

} // namespace symmetry
} // namespace pcl
