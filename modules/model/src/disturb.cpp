#include "model/disturb.h"

#include "base/bounding_box.h"
#include "model/random_numbers.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

void
checkRange(const char* what, double value, double low, double high)
{
  if (value >= low && value <= high)
    return;
  std::ostringstream message;
  message << what << " is " << value << ", allowed are " << low << " to " << high;
  throw std::invalid_argument(message.str());
}

/** \brief Uniform on the unit sphere. */
std::array<double, 3>
randomDirection(RandomNumbers& random)
{
  const double z = random.uniform(-1.0, 1.0);
  const double angle = random.uniform(0.0, 6.283185307179586);
  const double radius = std::sqrt(1.0 - z * z);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/** Three directions at right angles to each other, the first of which is random. */
Eigen::Matrix3d
randomAxes(RandomNumbers& random)
{
  const std::array<double, 3> direction = randomDirection(random);
  const Eigen::Vector3d first(direction[0], direction[1], direction[2]);
  const Eigen::Vector3d second =
      Eigen::AngleAxisd(random.uniform(0.0, 6.283185307179586), first) * first.unitOrthogonal();
  Eigen::Matrix3d axes;
  axes << first, second, first.cross(second);
  return axes;
}

/** Between 0.6 and 1 of an angle, to either side. */
double
randomPart(double angle, RandomNumbers& random)
{
  const double part = angle * random.uniform(0.6, 1.0);
  return random.uniform() < 0.5 ? -part : part;
}

/** What lies along the first axis comes to lie on an arc in the plane of the first two. */
Eigen::Vector3d
bent(const Eigen::Vector3d& p, double angle)
{
  const double radius = 1.0 / angle;
  return {(radius - p.y()) * std::sin(p.x() * angle), radius - (radius - p.y()) * std::cos(p.x() * angle), p.z()};
}

/** Turned about the first axis, the farther along it the more. */
Eigen::Vector3d
twisted(const Eigen::Vector3d& p, double angle)
{
  return Eigen::AngleAxisd(p.x() * angle, Eigen::Vector3d::UnitX()) * p;
}

std::vector<std::vector<Index>>
neighbourLists(const Surface& surface)
{
  std::vector<std::vector<Index>> lists(surface.size());
  for (const Triangle& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      lists[static_cast<std::size_t>(t[k])].push_back(t[(k + 1) % 3]);
  return lists;
}

/** \brief The first \a count vertices that a walk over the edges meets, ring by ring. */
std::vector<Index>
patchOnMesh(const std::vector<std::vector<Index>>& neighbours, Index seed, std::size_t count)
{
  std::vector<char> met(neighbours.size(), 0);
  std::vector<Index> patch = {seed};
  met[static_cast<std::size_t>(seed)] = 1;
  for (std::size_t next = 0; next < patch.size() && patch.size() < count; ++next)
    for (const Index other : neighbours[static_cast<std::size_t>(patch[next])])
      if (met[static_cast<std::size_t>(other)] == 0) {
        met[static_cast<std::size_t>(other)] = 1;
        patch.push_back(other);
      }
  patch.resize(std::min(count, patch.size()));
  return patch;
}

/** \brief The \a count points closest to one of them. */
std::vector<Index>
patchOnCloud(const Surface& surface, Index seed, std::size_t count)
{
  const Vector3 centre = surface.points[static_cast<std::size_t>(seed)];
  std::vector<std::pair<double, Index>> order(surface.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    double squared = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      squared += std::pow(static_cast<double>(surface.points[i][k]) - static_cast<double>(centre[k]), 2);
    order[i] = {squared, static_cast<Index>(i)};
  }
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count - 1), order.end());
  std::vector<Index> patch(count);
  std::transform(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), patch.begin(),
                 [](const auto& entry) { return entry.second; });
  return patch;
}

/** \brief Unmarks vertices whose triangles have all lost a vertex. */
void
unmarkLoose(const Surface& surface, std::vector<char>& keep)
{
  std::vector<char> held(keep.size(), 0);
  const auto kept = [&](Index vertex) {
    return keep[static_cast<std::size_t>(vertex)] != 0;
  };
  for (const Triangle& t : surface.triangles)
    if (std::all_of(t.begin(), t.end(), kept))
      for (const Index vertex : t)
        held[static_cast<std::size_t>(vertex)] = 1;
  keep = std::move(held);
}

