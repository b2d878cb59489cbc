#include "dialogs/support_choices.hpp"

#include <algorithm>

#include <QCoreApplication>

namespace pastoso::dialogs {
namespace {

/// Makes tr() find these words.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(CanvasChoices)
};

}  // namespace

std::vector<Support> supports() {
    return {
        {"medium linen", Words::tr("Medium linen"), Words::tr("lively weave with slubs")},
        {"fine portrait linen", Words::tr("Fine portrait linen"), Words::tr("fine weave")},
        {"rough jute", Words::tr("Rough jute"), Words::tr("coarse weave")},
        {"cotton duck", Words::tr("Cotton duck"), Words::tr("fine even weave")},
        {"gesso panel", Words::tr("Gesso panel"), Words::tr("brushed gesso")},
        {"panel", Words::tr("Panel"), Words::tr("smooth gesso")},
    };
}

QString support_words(const std::string& support) {
    if (support == "linen") return Words::tr("Linen").toLower();
    const auto all = supports();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Support& known) { return known.id == support; });
    return found != all.end() ? found->name.toLower() : Words::tr("an image");
}

}  // namespace pastoso::dialogs
