#include "panels/pen/brush_finder.hpp"

#include "commands/command_search.hpp"
#include "panels/parts/section.hpp"

#include <algorithm>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>

namespace pastoso::panels {
namespace {

using Kind = BrushChoice::Kind;

constexpr int kFamilyRole = Qt::UserRole + 1;

/// In their order: the latest first.
std::vector<BrushEntry> recent_of(const std::vector<BrushEntry>& entries,
                                  const tools::BrushShelf& shelf) {
    std::vector<BrushEntry> recent;
    for (const std::string& name : shelf.recent)
        for (const BrushEntry& entry : entries) {
            if (entry.name.toStdString() != name || !entry.fault.isEmpty()) continue;
            recent.push_back(entry);
            recent.back().family.clear();
        }
    return recent;
}

bool is_chosen(const BrushEntry& entry, const BrushChoice& choice) {
    if (!choice.typed.trimmed().isEmpty())
        return commands::fit_of_name(choice.typed, shown_name(entry), entry.family) > 0;
    switch (choice.kind) {
        case Kind::Favourites:
            return entry.favourite;
        case Kind::Own:
            return entry.own;
        case Kind::Family:
            return entry.family == choice.family;
        default:
            return true;
    }
}

}  // namespace

std::vector<BrushEntry> chosen_brushes(const std::vector<BrushEntry>& entries,
                                       const tools::BrushShelf& shelf, const BrushChoice& choice) {
    std::vector<BrushEntry> marked = entries;
    for (BrushEntry& entry : marked)
        entry.favourite = tools::is_favourite(entry.name.toStdString(), shelf);
    if (choice.kind == Kind::Recent && choice.typed.trimmed().isEmpty()) return recent_of(marked, shelf);
    std::erase_if(marked, [&](const BrushEntry& entry) { return !is_chosen(entry, choice); });
    return marked;
}

BrushFinder::BrushFinder(QWidget* parent)
    : QWidget(parent), folder_(new QComboBox), typed_(new QLineEdit) {
    folder_->setObjectName(QStringLiteral("brush_folder"));
    folder_->setAccessibleName(tr("Which tools are listed"));
    folder_->setToolTip(folder_->accessibleName());
    let_shrink(folder_);
    keep_keys_for_canvas(folder_);
    typed_->setObjectName(QStringLiteral("brush_search"));
    typed_->setPlaceholderText(tr("Find a tool"));
    typed_->setToolTip(tr("A few letters of its name or of its family; Return takes the first"));
    typed_->setAccessibleName(typed_->placeholderText());
    typed_->setClearButtonEnabled(true);
    typed_->setFocusPolicy(Qt::StrongFocus);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(folder_, 1);
    row->addWidget(typed_, 1);
    show_families({});
    connect(folder_, &QComboBox::activated, this, [this] {
        const QSignalBlocker quiet(typed_);
        typed_->clear();
        Q_EMIT changed();
    });
    connect(typed_, &QLineEdit::textChanged, this, &BrushFinder::changed);
    connect(typed_, &QLineEdit::returnPressed, this, &BrushFinder::first_wanted);
}

void BrushFinder::show_families(const std::vector<BrushEntry>& entries) {
    const QSignalBlocker quiet(folder_);
    const QString before = folder_->currentText();
    folder_->clear();
    const auto add = [&](const QString& words, Kind kind) {
        folder_->addItem(words, static_cast<int>(kind));
    };
    add(tr("All"), Kind::All);
    add(tr("Favourites"), Kind::Favourites);
    add(tr("Recent"), Kind::Recent);
    add(tr("My own"), Kind::Own);
    folder_->insertSeparator(folder_->count());
    for (const BrushEntry& entry : entries) {
        if (folder_->findData(entry.family, kFamilyRole) >= 0) continue;
        add(entry.family, Kind::Family);
        folder_->setItemData(folder_->count() - 1, entry.family, kFamilyRole);
    }
    folder_->setCurrentIndex(before.isEmpty() ? 0 : std::max(0, folder_->findText(before)));
}

BrushChoice BrushFinder::choice() const {
    return {static_cast<Kind>(folder_->currentData().toInt()),
            folder_->currentData(kFamilyRole).toString(), typed_->text()};
}

}  // namespace pastoso::panels
