#include "panels/colour/mixes_part.hpp"

#include "appearance/screen_colours.hpp"
#include "panels/paint/paint_words.hpp"
#include "panels/paint/swatch_colours.hpp"
#include "panels/parts/choice_list.hpp"
#include "panels/parts/labels.hpp"
#include "panels/parts/section.hpp"

#include <algorithm>

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr QSize kIcon(28, 18);
constexpr int kMostRowsSeen = 6;

QPushButton* push_button(const char* name, const QString& words, const QString& hint) {
    auto* button = new QPushButton(words);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(hint);
    keep_keys_for_canvas(button);
    return button;
}

QIcon icon_of(const QColor& colour, double pixel_ratio) {
    QPixmap pixmap(kIcon * pixel_ratio);
    pixmap.setDevicePixelRatio(pixel_ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QColor(0, 0, 0, 140));
    painter.setBrush(appearance::shown(colour));
    painter.drawRoundedRect(QRectF(QPointF(0.5, 0.5), kIcon - QSize(1, 1)), 3.0, 3.0);
    painter.end();
    // The same paint when selected: a highlight must not change what it looks like.
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

}  // namespace

MixesPart::MixesPart(QWidget* parent) : QWidget(parent), list_(new ChoiceList) {
    list_->setObjectName(QStringLiteral("mixes"));
    list_->setAccessibleName(tr("Your mixes"));
    list_->setIconSize(kIcon);
    list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    list_->setContextMenuPolicy(Qt::ActionsContextMenu);
    auto* rename = new QAction(tr("Rename"), list_);
    auto* remove = new QAction(tr("Remove"), list_);
    list_->addActions({rename, remove});
    QPushButton* keep =
        push_button("keep_mix", tr("Keep as a mix"),
                    tr("Keep the paint in hand as a recipe of tubes, under a name of your own"));
    remove_ = push_button("remove_mix", tr("Remove"), tr("Take the chosen mix away"));
    export_ = push_button("export_paints", tr("Export..."),
                          tr("Save your mixes and your palette as a file for others"));
    QPushButton* import = push_button("import_paints", tr("Import..."),
                                      tr("Add the mixes and the palette of such a file"));
    auto* column = section(this, tr("Your mixes"));
    column->addWidget(list_);
    none_ = note(tr("Paints that you keep are listed here, under names of your own."));
    column->addWidget(none_);
    const std::vector<std::vector<QPushButton*>> rows = {{keep, remove_}, {export_, import}};
    for (const auto& buttons : rows) {
        auto* row = new QHBoxLayout;
        for (QPushButton* button : buttons)
            row->addWidget(button, 1);
        column->addLayout(row);
    }
    connect(list_, &ChoiceList::taken, this,
            [this](const QListWidgetItem* item) { Q_EMIT taken(list_->row(item)); });
    connect(list_, &QListWidget::itemChanged, this,
            [this](const QListWidgetItem* item) { Q_EMIT renamed(list_->row(item), item->text()); });
    connect(rename, &QAction::triggered, this, [this] { ask_name(list_->currentRow()); });
    connect(remove, &QAction::triggered, this, &MixesPart::remove_current);
    connect(remove_, &QPushButton::clicked, this, &MixesPart::remove_current);
    connect(list_, &ChoiceList::removal_wanted, this, &MixesPart::remove_current);
    connect(keep, &QPushButton::clicked, this, &MixesPart::keep_wanted);
    connect(export_, &QPushButton::clicked, this, &MixesPart::export_wanted);
    connect(import, &QPushButton::clicked, this, &MixesPart::import_wanted);
}

void MixesPart::show_mixes(const std::vector<tools::NamedPaint>& mixes, const tools::SwatchView& view) {
    const QSignalBlocker quiet(list_);
    while (list_->count() > static_cast<int>(mixes.size()))
        delete list_->takeItem(list_->count() - 1);
    while (list_->count() < static_cast<int>(mixes.size())) {
        auto* item = new QListWidgetItem(list_);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    for (int row = 0; row < list_->count(); ++row) {
        const tools::NamedPaint& mix = mixes[static_cast<std::size_t>(row)];
        QListWidgetItem* item = list_->item(row);
        item->setText(QString::fromStdString(mix.name));
        item->setToolTip(recipe_lines(mix.paint));
        item->setIcon(icon_of(shown_colour(mix.paint, view), devicePixelRatioF()));
    }
    list_->setVisible(!mixes.empty());
    none_->setVisible(mixes.empty());
    remove_->setEnabled(!mixes.empty());
    fit_to_rows(list_, std::min(kMostRowsSeen, list_->count()));
}

void MixesPart::allow_export(bool allowed) {
    export_->setEnabled(allowed);
}

void MixesPart::ask_name(int index) {
    QListWidgetItem* item = list_->item(index);
    if (item == nullptr) return;
    list_->setCurrentItem(item);
    list_->scrollToItem(item);
    list_->editItem(item);
}

void MixesPart::remove_current() {
    if (list_->currentRow() >= 0) Q_EMIT removal_wanted(list_->currentRow());
}

}  // namespace pastoso::panels
