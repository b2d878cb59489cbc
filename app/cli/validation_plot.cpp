#include "cli/validation_report.hpp"
#include "core/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pastoso::cli {
namespace {

using core::number_text;
using film::validation::Curve;
using film::validation::PlotPoint;

constexpr double kWidth = 760.0, kHeight = 420.0;
constexpr double kLeft = 70.0, kRight = 540.0, kTop = 44.0, kBottom = 360.0;  // of the axes
constexpr double kLine = 15.0;                                                // of text
constexpr int kMostLines = 21;
/// Told apart by those who see no red or green, too (Okabe and Ito 2008).
constexpr std::array kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                 "#56b4e9", "#e69f00", "#7f7f7f", "#882255"};

struct Span {
    double least = 0.0, most = 1.0;

    void take(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

/// 1, 2 or 5 times a power of ten, of which some five fit.
double tick_of(const Span& span) {
    const double rough = (span.most - span.least) / 5.0;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double times : {1.0, 2.0, 5.0})
        if (times * power >= rough) return times * power;
    return 10.0 * power;
}

struct Axes {
    Span x, y;

    double right(double value) const {
        return kLeft + (value - x.least) / (x.most - x.least) * (kRight - kLeft);
    }
    double down(double value) const {
        return kBottom - (value - y.least) / (y.most - y.least) * (kBottom - kTop);
    }
};

Axes axes_of(const std::vector<ValidatedRun>& runs) {
    Axes axes;
    bool first = true;
    for (const ValidatedRun& run : runs)
        for (const Curve* curve : {&run.outcome.measured, &run.outcome.exact})
            for (const PlotPoint& point : *curve) {
                if (first) axes = {{point.x, point.x}, {0.0, point.y}};
                first = false;
                axes.x.take(point.x);
                axes.y.take(point.y);
            }
    if (axes.x.most <= axes.x.least) axes.x.most = axes.x.least + 1.0;
    if (axes.y.most <= axes.y.least) axes.y.most = axes.y.least + 1.0;
    axes.y.most += 0.04 * (axes.y.most - axes.y.least);
    return axes;
}

std::string pixel(double value) {
    return number_text(std::round(10.0 * value) / 10.0, 6);
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char letter : text)
        safe += letter == '<'   ? "&lt;"
                : letter == '>' ? "&gt;"
                : letter == '&' ? "&amp;"
                                : std::string(1, letter);
    return safe;
}

std::string text_at(double x, double y, const std::string& text, const std::string& more = "") {
    return "<text x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\"" + more + ">" + escaped(text) +
           "</text>\n";
}

std::string line(double x0, double y0, double x1, double y1, const std::string& stroke) {
    return "<line x1=\"" + pixel(x0) + "\" y1=\"" + pixel(y0) + "\" x2=\"" + pixel(x1) + "\" y2=\"" +
           pixel(y1) + "\" stroke=\"" + stroke + "\"/>\n";
}

std::string polyline(const Curve& curve, const Axes& axes, const std::string& style) {
    if (curve.size() == 1) return "";
    std::string text = "<polyline fill=\"none\" " + style + " points=\"";
    for (const PlotPoint& point : curve)
        text += pixel(axes.right(point.x)) + "," + pixel(axes.down(point.y)) + " ";
    return text + "\"/>\n";
}

