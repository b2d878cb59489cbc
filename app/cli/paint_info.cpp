#include "cli/paint_info.hpp"

#include "cli/printing.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "pigment/appearance.hpp"
#include "pigment/box.hpp"
#include "pigment/gpl.hpp"
#include "pigment/hex_colour.hpp"
#include "pigment/paint_name.hpp"
#include "pigment/recipe.hpp"
#include "pigment/rgb_paint.hpp"
#include "pigment/user_pigments.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace pastoso::cli {
namespace {

using pigment::Pigment;

/// As a screen shows it whose white is titanium white.
std::string shown(const pigment::LinearRgb& of_paint) {
    return pigment::hex_colour(pigment::encoded(pigment::screen_colour(of_paint)));
}

int opacity_percent(const pigment::Coefficients& paint) {
    return static_cast<int>(std::lround(100.0 * pigment::contrast_ratio(paint)));
}

/// To two digits, more would be pretence.
std::string strength_text(const pigment::Coefficients& paint) {
    const double strength = pigment::tinting_strength(paint);
    char text[32];
    std::snprintf(text, sizeof text, "%.0f",
                  strength < 100.0 ? strength : 10.0 * std::round(strength / 10));
    return text;
}

void print_row(const Pigment& paint) {
    const pigment::Coefficients& coefficients = paint.coefficients;
    print("  %-10s %-9s %-10s %-9s %5d %% %8s  %s\n", paint.ci_name.c_str(),
          shown(pigment::masstone(coefficients)).c_str(),
          shown(pigment::undertone(coefficients)).c_str(), shown(pigment::tint(coefficients)).c_str(),
          opacity_percent(coefficients), strength_text(coefficients).c_str(), paint.name.c_str());
}

void print_rows(const char* heading, const std::vector<Pigment>& paints) {
    if (paints.empty()) return;
    print("\n%s:\n", heading);
    for (const Pigment& paint : paints)
        print_row(paint);
}

std::vector<Pigment> outside_the_box() {
    std::vector<Pigment> others;
    for (const Pigment& paint : pigment::bundled_palette()) {
        const auto& box = pigment::default_box();
        const bool in_box = std::any_of(box.begin(), box.end(), [&](const Pigment& other) {
            return other.ci_name == paint.ci_name;
        });
        if (!in_box) others.push_back(paint);
    }
    return others;
}

void print_bands(const char* what, const float* first) {
    print("%s:", what);
    for (int band = 0; band < pigment::kBands; ++band)
        print(" %.4g", static_cast<double>(first[band]));
    print("\n");
}

pigment::Srgb8 parse_colour(const std::string& text) {
    pigment::check_paint_name(text);
    const auto colour = pigment::parse_hex_colour(text);
    if (!colour) {
        throw core::InputError("\"%1\" is a pigment, not a colour; give for example \"#7a5c3e\".", text);
    }
    return *colour;
}

pigment::RecipeFinder finder_of(std::span<const std::string> names) {
    if (names.empty()) return pigment::RecipeFinder(pigment::default_box());
    std::vector<Pigment> paints;
    for (const std::string& name : names)
        paints.push_back(pigment::find_pigment(name));
    return pigment::RecipeFinder(paints);
}

}  // namespace

void print_paints() {
    print("  %-10s %-9s %-10s %-9s %7s %8s  %s\n", "Paint", "Masstone", "Undertone", "Tint", "Opacity",
          "Tinting", "Name");
    print_rows("The box", pigment::default_box());
    print_rows("Other paints", outside_the_box());
    print_rows("Your own", pigment::user_pigments().pigments);
    print(
        "\nColours as a screen shows them whose white is titanium white. Masstone: thick. Undertone: a\n"
        "film of 25 um over white. Tint: one part in ten of white. Opacity: how light 0.1 mm is over\n"
        "black, of what it is over white. Tinting: the parts of white that one part still colours.\n");
    std::string faults;
    for (const core::Message& fault : pigment::user_pigments().faults)
        faults += (faults.empty() ? "" : " ") + fault.text();
    if (!faults.empty()) throw core::InputError(core::Message::verbatim(faults));
}

void print_paint(const std::string& name) {
    const pigment::Coefficients paint = pigment::named_paint(name);
    print("%s: %s\n", name.c_str(), pigment::painters_name(name).c_str());
    print("masstone: %s\n", shown(pigment::masstone(paint)).c_str());
    print("undertone: %s (25 um over white)\n", shown(pigment::undertone(paint)).c_str());
    print("tint: %s (1 part in 10 of white)\n", shown(pigment::tint(paint)).c_str());
    print("opacity: %d %% (0.1 mm over black, of what it is over white)\n", opacity_percent(paint));
    print("tinting strength: 1 part colours %s parts of white\n", strength_text(paint).c_str());
    print_bands("absorption per mm, violet to red", paint.data());
    print_bands("scattering per mm, violet to red", paint.data() + pigment::kBands);
}

void print_closest(const std::string& colour, std::span<const std::string> paints) {
    const pigment::LinearRgb on_screen = pigment::decoded(parse_colour(colour));
    const pigment::Recipe recipe = finder_of(paints).closest(pigment::paint_colour(on_screen));
    print("%s\n", colour.c_str());
    print("closest recipe: %s (dE %.1f)\n", pigment::recipe_text(recipe).c_str(), recipe.difference);
    for (const pigment::RecipePart& part : recipe.ingredients)
        print("  %3d  %-10s %s\n", part.parts, part.ci_name.c_str(),
              pigment::painters_name(part.ci_name).c_str());
    print("the colour's own paint: %s (dE %.1f)\n", colour.c_str(),
          pigment::rgb_paint(on_screen).difference);
}

void print_palette(const std::string& path) {
    const pigment::ColourPalette palette = pigment::parse_gpl(core::read_text_file(path), path);
    const pigment::RecipeFinder finder(pigment::default_box());
    print("%s: palette of colours\nname: %s\ncolours: %zu\n\n", path.c_str(), palette.name.c_str(),
          palette.colours.size());
    for (const pigment::NamedColour& colour : palette.colours) {
        const pigment::Recipe recipe =
            finder.closest(pigment::paint_colour(pigment::decoded(colour.colour)));
        print("%s  dE %4.1f  %-32s %s\n", pigment::hex_colour(colour.colour).c_str(), recipe.difference,
              pigment::recipe_text(recipe).c_str(), colour.name.c_str());
    }
}

}  // namespace pastoso::cli
