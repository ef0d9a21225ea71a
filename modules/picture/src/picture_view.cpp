#include "picture/picture_view.h"

#include "base/vector_math.h"
#include "picture/upright.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t coverage_size = 40;     ///< cells across the coarse pictures that views are compared by
constexpr std::size_t coverage_points = 6000; ///< points drawn into them
constexpr int directions_tried = 200;

Vector3
at(const Surface& surface, Index index)
{
  return surface.points[static_cast<std::size_t>(index)];
}

/** \brief What there is to be seen: some of the points, with their sides, about their mean. */
struct Scene {
  std::vector<Vector3> points;
  std::vector<Side> sides;
  Vector3 centre = {0.0F, 0.0F, 0.0F};
  float radius = 1.0F;
};

Scene
makeScene(const Surface& surface, const SymmetryResult& result)
{
  Scene scene;
  const std::size_t step = std::max<std::size_t>(1, surface.size() / coverage_points);
  std::array<double, 3> sum = {0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < surface.size(); i += step) {
    if (!isFinite(surface.points[i]))
      continue;
    scene.points.push_back(surface.points[i]);
    scene.sides.push_back(result.sides[i]);
    for (std::size_t k = 0; k < 3; ++k)
      sum[k] += static_cast<double>(surface.points[i][k]);
  }
  const double count = std::max(1.0, static_cast<double>(scene.points.size()));
  for (std::size_t k = 0; k < 3; ++k)
    scene.centre[k] = static_cast<float>(sum[k] / count);
  scene.radius = 0.0F;
  for (const Vector3& point : scene.points)
    scene.radius = std::max(scene.radius, distance(point, scene.centre));
  if (!(scene.radius > 0.0F))
    scene.radius = 1.0F;
  return scene;
}

/** \brief Directions of the spread of the points, largest first. */
std::array<Vector3, 3>
principalDirections(const Scene& scene)
{
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Vector3& point : scene.points) {
    const Vector3 offset = (1.0F / scene.radius) * (point - scene.centre);
    const Eigen::Vector3d place(offset[0], offset[1], offset[2]);
    covariance += place * place.transpose();
  }
  const Eigen::Matrix3f vectors =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().cast<float>();
  std::array<Vector3, 3> directions = {};
  for (int i = 0; i < 3; ++i)
    directions[static_cast<std::size_t>(2 - i)] = {vectors(0, i), vectors(1, i), vectors(2, i)};
  return directions;
}

/** \brief Direction from the source side to the target side: that of the plane which fits the map best, or without one
 * the mean of all pairs; zero where there are none. */
Vector3
lateralDirection(const Surface& surface, const SymmetryResult& result, const std::vector<PartnerPair>& pairs)
{
  const std::array<double, 3>& normal = result.plane.normal;
  const Vector3 across{-static_cast<float>(normal[0]), -static_cast<float>(normal[1]), -static_cast<float>(normal[2])};
  if (!pairs.empty() && norm(across) > 0.0F) {
    return across;
  }
  std::array<double, 3> sum = {0.0, 0.0, 0.0};
  for (const PartnerPair& pair : pairs) {
    const Vector3 offset = at(surface, pair.target) - at(surface, pair.source);
    for (std::size_t k = 0; k < 3; ++k)
      sum[k] += static_cast<double>(offset[k]);
  }
  const double length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  if (!(length > 0.0))
    return {0.0F, 0.0F, 0.0F};
  return {static_cast<float>(sum[0] / length), static_cast<float>(sum[1] / length),
          static_cast<float>(sum[2] / length)};
}

/** \brief The direction or its opposite, whichever has its largest coordinate positive: scans mostly stand along +y or
 * +z. */
Vector3
uprightSign(const Vector3& direction)
{
  const auto largest =
      std::max_element(direction.begin(), direction.end(), [](float a, float b) { return std::abs(a) < std::abs(b); });
  return *largest < 0.0F ? -1.0F * direction : direction;
}

/** \brief The view against \a toward in which \a level is level. */
PictureView
makeView(const Scene& scene, const Vector3& toward, const Vector3& level)
{
  PictureView view;
  view.toward = toward;
  view.up = cross(toward, level);
  if (norm(view.up) < 1e-3F) // seen along the level direction: any other will do
    view.up = cross(toward, std::abs(toward[0]) < 0.7F ? Vector3{1.0F, 0.0F, 0.0F} : Vector3{0.0F, 1.0F, 0.0F});
  view.up = uprightSign(normalized(view.up));
  view.right = cross(view.up, view.toward);
  view.centre = scene.centre;
  return view;
}

