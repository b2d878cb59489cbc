#include "panels/paint/medium_box.hpp"

#include "appearance/screen_colours.hpp"
#include "appearance/shown_names.hpp"
#include "film/media_families.hpp"
#include "panels/parts/section.hpp"

#include <algorithm>

#include <QAbstractItemView>
#include <QHelpEvent>
#include <QPainter>
#include <QStandardItemModel>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QStyledItemDelegate>
#include <QToolTip>

namespace pastoso::panels {
namespace {

constexpr int kNameRole = Qt::UserRole, kSentenceRole = kNameRole + 1, kSwatchRole = kNameRole + 2;
constexpr int kGap = 6, kListWidth = 430;

bool is_heading(const QModelIndex& index) {
    return !(index.flags() & Qt::ItemIsEnabled);
}

/// The swatch on the left; the name, and below it the sentence in two lines.
class MediumDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const int line = option.fontMetrics.height();
        if (is_heading(index)) return {0, line + kGap};
        return {0, std::max(kMediumSwatch.height(), 3 * line) + kGap};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const QRect row = option.rect.adjusted(kGap, 0, -kGap, 0);
        const bool chosen = option.state & QStyle::State_Selected;
        const auto pen = [&](QPalette::ColorRole role, QPalette::ColorGroup group) {
            painter->setPen(option.palette.color(group, chosen ? QPalette::HighlightedText : role));
        };
        painter->save();
        QFont bold = option.font;
        bold.setBold(true);
        painter->setFont(bold);
        if (is_heading(index)) {
            pen(QPalette::Text, QPalette::Disabled);
            painter->drawText(row, Qt::AlignVCenter, index.data().toString());
            return painter->restore();
        }
        if (chosen) painter->fillRect(option.rect, option.palette.highlight());
        QRect swatch(QPoint(row.left(), 0), kMediumSwatch);
        swatch.moveTop(row.center().y() - swatch.height() / 2);
        painter->drawImage(swatch, appearance::shown(index.data(kSwatchRole).value<QImage>()));
        const QRect text = row.adjusted(kMediumSwatch.width() + kGap, 2, 0, -2);
        pen(QPalette::Text, QPalette::Active);
        painter->drawText(text, Qt::AlignTop | Qt::AlignLeft, index.data().toString());
        painter->setFont(option.font);
        painter->drawText(text.adjusted(0, option.fontMetrics.height(), 0, 0), Qt::TextWordWrap,
                          index.data(kSentenceRole).toString());
        painter->restore();
    }
};

}  // namespace

MediumBox::MediumBox(QWidget* parent) : QComboBox(parent) {
    keep_keys_for_canvas(this);
    setItemDelegate(new MediumDelegate(this));
    view()->setMinimumWidth(kListWidth);
    for (const film::MediaFamily& family : film::bundled_media_families()) {
        add_heading(appearance::shown_name(family.name));
        for (const film::Medium& medium : family.media) {
            addItem(appearance::shown_title(medium.name), QString::fromStdString(medium.name));
            const QString sentence = appearance::shown_name(medium.description);
            setItemData(count() - 1, sentence, kSentenceRole);
            setItemData(count() - 1, sentence, Qt::AccessibleDescriptionRole);
        }
    }
    setMaxVisibleItems(count());
    connect(this, &QComboBox::activated, this,
            [this] { Q_EMIT medium_chosen(currentData().toString()); });
}

void MediumBox::add_heading(const QString& family) {
    addItem(family);
    static_cast<QStandardItemModel*>(model())->item(count() - 1)->setFlags(Qt::NoItemFlags);
}

void MediumBox::show_medium(const QString& name) {
    setCurrentIndex(findData(name));
}

QStringList MediumBox::media() const {
    QStringList names;
    for (int item = 0; item < count(); ++item)
        if (itemData(item).isValid()) names += itemData(item).toString();
    return names;
}

QString MediumBox::shown_medium(const QString& name) const {
    return itemText(findData(name));
}

QString MediumBox::sentence(const QString& name) const {
    return itemData(findData(name), kSentenceRole).toString();
}

void MediumBox::choose(const QString& name) {
    show_medium(name);
    Q_EMIT medium_chosen(name);
}

QImage MediumBox::swatch(const QString& name) const {
    return itemData(findData(name), kSwatchRole).value<QImage>();
}

void MediumBox::set_swatch(const QString& name, const QImage& image) {
    setItemData(findData(name), image, kSwatchRole);
    view()->viewport()->update();
}

void MediumBox::showPopup() {
    Q_EMIT swatches_wanted();
    QComboBox::showPopup();
}

bool MediumBox::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QComboBox::event(event);
    const QPoint at = static_cast<const QHelpEvent*>(event)->globalPos();
    QToolTip::showText(at, currentText() + QLatin1Char('\n') + toolTip(), this);
    return true;
}

void MediumBox::paintEvent(QPaintEvent*) {
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    const QRect field =
        style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    option.currentText = fontMetrics().elidedText(option.currentText, Qt::ElideRight, field.width() - 2);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

}  // namespace pastoso::panels
