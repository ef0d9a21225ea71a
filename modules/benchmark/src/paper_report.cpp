#include "benchmark/paper_report.h"

#include "benchmark/colour_transfer.h"
#include "benchmark/error_curve_plot.h"
#include "benchmark/model_input.h"
#include "benchmark/summary.h"
#include "estimation/enum_names.h"
#include "io/write/output_file.h"

#include <pcl/symmetry/surface_io.h>
#include <pcl/symmetry/symmetry.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iomanip>
#include <sstream>

namespace pcl {
namespace symmetry {
namespace {

/** \brief Correspondence Rate / Mesh Rate in percent as their authors publish them. */
struct PublishedRates {
  const char* name; ///< of the class, or of a set that is one class
  const char* staged;
  const char* faisd;
  const char* moebius;
};

constexpr PublishedRates published_rates[] = {{"victoria", "78/75", "96/100", "83/63"},
                                              {"gorilla", "98/100", "100/100", ""},
                                              {"david", "95/100", "96/100", "82/57"},
                                              {"wolf", "97/100", "100/100", "100/100"},
                                              {"cat", "65/64", "96/100", "66/54"},
                                              {"michael", "88/90", "97/100", "87/75"},
                                              {"SCAPE", "81/75", "", ""},
                                              {"KIDS", "84/88", "", ""}};

/** \brief Seconds of the paper, for the sparse matches and for the dense map after them. */
struct PublishedSeconds {
  const char* vertices;
  const char* seconds;
};

constexpr PublishedSeconds published_seconds[] = {{"12500", "7 + 23"}, {"27000", "27 + 105"}};

std::string
toLower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string
number(double value, int decimals)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

/** \brief A name as text of a table: no bar ends its cell, no sign begins a tag or a link. */
std::string
cell(const std::string& name)
{
  std::string text;
  for (const char c : name)
    text += std::string(std::string_view("|<[]*_`\\").find(c) == std::string_view::npos ? "" : "\\") +
            (c == '\n' ? ' ' : c);
  return text;
}

/** \brief A name as part of that of a file and of a link to it. */
std::string
fileWord(std::string name)
{
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '.')
      c = '_';
  return name;
}

/** \brief What both methods make of one class; the vertices are a mean. */
struct ClassFigures {
  GroupSummary staged;
  GroupSummary robust;
  double vertices = 0.0;
  double sparse_seconds = 0.0; ///< of the staged method
  double dense_seconds = 0.0;

  bool
  isCalled(const std::string& name) const
  {
    return toLower(staged.class_name) == toLower(name) || toLower(staged.set) == toLower(name);
  }