/** \brief Cells of a coarse picture in which each side is on top. */
std::array<double, 4>
countVisible(const Scene& scene, const PictureView& view)
{
  struct Top {
    float depth = -std::numeric_limits<float>::infinity();
    Side side = Side::None;
  };
  std::vector<Top> cells(coverage_size * coverage_size);
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const Vector3 offset = (0.5F / scene.radius) * (scene.points[i] - scene.centre);
    const auto cell = [](float coordinate) {
      constexpr auto size = static_cast<float>(coverage_size);
      // In this order what is not a number becomes 0.
      return static_cast<std::size_t>(std::min(std::max(0.0F, (coordinate + 0.5F) * size), size - 1.0F));
    };
    Top& top = cells[cell(dot(offset, view.up)) * coverage_size + cell(dot(offset, view.right))];
    const float depth = dot(offset, view.toward);
    if (depth > top.depth)
      top = {depth, scene.sides[i]};
  }
  std::array<double, 4> visible = {0.0, 0.0, 0.0, 0.0};
  for (const Top& top : cells)
    if (std::isfinite(top.depth))
      visible[static_cast<std::size_t>(top.side)] += 1.0;
  return visible;
}

/** \brief Worth of a view: area, times how evenly it shows the two sides. */
double
rateView(const Scene& scene, const PictureView& view, bool has_sides)
{
  const std::array<double, 4> visible = countVisible(scene, view);
  const double area = visible[0] + visible[1] + visible[2] + visible[3];
  if (!has_sides)
    return area;
  const double less = std::min(visible[1], visible[2]);
  const double more = std::max(visible[1], visible[2]);
  return more > 0.0 ? area * std::sqrt(less / more) : 0.0;
}

/** \brief Evenly spread directions at right angles to one: from there both sides are seen alike, and an axis that lies in
 * the plane between them is a straight line. */
std::vector<Vector3>
halfCircle(const Vector3& direction)
{
  constexpr int directions_around = 60; // 3 degrees apart
  const Vector3 other = std::abs(direction[0]) < 0.7F ? Vector3{1.0F, 0.0F, 0.0F} : Vector3{0.0F, 1.0F, 0.0F};
  const Vector3 first = normalized(cross(direction, other));
  const Vector3 second = cross(direction, first);
  std::vector<Vector3> directions;
  for (int i = 0; i < directions_around; ++i) {
    const double angle = std::acos(-1.0) * i / directions_around;
    directions.push_back(static_cast<float>(std::cos(angle)) * first + static_cast<float>(std::sin(angle)) * second);
  }
  return directions;
}

/** \brief Evenly spread directions of a half sphere (Fibonacci lattice). */
std::vector<Vector3>
halfSphere()
{
  std::vector<Vector3> directions;
  const double golden_angle = std::acos(-1.0) * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < directions_tried; ++i) {
    const double z = (i + 0.5) / directions_tried;
    const double radius = std::sqrt(1.0 - z * z);
    directions.push_back({static_cast<float>(radius * std::cos(golden_angle * i)),
                          static_cast<float>(radius * std::sin(golden_angle * i)), static_cast<float>(z)});
  }
  return directions;
}

float
extentAlong(const Scene& scene, const Vector3& direction)
{
  float least = std::numeric_limits<float>::infinity();
  float most = -least;
  for (const Vector3& point : scene.points) {
    const float place = dot(point - scene.centre, direction);
    least = std::min(least, place);
    most = std::max(most, place);
  }
  return most - least;
}

/** \brief Whether there is nothing to be seen from the side, as of a sheet: it is looked at from the front, up or not. */
bool
isFlat(const Scene& scene, const std::array<Vector3, 3>& principal)
{
  constexpr float thin = 0.01F; // edge-on it would be a line some pixels wide
  return extentAlong(scene, principal[2]) < thin * extentAlong(scene, principal[0]);
}

/** \brief Of several views the one that shows most from before and from behind; ties go to the first. */
PictureView
bestOf(const Scene& scene, const std::vector<PictureView>& views, bool has_sides)
{
  PictureView best = views.front();
  double best_worth = -1.0;
  for (const PictureView& view : views) {
    const double worth = rateView(scene, view, has_sides) + rateView(scene, view.fromBehind(), has_sides);
    if (worth > best_worth) {
      best_worth = worth;
      best = view;
    }
  }
  return best;
}

/** \brief Views at the height of the surface, from the front and, of what is deeper than wide, from some way to its sides:
 * an axis in the plane between the sides is a straight line from the front only. */
