#include "benchmark/ground_truth.h"

#include "benchmark/text_lines.h"

#include <pcl/exceptions.h>

#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

std::vector<Index>
readLandmarks(const std::string& file)
{
  std::vector<Index> vertices;
  TextLines lines(file);
  while (lines.next()) {
    const Index vertex = lines.toInteger(lines.words().front());
    if (vertex < 0)
      lines.fail("vertex " + std::to_string(vertex) + " is negative");
    vertices.push_back(vertex);
  }
  return vertices;
}

Index
landmarkVertex(const TextLines& lines, std::string_view word, const std::vector<Index>& vertices)
{
  const Index landmark = lines.toInteger(word);
  if (landmark < 0 || static_cast<std::size_t>(landmark) >= vertices.size())
    lines.fail("landmark " + std::to_string(landmark) + " is not in [0, " + std::to_string(vertices.size()) + ")");
  return vertices[static_cast<std::size_t>(landmark)];
}

/** A 1-based number of a dense map as 0-based vertex; no_index where it stands for none. */
Index
denseVertex(const TextLines& lines, std::string_view word)
{
  const double number = lines.toNumber(word);
  if (std::isnan(number) || number < 1.0)
    return no_index;
  if (number != std::floor(number) || number > std::numeric_limits<Index>::max())
    lines.fail("'" + std::string(word) + "' is no number of a vertex");
  return static_cast<Index>(number) - 1;
}

void
appendKnown(GroundTruth& truth, Index vertex, Index partner)
{
  if (vertex != no_index && partner != no_index)
    truth.push_back({vertex, partner});
}

/** The lines of a dense file, each with its numbers. */
std::vector<std::vector<Index>>
readDenseRows(const std::string& file)
{
  std::vector<std::vector<Index>> rows;
  TextLines lines(file);
  while (lines.next()) {
    std::vector<Index> row;
    row.reserve(lines.words().size());
    for (const std::string_view word : lines.words())
      row.push_back(denseVertex(lines, word));
    // The first line tells a table of two columns from a list that is only broken into lines.
    if (!rows.empty() && rows[0].size() == 2 && row.size() != 2)
      lines.fail("2 numbers expected, as in the first line, and not " + std::to_string(row.size()));
    rows.push_back(std::move(row));
  }
  return rows;
}

GroundTruth
requireSome(GroundTruth truth, const std::string& file)
{
  if (truth.empty())
    throw pcl::IOException(file + ": no vertex with a partner in it");
  return truth;
}

bool
endsWith(const std::string& text, const std::string& ending)
{
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

} // namespace

GroundTruth
readLandmarkTruth(const std::string& landmark_file, const std::string& symmetry_file)
{
  const std::vector<Index> vertices = readLandmarks(landmark_file);
  GroundTruth truth;
  TextLines lines(symmetry_file);
  while (lines.next()) {
    std::vector<Index> row;
    for (const std::string_view word : lines.words())
      row.push_back(landmarkVertex(lines, word, vertices));
    if (row.size() == 1)
      truth.push_back({row[0], row[0]});
    if (row.size() == 2) {
      truth.push_back({row[0], row[1]});
      truth.push_back({row[1], row[0]});
    }
  }
  return requireSome(std::move(truth), symmetry_file);
}

GroundTruth
readDenseTruth(const std::string& file)
{
  const std::vector<std::vector<Index>> rows = readDenseRows(file);
  GroundTruth truth;
  if (rows.size() > 1 && rows[0].size() == 2) {
    for (const std::vector<Index>& row : rows)
      appendKnown(truth, row[0], row[1]);
  }
  else {
    Index vertex = 0;
    for (const std::vector<Index>& row : rows)
      for (const Index partner : row)
        appendKnown(truth, vertex++, partner);
  }
  return requireSome(std::move(truth), file);
}

GroundTruth
readGroundTruth(const std::string& specification)
{
  const std::string pid = ".pid";
  if (endsWith(specification, pid))
    return readLandmarkTruth(specification, specification.substr(0, specification.size() - pid.size()) + ".sym.info");
  const std::size_t landmarks_end = specification.find(".vts:");
  if (landmarks_end != std::string::npos)
    return readLandmarkTruth(specification.substr(0, landmarks_end + 4), specification.substr(landmarks_end + 5));
  return readDenseTruth(specification);
}

void
checkGroundTruth(const GroundTruth& truth, std::size_t vertices, const std::string& specification)
{
  for (const TruePartner& pair : truth)
    for (const Index vertex : {pair.vertex, pair.partner})
      if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertices)
        throw pcl::IOException(specification + ": vertex " + std::to_string(vertex) + " (0-based) is not in [0, " +
                               std::to_string(vertices) + ") of the model");
}

} // namespace symmetry
} // namespace pcl
