#include "symmetry/sides/curve_points.h"

#include "base/vector_math.h"
#include "symmetry/sides/side_settings.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr AxisSettings settings{};

/** A place of the curve and the crossing that it stands for. */
struct Place {
  Vector3 position;
  std::size_t crossing;
};

float
meanEdgeLength(const std::vector<Vector3>& points, const ZeroLine& line)
{
  double sum = 0.0;
  for (const ZeroCrossing& crossing : line.crossings) {
    sum += distance(points[crossing.from], points[crossing.to]);
  }
  return static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(line.crossings.size(), 1)));
}

/** Around a point that the line runs next to it crosses edges in nearly the same place. */
std::vector<Place>
withoutCoincident(const std::vector<Place>& places, float closest, bool closed)
{
  std::vector<Place> kept;
  for (const Place& place : places) {
    if (kept.empty() || distance(kept.back().position, place.position) > closest) {
      kept.push_back(place);
    }
  }
  if (!closed && kept.size() > 1) {
    kept.back() = places.back(); // the line ends at the border itself
  }
  while (closed && kept.size() > 3 && distance(kept.back().position, kept.front().position) <= closest) {
    kept.pop_back();
  }
  return kept;
}

/** Places about \a spacing apart along the line. */
std::vector<Place>
evenlySpaced(const std::vector<Place>& places, float spacing, bool closed)
{
  std::vector<Place> ring = places;
  if (closed) {
    ring.push_back(places.front());
  }
  float length = 0.0F;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    length += distance(ring[i - 1].position, ring[i].position);
  }
  if (!(spacing > 0.0F) || length < 3.0F * spacing) {
    return places;
  }
  const auto steps = static_cast<std::size_t>(std::lround(length / spacing));
  const float step = length / static_cast<float>(steps);
  std::vector<Place> even{places.front()};
  float before = 0.0F; // length of the line up to the start of the segment
  for (std::size_t i = 1; i < ring.size() && even.size() < steps; ++i) {
    const float segment = distance(ring[i - 1].position, ring[i].position);
    float next = step * static_cast<float>(even.size());
    for (; next <= before + segment && even.size() < steps; next = step * static_cast<float>(even.size())) {
      const float share = segment > 0.0F ? (next - before) / segment : 0.0F;
      const Place& nearer = share < 0.5F ? ring[i - 1] : ring[i];
      even.push_back({ring[i - 1].position + share * (ring[i].position - ring[i - 1].position), nearer.crossing});
    }
    before += segment;
  }
  if (!closed) {
    even.push_back(places.back());
  }
  return even;
}

/** One round: every place moves by a share of the way to the middle between its neighbours. */
void
moveToMiddles(std::vector<Place>& places, float share, bool closed)
{
  const std::vector<Place> before = places;
  const std::size_t n = places.size();
  for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < n; ++i) {
    const Vector3 middle = 0.5F * (before[(i + n - 1) % n].position + before[(i + 1) % n].position);
    places[i].position = before[i].position + share * (middle - before[i].position);
  }
}

/** Directions at each place, and the lengths up to it. */
std::vector<AxisPoint>
withDirections(const PreparedSurface& surface,
               const std::vector<float>& side_function,
               const ZeroLine& line,
               const std::vector<Place>& places)
{
  std::vector<AxisPoint> curve;
  const std::size_t n = places.size();
  float length = 0.0F;
  float to_source = 0.0F;
  for (std::size_t i = 0; i < n; ++i) {
    const ZeroCrossing& crossing = line.crossings[places[i].crossing];
    const std::size_t previous = i > 0 ? i - 1 : line.closed ? n - 1 : i;
    const std::size_t next = i + 1 < n ? i + 1 : line.closed ? 0 : i;
    length += i > 0 ? distance(places[i - 1].position, places[i].position) : 0.0F;
    AxisPoint point;
    point.position = places[i].position;
    point.arc_length = length;
    point.nearest = crossing.nearerEnd();
    if (!surface.normals.empty()) {
      point.normal = unitOrZero((1.0F - crossing.share) * surface.normals[crossing.from] +
                                crossing.share * surface.normals[crossing.to]);
    }
    point.across = unitOrZero(cross(point.normal, places[next].position - places[previous].position));
    const Vector3 along_edge = surface.points[crossing.from] - surface.points[crossing.to];
    to_source += dot(point.across, side_function[crossing.from] < 0.0F ? -1.0F * along_edge : along_edge);
    curve.push_back(point);
  }
  if (to_source < 0.0F) { // normals are oriented alike, so that one sign holds for all places
    for (AxisPoint& point : curve) {
      point.across = -1.0F * point.across;
    }
  }
  return curve;
}

} // namespace

std::vector<AxisPoint>
curvePoints(const PreparedSurface& surface, const std::vector<float>& side_function, const ZeroLine& line)
{
  const float edge = meanEdgeLength(surface.points, line);
  std::vector<Place> places;
  for (std::size_t i = 0; i < line.crossings.size(); ++i) {
    places.push_back({placeOf(line.crossings[i], surface.points), i});
  }
  places = withoutCoincident(places, settings.coincidence * edge, line.closed);
  if (surface.is_cloud) {
    places = evenlySpaced(places, edge, line.closed);
    for (int round = 0; places.size() > 3 && round < settings.fairing_rounds; ++round) {
      moveToMiddles(places, settings.fairing, line.closed);
      moveToMiddles(places, -settings.fairing_back, line.closed);
    }
  }
  return withDirections(surface, side_function, line, places);
}

} // namespace symmetry
} // namespace pcl
