#include "cli/values.hpp"

#include "cli/usage_error.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace pastoso::cli {
namespace {

std::optional<double> number(std::string_view text) {
    double value = 0.0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

/// Cuts off and returns what stands before the first `separator`, the whole rest where there is none.
std::string_view take_until(std::string_view& rest, char separator) {
    const std::size_t length = std::min(rest.find(separator), rest.size());
    const std::string_view head = rest.substr(0, length);
    rest.remove_prefix(std::min(length + 1, rest.size()));
    return head;
}

[[noreturn]] void refuse_size(const std::string& text) {
    throw UsageError("--canvas: \"" + text + "\" is not a size; give for example 300x200mm.");
}

[[noreturn]] void refuse_paint(const std::string& text) {
    throw UsageError("--paint: \"" + text +
                     "\" is not a paint; give for example PB29, or PB29=1+PW6=0.5 for a "
                     "mixture, PB29@0.3 for a thinned paint, or \"#c03020\" for a colour.");
}

document::Ingredient parse_ingredient(std::string_view part, const std::string& whole) {
    document::Ingredient ingredient;
    const bool has_parts = part.find('=') != std::string_view::npos;
    ingredient.pigment = take_until(part, '=');
    const std::optional<double> parts = has_parts ? number(part) : 1.0;
    if (ingredient.pigment.empty() || !parts) refuse_paint(whole);
    ingredient.parts = *parts;
    return ingredient;
}

}  // namespace

CanvasSize parse_canvas_size(const std::string& text) {
    std::string_view rest = text;
    double unit_mm = 1.0;
    if (rest.ends_with("mm")) {
        rest.remove_suffix(2);
    } else if (rest.ends_with("cm")) {
        rest.remove_suffix(2);
        unit_mm = 10.0;
    }
    const std::optional<double> width = number(take_until(rest, 'x'));
    const std::optional<double> height = number(rest);
    if (!width || !height) refuse_size(text);
    return {*width * unit_mm, *height * unit_mm};
}

document::PaintRecipe parse_paint(const std::string& text) {
    document::PaintRecipe paint;
    std::string_view rest = text;
    std::string_view mixture = take_until(rest, '@');
    if (text.find('@') != std::string::npos) {
        const std::optional<double> strength = number(rest);
        if (!strength) refuse_paint(text);
        paint.strength = *strength;
    }
    if (mixture == "clear") return paint;
    if (mixture.empty() || mixture.ends_with('+')) refuse_paint(text);
    while (!mixture.empty())
        paint.ingredients.push_back(parse_ingredient(take_until(mixture, '+'), text));
    return paint;
}

}  // namespace pastoso::cli
