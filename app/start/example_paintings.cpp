#include "start/example_paintings.hpp"

#include "core/error.hpp"
#include "core/resources.hpp"

#include <string>

#include <QCoreApplication>

namespace pastoso::start {
namespace {

/// Makes tr() find these words.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(ExamplePaintings)
};

}  // namespace

std::vector<ExamplePainting> example_paintings() {
    struct Bundled {
        const char* file;
        QString name, detail;
    };
    const Bundled all[] = {
        {"still-life", Words::tr("Still life"), Words::tr("Oil, wet in wet")},
        {"surf", Words::tr("Surf"), Words::tr("Oil, in thick impasto")},
        {"poppies", Words::tr("Poppies"), Words::tr("Oil over a dry ground")},
        {"evening", Words::tr("Evening by a river"), Words::tr("Oil, from ground to glaze")},
    };
    std::vector<ExamplePainting> examples;
    for (const auto& [file, name, detail] : all) {
        try {
            const std::string base = std::string("strokes/") + file;
            examples.push_back(
                {name, detail, core::resource_path(base + ".json"), core::resource_path(base + ".png")});
        } catch (const core::InputError&) {
            continue;  // a program without its examples paints all the same
        }
    }
    return examples;
}

}  // namespace pastoso::start