/** \brief Applies new vertex numbers: \a number[i] is that of vertex i, or no_index where it goes. */
void
renumber(Model& model, const std::vector<Index>& number, std::size_t count)
{
  const auto renamed = [&](Index vertex) {
    return vertex == no_index ? no_index : number[static_cast<std::size_t>(vertex)];
  };
  Model result;
  result.surface.points.resize(count);
  result.surface.normals.resize(model.surface.normals.empty() ? 0 : count);
  result.partners.resize(count, no_index);
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == no_index)
      continue;
    const auto to = static_cast<std::size_t>(number[i]);
    result.surface.points[to] = model.surface.points[i];
    if (!model.surface.normals.empty())
      result.surface.normals[to] = model.surface.normals[i];
    result.partners[to] = renamed(model.partners[i]);
  }
  for (const Triangle& t : model.surface.triangles) {
    const Triangle moved = {renamed(t[0]), renamed(t[1]), renamed(t[2])};
    if (*std::min_element(moved.begin(), moved.end()) != no_index)
      result.surface.triangles.push_back(moved);
  }
  model = std::move(result);
}

} // namespace

void
addNoise(Model& model, double fraction, std::uint64_t seed)
{
  checkRange("noise", fraction, 0.0, 1.0);
  RandomNumbers random(seed);
  const double deviation = fraction * boundingBox(model.surface.points).diagonal();
  for (Vector3& point : model.surface.points) {
    const std::array<double, 3> direction = randomDirection(random);
    const double length = deviation * random.normal();
    for (std::size_t k = 0; k < 3; ++k)
      point[k] = static_cast<float>(static_cast<double>(point[k]) + length * direction[k]);
  }
}

void
bend(Model& model, double angle, std::uint64_t seed)
{
  checkRange("angle of the bends", angle, 0.0, 3.0);
  const BoundingBox box = boundingBox(model.surface.points);
  const double diagonal = box.diagonal();
  if (angle == 0.0 || diagonal == 0.0)
    return;
  const auto vector = [](const Vector3& v) {
    return Eigen::Vector3d(v[0], v[1], v[2]);
  };
  const Eigen::Vector3d centre = 0.5 * (vector(box.low) + vector(box.high));
  RandomNumbers random(seed);
  for (const auto motion : {bent, bent, twisted}) {
    const Eigen::Matrix3d axes = randomAxes(random);
    const double part = randomPart(angle, random);
    for (Vector3& point : model.surface.points) {
      const Eigen::Vector3d p = axes.transpose() * (vector(point) - centre) / diagonal;
      const Eigen::Vector3d moved = centre + diagonal * (axes * motion(p, part));
      point = {static_cast<float>(moved.x()), static_cast<float>(moved.y()), static_cast<float>(moved.z())};
    }
  }
  model.surface.normals.clear();
}

void
quantise(Model& model, double fraction)
{
  checkRange("step", fraction, 0.0, 1.0);
  const double step = fraction * boundingBox(model.surface.points).diagonal();
  if (step == 0.0)
    return;
  for (Vector3& point : model.surface.points)
    for (float& coordinate : point)
      coordinate = static_cast<float>(step * std::round(static_cast<double>(coordinate) / step));
}

std::vector<char>
markOutsideHoles(const Surface& surface, std::size_t holes, double share, std::uint64_t seed)
{
  checkRange("share of the holes", share, 0.0, 0.9);
  const std::size_t points = surface.size();
  std::vector<char> keep(points, 1);
  if (holes == 0 || points == 0)
    return keep;
  RandomNumbers random(seed);
  const double each = share * static_cast<double>(points) / static_cast<double>(holes);
  const std::size_t count = std::max<std::size_t>(1, static_cast<std::size_t>(each));
  const bool faces = surface.hasFaces();
  const std::vector<std::vector<Index>> neighbours =
      faces ? neighbourLists(surface) : std::vector<std::vector<Index>>();
  for (std::size_t hole = 0; hole < holes; ++hole) {
    const auto centre = static_cast<Index>(random.index(points));
    const std::vector<Index> patch =
        faces ? patchOnMesh(neighbours, centre, count) : patchOnCloud(surface, centre, count);
    for (const Index vertex : patch)
      keep[static_cast<std::size_t>(vertex)] = 0;
  }
  if (faces)
    unmarkLoose(surface, keep);
  return keep;
}

