#include "main/program/folder_facts.hpp"

#include "core/resources.hpp"
#include "core/user_data.hpp"
#include "journal/journal_folder.hpp"

#include <QCoreApplication>

namespace pastoso::main {
namespace {

/// Makes tr() find these words.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(FolderFacts)
};

}  // namespace

Facts folder_facts() {
    Facts facts;
    const auto add = [&facts](const QString& what, const std::filesystem::path& path) {
        facts.emplace_back(what,
                           path.empty() ? Words::tr("none") : QString::fromStdString(path.string()));
    };
    add(Words::tr("Settings"), core::user_config_path(""));
    add(Words::tr("Your tools, paints and lamps"), core::user_data_path(""));
    add(Words::tr("Paintings that are not saved"), journal::journals_path());
    add(Words::tr("What the program brings along"), core::resource_path("media.json").parent_path());
    return facts;
}

}  // namespace pastoso::main