  std::string
  title() const
  {
    const bool is_whole_set = toLower(staged.set) == toLower(staged.class_name);
    return cell(is_whole_set ? staged.set : staged.set + " " + staged.class_name) + " (" +
           std::to_string(staged.models) + ")";
  }
};

/** \brief Seconds of the staged method before its dense map, and from there on. */
std::pair<double, double>
splitSeconds(const ModelRun& run)
{
  std::pair<double, double> split{0.0, 0.0};
  bool is_dense = false;
  for (const auto& [step, seconds] : run.seconds) {
    is_dense = is_dense || step == "dense";
    (is_dense ? split.second : split.first) += seconds;
  }
  return split;
}

std::vector<ClassFigures>
collectFigures(const PaperRuns& runs)
{
  std::vector<ClassFigures> figures;
  const std::vector<GroupSummary> robust = summariseClasses(runs.robust);
  for (const GroupSummary& staged : summariseClasses(runs.staged)) {
    ClassFigures of_class;
    of_class.staged = staged;
    for (const GroupSummary& other : robust)
      if (other.set == staged.set && other.class_name == staged.class_name)
        of_class.robust = other;
    const double weight = 1.0 / static_cast<double>(staged.models);
    for (const ModelRun& run : runs.staged)
      if (run.model.set == staged.set && run.model.class_name == staged.class_name && !run.model.truth.empty()) {
        const auto [sparse, dense] = splitSeconds(run);
        of_class.vertices += weight * static_cast<double>(run.points);
        of_class.sparse_seconds += weight * sparse;
        of_class.dense_seconds += weight * dense;
      }
    figures.push_back(std::move(of_class));
  }
  return figures;
}

std::string
ratesOf(const GroupSummary& summary)
{
  return number(100.0 * summary.correspondence_rate, 1) + "/" + number(100.0 * summary.mesh_rate, 0);
}

std::string
rateRow(const std::string& title, const ClassFigures* ours, const PublishedRates& published)
{
  return "| " + title + " | " + published.staged + " | " + (ours != nullptr ? ratesOf(ours->staged) : "") + " | " +
         (ours != nullptr ? ratesOf(ours->robust) : "") + " | " + published.faisd + " | " + published.moebius + " |\n";
}

/** \brief The rows of the paper in its order, also where no model of them was run, and then what else was run. */
std::string
rateTable(const std::vector<ClassFigures>& figures)
{
  std::string text = "| class (models) | staged, as published | staged | robust | FAISD, as published | Moebius, as "
                     "published |\n| --- | --- | --- | --- | --- | --- |\n";
  std::vector<bool> is_shown(figures.size(), false);
  for (const PublishedRates& published : published_rates) {
    bool was_run = false;
    for (std::size_t i = 0; i < figures.size(); ++i)
      if (figures[i].isCalled(published.name)) {
        text += rateRow(figures[i].title(), &figures[i], published);
        is_shown[i] = was_run = true;
      }
    if (!was_run)
      text += rateRow(published.name, nullptr, published);
  }
  for (std::size_t i = 0; i < figures.size(); ++i)
    if (!is_shown[i])
      text += rateRow(figures[i].title(), &figures[i], {"", "", "", ""});
  return text;
}

std::string
timeTable(const std::vector<ClassFigures>& figures)
{
  std::string text = "| class (models) | vertices | staged, sparse + dense | robust |\n| --- | --- | --- | --- |\n";
  for (const PublishedSeconds& published : published_seconds)
    text += std::string("| as published | ") + published.vertices + " | " + published.seconds + " | |\n";
  for (const ClassFigures& ours : figures)
    text += "| " + ours.title() + " | " + number(ours.vertices, 0) + " | " + number(ours.sparse_seconds, 2) + " + " +
            number(ours.dense_seconds, 2) + " | " + number(ours.robust.mean_seconds, 2) + " |\n";
  return text;
}

/** \brief The models that count as wrong since they could not be run. */
std::string
failureList(const std::vector<ModelRun>& runs, const char* method)
{
  std::string text;
  for (const ModelRun& run : runs)
    if (!run.failure.empty())
      text +=
          "- " + cell(run.model.set + "/" + run.model.name) + ", " + method + ", failed: " + cell(run.failure) + "\n";
  return text;
}

/** \brief What the options of the benchmark may change and the tables depend on. */
std::string
parameterList(const SymmetryParameters& parameters)
{
  return std::string("metric ") + nameOf(metric_names, parameters.metric) + ", extremities " +
         nameOf(extreme_points_names, parameters.staged.extremities) + ", landmarks " +
         std::to_string(parameters.staged.landmarks) + ", samples " + std::to_string(parameters.staged.samples) +
         " (staged) and " + std::to_string(parameters.robust.samples) + " (robust)";
}

std::string
pictureList(const std::vector<PaperPicture>& pictures, std::string PaperPicture::*file)
{
  std::string text;
  for (const PaperPicture& picture : pictures) {
    const std::string title =
        cell(picture.model.set + "/" + picture.model.name) + ", " + nameOf(method_names, picture.method);
    const std::string& link = picture.*file;
    text += link.empty() ? title + ": no map (" + cell(toString(picture.status)) + ")\n\n"
                         : title + "\n\n![" + title + "](" + link + ")\n\n";
  }
  return text;
}

std::vector<ErrorCurve>
curvesOf(const PaperRuns& runs)
{
  std::vector<ErrorCurve> curves;
  for (const auto& [method, of_method] :
       {std::make_pair("staged", &runs.staged), std::make_pair("robust", &runs.robust)})
    for (ErrorCurve& curve : errorCurves(*of_method)) {
      curve.name += std::string(", ") + method;
      curves.push_back(std::move(curve));
    }
  return curves;
}

PaperPicture
drawPictures(const std::string& folder, const BenchmarkModel& model, Method method, RunOptions options)
{
  options.parameters.method = method;
  const Surface surface = readModel(model, options).input.surface;
  const SymmetryResult result = estimateIntrinsicSymmetry(surface, parametersFor(model, options));
  PaperPicture picture{model, method, result.status, "", ""};
  if (!hasMap(result.status))
    return picture;
  const std::string begin = fileWord(model.set) + "_" + fileWord(model.name) + "_" + nameOf(method_names, method);
  const auto place = [&folder](const std::string& name) {
    return (std::filesystem::path(folder) / name).string();
  };
  picture.matches = begin + ".png";
  picture.colours = begin + "_colours.png";
  writePicture(place(picture.matches), surface, result);
  writeColourTransfer(place(picture.colours), surface, result);
  return picture;
}

/** \brief The first model of each class that neither method failed for. */
std::vector<BenchmarkModel>
modelsToDraw(const PaperRuns& runs)
{
  std::vector<BenchmarkModel> models;
  for (std::size_t i = 0; i < runs.staged.size(); ++i) {
    const BenchmarkModel& model = runs.staged[i].model;
    const bool is_new = std::none_of(models.begin(), models.end(), [&model](const BenchmarkModel& other) {
      return other.set == model.set && other.class_name == model.class_name;
    });
    if (is_new && !model.truth.empty() && runs.staged[i].failure.empty() && runs.robust[i].failure.empty())
      models.push_back(model);
  }
  return models;
}

} // namespace

std::string
describePaper(const PaperRuns& runs, const SymmetryParameters& parameters, const std::vector<PaperPicture>& pictures)
{
  const std::vector<ClassFigures> figures = collectFigures(runs);
  std::string text = "# Published and measured\n\n"
                     "Staged is the published method step by step, robust the project's own. What is published was "
                     "measured by its authors, on all poses of each class and on other machines. Parameters here: " +
                     parameterList(parameters) + ".\n\n## Table 1: Correspondence Rate / Mesh Rate, %\n\n";
  text += rateTable(figures);
  const std::string failures = failureList(runs.staged, "staged") + failureList(runs.robust, "robust");
  text += failures.empty() ? "" : "\n" + failures;
  text += "\n## Table 2: seconds\n\nMeans over the models, reading and writing left out.\n\n" + timeTable(figures);
  text += std::string("\n## Figure 4: points below a geodesic error\n\n![Error curves](") + paper_curves + ")\n\n";
  if (!pictures.empty()) {
    text += "## Figure 5: colours of one side carried over to the other\n\n" +
            pictureList(pictures, &PaperPicture::colours);
    text += "## Figures 6 to 9: axis and matches\n\n" + pictureList(pictures, &PaperPicture::matches);
  }
  return text;
}

void
writePaper(const std::string& folder, const PaperRuns& runs, const RunOptions& options)
{
  std::vector<PaperPicture> pictures;
  for (const BenchmarkModel& model : modelsToDraw(runs))
    for (const Method method : {Method::Staged, Method::Robust})
      pictures.push_back(drawPictures(folder, model, method, options));
  writeErrorCurves((std::filesystem::path(folder) / paper_curves).string(), curvesOf(runs));
  writeWholeFile((std::filesystem::path(folder) / paper_page).string(),
                 describePaper(runs, options.parameters, pictures));
}

} // namespace symmetry
} // namespace pcl
