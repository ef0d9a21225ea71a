#include "cloud/resampled_cloud.h"

#include "base/bounding_box.h"
#include "base/heartbeat.h"
#include "base/parallel.h"
#include "base/renumbering.h"
#include "base/statistics.h"
#include "base/vector_math.h"
#include "cloud/cloud_normals.h"
#include "cloud/cloud_settings.h"
#include "cloud/merged_sheets.h"
#include "cloud/outliers.h"
#include "cloud/outside_space.h"
#include "cloud/point_grid.h"
#include "cloud/sheet_smoothing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

constexpr ResamplingSettings settings{};

/** Numbers of points no two of which are closer than a spacing, and all others are within it of one of them. */
std::vector<Index>
thinOut(const std::vector<Vector3>& points, float spacing)
{
  const PointGrid grid(points, spacing);
  std::vector<char> covered(points.size(), 0);
  std::vector<Index> kept;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (covered[v] != 0) {
      continue;
    }
    kept.push_back(static_cast<Index>(v));
    grid.visitAround(points[v], [&](Index i) {
      if (distance(points[i], points[v]) < spacing) {
        covered[i] = 1;
      }
    });
  }
  return kept;
}

/** Nearest kept point of every point, at most a spacing away. */
std::vector<Index>
nearestKept(const std::vector<Vector3>& points, const std::vector<Index>& kept, float spacing)
{
  std::vector<Vector3> places;
  places.reserve(kept.size());
  for (const Index v : kept) {
    places.push_back(points[v]);
  }
  const PointGrid grid(places, spacing);
  std::vector<Index> nearest(points.size(), no_index);
  constexpr std::size_t grain = 1024;
  parallelFor(
      points.size(),
      [&](std::size_t v) {
        float least = std::numeric_limits<float>::infinity();
        grid.visitAround(points[v], [&](Index i) {
          const float d = distance(places[i], points[v]);
          if (d < least) {
            least = d;
            nearest[v] = i;
          }
        });
      },
      grain);
  return nearest;
}

/** Some points of a cloud, with the places that they were moved to. */
struct Selection {
  std::vector<Index> chosen;    ///< numbers in the cloud
  std::vector<Vector3> places;  ///< of the chosen ones
  std::vector<Vector3> normals; ///< of the sheets there; empty if nothing was smoothed
  std::vector<Index> nearest;   ///< for every point of the cloud the entry that stands for it, no_index: an outlier
};

Selection
allPoints(const std::vector<Vector3>& points)
{
  Selection all{std::vector<Index>(points.size()), points, {}, {}};
  std::iota(all.chosen.begin(), all.chosen.end(), 0);
  all.nearest = all.chosen;
  return all;
}

/** Goes over to the given entries. \param[in] stand_in for every entry now: which of those stands for it */
void
select(Selection& selection, const std::vector<Index>& kept, const std::vector<Index>& stand_in)
{
  keepEntries(selection.chosen, kept);
  keepEntries(selection.places, kept);
  if (!selection.normals.empty()) {
    keepEntries(selection.normals, kept);
  }
  renumber(selection.nearest, stand_in);
}

void
selectSpaced(Selection& selection, float spacing)
{
  const std::vector<Index> kept = thinOut(selection.places, spacing);
  select(selection, kept, nearestKept(selection.places, kept, spacing));
}

/** Support of the middle of the surface: half of it has more. Places that are as dense as the points of the cloud stand
 * for unequal areas; what is alone is no surface, however large the gap to the next. */
float
typicalSupport(const SheetPlaces& sheets)
{
  const float largest = settings.maximum_gap * median(sheets.gaps);
  std::vector<std::pair<float, float>> support_and_area;
  float total = 0.0F;
  for (std::size_t i = 0; i < sheets.places.size(); ++i) {
    const float gap = std::min(sheets.gaps[i], largest);
    support_and_area.emplace_back(sheets.support[i], gap * gap);
    total += gap * gap;
  }
  std::sort(support_and_area.begin(), support_and_area.end());
  float below = 0.0F;
  for (const auto& [support, area] : support_and_area) {
    below += area;
    if (below >= 0.5F * total) {
      return support;
    }
  }
  return 0.0F;
}

