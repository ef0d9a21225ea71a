#include "benchmark/data_set.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <optional>

namespace fs = std::filesystem;

namespace pcl {
namespace symmetry {
namespace {

bool
isDigit(char c)
{
  return c >= '0' && c <= '9';
}

std::string
toLower(std::string text)
{
  for (char& c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool
isSurfaceFile(const fs::path& path)
{
  static const std::array<const char*, 5> endings{".off", ".obj", ".ply", ".pcd", ".stl"};
  const std::string ending = toLower(path.extension().string());
  return fs::is_regular_file(path) && std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/** Compares runs of digits by value, so that cat10 comes after cat2. */
bool
naturalLess(const std::string& a, const std::string& b)
{
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    const std::size_t a_end = isDigit(a[i]) ? std::min(a.find_first_not_of("0123456789", i), a.size()) : i + 1;
    const std::size_t b_end = isDigit(b[j]) ? std::min(b.find_first_not_of("0123456789", j), b.size()) : j + 1;
    const bool both_numbers = isDigit(a[i]) && isDigit(b[j]);
    if (both_numbers && a_end - i != b_end - j)
      return a_end - i < b_end - j;
    const int order = a.compare(i, a_end - i, b, j, b_end - j);
    if (order != 0)
      return order < 0;
    i = a_end;
    j = b_end;
  }
  return a.size() - i < b.size() - j;
}

std::vector<fs::path>
listFolder(const fs::path& folder)
{
  std::vector<fs::path> entries;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end(), [](const fs::path& a, const fs::path& b) {
    return naturalLess(a.filename().string(), b.filename().string());
  });
  return entries;
}

std::vector<fs::path>
listSurfaceFiles(const fs::path& folder)
{
  std::vector<fs::path> files = listFolder(folder);
  files.erase(std::remove_if(files.begin(), files.end(), [](const fs::path& file) { return !isSurfaceFile(file); }),
              files.end());
  return files;
}

/** Name of a folder, also where its path ends in a slash or a dot. */
std::string
folderName(const fs::path& folder)
{
  return fs::canonical(folder).filename().string();
}

/** Class of a model of SHREC 2007 from its number; nothing where the name is no such number. */
std::optional<std::size_t>
numberedClass(const std::string& model)
{
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(model.data(), model.data() + model.size(), number);
  if (error != std::errc() || end != model.data() + model.size() || number < 1 || number > 400)
    return std::nullopt;
  return (number - 1) / 20 + 1;
}

std::string
numberedClassName(std::size_t class_number)
{
  static const std::array<const char*, 20> names{
      "human", "cup",  "glasses", "plane",  "ant",       "chair", "octopus", "table",   "teddy", "hand",
      "plier", "fish", "bird",    "spring", "armadillo", "bust",  "mech",    "bearing", "vase",  "four-legged"};
  return names.at(class_number - 1);
}

std::string
withoutNumber(const std::string& model)
{
  const std::size_t last = model.find_last_not_of("0123456789");
  return model.substr(0, last == std::string::npos ? 0 : last + 1);
}

/** The only .pid file of a folder; nothing where there are several or none. */
std::optional<fs::path>
onlyLandmarkFile(const fs::path& corrs)
{
  std::vector<fs::path> files = listFolder(corrs);
  files.erase(
      std::remove_if(files.begin(), files.end(), [](const fs::path& file) { return file.extension() != ".pid"; }),
      files.end());
  return files.size() == 1 ? std::optional<fs::path>(files.front()) : std::nullopt;
}

void
setLandmarkTruth(BenchmarkModel& model, const fs::path& corrs)
{
  const std::optional<std::size_t> class_number = numberedClass(model.name);
  const fs::path own_landmarks = corrs / (model.name + ".vts");
  if (class_number && fs::exists(own_landmarks)) {
    model.class_name = numberedClassName(*class_number);
    model.truth = own_landmarks.string() + ":" + (corrs / (std::to_string(*class_number) + ".sym.info")).string();
    return;
  }
  model.class_name = withoutNumber(model.name);
  const fs::path class_landmarks = corrs / (model.class_name + ".pid");
  if (fs::exists(class_landmarks)) {
    model.truth = class_landmarks.string();
  }
  else if (const std::optional<fs::path> only = onlyLandmarkFile(corrs)) {
    model.class_name = only->stem().string();
    model.truth = only->string();
  }
}

void
setDenseTruth(BenchmarkModel& model, const fs::path& folder)
{
  model.class_name = toLower(model.set);
  for (const fs::path& file : {folder / (model.name + "_sym.txt"), folder / "sym.txt"})
    if (model.truth.empty() && fs::exists(file))
      model.truth = file.string();
}

/** The models of one data set; none where \a folder is no data set. */
std::vector<BenchmarkModel>
findModelsOfSet(const fs::path& folder)
{
  const fs::path corrs = folder / "Corrs";
  const bool has_landmarks = fs::is_directory(folder / "Meshes") && fs::is_directory(corrs);
  std::vector<BenchmarkModel> models;
  for (const fs::path& file : listSurfaceFiles(has_landmarks ? folder / "Meshes" : folder)) {
    BenchmarkModel model;
    model.file = file.string();
    model.name = file.stem().string();
    model.set = folderName(folder);
    if (has_landmarks)
      setLandmarkTruth(model, corrs);
    else
      setDenseTruth(model, folder);
    models.push_back(std::move(model));
  }
  return models;
}

std::vector<BenchmarkModel>
findModelsBelow(const fs::path& folder)
{
  std::vector<BenchmarkModel> models = findModelsOfSet(folder);
  if (!models.empty())
    return models;
  for (const fs::path& entry : listFolder(folder)) {
    if (!fs::is_directory(entry))
      continue;
    const std::vector<BenchmarkModel> found = findModelsOfSet(entry);
    models.insert(models.end(), found.begin(), found.end());
  }
  return models;
}

} // namespace

std::vector<BenchmarkModel>
findModels(const std::string& folder)
{
  if (!fs::is_directory(folder))
    throw pcl::IOException(folder + ": is no folder");
  try {
    std::vector<BenchmarkModel> models = findModelsBelow(folder);
    if (models.empty())
      throw pcl::IOException(folder + ": no model in it or in the folders directly below");
    return models;
  }
  catch (const fs::filesystem_error& error) {
    throw pcl::IOException(folder + ": cannot be read: " + error.code().message());
  }
}

void
addVariants(std::vector<BenchmarkModel>& models, std::size_t count)
{
  std::vector<BenchmarkModel> all;
  for (BenchmarkModel& model : models) {
    const BenchmarkModel as_it_is = std::move(model);
    all.push_back(as_it_is);
    for (std::size_t k = 1; k <= count; ++k) {
      all.push_back(as_it_is);
      all.back().variant = static_cast<Variant>(k);
      all.back().name += std::string("~") + toString(all.back().variant);
    }
  }
  models = std::move(all);
}

} // namespace symmetry
} // namespace pcl
