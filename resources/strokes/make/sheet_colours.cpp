// The colours of the reference sheet: tint ladders and the mixtures that every painter knows.
#include "sheet_parts.hpp"

#include <string>

namespace pastoso::examples {
namespace {

constexpr double kSwatchWidth_mm = 8.5;

/// A short stroke of one paint.
void swatch(Painter& painter, Point middle, const std::string& paint) {
    painter.wipe();
    painter.dip(load(mixture(paint), 0.8));
    paint_held(painter, Curve({middle - Point{0, 5.5}, middle + Point{0, 5.5}}), 40, {0.4, 0.1, 0.1}, 0);
}

void tint_ladder(Painter& painter, const Field& field, double y_mm, const std::string& pigment) {
    const char* white[] = {"", " PW6=1", " PW6=3", " PW6=9", " PW6=30", " PW6=100"};
    painter.take("Flat bristle 20", kSwatchWidth_mm);
    for (int i = 0; i < 6; ++i)
        swatch(painter, field.at(8.5 + 10.2 * i, y_mm), pigment + white[i]);
}

/// Two paints with three mixtures between them, all of them with as much `white`.
void mixing_row(Painter& painter, const Field& field, double y_mm, const std::string& first,
                const std::string& second, double strength_of_first, const std::string& white = "") {
    painter.take("Flat bristle 20", kSwatchWidth_mm);
    for (int i = 0; i < 5; ++i) {
        const double share = i / 4.0;
        const std::string a = first + "=" + std::to_string(strength_of_first * (1.0 - share) + 1e-6);
        const std::string b = second + "=" + std::to_string(share + 1e-6);
        const std::string paint = i == 0 ? first : i == 4 ? second : a + " " + b;
        swatch(painter, field.at(10.0 + 12.0 * i, y_mm), paint + white);
    }
}

}  // namespace

void paint_sheet_colours(Painter& painter) {
    tint_ladder(painter, Field(0, 8), 14, "PB15:3");
    tint_ladder(painter, Field(0, 8), 28, "PR122");
    tint_ladder(painter, Field(1, 8), 14, "PG7");
    tint_ladder(painter, Field(1, 8), 28, "PB29");
    mixing_row(painter, Field(2, 8), 14, "PY74", "PB15:3", 20);
    mixing_row(painter, Field(2, 8), 28, "PY35", "PB29", 1);
    mixing_row(painter, Field(3, 8), 14, "PY74", "PR254", 3);
    mixing_row(painter, Field(3, 8), 28, "PY35", "PBk9", 4);
    mixing_row(painter, Field(4, 8), 14, "PBr7-BU", "PB29", 1, " PW6=2");
    mixing_row(painter, Field(4, 8), 28, "PR101", "PG18", 1, " PW6=3");
    mixing_row(painter, Field(5, 8), 14, "PR122", "PB29", 1, " PW6=2");
    mixing_row(painter, Field(5, 8), 28, "PV19", "PB15:3", 4, " PW6=6");
}

}  // namespace pastoso::examples
