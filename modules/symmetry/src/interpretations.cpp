#include "symmetry/interpretations.h"

#include "base/statistics.h"
#include "symmetry/confidence/map_confidence.h"
#include "symmetry/surface/mesh_subdivision.h"
#include "symmetry/surface/surface_preparation.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** Edges between parallel sheets barred, normals of one sheet: where points are dense and without noise. The numbers of
 * this and the following tests were chosen by hand on generated bodies and scans; no script fits them. */
const ContactTest parallel_sheets{0.85F, 6.0F, 0.5F, true, 0.15F};

/** How readily an edge is taken for a shortcut between parts in contact. */
const ContactTest trusting{0.5F, 3.0F};
const ContactTest usual{0.8F, 4.0F};
const ContactTest distrustful{0.95F, 8.0F};

/** Shares of the usual number of samples: far enough from it, and from each other, that other samples are extreme points
 * and other hypotheses are made; fewer than half are too coarse for hands, more cost more. */
constexpr float fewer_samples = 0.73F;
constexpr float more_samples = 1.33F;

/** Depths at which touching surfaces that noise has merged are looked for, in spacings. */
constexpr float contact_depth = 1.0F;
constexpr float shallow_contact_depth = 0.7F;

/** Fewer points are as far apart as fingers are thick, and touch all over: what a mesh of so few says of its contacts is
 * better than what a cloud does, unless there are holes in it. */
constexpr std::size_t dense_points = 8000;

/** Whether points have so many neighbours that they are those of no surface: thousands of parts that cross each other all
 * over. Other samples tell nothing new of them, and all that is done for a sample takes many times as long. A surface
 * has 6 on average; of 25 public objects, many of them in parts, none has more than 7.6. */
bool
isTangled(const SurfaceGraph& graph)
{
  constexpr std::size_t most_neighbours = 24;
  return graph.neighbours.size() > most_neighbours * graph.size();
}

/** Whether the distances of neighbours differ so much from place to place that no radius or depth in spacings fits them
 * all, as where points gather around a centre. Of clouds of bodies and objects the longest are 8 times the shortest. */
bool
isScattered(const SurfaceGraph& graph)
{
  constexpr std::size_t probes = 2000;
  constexpr float most = 100.0F; // between the tenth part with the shortest edges and that with the longest
  std::vector<float> lengths;
  const std::size_t step = std::max<std::size_t>(1, graph.size() / probes);
  for (std::size_t v = 0; v < graph.size(); v += step) {
    float sum = 0.0F;
    for (const auto [w, length] : graph.edges(v)) {
      sum += length;
    }
    lengths.push_back(sum / static_cast<float>(std::max(graph.offsets[v + 1] - graph.offsets[v], 1U)));
  }
  return quantile(lengths, 0.9) > most * quantile(lengths, 0.1);
}

ContactTest
atDepth(ContactTest test, float depth)
{
  test.depth = depth;
  return test;
}

/** Which points of a cloud touch and which are connected cannot always be told: the ways to read it, the one that is
 * usually right first.
 * \param[in] depths see ContactTest; none: as density and noise allow */
std::vector<ContactTest>
contactTests(const PreparedSurface& surface, const SymmetryParameters& parameters, const std::vector<float>& depths)
{
  if (!surface.is_cloud || parameters.method == Method::Staged) {
    return {ContactTest{}};
  }
  const bool is_precise = surface.summary.smoothing_radius == 0.0F && surface.size() >= dense_points;
  if (surface.summary.read_as_cloud && is_precise) {
    return {parallel_sheets, usual}; // of a mesh the best one speaks: the other two cost more than they find
  }
  std::vector<ContactTest> tests;
  if (depths.empty() && is_precise) {
    tests.push_back(parallel_sheets);
  }
  for (const float depth : depths.empty() ? std::vector<float>{0.0F} : depths) {
    tests.insert(tests.end(), {atDepth(trusting, depth), atDepth(usual, depth), atDepth(distrustful, depth)});
  }
  return tests;
}

} // namespace

