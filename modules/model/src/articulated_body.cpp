#include "model/articulated_body.h"

#include "model/body_plan.h"
#include "model/editable_mesh.h"
#include "model/polygonize.h"
#include "model/pose.h"
#include "model/random_numbers.h"
#include "model/remesh.h"
#include "model/terrain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

constexpr double surplus = 1.7; // vertices before the short edges are collapsed, per vertex wanted
constexpr int relax_rounds = 6;

struct BodyKind {
  Body body;
  const char* name;
  bool symmetric;
  BodyPlan (*plan)(std::uint64_t seed); ///< null for what has no bones
};

/** \brief The plan of a body that is the same for every seed. */
template <BodyPlan (*Plan)()>
BodyPlan
drawn(std::uint64_t /*seed*/)
{
  return Plan();
}

constexpr std::array<BodyKind, 13> kinds = {{
    {Body::Human, "human", true, drawn<humanPlan>},
    {Body::Quadruped, "quadruped", true, drawn<quadrupedPlan>},
    {Body::Spider, "spider", true, drawn<spiderPlan>},
    {Body::Bird, "bird", true, drawn<birdPlan>},
    {Body::MissingArm, "missing-arm", false, drawn<missingArmPlan>},
    {Body::ThirdArm, "third-arm", false, drawn<thirdArmPlan>},
    {Body::MissingLeg, "missing-leg", false, drawn<missingLegPlan>},
    {Body::Hand, "hand", false, drawn<handPlan>},
    {Body::Helix, "helix", false, drawn<helixPlan>},
    {Body::Terrain, "terrain", false, nullptr},
    {Body::Creature, "creature", true, creaturePlan},
    {Body::LameCreature, "lame-creature", false, lameCreaturePlan},
    {Body::AskewCreature, "askew-creature", false, askewCreaturePlan},
}};

const BodyKind&
kindOf(Body body)
{
  for (const BodyKind& kind : kinds)
    if (kind.body == body)
      return kind;
  throw std::invalid_argument("there is no body number " + std::to_string(static_cast<int>(body)));
}

void
checkRange(const char* name, double value, double low, double high)
{
  if (value >= low && value <= high)
    return;
  std::ostringstream message;
  message << name << " is " << value << ", allowed are " << low << " to " << high;
  throw std::invalid_argument(message.str());
}

void
check(const ModelParameters& parameters)
{
  kindOf(parameters.body);
  checkRange("vertices", static_cast<double>(parameters.vertices), 1000, 4000000);
  checkRange("bend", parameters.bend, 0.0, 1.5);
  checkRange("retriangulate", parameters.retriangulate, 0.0, 1.0);
  checkRange("jitter", parameters.jitter, 0.0, 0.4);
  checkRange("density_ratio", parameters.density_ratio, 1.0, 100.0);
}

/** \brief Edge lengths that grow from one end of the body to the other, by the square root of the density ratio. */
SizeField
sizeField(const ImplicitSurface& skin, double density_ratio)
{
  if (density_ratio == 1.0)
    return [](const Eigen::Vector3d&) {
      return 1.0;
    };
  const Eigen::Vector3d& low = skin.lowest();
  const Eigen::Vector3d extent = skin.highest() - low;
  const int axis = extent.y() > extent.z() ? 1 : 2; // never x: the halves are to be alike
  const double growth = 0.5 * std::log(density_ratio);
  return [=](const Eigen::Vector3d& point) {
    return std::exp(growth * (1.0 - std::clamp((point[axis] - low[axis]) / extent[axis], 0.0, 1.0)));
  };
}

/** \brief The skin, or its left half, with the wanted number of vertices once the half is mirrored. */
TriangleMesh
meshSkin(const ImplicitSurface& skin, double coarsest, bool symmetric, const ModelParameters& parameters)
{
  const Extent extent = symmetric ? Extent::PositiveHalf : Extent::Whole;
  TriangleMesh mesh = polygonize(skin, coarsest, extent);
  const double ratio = parameters.density_ratio;
  const double densest = ratio > 1.0 ? ratio * std::log(ratio) / (ratio - 1.0) : 1.0; // relative to the mean
  const double wanted = surplus * densest * static_cast<double>(parameters.vertices) / (symmetric ? 2.0 : 1.0);
  const double cell = coarsest * std::sqrt(static_cast<double>(mesh.points.size()) / wanted);
  if (cell < coarsest)
    mesh = polygonize(skin, cell, extent);

  EditableMesh editable(std::move(mesh));
  const SizeField size = sizeField(skin, ratio);
  if (!reduce(editable, skin, size, symmetric ? parameters.vertices : 2 * parameters.vertices))
    throw std::runtime_error("a " + std::string(toString(parameters.body)) + " cannot be made of " +
                             std::to_string(parameters.vertices) + " vertices");
  relax(editable, skin, size, relax_rounds);
  return editable.compact();
}

/** \brief Adds the right half; vertices at x = 0 become their own partners. */
std::vector<Index>
mirrorHalf(TriangleMesh& mesh)
{
  const std::size_t half = mesh.points.size();
  std::vector<Index> partners(half);
  for (std::size_t i = 0; i < half; ++i) {
    partners[i] = static_cast<Index>(i);
    const Eigen::Vector3d point = mesh.points[i];
    if (point.x() == 0.0)
      continue;
    partners[i] = static_cast<Index>(mesh.points.size());
    partners.push_back(static_cast<Index>(i));
    mesh.points.emplace_back(-point.x(), point.y(), point.z());
  }
  const auto image = [&](Index vertex) {
    return partners[static_cast<std::size_t>(vertex)];
  };
  const std::size_t faces = mesh.triangles.size();
  for (std::size_t i = 0; i < faces; ++i) {
    const Triangle t = mesh.triangles[i];
    mesh.triangles.push_back({image(t[0]), image(t[2]), image(t[1])});
  }
  return partners;
}

