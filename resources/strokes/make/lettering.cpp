#include "lettering.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace pastoso::examples {
namespace {

/// Width of a letter's box and the way to the next, in heights.
constexpr double kWidth = 0.62, kAdvance = 0.86;
/// Time and samples for each corner of a letter: a quick hand, but one that turns its corners.
constexpr double kCorner_s = 0.012;
constexpr int kSamplesPerCorner = 5;
constexpr Press kPress{0.5, 0.06, 0.06};

/// The strokes of a letter on a grid of five columns (0-4) and seven rows (0-6): pairs of digits, column
/// and row, with a space between strokes.
std::string_view strokes_of(char letter) {
    static constexpr std::string_view kLetters[26] = {"062046 1434",                   // A
                                                      "0006 003041423303 3344453606",  // B
                                                      "413010010516363645",            // C
                                                      "0006 002042442606",             // D
                                                      "400006 0333 0646",              // E
                                                      "400006 0333",                   // F
                                                      "41301001051636454323",          // G
                                                      "0006 4046 0343",                // H
                                                      "2026",                          // I
                                                      "404536261605",                  // J
                                                      "0006 4003 1346",                // K
                                                      "000646",                        // L
                                                      "0600234046",                    // M
                                                      "06004640",                      // N
                                                      "100105163645413010",            // O
                                                      "0600 003041423303",             // P
                                                      "100105163645413010 2446",       // Q
                                                      "0600 003041423303 2346",        // R
                                                      "413010010213334445361605",      // S
                                                      "0040 2026",                     // T
                                                      "000516364540",                  // U
                                                      "002640",                        // V
                                                      "0016233640",                    // W
                                                      "0046 4006",                     // X
                                                      "002340 2326",                   // Y
                                                      "00400646"};                     // Z
    static constexpr std::string_view kDigits[10] = {
        "100105163645413010",  "1120 2026", "01103041420646",
        "0040234445361605",    "36300444",  "4000022333444536",
        "3001051636453413",    "004026",    "1313020110304142331304051636454433",
        "43130201103041423626"};
    if (letter >= 'A' && letter <= 'Z') return kLetters[letter - 'A'];
    if (letter >= '0' && letter <= '9') return kDigits[letter - '0'];
    return "";
}

/// The point at share u of a polyline's length.
Point along(const std::vector<Point>& corners, double u) {
    double total = 0.0;
    for (std::size_t i = 1; i < corners.size(); ++i)
        total += length(corners[i] - corners[i - 1]);
    double left = u * total;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const double side = length(corners[i] - corners[i - 1]);
        if (left <= side || i + 1 == corners.size())
            return corners[i - 1] + std::min(1.0, left / side) * (corners[i] - corners[i - 1]);
        left -= side;
    }
    return corners.front();
}

void write_stroke(Painter& painter, std::string_view digits, Point corner, double height_mm) {
    std::vector<Point> corners;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
        corners.push_back(corner + Point{kWidth * height_mm * (digits[i] - '0') / 4.0,
                                         height_mm * (digits[i + 1] - '0') / 6.0});
    const auto count = static_cast<int>(corners.size());
    painter.stroke(
        kCorner_s * count,
        [&](double u) {
            const Point at = along(corners, u);
            return Touch{at.x, at.y, pressure_at(kPress, u)};
        },
        kSamplesPerCorner * count);
}

}  // namespace

brush::Preset lettering_pen(double width_mm) {
    brush::Preset pen = brush::resized(brush::find_preset("Rigger 2"), width_mm);
    pen.name = "Lettering pen";
    pen.stroke.smoothing_ms = 0.0;
    pen.flex.descend = 5.0;
    pen.flex.bend = 0.1;
    pen.paint.film_mm = 0.12;
    pen.paint.hair = pen.paint.groove = pen.paint.streak = 0.0;
    return pen;
}

void write(Painter& painter, std::string_view words, Point corner, double height_mm) {
    for (const char character : words) {
        const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
        std::string_view strokes = strokes_of(letter);
        while (!strokes.empty()) {
            const std::size_t end = std::min(strokes.find(' '), strokes.size());
            write_stroke(painter, strokes.substr(0, end), corner, height_mm);
            strokes.remove_prefix(std::min(end + 1, strokes.size()));
        }
        corner.x += kAdvance * height_mm;
    }
}

}  // namespace pastoso::examples
