#include "estimation/enum_names.h"
#include "io/write/output_file.h"
#include "io/write/record_writer.h"

#include <pcl/symmetry/surface_io.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

using Json = nlohmann::ordered_json;

/** \brief A float as 0.1, not as the 0.10000000149011612 that it is as a double; null where it is not finite, which
 * JSON has no number for. */
Json
toJson(float value)
{
  if (!std::isfinite(value))
    return nullptr;
  std::string digits;
  appendNumber(digits, value);
  double shortest = 0.0;
  std::from_chars(digits.data(), digits.data() + digits.size(), shortest);
  return shortest;
}

Json
describeInput(const std::string& file, const InputSummary& input)
{
  return {{"file", file},
          {"points", input.points},
          {"faces", input.faces},
          {"used", input.used},
          {"working_points", input.working_points},
          {"dropped", input.points - std::min(input.used, input.points)},
          {"non_finite", input.non_finite},
          {"outside_indices", input.outside_indices},
          {"outliers", input.outliers},
          {"unused", input.unused},
          {"welded", input.welded},
          {"junctions", input.junctions},
          {"other_components", input.other_components},
          {"components", input.components},
          {"linked_parts", input.linked_parts},
          {"part_links", input.part_links},
          {"bridges", input.bridges},
          {"distrusted_edges", input.distrusted_edges},
          {"read_as_cloud", input.read_as_cloud},
          {"smoothing_radius", toJson(input.smoothing_radius)},
          {"notes", input.notes}};
}

Json
describeMap(const SymmetryResult& result)
{
  return {{"matched", result.map.matched},
          {"axis", result.map.axis},
          {"axis_curves", result.axis.size()},
          {"involution", toJson(result.map.involution)},
          {"inverted_faces", toJson(result.map.inverted_faces)},
          {"torn_faces", toJson(result.map.torn_faces)},
          {"isometry_error", toJson(result.map.isometry_error)}};
}

Json
describePlane(const MirrorPlane& plane)
{
  return {{"normal", plane.normal}, {"offset", plane.offset}, {"rms", plane.rms}, {"to_x", plane.to_x}};
}

Json
describeNaming(const SideNaming& naming)
{
  return {{"by", "reference"},
          {"exchanged", naming.exchanged},
          {"margin", toJson(naming.margin)},
          {"misfit", toJson(naming.misfit)}};
}

Json
describeUnsupported(const std::vector<UnsupportedPart>& parts)
{
  Json list = Json::array();
  for (const UnsupportedPart& part : parts)
    list.push_back({{"points", part.points},
                    {"share", toJson(part.share)},
                    {"extent", toJson(part.extent)},
                    {"extreme_point", part.extreme}});
  return list;
}

Json
describeAlternatives(const std::vector<AlternativeMap>& alternatives)
{
  Json list = Json::array();
  for (const AlternativeMap& alternative : alternatives)
    list.push_back({{"score", toJson(alternative.score)},
                    {"confidence", toJson(alternative.confidence)},
                    {"reverses_orientation", alternative.reverses_orientation}});
  return list;
}

Json
describeStaged(const StagedParameters& staged)
{
  return {{"landmarks", staged.landmarks},
          {"samples", staged.samples},
          {"embedding_dimensions", staged.embedding_dimensions},
          {"extremities", nameOf(extreme_points_names, staged.extremities)},
          {"pairing", nameOf(pairing_names, staged.pairing)}};
}

Json
describeParameters(const SymmetryParameters& parameters)
{
  return {{"method", nameOf(method_names, parameters.method)},
          {"robust", {{"samples", parameters.robust.samples}}},
          {"staged", describeStaged(parameters.staged)},
          {"metric", nameOf(metric_names, parameters.metric)},
          {"k_search", parameters.k_search},
          {"radius", toJson(parameters.radius)},
          {"normals", nameOf(normal_source_names, parameters.normals)},
          {"components", nameOf(component_use_names, parameters.components)},
          {"outlier_deviations", toJson(parameters.outlier_deviations)},
          {"sparse_only", parameters.sparse_only},
          {"label_axis", parameters.label_axis},
          {"alternatives", parameters.alternatives},
          {"threads", parameters.threads}};
}

Json
describeSeconds(const std::vector<std::pair<std::string, double>>& steps)
{
  // Whole microseconds: the total is the sum of the numbers that a reader sees.
  const auto round = [](double seconds) {
    return std::round(seconds * 1e6) / 1e6;
  };
  Json seconds = Json::object();
  double total = 0.0;
  for (const auto& [step, duration] : steps) {
    seconds[step] = seconds.value(step, 0.0) + round(duration);
    total += round(duration);
  }
  seconds["total"] = round(total);
  return seconds;
}

/** \brief A file name need not be UTF-8, but JSON must be. */
void
writeJson(const std::string& path, const Json& json)
{
  writeWholeFile(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace

void
writeFailureReport(const std::string& path,
                   const std::string& input_file,
                   const SymmetryParameters& parameters,
                   const std::string& reason)
{
  writeJson(path, {{"status", "failed"},
                   {"message", reason},
                   {"input", {{"file", input_file}}},
                   {"parameters", describeParameters(parameters)},
                   {"version", PCL_SYMMETRY_VERSION}});
}

void
writeReport(const std::string& path,
            const std::string& input_file,
            const SymmetryParameters& parameters,
            const SymmetryResult& result)
{
  Json report = {{"status", toString(result.status)},
                 {"message", result.message},
                 {"confidence", toJson(result.confidence)},
                 {"diameter", toJson(result.diameter)},
                 {"input", describeInput(input_file, result.input)},
                 {"map", describeMap(result)},
                 {"matches", result.matches.size()}};
  if (result.plane.normal != MirrorPlane{}.normal)
    report["mirror_plane"] = describePlane(result.plane);
  if (result.naming.by_reference)
    report["side_names"] = describeNaming(result.naming);
  if (!result.unsupported.empty())
    report["unsupported"] = describeUnsupported(result.unsupported);
  if (result.equal_reflections > 1)
    report["equal_reflections"] = result.equal_reflections;
  if (result.alternatives.size() > 1) {
    report["alternatives"] = describeAlternatives(result.alternatives);
    report["rotations"] = describeAlternatives(result.rotations);
  }
  report["parameters"] = describeParameters(parameters);
  report["seconds"] = describeSeconds(result.seconds);
  report["version"] = PCL_SYMMETRY_VERSION;
  writeJson(path, report);
}

} // namespace symmetry
} // namespace pcl
