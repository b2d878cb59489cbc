#include "tools/mixed_paints.hpp"

#include "core/number_text.hpp"
#include "document/paint_mixing.hpp"

#include <map>
#include <string>

namespace pastoso::tools {
namespace {

struct Mixtures {
    film::Medium medium;
    std::map<std::string, film::PaintCoefficients> paints;
};

/// One text for one recipe.
std::string key_of(const document::PaintRecipe& paint) {
    std::string key = core::number_text(paint.strength);
    for (const document::Ingredient& part : paint.ingredients)
        key += ' ' + core::number_text(part.parts) + ' ' + part.pigment;
    return key;
}

}  // namespace

const film::PaintCoefficients& remembered_paint(const document::PaintRecipe& paint,
                                                const film::Medium& medium) {
    thread_local Mixtures known;
    if (!(known.medium == medium) || known.paints.size() >= kMostMixtures) known = {medium, {}};
    const auto [entry, added] = known.paints.try_emplace(key_of(paint));
    if (added) entry->second = document::mixed_paint(paint, medium);
    return entry->second;
}

}  // namespace pastoso::tools
