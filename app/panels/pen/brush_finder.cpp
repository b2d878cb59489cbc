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

constexpr int kNameRole = Qt::UserRole + 1;

/// Those of that name that can be taken, in the order of the names and under no heading.
std::vector<BrushEntry> named(const std::vector<std::string>& names,
                              const std::vector<BrushEntry>& entries) {
    std::vector<BrushEntry> found;
    for (const std::string& name : names)
        for (const BrushEntry& entry : entries) {
            if (entry.name.toStdString() != name || !entry.fault.isEmpty()) continue;
            found.push_back(entry);
            found.back().family.clear();
        }
    return found;
}

/// Within each family; those that the order leaves out follow as they come.
void put_in_order(std::vector<BrushEntry>& entries, const std::vector<std::string>& order) {
    const auto rank = [&order](const BrushEntry& entry) {
        return std::ranges::find(order, entry.name.toStdString()) - order.begin();
    };
    for (auto first = entries.begin(); first != entries.end();) {
        const auto last = std::find_if(first, entries.end(), [first](const BrushEntry& entry) {
            return entry.family != first->family;
        });
        std::ranges::stable_sort(first, last, {}, rank);
        first = last;
    }
}

/// Null where what is chosen has no order of its own.
const std::vector<std::string>* names_of(const BrushChoice& choice, const tools::BrushShelf& shelf) {
    if (!choice.typed.trimmed().isEmpty()) return nullptr;
    if (choice.kind == Kind::Recent) return &shelf.recent;
    if (choice.kind == Kind::Favourites) return &shelf.favourites;
    const tools::BrushTag* tag = tools::find_tag(choice.name.toStdString(), shelf);
    return choice.kind == Kind::Tag && tag != nullptr ? &tag->tools : nullptr;
}

bool is_chosen(const BrushEntry& entry, const BrushChoice& choice) {
    if (!choice.typed.trimmed().isEmpty())
        return commands::fit_of_name(choice.typed, shown_name(entry), entry.family) > 0;
    switch (choice.kind) {
        case Kind::Own:
            return entry.own;
        case Kind::Family:
            return entry.family == choice.name;
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
    if (const auto* names = names_of(choice, shelf)) return named(*names, marked);
    std::erase_if(marked, [&](const BrushEntry& entry) { return !is_chosen(entry, choice); });
    put_in_order(marked, shelf.order);
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
    show_folders({}, {});
    connect(folder_, &QComboBox::activated, this, [this] {
        const QSignalBlocker quiet(typed_);
        typed_->clear();
        Q_EMIT changed();
    });
    connect(typed_, &QLineEdit::textChanged, this, &BrushFinder::changed);
    connect(typed_, &QLineEdit::returnPressed, this, &BrushFinder::first_wanted);
}

void BrushFinder::add_folder(const QString& words, Kind kind, const QString& name) {
    folder_->addItem(words, static_cast<int>(kind));
    folder_->setItemData(folder_->count() - 1, name, kNameRole);
}

void BrushFinder::show_folders(const std::vector<BrushEntry>& entries,
                               const std::vector<tools::BrushTag>& tags) {
    const QSignalBlocker quiet(folder_);
    const BrushChoice before = choice();
    folder_->clear();
    add_folder(tr("All"), Kind::All);
    add_folder(tr("Favourites"), Kind::Favourites);
    add_folder(tr("Recent"), Kind::Recent);
    add_folder(tr("My own"), Kind::Own);
    if (!tags.empty()) folder_->insertSeparator(folder_->count());
    for (const tools::BrushTag& tag : tags)
        add_folder(QString::fromStdString(tag.name), Kind::Tag, QString::fromStdString(tag.name));
    folder_->insertSeparator(folder_->count());
    QString family;
    for (const BrushEntry& entry : entries) {
        if (entry.family != family) add_folder(entry.family, Kind::Family, entry.family);
        family = entry.family;
    }
    for (int row = folder_->count() - 1; row >= 0; --row)
        if (folder_->itemData(row).toInt() == static_cast<int>(before.kind) &&
            folder_->itemData(row, kNameRole).toString() == before.name)
            folder_->setCurrentIndex(row);
}

QString BrushFinder::words_of_none() const {
    const BrushChoice chosen = choice();
    if (!chosen.typed.trimmed().isEmpty()) return tr("No tool has such a name.");
    switch (chosen.kind) {
        case Kind::Favourites:
            return tr("Tools that you mark with a star are listed here.");
        case Kind::Recent:
            return tr("Tools that you have taken are listed here, the latest first.");
        case Kind::Own:
            return tr("Tools that you save as your own are listed here.");
        default:
            return {};
    }
}

BrushChoice BrushFinder::choice() const {
    return {static_cast<Kind>(folder_->currentData().toInt()),
            folder_->currentData(kNameRole).toString(), typed_->text()};
}

}  // namespace pastoso::panels
