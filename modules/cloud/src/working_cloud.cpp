#include "cloud/working_cloud.h"

#include "cloud/point_grid.h"
#include "geodesic/parallel.h"
#include "geodesic/vector_math.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl {
namespace symmetry {
namespace {

float
median(std::vector<float> values)
{
  if (values.empty()) {
    return 0.0F;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** Mean distance of every point to its neighbours. */
std::vector<float>
neighbourDistances(const std::vector<Vector3>& points, const NeighbourLists& lists)
{
  std::vector<float> mean(points.size(), 0.0F);
  for (std::size_t v = 0; v < points.size(); ++v) {
    std::size_t found = 0;
    for (std::size_t i = v * lists.k; i < (v + 1) * lists.k && lists.neighbours[i] != no_index; ++i, ++found) {
      mean[v] += distance(points[v], points[lists.neighbours[i]]);
    }
    mean[v] /= static_cast<float>(std::max<std::size_t>(found, 1));
  }
  return mean;
}

/** Points whose neighbours are, in the lower quartile, several times closer to theirs. */
std::vector<char>
findOutliers(const NeighbourLists& lists, const std::vector<float>& mean_distance)
{
  constexpr float farther = 3.0F;
  std::vector<char> outlier(mean_distance.size(), 0);
  std::vector<float> around;
  for (std::size_t v = 0; v < mean_distance.size(); ++v) {
    around.clear();
    for (std::size_t i = v * lists.k; i < (v + 1) * lists.k && lists.neighbours[i] != no_index; ++i) {
      if (static_cast<std::size_t>(lists.neighbours[i]) != v) {
        around.push_back(mean_distance[lists.neighbours[i]]);
      }
    }
    if (!around.empty()) {
      const auto quartile = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 4);
      std::nth_element(around.begin(), quartile, around.end());
      outlier[v] = static_cast<char>(*quartile > 0.0F && mean_distance[v] > farther * *quartile);
    }
  }
  return outlier;
}

/** Plane through the mean of the points around a place. */
struct LocalPlane {
  Vector3 mean{};
  Vector3 normal{};
  float thickness = 0.0F; ///< root mean square distance of the points from it
  float support = 0.0F;   ///< sum of the weights
};

/** The points nearer to a place than a radius, which is the edge of the grid's cubes. */
void
gatherAround(const std::vector<Vector3>& points,
             const PointGrid& grid,
             const Vector3& place,
             float radius,
             std::vector<Vector3>& gathered)
{
  gathered.clear();
  grid.visitAround(place, [&](Index i) {
    if (distance(points[i], place) < radius) {
      gathered.push_back(points[i]);
    }
  });
}

/** 1 in the middle, 0 from one unit off on. */
float
biweight(float squared)
{
  return squared < 1.0F ? (1.0F - squared) * (1.0F - squared) : 0.0F;
}

/** \param[in] weight of a point at an offset from the place, in units of the radius */
template <typename Weight>
LocalPlane
fitPlane(const std::vector<Vector3>& around, const Vector3& place, float radius, Weight weight)
{
  Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  LocalPlane plane{place, {0.0F, 0.0F, 1.0F}, 0.0F, 0.0F};
  for (const Vector3& p : around) {
    const Vector3 offset = (1.0F / radius) * (p - place);
    const float w = weight(offset);
    const Eigen::Vector3f x(offset[0], offset[1], offset[2]);
    mean += w * x;
    covariance += w * x * x.transpose();
    plane.support += w;
  }
  if (plane.support <= 0.0F) {
    return plane;
  }
  mean /= plane.support;
  covariance = covariance / plane.support - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(covariance);
  const Eigen::Vector3f normal = solver.eigenvectors().col(0);
  if (normal.allFinite()) {
    plane.normal = normalized({normal.x(), normal.y(), normal.z()});
  }
  plane.mean = place + radius * Vector3{mean.x(), mean.y(), mean.z()};
  plane.thickness = radius * std::sqrt(std::max(0.0F, solver.eigenvalues()(0)));
  return plane;
}

/** Plane through all points around a place; the farther they are, the less they count. */
LocalPlane
fitPlane(const std::vector<Vector3>& around, const Vector3& place, float radius)
{
  return fitPlane(around, place, radius, [](const Vector3& offset) { return biweight(dot(offset, offset)); });
}

/** Plane through those points around a place that are on its own sheet of the surface: points also count the less the
 * farther they are from the plane through the place, and from \a width on not at all. */
LocalPlane
fitSheet(const std::vector<Vector3>& around, const Vector3& place, const Vector3& normal, float radius, float width)
{
  const float radii_per_width = radius / width;
  return fitPlane(around, place, radius, [&](const Vector3& offset) {
    const float height = radii_per_width * dot(offset, normal);
    return biweight(dot(offset, offset)) * biweight(height * height);
  });
}

/** Every so many-th point, so that about \a most are left; all if there are no more. */
std::vector<Vector3>
everyFew(const std::vector<Vector3>& points, std::size_t most)
{
  const std::size_t stride = std::max<std::size_t>(1, points.size() / std::max<std::size_t>(1, most));
  std::vector<Vector3> chosen;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    chosen.push_back(points[i]);
  }
  return chosen;
}

/** Median thickness of neighbourhoods over their radius; a ball has 0.33. */
float
relativeThickness(const std::vector<Vector3>& points, float radius)
{
  constexpr std::size_t probes = 600;
  const PointGrid grid(points, radius);
  std::vector<float> thickness;
  std::vector<Vector3> around;
  for (const Vector3& place : everyFew(points, probes)) {
    gatherAround(points, grid, place, radius, around);
    thickness.push_back(fitPlane(around, place, radius).thickness / radius);
  }
  return median(std::move(thickness));
}

/** How a noisy cloud is smoothed. */
struct Smoothing {
  float radius = 0.0F;  ///< of the neighbourhoods that sheets are fitted to; 0: there is no noise to speak of
  float width = 0.0F;   ///< half the thickness of a sheet
  float spacing = 0.0F; ///< of points that show all that is left to see
};

/** The radius at which neighbourhoods are flattest for their size: below it noise makes them thick, above it the
 * curvature of the surface. None where they are flat at the spacing, or hardly thick there and, since that comes from
 * curvature, thicker at once above it. The width is that of the flattest neighbourhoods, which curvature makes thicker
 * than the noise alone: a narrower one would keep noise that happens to bunch. */
Smoothing
findSmoothing(const std::vector<Vector3>& points, float spacing)
{
  constexpr float first = 2.2F;    // spacings; with fewer points around, any plane fits
  constexpr float largest = 0.06F; // of the longest side
  constexpr float step = 1.25F;
  constexpr float flat = 0.09F;
  constexpr float fewest = 6.0F;   // spacings; with fewer points around, planes are uncertain
  constexpr float step_up = 1.25F; // with more points the planes gain in certainty more than they lose
  constexpr float spacings_per_radius = 6.0F;
  constexpr float width_of_thickness = 3.0F; // the thickness is a standard deviation
  Smoothing best;
  float flattest = std::numeric_limits<float>::infinity();
  for (float radius = first * spacing; radius > 0.0F && radius < largest; radius *= step) {
    const float thickness = relativeThickness(points, radius);
    if (best.radius == 0.0F && thickness < flat) {
      return {};
    }
    if (thickness < flattest) {
      flattest = thickness;
      best = {std::max(step_up * radius, fewest * spacing), width_of_thickness * thickness * radius,
              radius / spacings_per_radius};
    }
  }
  return best;
}

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
nearestKept(const std::vector<Vector3>& points, const std::vector<Index>& kept, float spacing, unsigned threads)
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
      points.size(), threads,
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

constexpr std::size_t enough = 500; // points for a plane

/** Number of points within a radius that nine of ten neighbourhoods have. */
std::size_t
fewestAround(const std::vector<Vector3>& points, float radius)
{
  constexpr std::size_t probes = 300;
  const PointGrid grid(points, radius);
  std::vector<std::size_t> numbers;
  std::vector<Vector3> around;
  for (const Vector3& place : everyFew(points, probes)) {
    gatherAround(points, grid, place, radius, around);
    numbers.push_back(around.size());
  }
  const auto tenth = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 10);
  std::nth_element(numbers.begin(), tenth, numbers.end());
  return *tenth;
}

/** Moves a place onto its sheet; the share of the weight of all points around that is within the sheet. */
float
moveToSheet(Vector3& place, const std::vector<Vector3>& around, const Smoothing& smoothing)
{
  constexpr int rounds = 4; // each takes a place nearer to the middle of its sheet by more than a half
  const LocalPlane all = fitPlane(around, place, smoothing.radius);
  LocalPlane sheet = all;
  for (int round = 0; round < rounds; ++round) {
    sheet = fitSheet(around, place, sheet.normal, smoothing.radius, smoothing.width);
    place = place - dot(place - sheet.mean, sheet.normal) * sheet.normal;
  }
  return all.support > 0.0F ? sheet.support / all.support : 0.0F;
}

/** Moves places onto the sheets of the surface around them; how many points support each, 0 where most points around
 * are on other sheets. Where two sheets are nearer to each other than the radius each place stays with its own (robust
 * moving least squares, as S. Fleishman et al.: Robust moving least-squares fitting with sharp features, 2005). */
std::vector<float>
moveToSheets(std::vector<Vector3>& places,
             const std::vector<Vector3>& points,
             const Smoothing& smoothing,
             unsigned threads)
{
  constexpr float least_share = 0.1F; // of a stray point; at a fork of sheets it is larger
  std::vector<float> support(places.size(), 0.0F);
  const PointGrid grid(points, smoothing.radius);
  constexpr std::size_t grain = 64;
  parallelBlocks(places.size(), grain, threads, [&] {
    return [&, around = std::vector<Vector3>()](std::size_t begin, std::size_t end) mutable {
      for (std::size_t v = begin; v < end; ++v) {
        gatherAround(points, grid, places[v], smoothing.radius, around);
        const auto number = static_cast<float>(around.size());
        around = everyFew(around, enough);
        const float share = moveToSheet(places[v], around, smoothing);
        support[v] = share < least_share ? 0.0F : share * number;
      }
    };
  });
  return support;
}

/** Some points of a cloud, with the places that they were moved to. */
struct Selection {
  std::vector<Index> chosen;   ///< numbers in the cloud
  std::vector<Vector3> places; ///< of the chosen ones
  std::vector<Index> nearest;  ///< for every point of the cloud the entry that stands for it, no_index: an outlier
};

Selection
allPoints(const std::vector<Vector3>& points)
{
  Selection all{std::vector<Index>(points.size()), points, {}};
  std::iota(all.chosen.begin(), all.chosen.end(), 0);
  all.nearest = all.chosen;
  return all;
}

/** Goes over to the given entries. \param[in] stand_in for every entry now: which of those stands for it */
void
select(Selection& selection, const std::vector<Index>& kept, const std::vector<Index>& stand_in)
{
  for (std::size_t i = 0; i < kept.size(); ++i) { // ascending: nothing is overwritten that is still needed
    selection.chosen[i] = selection.chosen[kept[i]];
    selection.places[i] = selection.places[kept[i]];
  }
  selection.chosen.resize(kept.size());
  selection.places.resize(kept.size());
  for (Index& entry : selection.nearest) {
    entry = entry == no_index ? no_index : stand_in[entry];
  }
}

void
selectSpaced(Selection& selection, float spacing, unsigned threads)
{
  const std::vector<Index> kept = thinOut(selection.places, spacing);
  select(selection, kept, nearestKept(selection.places, kept, spacing, threads));
}

/** Takes out entries with hardly any points around them, and what they stand for. */
void
dropUnsupported(Selection& selection, const std::vector<float>& support)
{
  constexpr float little = 0.05F; // of the median; the density may well vary by ten
  const float least = little * median(support);
  std::vector<Index> kept;
  std::vector<Index> stand_in(support.size(), no_index);
  for (std::size_t i = 0; i < support.size(); ++i) {
    if (support[i] >= least) {
      stand_in[i] = static_cast<Index>(kept.size());
      kept.push_back(static_cast<Index>(i));
    }
  }
  select(selection, kept, stand_in);
}

/** A spacing, not below the given one, that leaves at most so many points. */
float
spacingForAtMost(const std::vector<Vector3>& points, std::size_t most, float spacing, float mean_distance)
{
  std::size_t left = spacing > 0.0F ? thinOut(points, spacing).size() : points.size();
  while (left > most) {
    // On a surface the number of points falls with the square of the spacing.
    const float finer = std::max(spacing, mean_distance);
    spacing = finer * std::max(1.1F, std::sqrt(static_cast<float>(left) / static_cast<float>(most)));
    left = thinOut(points, spacing).size();
  }
  return spacing;
}

/** Moves the points of a noisy cloud onto its sheets. Not all of them: some at a fraction of the spacing to come, by
 * enough others. */
void
smooth(Selection& selection, const Smoothing& smoothing, std::size_t most, float mean_distance, unsigned threads)
{
  constexpr float fraction = 0.5F;
  const std::size_t times_enough = std::max<std::size_t>(1, fewestAround(selection.places, smoothing.radius) / enough);
  const std::vector<Vector3> points = everyFew(selection.places, selection.places.size() / times_enough);
  const float spacing = spacingForAtMost(selection.places, 2 * most, fraction * smoothing.spacing, mean_distance);
  selectSpaced(selection, spacing, threads);
  dropUnsupported(selection, moveToSheets(selection.places, points, smoothing, threads));
}

} // namespace