std::string frame(const Axes& axes, const film::validation::Case& shown) {
    std::string text;
    const double tick_x = tick_of(axes.x), tick_y = tick_of(axes.y);
    for (double x = std::ceil(axes.x.least / tick_x) * tick_x; x <= axes.x.most + 1e-9 * tick_x;
         x += tick_x) {
        text += line(axes.right(x), kTop, axes.right(x), kBottom, "#e4e4e4");
        text +=
            text_at(axes.right(x), kBottom + kLine + 2.0,
                    number_text(std::abs(x) < 1e-9 * tick_x ? 0.0 : x, 4), " text-anchor=\"middle\"");
    }
    for (double y = std::ceil(axes.y.least / tick_y) * tick_y; y <= axes.y.most + 1e-9 * tick_y;
         y += tick_y) {
        text += line(kLeft, axes.down(y), kRight, axes.down(y), "#e4e4e4");
        text += text_at(kLeft - 6.0, axes.down(y) + 4.0,
                        number_text(std::abs(y) < 1e-9 * tick_y ? 0.0 : y, 4), " text-anchor=\"end\"");
    }
    text +=
        line(kLeft, kBottom, kRight, kBottom, "#000000") + line(kLeft, kTop, kLeft, kBottom, "#000000");
    text +=
        text_at(0.5 * (kLeft + kRight), kBottom + 2.6 * kLine, shown.x_axis, " text-anchor=\"middle\"");
    text += text_at(
        16.0, 0.5 * (kTop + kBottom), shown.y_axis,
        " text-anchor=\"middle\" transform=\"rotate(-90 16 " + pixel(0.5 * (kTop + kBottom)) + ")\"");
    return text + text_at(kLeft, 24.0, shown.name + ": " + shown.law, " font-size=\"13\"");
}

/// Explicit steps are drawn through, large ones dashed; a colour for each cell size and angle.
std::string curves(const std::vector<ValidatedRun>& runs, const Axes& axes) {
    std::string text, key;
    int lines = 0;
    const auto label = [&](const std::string& style, const std::string& words) {
        if (lines >= kMostLines) return;
        const double y = kTop + kLine * lines++;
        key += "<line x1=\"" + pixel(kRight + 14.0) + "\" y1=\"" + pixel(y - 4.0) + "\" x2=\"" +
               pixel(kRight + 40.0) + "\" y2=\"" + pixel(y - 4.0) + "\" " + style + "/>\n" +
               text_at(kRight + 46.0, y, words);
    };
    std::vector<std::pair<double, double>> kinds;
    for (const ValidatedRun& run : runs) {
        const std::pair kind(run.run.cell_mm, run.run.angle_deg);
        if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
        const auto colour =
            static_cast<std::size_t>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin()) %
            kColours.size();
        const bool large = run.run.scheme == film::Scheme::LargeStep;
        const std::string style = std::string("stroke-width=\"1.4\" stroke=\"") + kColours[colour] +
                                  "\"" + (large ? " stroke-dasharray=\"5 3\"" : "");
        text += polyline(run.outcome.measured, axes, style);
        label(style, name_of(run.run.scheme) + ", " + number_text(run.run.cell_mm, 3) + " mm, " +
                         number_text(run.run.angle_deg, 3) + "°");
    }
    const std::string exact_style = "stroke-width=\"1.2\" stroke=\"#000000\"";
    std::vector<Curve> drawn;
    for (const ValidatedRun& run : runs) {
        const auto same = [&](const Curve& other) {
            return std::equal(
                other.begin(), other.end(), run.outcome.exact.begin(), run.outcome.exact.end(),
                [](const PlotPoint& a, const PlotPoint& b) { return a.x == b.x && a.y == b.y; });
        };
        if (std::any_of(drawn.begin(), drawn.end(), same)) continue;
        drawn.push_back(run.outcome.exact);
        text += polyline(run.outcome.exact, axes, exact_style);
    }
    label(exact_style, "exact");
    return text + key;
}

}  // namespace

std::string validation_plot(const std::vector<ValidatedRun>& runs) {
    const Axes axes = axes_of(runs);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + pixel(kWidth) + "\" height=\"" +
           pixel(kHeight) + "\" viewBox=\"0 0 " + pixel(kWidth) + " " + pixel(kHeight) +
           "\" font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"100%\" height=\"100%\" "
           "fill=\"#ffffff\"/>\n" +
           frame(axes, *runs.front().wanted) + curves(runs, axes) + "</svg>\n";
}

}  // namespace pastoso::cli