/** \brief Slides the vertices from \a first on along the skin. */
void
jitterVertices(EditableMesh& mesh, const ImplicitSurface& skin, Index first, double jitter, RandomNumbers& random)
{
  for (auto vertex = first; vertex < static_cast<Index>(mesh.points().size()); ++vertex) {
    const Eigen::Vector3d here = mesh.point(vertex);
    const std::vector<Index> ring = mesh.neighbours(vertex);
    double edge = 0.0;
    for (const Index other : ring)
      edge += (mesh.point(other) - here).norm() / static_cast<double>(ring.size());
    const Eigen::Vector3d normal = mesh.normal(vertex).normalized();
    const Eigen::Vector3d step(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    const Eigen::Vector3d along = (step - step.dot(normal) * normal) / std::sqrt(3.0);
    mesh.point(vertex) = skin.project(here + jitter * edge * along);
  }
}

/** \brief Sine of the smallest angle of a triangle, roughly: the lowest height over the longest edge. */
double
shape(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() / longest;
}

/** \brief Flips a share of the edges whose two triangles lie among the vertices from \a first on. */
void
flipEdges(EditableMesh& mesh, Index first, double share, RandomNumbers& random)
{
  constexpr double minimum_shape = 0.22; // two equilateral triangles become two of 0.29
  constexpr double minimum_cosine = 0.9; // of the angle between the two triangles: a flip must not dent the skin
  for (const auto& [a, b] : mesh.edges()) {
    const bool drawn = random.uniform() < share;
    const auto [c, d] = mesh.opposite(a, b);
    if (!drawn || a < first || c < first || d < first)
      continue;
    const Eigen::Vector3d& pa = mesh.point(a);
    const Eigen::Vector3d& pb = mesh.point(b);
    const Eigen::Vector3d& pc = mesh.point(c);
    const Eigen::Vector3d& pd = mesh.point(d);
    const Eigen::Vector3d left = (pb - pa).cross(pc - pa).normalized();
    const Eigen::Vector3d right = (pa - pb).cross(pd - pb).normalized();
    if (left.dot(right) > minimum_cosine && shape(pc, pd, pb) > minimum_shape && shape(pd, pc, pa) > minimum_shape)
      mesh.flip(a, b);
  }
}

/** \brief Makes the triangles of the right half differ from those of the left one. */
void
retriangulateRight(TriangleMesh& mesh,
                   const ImplicitSurface& skin,
                   Index first,
                   const ModelParameters& parameters,
                   RandomNumbers& random)
{
  EditableMesh editable(std::move(mesh));
  if (parameters.jitter > 0.0)
    jitterVertices(editable, skin, first, parameters.jitter, random);
  flipEdges(editable, first, parameters.retriangulate, random);
  mesh = editable.compact();
}

Model
growBody(const BodyKind& kind, const ModelParameters& parameters)
{
  const BodyPlan plan = kind.plan(parameters.seed);
  const ImplicitSurface skin = plan.surface();
  TriangleMesh mesh = meshSkin(skin, plan.detail(), kind.symmetric, parameters);
  RandomNumbers random(parameters.seed);
  const Pose pose = randomPose(plan, parameters.bend, random);

  Model model;
  if (kind.symmetric) {
    const auto first_right = static_cast<Index>(mesh.points.size());
    model.partners = mirrorHalf(mesh);
    retriangulateRight(mesh, skin, first_right, parameters, random);
  }
  else {
    model.partners.assign(mesh.points.size(), no_index);
  }
  if (parameters.bend > 0.0)
    bendBody(plan, pose, mesh.points);
  model.surface.points.reserve(mesh.points.size());
  for (const Eigen::Vector3d& point : mesh.points)
    model.surface.points.push_back(
        {static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z())});
  model.surface.triangles = std::move(mesh.triangles);
  return model;
}

} // namespace

const std::vector<Body>&
allBodies()
{
  static const std::vector<Body> bodies = [] {
    std::vector<Body> all;
    all.reserve(kinds.size());
    for (const BodyKind& kind : kinds)
      all.push_back(kind.body);
    return all;
  }();
  return bodies;
}

const char*
toString(Body body)
{
  return kindOf(body).name;
}

Body
bodyFromName(const std::string& name)
{
  std::string names;
  for (const BodyKind& kind : kinds) {
    if (name == kind.name)
      return kind.body;
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  }
  throw std::invalid_argument("there is no body '" + name + "'; there are " + names);
}

bool
isSymmetric(Body body)
{
  return kindOf(body).symmetric;
}

Model
makeModel(const ModelParameters& parameters)
{
  check(parameters);
  const BodyKind& kind = kindOf(parameters.body);
  if (kind.plan != nullptr)
    return growBody(kind, parameters);
  RandomNumbers random(parameters.seed);
  Model model;
  model.surface = makeTerrain(parameters.vertices, random);
  model.partners.assign(model.surface.size(), no_index);
  return model;
}

} // namespace symmetry
} // namespace pcl
