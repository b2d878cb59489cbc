#include "panels/pen/laid_guide_part.hpp"

#include "panels/parts/labels.hpp"
#include "panels/parts/section.hpp"
#include "panels/parts/value_row.hpp"
#include "panels/pen/guide_boxes.hpp"
#include "panels/pen/guide_numbers.hpp"

#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

using tools::GuideKind;

constexpr double kPercent = 100.0;

}  // namespace

LaidGuidePart::LaidGuidePart(QWidget* parent) : QWidget(parent) {
    auto* column = section(this, tr("Guide"));
    form_ = form_in(column);
    add_kinds(form_);
    for (const GuideNumber& number : guide_numbers()) {
        const bool mm = number.unit == GuideUnit::Millimetres;
        QDoubleSpinBox* box =
            add_number(form_, QString::fromLatin1(number.name), translated(number.words), number.least,
                       number.most, mm ? tr(" mm") : QStringLiteral("\u00b0"));
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, &number](double value) {
            brush::PenGuide guide = shown_;
            number.set(guide, value);
            Q_EMIT guide_chosen(guide);
        });
        numbers_.push_back(box);
    }
    auto* rows = new QGridLayout;
    column->addLayout(rows);
    strength_ = new ValueRow(rows, QStringLiteral("guide_strength"), tr("Snapping strength"),
                             tr("How far the guide draws the brush from where your hand is: 0 not at "
                                "all, 100 all the way"),
                             {0.0, kPercent, 0, tr(" %")});
    connect(strength_, &ValueRow::chosen, this, [this](double value) {
        brush::PenGuide guide = shown_;
        guide.strength = value / kPercent;
        Q_EMIT guide_chosen(guide);
    });
    show_guide({});
}

void LaidGuidePart::add_kinds(QFormLayout* form) {
    kind_ = new QComboBox;
    kind_->setObjectName(QStringLiteral("guide_kind"));
    kind_->setAccessibleName(tr("What guides your strokes"));
    kind_->setToolTip(kind_->accessibleName());
    const auto add = [this](GuideKind kind, const QString& words) {
        kind_->addItem(words, static_cast<int>(kind));
    };
    add(GuideKind::None, tr("none"));
    add(GuideKind::Ruler, tr("Ruler"));
    add(GuideKind::ParallelRuler, tr("Parallel ruler"));
    add(GuideKind::Ellipse, tr("Ellipse"));
    add(GuideKind::ConcentricEllipse, tr("Concentric ellipse"));
    add(GuideKind::OnePoint, tr("1 point perspective"));
    add(GuideKind::TwoPoints, tr("2 point perspective"));
    add(GuideKind::ThreePoints, tr("3 point perspective"));
    add(GuideKind::Grid, tr("Grid"));
    let_shrink(kind_);
    keep_keys_for_canvas(kind_);
    form->addRow(tr("Lies on the canvas"), kind_);
    connect(kind_, &QComboBox::activated, this,
            [this] { Q_EMIT kind_chosen(static_cast<GuideKind>(kind_->currentData().toInt())); });
}

void LaidGuidePart::show_guide(const brush::PenGuide& guide) {
    shown_ = guide;
    const GuideKind kind = tools::kind_of(guide);
    const QSignalBlocker silent(kind_);
    kind_->setCurrentIndex(kind_->findData(static_cast<int>(kind)));
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        const GuideNumber& number = guide_numbers()[i];
        const bool has = std::count(number.kinds.begin(), number.kinds.end(), kind) > 0;
        form_->setRowVisible(numbers_[i], has);
        if (!has) continue;
        const double value = number.get(guide);
        show_number(numbers_[i],
                    number.unit == GuideUnit::Degrees ? std::remainder(value, 360.0) : value);
    }
    strength_->show_value(kPercent * guide.strength);
}

}  // namespace pastoso::panels
