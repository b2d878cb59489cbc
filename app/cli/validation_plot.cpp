#include "cli/validation_report.hpp"
#include "core/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
constexpr std::array kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9",
                                 "#e69f00", "#000000", "#882255", "#999933"};

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

std::string path_of(const Curve& curve, const Axes& axes, const std::string& style) {
    if (curve.empty()) return {};
    std::string text = "<path fill=\"none\" stroke-linejoin=\"round\" " + style + " d=\"";
    char command = 'M';
    for (const PlotPoint& point : curve) {
        text += command + pixel(axes.right(point.x)) + " " + pixel(axes.down(point.y));
        command = 'L';
    }
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

/// The lines beside the axes that say which curve is which.
class Key {
  public:
    void add(const std::string& style, const std::string& words) {
        if (lines_ >= kMostLines) return;
        const double y = kTop + kLine * lines_++;
        text_ += "<line x1=\"" + pixel(kRight + 14.0) + "\" y1=\"" + pixel(y - 4.0) + "\" x2=\"" +
                 pixel(kRight + 40.0) + "\" y2=\"" + pixel(y - 4.0) + "\" " + style + "/>\n" +
                 text_at(kRight + 46.0, y, words);
    }
    const std::string& text() const { return text_; }

  private:
    int lines_ = 0;
    std::string text_;
};

bool is_same(const Curve& a, const Curve& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](PlotPoint p, PlotPoint q) { return p.x == q.x && p.y == q.y; });
}

/// Broad, below the others. Most runs of a case share one.
std::string exact_curves(const std::vector<ValidatedRun>& runs, const Axes& axes, Key& key) {
    const std::string style = "stroke-width=\"5\" stroke=\"#c8c8c8\"";
    std::string text;
    for (auto run = runs.begin(); run != runs.end(); ++run)
        if (std::none_of(runs.begin(), run, [&](const ValidatedRun& before) {
                return is_same(before.outcome.exact, run->outcome.exact);
            }))
            text += path_of(run->outcome.exact, axes, style);
    if (!runs.front().outcome.exact.empty()) key.add(style, "exact");
    return text;
}

/// Explicit steps are drawn through, large ones dashed; a colour for each cell size and angle.
std::string measured_curves(const std::vector<ValidatedRun>& runs, const Axes& axes, Key& key) {
    std::vector<std::pair<double, double>> kinds;
    std::string text;
    for (const ValidatedRun& run : runs) {
        const std::pair kind(run.run.cell_mm, run.run.angle_deg);
        auto known = std::find(kinds.begin(), kinds.end(), kind);
        if (known == kinds.end()) known = kinds.insert(kinds.end(), kind);
        const auto colour = static_cast<std::size_t>(known - kinds.begin()) % kColours.size();
        const bool large = run.run.scheme == film::Scheme::LargeStep;
        const std::string style = std::string("stroke-width=\"1.3\" stroke=\"") + kColours[colour] +
                                  "\"" + (large ? " stroke-dasharray=\"5 3\"" : "");
        text += path_of(run.outcome.measured, axes, style);
        key.add(style, film::validation::name_of(run.run.scheme) + ", " +
                           number_text(run.run.cell_mm, 3) + " mm, " +
                           number_text(run.run.angle_deg, 3) + "°");
    }
    return text;
}

std::string curves(const std::vector<ValidatedRun>& runs, const Axes& axes) {
    Key key;
    const std::string exact = exact_curves(runs, axes, key);
    return exact + measured_curves(runs, axes, key) + key.text();
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