WorkingCloud
makeWorkingCloud(const std::vector<Vector3>& points,
                 const NeighbourLists& lists,
                 std::size_t most,
                 unsigned threads,
                 float smoothing_share)
{
  const std::vector<float> mean_distances = neighbourDistances(points, lists);
  const std::vector<char> outlier = findOutliers(lists, mean_distances);
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
  smoothing.radius *= smoothing_share;
  smoothing.spacing *= smoothing_share;
  if (smoothing.radius > 0.0F) {
    smooth(selection, smoothing, most, mean_distance, threads);
  }
  const float spacing = spacingForAtMost(selection.places, most, smoothing.spacing, mean_distance);
  if (spacing > 0.0F) {
    selectSpaced(selection, spacing, threads);
  }

  WorkingCloud cloud;
  cloud.smoothing_radius = smoothing.radius;
  cloud.points = std::move(selection.places);
  for (const Index i : selection.chosen) {
    cloud.original.push_back(number[i]);
  }
  cloud.representatives.assign(points.size(), no_index);
  for (std::size_t i = 0; i < number.size(); ++i) {
    cloud.representatives[number[i]] = selection.nearest[i];
  }
  cloud.outliers =
      static_cast<std::size_t>(std::count(cloud.representatives.begin(), cloud.representatives.end(), no_index));
  return cloud;
}

} // namespace symmetry
} // namespace pcl