bool
PastInterpretations::isNew(const PreparedSurface& surface, const ContactTest& contact, float samples)
{
  auto past = std::find_if(surfaces_.begin(), surfaces_.end(), [&](const PastSurface& other) {
    return other.samples == samples && other.points == surface.points && other.normals == surface.normals;
  });
  if (past == surfaces_.end()) {
    past = surfaces_.insert(surfaces_.end(), {samples, surface.points, surface.normals, {}});
  }
  if (std::find(past->contacts.begin(), past->contacts.end(), contact) != past->contacts.end()) {
    return false;
  }
  past->contacts.push_back(contact);
  return true;
}

InterpretationPlan::InterpretationPlan(const Surface& surface,
                                       const SymmetryParameters& parameters,
                                       const NeighbourSearch& search)
    : surface_(surface),
      parameters_(parameters),
      search_(search),
      stages_{{NoiseInterpretation::Close, FaceUse::Connection, {}}}
{
}

Pooling
InterpretationPlan::pooling() const
{
  return surface_.hasFaces() && parameters_.method == Method::Robust ? Pooling::Odds : Pooling::Votes;
}

std::optional<InterpretationPlan::Attempt>
InterpretationPlan::next(const RivalInterpretations& rivals)
{
  while (!rivals.isSettled()) {
    while (!contacts_.empty()) {
      const ContactTest contact = contacts_.back();
      contacts_.pop_back();
      if (past_.isNew(usable_.surface, contact, samples_)) { // else it would speak twice
        return Attempt{prepareSurface(usable_, parameters_, contact), samples_};
      }
    }
    if (stages_.empty() && is_first_) {
      is_first_ = false;
      stages_ = furtherStages(rivals);
      if (surface_.hasFaces() && !usable_.surface.is_cloud && !stages_.empty()) {
        connected_ = rivals.best().surface; // there is no other yet
      }
      std::reverse(stages_.begin(), stages_.end());
    }
    if (stages_.empty()) {
      break;
    }
    const Stage stage = std::move(stages_.back());
    stages_.pop_back();
    if (connected_ && stage.faces == FaceUse::Connection) {
      return Attempt{*connected_, stage.samples}; // other samples of the same surface
    }
    // The staged method takes a mesh as it is, as it was published.
    const std::size_t points = parameters_.method == Method::Robust ? points_of_a_surface : 0;
    usable_ = usablePoints(surface_, parameters_, search_, stage.noise, stage.faces, points);
    samples_ = stage.samples;
    contacts_ = contactTests(usable_.surface, parameters_, stage.depths);
    std::reverse(contacts_.begin(), contacts_.end());
  }
  return std::nullopt;
}

/** What to try where the first stage leaves doubt. */
std::vector<InterpretationPlan::Stage>
InterpretationPlan::furtherStages(const RivalInterpretations& rivals) const
{
  const Interpretation& best = rivals.best();
  if (parameters_.method == Method::Staged) {
    return {};
  }
  if (surface_.hasFaces()) {
    std::vector<Stage> stages;
    if (usable_.surface.size() >= dense_points || weightOfHoles(best.estimate.known_holes) > 0.0F) {
      stages.push_back({NoiseInterpretation::Close, FaceUse::Normals, {}});
    }
    if (!isTangled(best.surface.graph)) {
      stages.push_back({NoiseInterpretation::Close, FaceUse::Connection, {}, fewer_samples});
      stages.push_back({NoiseInterpretation::Close, FaceUse::Connection, {}, more_samples});
    }
    return stages;
  }
  if (isScattered(best.surface.graph)) {
    return {};
  }
  if (usable_.surface.summary.smoothing_radius == 0.0F) {
    return {{NoiseInterpretation::Parted, FaceUse::Connection, {contact_depth}}};
  }
  // Noise makes each interpretation uncertain, so that several are worth their time.
  return {{NoiseInterpretation::Smooth, FaceUse::Connection, {}},
          {NoiseInterpretation::Parted, FaceUse::Connection, {contact_depth, 0.0F, shallow_contact_depth}}};
}

} // namespace symmetry
} // namespace pcl