void
cutHoles(Model& model, std::size_t holes, double share, std::uint64_t seed)
{
  keepVertices(model, markOutsideHoles(model.surface, holes, share, seed));
}

std::vector<char>
markThinnedOut(const std::vector<Vector3>& points, double ratio, std::uint64_t seed)
{
  checkRange("density ratio", ratio, 1.0, 1000.0);
  RandomNumbers random(seed);
  const std::array<double, 3> direction = randomDirection(random);
  std::vector<double> along(points.size(), 0.0);
  for (std::size_t i = 0; i < along.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      along[i] += direction[k] * static_cast<double>(points[i][k]);
  if (along.empty())
    return {};
  const auto [least, most] = std::minmax_element(along.begin(), along.end());
  const double low = *least;
  const double range = std::max(*most - low, 1e-300);
  std::vector<char> keep(along.size());
  for (std::size_t i = 0; i < keep.size(); ++i)
    keep[i] = random.uniform() < std::pow(ratio, -(along[i] - low) / range) ? 1 : 0;
  return keep;
}

void
thinOut(Model& model, double ratio, std::uint64_t seed)
{
  const std::vector<char> keep = markThinnedOut(model.surface.points, ratio, seed);
  dropFaces(model);
  keepVertices(model, keep);
}

void
dropPoints(Model& model, double share, std::uint64_t seed)
{
  checkRange("share of dropped points", share, 0.0, 1.0 - 1e-9);
  dropFaces(model);
  RandomNumbers random(seed);
  std::vector<std::size_t> order(model.surface.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  random.shuffle(order);
  std::vector<char> keep(order.size(), 1);
  const auto dropped = static_cast<std::size_t>(share * static_cast<double>(order.size()));
  for (std::size_t i = 0; i < dropped; ++i)
    keep[order[i]] = 0;
  keepVertices(model, keep);
}

void
dropFaces(Model& model)
{
  model.surface.triangles.clear();
}

void
shuffleVertices(Model& model, std::uint64_t seed)
{
  RandomNumbers random(seed);
  std::vector<Index> number(model.surface.size());
  std::iota(number.begin(), number.end(), Index{0});
  random.shuffle(number);
  renumber(model, number, number.size());
  random.shuffle(model.surface.triangles);
}

void
addOutliers(Model& model, double share, std::uint64_t seed)
{
  checkRange("share of outliers", share, 0.0, 1.0);
  RandomNumbers random(seed);
  const BoundingBox box = boundingBox(model.surface.points);
  const auto count = static_cast<std::size_t>(share * static_cast<double>(model.surface.size()));
  for (std::size_t i = 0; i < count; ++i) {
    Vector3 point;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto low = static_cast<double>(box.low[k]);
      const double margin = 0.1 * (static_cast<double>(box.high[k]) - low);
      point[k] = static_cast<float>(random.uniform(low - margin, static_cast<double>(box.high[k]) + margin));
    }
    model.surface.points.push_back(point);
    model.partners.push_back(no_index);
    if (!model.surface.normals.empty())
      model.surface.normals.push_back({0, 0, 1});
  }
}

std::vector<Index>
repeatPoints(Model& model, double share, std::uint64_t seed)
{
  checkRange("share of repeated points", share, 0.0, 1.0);
  RandomNumbers random(seed);
  const std::size_t points = model.surface.size();
  std::vector<Index> originals(static_cast<std::size_t>(share * static_cast<double>(points)));
  for (Index& original : originals) {
    original = static_cast<Index>(random.index(points));
    const Vector3 place = model.surface.points[static_cast<std::size_t>(original)];
    model.surface.points.push_back(place);
    model.partners.push_back(no_index);
    if (!model.surface.normals.empty()) {
      const Vector3 normal = model.surface.normals[static_cast<std::size_t>(original)];
      model.surface.normals.push_back(normal);
    }
  }
  return originals;
}

void
keepVertices(Model& model, const std::vector<char>& keep)
{
  if (keep.size() != model.surface.size())
    throw std::invalid_argument("there are " + std::to_string(keep.size()) + " marks for " +
                                std::to_string(model.surface.size()) + " vertices");
  std::vector<Index> number(keep.size(), no_index);
  Index count = 0;
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i] != 0)
      number[i] = count++;
  renumber(model, number, static_cast<std::size_t>(count));
}

} // namespace symmetry
} // namespace pcl
