#include "symmetry/search/limb_exchange.h"

#include "symmetry/search/functional_map.h"
#include "symmetry/search/given_maps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** The ends of the limbs and where a map sends them. */
class LimbPairing {
public:
  LimbPairing(const LandmarkSurface& landmarks, const SampleMap& map, const LimbExchangeSettings& settings)
      : landmarks_(&landmarks), ends_(extremitiesOf(landmarks, settings.separation, most_limbs))
  {
    for (const Index end : ends_) {
      partners_.push_back(nearestEnd(map[static_cast<std::size_t>(end)], 0.5F * settings.separation));
    }
  }

  std::size_t
  size() const
  {
    return ends_.size();
  }

  std::size_t
  paired() const
  {
    return static_cast<std::size_t>(
        std::count_if(partners_.begin(), partners_.end(), [](Index partner) { return partner != no_index; }));
  }

  /** Whether the ends, which are those of one surface, go to the same ones. */
  bool
  isSameAs(const LimbPairing& other) const
  {
    return partners_ == other.partners_;
  }

  /** Whether both stand still, or change places. */
  bool
  isExchangeable(std::size_t a, std::size_t b) const
  {
    const auto goes_to = [this](std::size_t from, std::size_t to) {
      return partners_[from] == static_cast<Index>(to);
    };
    return (goes_to(a, a) && goes_to(b, b)) || (goes_to(a, b) && goes_to(b, a));
  }

  /** The same but for two ends. */
  LimbPairing
  exchanged(std::size_t a, std::size_t b) const
  {
    LimbPairing other = *this;
    std::swap(other.partners_[a], other.partners_[b]);
    return other;
  }

  /** Mean change of the distances of two ends to all others, share of the diameter. */
  float
  changeAt(std::size_t a, std::size_t b) const
  {
    float sum = 0.0F;
    std::size_t count = 0;
    for (const std::size_t end : {a, b}) {
      for (std::size_t other = 0; other < size(); ++other) {
        if (other != a && other != b && partners_[other] != no_index) {
          sum += std::abs(distance(ends_[end], ends_[other]) - distance(partnerOf(end), partnerOf(other)));
          ++count;
        }
      }
    }
    return count == 0 ? landmarks_->diameter : sum / (static_cast<float>(count) * landmarks_->diameter);
  }

  /** The map that carries distances to the ends over to those to their partners. */
  SampleMap
  toMap() const
  {
    const auto columns = static_cast<Eigen::Index>(paired());
    Eigen::MatrixXf from(landmarks_->distances.rows(), columns);
    Eigen::MatrixXf to(from.rows(), columns);
    Eigen::Index column = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      if (partners_[i] != no_index) {
        from.col(column) = landmarks_->distances.col(ends_[i]);
        to.col(column) = landmarks_->distances.col(partnerOf(i));
        ++column;
      }
    }
    return nearestRows(from, to);
  }

private:
  float
  distance(Index a, Index b) const
  {
    return landmarks_->distances(a, b);
  }

  Index
  partnerOf(std::size_t end) const
  {
    return ends_[static_cast<std::size_t>(partners_[end])];
  }

  /** Number of the nearest end; no_index where none is within a share of the diameter. */
  Index
  nearestEnd(Index landmark, float within) const
  {
    const auto nearest = std::min_element(
        ends_.begin(), ends_.end(), [&](Index a, Index b) { return distance(landmark, a) < distance(landmark, b); });
    return nearest != ends_.end() && distance(landmark, *nearest) <= within * landmarks_->diameter
               ? static_cast<Index>(nearest - ends_.begin())
               : no_index;
  }

  const LandmarkSurface* landmarks_;
  std::vector<Index> ends_;
  std::vector<Index> partners_; ///< numbers of ends
};

/** A pairing that differs from another one in two limbs. */
struct Exchange {
  LimbPairing pairing;
  float change = 0.0F;
};

/** Of one pairing, the least change first. */
std::vector<Exchange>
exchangesOf(const LimbPairing& pairing)
{
  constexpr std::size_t fewest_paired = 4; // distances to three leave left and right open
  std::vector<Exchange> exchanges;
  for (std::size_t a = 0; a < pairing.size() && pairing.paired() >= fewest_paired; ++a) {
    for (std::size_t b = a + 1; b < pairing.size(); ++b) {
      if (pairing.isExchangeable(a, b)) {
        LimbPairing exchanged = pairing.exchanged(a, b);
        const float change = exchanged.changeAt(a, b);
        exchanges.push_back({std::move(exchanged), change});
      }
    }
  }
  std::stable_sort(exchanges.begin(), exchanges.end(),
                   [](const Exchange& x, const Exchange& y) { return x.change < y.change; });
  return exchanges;
}

bool
contains(const std::vector<LimbPairing>& pairings, const LimbPairing& wanted)
{
  return std::any_of(pairings.begin(), pairings.end(),
                     [&wanted](const LimbPairing& pairing) { return pairing.isSameAs(wanted); });
}

/** Pairings that differ from one of these in two limbs, and are none of these. */
std::vector<LimbPairing>
exchangedPairings(const std::vector<LimbPairing>& pairings, std::size_t of_each)
{
  std::vector<LimbPairing> known = pairings;
  for (const LimbPairing& pairing : pairings) {
    const std::vector<Exchange> exchanges = exchangesOf(pairing);
    for (std::size_t k = 0; k < std::min(exchanges.size(), of_each); ++k) {
      if (!contains(known, exchanges[k].pairing)) {
        known.push_back(exchanges[k].pairing);
      }
    }
  }
  known.erase(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(pairings.size()));
  return known;
}

} // namespace

std::vector<SymmetryCandidate>
exchangeLimbs(const SampledSurface& sampled,
              const std::vector<SampleMap>& maps,
              const SearchSettings& search,
              const LimbExchangeSettings& settings)
{
  std::vector<LimbPairing> pairings;
  for (const SampleMap& map : maps) {
    LimbPairing pairing(sampled.landmarks, map, settings);
    if (!contains(pairings, pairing)) {
      pairings.push_back(std::move(pairing));
    }
  }
  const std::vector<LimbPairing> exchanged = exchangedPairings(pairings, settings.exchanges);
  std::vector<SampleMap> candidates(exchanged.size());
  std::transform(exchanged.begin(), exchanged.end(), candidates.begin(),
                 [](const LimbPairing& pairing) { return pairing.toMap(); });
  return candidatesFromMaps(sampled, std::move(candidates), search);
}

} // namespace symmetry
} // namespace pcl
