#include "panels/pen/brush_list.hpp"

#include "appearance/screen_colours.hpp"
#include "appearance/shown_names.hpp"
#include "panels/parts/section.hpp"

#include <QKeyEvent>
#include <QPixmap>

namespace pastoso::panels {
namespace {

constexpr int kEntryRole = Qt::UserRole, kNameRole = kEntryRole + 1, kThumbnailRole = kEntryRole + 2,
              kFaultyRole = kEntryRole + 3;
constexpr int kNoEntry = -1;

/// Neither a heading nor a file that cannot be read.
bool is_tool(const QListWidgetItem& item) {
    return item.data(kEntryRole).toInt() != kNoEntry && !item.data(kFaultyRole).toBool();
}

int entry_of(const QListWidgetItem* item) {
    return item == nullptr ? kNoEntry : item->data(kEntryRole).toInt();
}

}  // namespace

QString shown_name(const BrushEntry& entry) {
    return entry.own ? entry.name : appearance::shown_name(entry.name);
}

BrushList::BrushList(QWidget* parent) : ChoiceList(parent) {
    setIconSize(kThumbnailSize);
    let_arrange();
    setContextMenuPolicy(Qt::CustomContextMenu);
    connect(this, &ChoiceList::taken, this, [this](const QListWidgetItem* item) {
        if (entry_of(item) != kNoEntry) Q_EMIT entry_clicked(entry_of(item));
    });
    connect(&appearance::screen_colours(), &appearance::ScreenColours::changed, this, [this] {
        for (QListWidgetItem* item : items_)
            draw_thumbnail(*item);
    });
}

void BrushList::show_entries(const std::vector<BrushEntry>& entries) {
    clear();
    items_.clear();
    asked_.assign(entries.size(), false);
    QString family;
    for (const BrushEntry& entry : entries) {
        if (entry.family != family) add_heading(family = entry.family);
        add_entry(entry);
        asked_[items_.size() - 1] = !entry.fault.isEmpty();
    }
}

void BrushList::show_none(const QString& words) {
    show_entries({});
    if (!words.isEmpty()) add_heading(words);
}

void BrushList::add_entry(const BrushEntry& entry) {
    const QString shown = shown_name(entry);
    auto* item = new QListWidgetItem(entry.favourite ? shown + QStringLiteral(" \u2605") : shown, this);
    item->setData(kEntryRole, static_cast<int>(items_.size()));
    item->setData(kNameRole, entry.name);
    item->setFlags(item->flags() & ~Qt::ItemIsDropEnabled);  // tools are dropped between others
    item->setToolTip(!entry.fault.isEmpty() ? entry.fault
                     : entry.own            ? tr("%1, your own").arg(shown)
                                            : shown);
    QFont font = item->font();
    font.setItalic(entry.own);
    item->setFont(font);
    if (entry.fault.isEmpty()) {
        QPixmap empty(kThumbnailSize);
        empty.fill(Qt::transparent);
        item->setIcon(QIcon(empty));
    } else {
        item->setForeground(palette().brush(QPalette::Disabled, QPalette::Text));
        item->setData(kFaultyRole, true);
    }
    items_.push_back(item);
}

void BrushList::add_heading(const QString& words) {
    auto* heading = new QListWidgetItem(words, this);
    heading->setData(kEntryRole, kNoEntry);
    heading->setFlags(Qt::NoItemFlags);
}

void BrushList::show_entry(int entry) {
    if (entry < 0 || entry >= static_cast<int>(items_.size())) return setCurrentItem(nullptr);
    setCurrentItem(items_[static_cast<std::size_t>(entry)]);
    scrollToItem(currentItem());
}

int BrushList::current_entry() const {
    return entry_of(currentItem());
}

QString BrushList::name_at(const QPoint& place) const {
    const QListWidgetItem* item = itemAt(place);
    if (item == nullptr) item = currentItem();
    return item != nullptr && is_tool(*item) ? item->data(kNameRole).toString() : QString();
}

QStringList BrushList::names() const {
    QStringList names;
    for (int row = 0; row < count(); ++row)
        if (is_tool(*item(row))) names += item(row)->data(kNameRole).toString();
    return names;
}

void BrushList::set_thumbnail(const QString& name, const QImage& image) {
    for (QListWidgetItem* item : items_) {
        if (item->data(kNameRole) != name) continue;
        item->setData(kThumbnailRole, image);
        draw_thumbnail(*item);
    }
}

void BrushList::draw_thumbnail(QListWidgetItem& item) {
    const auto image = item.data(kThumbnailRole).value<QImage>();
    if (!image.isNull()) item.setIcon(QIcon(QPixmap::fromImage(appearance::shown(image))));
}

void BrushList::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_F2 && current_entry() != kNoEntry) return void(Q_EMIT rename_wanted());
    ChoiceList::keyPressEvent(event);
}

void BrushList::showEvent(QShowEvent* event) {
    ChoiceList::showEvent(event);
    scroll_to_current();
}

void BrushList::resizeEvent(QResizeEvent* event) {
    ChoiceList::resizeEvent(event);
    scroll_to_current();
}

/// A row that is painted is seen; while the window is still being laid out, none is.
void BrushList::paintEvent(QPaintEvent* event) {
    ChoiceList::paintEvent(event);
    ask_for_thumbnails();
}

/// Rows that were measured before the style was known are measured again first.
void BrushList::scroll_to_current() {
    doItemsLayout();
    scrollToItem(currentItem());
}

void BrushList::ask_for_thumbnails() {
    for (std::size_t entry = 0; entry < items_.size(); ++entry) {
        if (asked_[entry] || !viewport()->rect().intersects(visualItemRect(items_[entry]))) continue;
        asked_[entry] = true;
        Q_EMIT thumbnail_wanted(static_cast<int>(entry));
    }
}

}  // namespace pastoso::panels
