#include "glass/tea_recipes.hpp"

#include "core/error.hpp"
#include "core/resources.hpp"
#include "glass/panel_parts.hpp"

#include <string>

#include <QObject>

namespace pastoso::glass {
namespace {

struct Bundled {
    const char* scene;
    const char* words;
    const char* hint;
};

constexpr Bundled kBundled[] = {
    {"usual", QT_TR_NOOP("Cold milk"),
     QT_TR_NOOP("Cold milk sinks, and comes up again in soft clouds as it warms")},
    {"cold-brew", QT_TR_NOOP("Cold brew"),
     QT_TR_NOOP("A thin stream into cold tea: it heaps up on the floor and stays there for long")},
    {"cream", QT_TR_NOOP("Cream"), QT_TR_NOOP("Thick cream turns round and floats on the tea")},
    {"drops", QT_TR_NOOP("A drop"), QT_TR_NOOP("A little thin milk, drawn out to fingers and veils")},
    {"stirred", QT_TR_NOOP("Stirred"), QT_TR_NOOP("The spoon goes round while the milk is poured")},
    {"cloud", QT_TR_NOOP("White"), QT_TR_NOOP("A wide stream of milk billows up and fills the glass")},
};

}  // namespace

std::vector<TeaRecipe> tea_recipes() {
    std::vector<TeaRecipe> recipes;
    for (const Bundled& recipe : kBundled) {
        try {
            recipes.push_back({QString::fromLatin1(recipe.scene), words_of(recipe.words),
                               words_of(recipe.hint),
                               core::resource_path(std::string("tea/") + recipe.scene + ".jpg")});
        } catch (const core::InputError&) {
            continue;  // milk can be poured without a recipe
        }
    }
    return recipes;
}

}  // namespace pastoso::glass