/** Takes out entries with hardly any points around them, and what they stand for. */
void
dropUnsupported(Selection& selection, SheetPlaces& sheets, float typical_support)
{
  const float least = settings.minimum_support * typical_support;
  std::vector<Index> kept;
  std::vector<Index> stand_in(sheets.support.size(), no_index);
  for (std::size_t i = 0; i < sheets.support.size(); ++i) {
    if (sheets.support[i] >= least) {
      stand_in[i] = static_cast<Index>(kept.size());
      kept.push_back(static_cast<Index>(i));
    }
  }
  select(selection, kept, stand_in);
  keepEntries(sheets.gaps, kept);
}

/** A spacing, not below the given one, that leaves at most so many points. */
float
spacingForAtMost(const std::vector<Vector3>& points, std::size_t maximum_points, float spacing, float mean_distance)
{
  std::size_t left = spacing > 0.0F ? thinOut(points, spacing).size() : points.size();
  while (left > maximum_points) {
    // On a surface the number of points falls with the square of the spacing.
    const float finer = std::max({spacing, mean_distance, settings.least_spacing});
    spacing = finer *
              std::max(settings.spacing_step, std::sqrt(static_cast<float>(left) / static_cast<float>(maximum_points)));
    left = thinOut(points, spacing).size();
  }
  return spacing;
}

/** Moves the points of a noisy cloud onto its sheets. Not all of them: some at a fraction of the spacing to come.
 * \return the distance between the points of the cloud around each */
std::vector<float>
smooth(Selection& selection, const Smoothing& smoothing, std::size_t maximum_points, float mean_distance)
{
  const std::vector<Vector3> points = selection.places;
  const float spacing = spacingForAtMost(selection.places, 2 * maximum_points,
                                         settings.smoothed_spacing * smoothing.spacing, mean_distance);
  selectSpaced(selection, spacing);
  SheetPlaces sheets = moveToSheets(std::move(selection.places), points, smoothing);
  selection.places = std::move(sheets.places);
  selection.normals = std::move(sheets.normals);
  sheets.places = selection.places;
  const bool is_even = smoothing.least_radius >= smoothing.radius;
  dropUnsupported(selection, sheets, is_even ? median(sheets.support) : typicalSupport(sheets));
  return sheets.gaps;
}

/** Whether points are everywhere in the cube around them, as in a ball or a box: planes fitted to what is nowhere flat are
 * sheets that nothing has. \param[in] neighbours of each point, and the
 * mean of their distances */
bool
fillsSpace(const std::vector<Vector3>& points, std::size_t neighbours, float mean_distance)
{
  constexpr double ball = 4.18879;             // 4/3 pi: volume over the radius cubed
  constexpr double radius_of_mean = 4.0 / 3.0; // of a ball, over the mean distance from its centre
  const double radius = radius_of_mean * double{mean_distance};
  const double of_a_point = ball * radius * radius * radius / static_cast<double>(neighbours);
  const double side = boundingBox(points).longestSide();
  return static_cast<double>(points.size()) * of_a_point > settings.filled_share * side * side * side;
}

/** The surface around places, without the gaps between the points. \param[in] spacing of the places */
std::vector<Surfel>
surfels(const Selection& selection, const std::vector<float>& gaps, float spacing)
{
  std::vector<Surfel> discs;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const float radius = std::max(settings.spacings_per_radius * spacing, settings.gaps_per_radius * gaps[i]);
    discs.push_back({selection.places[i], selection.normals[i], radius});
  }
  return discs;
}

/** Lets what was left out be stood for by a point that is hardly farther from it than from its neighbours: of no use
 * for the surface (the tip of a claw, alone in a sparse place), but on it all the same. \param[in] mean_distances of
 * the points to their neighbours */
void
takeInNearby(const std::vector<Vector3>& points,
             const NeighbourLists& lists,
             const std::vector<float>& mean_distances,
             std::vector<Index>& representatives)
{
  const std::vector<Index> before = representatives;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (representatives[v] != no_index) {
      continue;
    }
    const IndexRange around = lists.of(v);
    const Index* const near = std::find_if(around.begin(), around.end(), [&](Index u) {
      return before[u] != no_index && distance(points[u], points[v]) <= settings.nearby_distance * mean_distances[u];
    });
    representatives[v] = near == around.end() ? no_index : before[*near];
  }
}

