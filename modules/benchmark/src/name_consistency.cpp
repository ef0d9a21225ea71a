#include "benchmark/name_consistency.h"

#include "../../estimation/src/neighbour_search.h"
#include "base/error_text.h"
#include "base/parallel.h"
#include "benchmark/text_lines.h"
#include "symmetry/names/labelled_samples.h"
#include "symmetry/names/name_comparison.h"

#include <pcl/symmetry/surface_io.h>
#include <pcl/symmetry/symmetry.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <ostream>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

std::string
kindOf(const BenchmarkModel& model)
{
  return model.set + "/" + model.class_name;
}

/** Whether most labels are those of the truth. */
bool
agreesWith(const std::vector<Side>& truth, const std::vector<Side>& sides)
{
  long agreement = 0;
  const auto is_side = [](Side side) {
    return side == Side::Source || side == Side::Target;
  };
  for (std::size_t v = 0; v < truth.size(); ++v)
    if (is_side(truth[v]) && is_side(sides[v]))
      agreement += truth[v] == sides[v] ? 1 : -1;
  return agreement > 0;
}

void
estimateModel(NamedModel& named, const RunOptions& options, bool is_exchanged)
{
  Surface surface = readSurface(named.model.file);
  const std::vector<Side> truth = readSideTruth(findSideTruth(named.model), surface.size());
  if (options.as_cloud)
    surface.triangles.clear();
  const SymmetryResult result = estimateIntrinsicSymmetry(surface, options.parameters);
  if (!hasMap(result.status))
    throw pcl::IOException(named.model.file + ": " + toString(result.status));
  named.is_as_true = agreesWith(truth, result.sides) != is_exchanged;
  named.described = describeLabelled(surface, result.sides, result.partners, searchByKdTree);
}

NamePairs&
rowOf(std::vector<NamePairs>& rows, const std::string& first, const std::string& second)
{
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const NamePairs& r) { return r.first == first && r.second == second; });
  if (row != rows.end())
    return *row;
  rows.push_back({first, second});
  return rows.back();
}

void
printRow(std::ostream& out, const std::string& name, const NamePairs& row)
{
  std::array<char, 200> line{};
  const auto share = [&row](std::size_t count) {
    return row.pairs == 0 ? 0.0 : 100.0 * static_cast<double>(count) / static_cast<double>(row.pairs);
  };
  std::snprintf(line.data(), line.size(), "%-48s %6zu %9.1f %10.1f %9.1f\n", name.c_str(), row.pairs,
                share(row.by_shape), share(row.by_reference), share(row.doubtful));
  out << line.data();
}

void
add(NamePairs& sum, const NamePairs& row)
{
  sum.pairs += row.pairs;
  sum.by_shape += row.by_shape;
  sum.by_reference += row.by_reference;
  sum.doubtful += row.doubtful;
}

} // namespace

std::string
findSideTruth(const BenchmarkModel& model)
{
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(model.file).parent_path();
  for (const fs::path& candidate : {folder / (model.name + "_side.txt"), folder / "side.txt",
                                    folder.parent_path() / "Sides" / (model.class_name + ".txt")})
    if (fs::is_regular_file(candidate))
      return candidate.string();
  return "";
}

std::vector<Side>
readSideTruth(const std::string& file, std::size_t vertices)
{
  std::vector<Side> sides;
  TextLines lines(file);
  while (lines.next())
    for (const std::string_view word : lines.words()) {
      const Index side = lines.toInteger(word);
      if (side < 0 || side > 3)
        lines.fail("a side is 0, 1, 2 or 3, not " + std::string(word));
      sides.push_back(static_cast<Side>(side));
    }
  if (sides.size() != vertices)
    throw pcl::IOException(file + ": " + std::to_string(sides.size()) + " sides for " + std::to_string(vertices) +
                           " vertices");
  return sides;
}

std::vector<NamePairs>
compareAllNames(const std::vector<BenchmarkModel>& models,
                const RunOptions& options,
                const std::vector<std::string>& exchanged,
                unsigned jobs,
                const std::function<void(const NamedModel&)>& failed)
{
  std::vector<NamedModel> named(models.size());
  const ThreadScope all_jobs(jobs);
  parallelFor(models.size(), [&](std::size_t i) {
    const ThreadScope of_a_job(options.parameters.threads);
    named[i].model = models[i];
    const bool is_exchanged = std::find(exchanged.begin(), exchanged.end(), models[i].class_name) != exchanged.end();
    try {
      estimateModel(named[i], options, is_exchanged);
    }
    catch (const std::exception& error) {
      named[i].failure = errorText(error);
    }
  });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (!named[i].failure.empty() && failed)
      failed(named[i]);
    for (std::size_t j = i + 1; j < named.size(); ++j)
      if (named[i].failure.empty() && named[j].failure.empty() && models[i].set == models[j].set)
        pairs.emplace_back(i, j);
  }
  std::vector<double> margins(pairs.size());
  parallelFor(pairs.size(), [&](std::size_t k) {
    margins[k] = compareNames(named[pairs[k].first].described, named[pairs[k].second].described).margin();
  });
  std::vector<NamePairs> rows;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const NamedModel& a = named[pairs[k].first];
    const NamedModel& b = named[pairs[k].second];
    NamePairs& row =
        rowOf(rows, std::min(kindOf(a.model), kindOf(b.model)), std::max(kindOf(a.model), kindOf(b.model)));
    const bool is_same = a.is_as_true == b.is_as_true;
    row.pairs += 1;
    row.by_shape += is_same ? 1 : 0;
    row.by_reference += (margins[k] >= 0.0) == is_same ? 1 : 0;
    row.doubtful += std::abs(margins[k]) < static_cast<double>(SideNaming::doubtful) ? 1 : 0;
  }
  return rows;
}

void
printNames(std::ostream& out, const std::vector<NamePairs>& rows)
{
  std::array<char, 200> line{};
  std::snprintf(line.data(), line.size(), "%-48s %6s %9s %10s %9s\n", "same names of the sides, %", "pairs", "by shape",
                "reference", "in doubt");
  out << line.data();
  NamePairs within;
  NamePairs across;
  for (const NamePairs& row : rows) {
    const bool is_within = row.first == row.second;
    printRow(out, is_within ? row.first : row.first + " " + row.second, row);
    add(is_within ? within : across, row);
  }
  printRow(out, "within classes", within);
  printRow(out, "across classes", across);
}

} // namespace symmetry
} // namespace pcl
