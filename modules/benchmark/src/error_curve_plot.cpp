#include "benchmark/error_curve_plot.h"

#include "io/write/output_file.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace pcl {
namespace symmetry {
namespace {

// In pixels; the plot area lies between the margins.
constexpr double width = 720.0;
constexpr double height = 480.0;
constexpr double margin_left = 70.0;
constexpr double margin_right = 170.0; // the legend stands there
constexpr double margin_top = 30.0;
constexpr double margin_bottom = 60.0;

/** Okabe and Ito's palette, told apart by colour-blind people as well. */
constexpr std::array<const char*, 7> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#e69f00", "#56b4e9", "#000000"};

std::string
number(double value, int decimals)
{
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string
escape(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
    escaped += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
  return escaped;
}

/** Maps thresholds and shares to pixels. */
struct Axes {
  double largest_threshold = 1.0;

  double
  x(double threshold) const
  {
    return margin_left + (width - margin_left - margin_right) * threshold / largest_threshold;
  }

  static double
  y(double share)
  {
    return height - margin_bottom - (height - margin_top - margin_bottom) * share;
  }
};

std::string
line(double x1, double y1, double x2, double y2, const std::string& style)
{
  return "<line x1='" + number(x1, 1) + "' y1='" + number(y1, 1) + "' x2='" + number(x2, 1) + "' y2='" + number(y2, 1) +
         "' " + style + "/>\n";
}

std::string
label(double x, double y, const std::string& text, const std::string& style)
{
  return "<text x='" + number(x, 1) + "' y='" + number(y, 1) + "' " + style + ">" + escape(text) + "</text>\n";
}

std::string
drawGrid(const Axes& axes)
{
  const std::string grid = "stroke='#dddddd'";
  std::string svg;
  for (int i = 0; i <= 5; ++i) {
    const double threshold = axes.largest_threshold * i / 5;
    const double share = 0.2 * i;
    svg += line(axes.x(threshold), Axes::y(0.0), axes.x(threshold), Axes::y(1.0), grid);
    svg += line(axes.x(0.0), Axes::y(share), axes.x(axes.largest_threshold), Axes::y(share), grid);
    svg += label(axes.x(threshold), Axes::y(0.0) + 20.0, number(threshold, 2), "text-anchor='middle'");
    svg += label(axes.x(0.0) - 8.0, Axes::y(share) + 5.0, number(100.0 * share, 0), "text-anchor='end'");
  }
  const std::string axis = "stroke='#333333'";
  svg += line(axes.x(0.0), Axes::y(0.0), axes.x(axes.largest_threshold), Axes::y(0.0), axis);
  svg += line(axes.x(0.0), Axes::y(0.0), axes.x(0.0), Axes::y(1.0), axis);
  return svg;
}

std::string
drawAxisTitles(const Axes& axes)
{
  const double middle = Axes::y(0.5);
  return label(axes.x(0.5 * axes.largest_threshold), height - 15.0, "geodesic error, share of the diameter",
               "text-anchor='middle'") +
         label(20.0, middle, "points with a smaller error, %",
               "text-anchor='middle' transform='rotate(-90 20 " + number(middle, 1) + ")'");
}

std::string
drawCurve(const Axes& axes, const ErrorCurve& curve, const std::string& colour)
{
  std::string points;
  for (std::size_t i = 0; i < curve.thresholds.size(); ++i)
    points += (points.empty() ? "" : " ") + number(axes.x(curve.thresholds[i]), 1) + "," +
              number(Axes::y(curve.shares[i]), 1);
  return "<polyline fill='none' stroke-width='2' stroke='" + colour + "' points='" + points + "'/>\n";
}

std::string
drawLegendEntry(std::size_t row, const std::string& name, const std::string& colour)
{
  const double x = width - margin_right + 20.0;
  const double y = margin_top + 12.0 + 22.0 * static_cast<double>(row);
  return line(x, y, x + 24.0, y, "stroke-width='2' stroke='" + colour + "'") + label(x + 32.0, y + 5.0, name, "");
}

} // namespace

std::string
drawErrorCurves(const std::vector<ErrorCurve>& curves)
{
  Axes axes{0.0};
  for (const ErrorCurve& curve : curves)
    axes.largest_threshold = std::max(axes.largest_threshold, curve.thresholds.back());
  if (curves.empty())
    axes.largest_threshold = 0.25;

  std::string svg = "<svg xmlns='http://www.w3.org/2000/svg' width='" + number(width, 0) + "' height='" +
                    number(height, 0) + "' font-family='sans-serif' font-size='14'>\n";
  svg += "<rect width='100%' height='100%' fill='white'/>\n";
  svg += drawGrid(axes) + drawAxisTitles(axes);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::string colour = colours[i % colours.size()];
    svg += drawCurve(axes, curves[i], colour) + drawLegendEntry(i, curves[i].name, colour);
  }
  return svg + "</svg>\n";
}

void
writeErrorCurves(const std::string& path, const std::vector<ErrorCurve>& curves)
{
  writeWholeFile(path, drawErrorCurves(curves));
}

} // namespace symmetry
} // namespace pcl