/** Puts a second point where two sheets have merged into one layer, each a little way into its own body. Points of the
 * cloud stay with the sheet of the side that they are on. */
void
partSheets(const std::vector<Vector3>& points, const LayerSides& layers, ResampledCloud& cloud)
{
  const std::size_t n = cloud.points.size();
  std::vector<Index> second(n, no_index);
  const std::vector<Vector3> middle = cloud.points;
  cloud.normals = layers.normals;
  for (std::size_t i = 0; i < n; ++i) {
    cloud.is_oriented.push_back(static_cast<char>(layers.sides[i] != Sides::Alike));
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (layers.sides[i] == Sides::Inside) {
      const Vector3 inwards = -settings.parted_clearance * layers.clearance * layers.normals[i];
      second[i] = static_cast<Index>(cloud.points.size());
      cloud.points[i] = middle[i] + inwards;
      cloud.points.push_back(middle[i] - inwards);
      cloud.normals.push_back(-1.0F * layers.normals[i]);
      cloud.is_oriented.push_back(1);
      cloud.original.push_back(cloud.original[i]);
    }
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Index i = cloud.representatives[v];
    if (i != no_index && second[i] != no_index && dot(points[v] - middle[i], layers.normals[i]) > 0.0F) {
      cloud.representatives[v] = second[i];
    }
  }
}

} // namespace

ResampledCloud
resampleCloud(const std::vector<Vector3>& points,
              const NeighbourLists& lists,
              std::size_t maximum_points,
              NoiseInterpretation interpretation)
{
  const std::vector<float> mean_distances = neighbourDistances(points, lists);
  const std::vector<char> outlier = findOutliers(points, lists, mean_distances);
  heartbeat();
  std::vector<Vector3> inliers;
  std::vector<Index> number;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (outlier[v] == 0) {
      inliers.push_back(points[v]);
      number.push_back(static_cast<Index>(v));
    }
  }
  const float mean_distance = median(mean_distances);
  Selection selection = allPoints(inliers);
  Smoothing smoothing = findSmoothing(inliers, mean_distance);
  if (smoothing.radius > 0.0F && fillsSpace(inliers, lists.k, mean_distance)) {
    smoothing = {};
  }
  else if (interpretation != NoiseInterpretation::Smooth) {
    smoothing = withLeastRadius(smoothing, mean_distance);
  }
  heartbeat();
  std::vector<float> gaps;
  if (smoothing.radius > 0.0F) {
    gaps = smooth(selection, smoothing, maximum_points, mean_distance);
  }
  else if (interpretation == NoiseInterpretation::Parted) {
    const std::vector<Vector3> normals = estimateNormals(points, lists);
    for (const Index v : number) {
      selection.normals.push_back(normals[v]);
      gaps.push_back(mean_distances[v]);
    }
  }
  const float spacing = spacingForAtMost(selection.places, maximum_points, smoothing.spacing, mean_distance);
  std::vector<Surfel> surface;
  if (interpretation == NoiseInterpretation::Parted) {
    surface = surfels(selection, gaps, std::max(spacing, mean_distance));
  }
  heartbeat();
  if (spacing > 0.0F) {
    selectSpaced(selection, spacing);
  }

  ResampledCloud cloud;
  cloud.smoothing_radius = smoothing.radius;
  cloud.points = std::move(selection.places);
  for (const Index i : selection.chosen) {
    cloud.original.push_back(number[i]);
  }
  cloud.representatives.assign(points.size(), no_index);
  for (std::size_t i = 0; i < number.size(); ++i) {
    cloud.representatives[number[i]] = selection.nearest[i];
  }
  takeInNearby(points, lists, mean_distances, cloud.representatives);
  if (!surface.empty()) {
    const LayerSides layers =
        lookToBothSides(surface, cloud.points, std::move(selection.normals), std::max(spacing, mean_distance));
    if (!layers.sides.empty()) {
      partSheets(points, layers, cloud);
    }
  }
  return cloud;
}

} // namespace symmetry
} // namespace pcl