std::vector<PictureView>
viewsAround(const Scene& scene, const Vector3& upright, const Vector3& level)
{
  constexpr std::array<float, 7> angles = {0.0F, 0.3F, -0.3F, 0.6F, -0.6F, 0.9F, -0.9F};
  const Vector3 front = cross(level, upright);
  const bool is_deep = extentAlong(scene, front) > extentAlong(scene, level);
  std::vector<PictureView> views;
  for (const float angle : angles) {
    if (angle != 0.0F && !is_deep) {
      break; // the front comes first
    }
    PictureView view;
    view.up = upright;
    view.toward = std::cos(angle) * front + std::sin(angle) * level;
    view.right = cross(view.up, view.toward);
    view.centre = scene.centre;
    views.push_back(view);
  }
  return views;
}

/** \brief Turns the view sideways, for what is deeper than wide: an animal seen from straight above or below shows both
 * of its sides, but hardly its shape. */
void
turn(PictureView& view)
{
  constexpr float angle = 0.5F;
  view.toward = std::cos(angle) * view.toward + std::sin(angle) * view.right;
  view.right = cross(view.up, view.toward);
}

/** \brief Makes the view show all points, with a margin. */
void
fitView(const std::vector<Vector3>& points, PictureView& view)
{
  constexpr float margin = 1.08F;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::array<float, 2> least = {infinity, infinity};
  std::array<float, 2> most = {-infinity, -infinity};
  for (const Vector3& point : points) {
    if (!isFinite(point))
      continue;
    const std::array<float, 2> place = {dot(point - view.centre, view.right), dot(point - view.centre, view.up)};
    for (std::size_t k = 0; k < 2; ++k) {
      least[k] = std::min(least[k], place[k]);
      most[k] = std::max(most[k], place[k]);
    }
  }
  const float extent = std::max(most[0] - least[0], most[1] - least[1]);
  if (!std::isfinite(extent)) // no point at all, or coordinates at the end of what a float holds
    return;
  view.centre = view.centre + 0.5F * (least[0] + most[0]) * view.right + 0.5F * (least[1] + most[1]) * view.up;
  const float smallest = extent > 0.0F ? 1e-3F * extent : 1.0F; // a line, or a single place
  view.width = margin * std::max(most[0] - least[0], smallest);
  view.height = margin * std::max(most[1] - least[1], smallest);
}

} // namespace

PictureView
PictureView::fromBehind() const
{
  PictureView view = *this;
  view.right = -1.0F * right;
  view.toward = -1.0F * toward;
  return view;
}

std::vector<PartnerPair>
findPartnerPairs(const Surface& surface, const SymmetryResult& result)
{
  std::vector<PartnerPair> pairs;
  const auto add = [&](Index source, Index target) {
    if (target != no_index && isFinite(at(surface, source)) && isFinite(at(surface, target)))
      pairs.push_back({source, target});
  };
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (result.sides[i] == Side::Source)
      add(static_cast<Index>(i), result.partners[i]);
  if (pairs.empty())
    for (const SymmetricMatch& match : result.matches)
      add(match.source, match.target);
  return pairs;
}

PictureView
chooseView(const Surface& surface, const SymmetryResult& result, const std::vector<PartnerPair>& pairs)
{
  const Scene scene = makeScene(surface, result);
  const std::array<Vector3, 3> principal = principalDirections(scene);
  const Vector3 lateral = lateralDirection(surface, result, pairs);
  const bool has_pairs = norm(lateral) > 0.0F;
  const Vector3 level = has_pairs ? lateral : principal[1];

  const bool can_stand = has_pairs && !isFlat(scene, principal);
  const Vector3 upright = can_stand ? uprightDirection(scene.points, lateral) : Vector3{0.0F, 0.0F, 0.0F};
  if (norm(upright) > 0.0F) {
    PictureView view = bestOf(scene, viewsAround(scene, upright, level), has_pairs);
    fitView(surface.points, view);
    return view;
  }
  std::vector<Vector3> directions = has_pairs ? halfCircle(level) : halfSphere();
  if (!has_pairs) {
    directions.insert(directions.begin(), principal.begin(), principal.end());
  }
  std::vector<PictureView> views;
  views.reserve(directions.size());
  for (const Vector3& direction : directions)
    views.push_back(makeView(scene, direction, level));
  PictureView best = bestOf(scene, views, has_pairs);
  if (has_pairs && extentAlong(scene, best.toward) > extentAlong(scene, best.right))
    turn(best);
  fitView(surface.points, best);
  return best;
}

} // namespace symmetry
} // namespace pcl
