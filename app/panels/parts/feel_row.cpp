#include "panels/parts/feel_row.hpp"

#include "panels/parts/section.hpp"
#include "panels/parts/slider_scale.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

namespace pastoso::panels {
namespace {

constexpr SliderScale kPlaces{};

}  // namespace

FeelRow::FeelRow(QGridLayout* grid, const QString& name, const QString& from, const QString& to,
                 const QString& hint)
    : QObject(grid->parentWidget()), slider_(new QSlider(Qt::Horizontal)) {
    slider_->setObjectName(name);
    slider_->setRange(0, SliderScale::kSteps);
    slider_->setPageStep(SliderScale::kSteps / 10);
    slider_->setToolTip(hint);
    slider_->setAccessibleName(tr("From %1 to %2").arg(from, to));
    keep_keys_for_canvas(slider_);
    keep_own_keys(slider_, {Qt::Key_PageUp, Qt::Key_PageDown});
    const int row = grid->rowCount();
    const auto add_word = [&](const QString& word, int column, Qt::Alignment side) {
        auto* label = new QLabel(word);
        label->setObjectName(QStringLiteral("reading"));
        label->setToolTip(hint);
        grid->addWidget(label, row, column, side);
    };
    add_word(from, 0, Qt::AlignRight);
    grid->addWidget(slider_, row, 1);
    add_word(to, 2, Qt::AlignLeft);
    grid->setColumnStretch(1, 1);
    connect(slider_, &QSlider::valueChanged, this,
            [this](int step) { Q_EMIT chosen(kPlaces.value_at(step)); });
}

void FeelRow::show_place(double place) {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(kPlaces.step_of(place));
}

}  // namespace pastoso::panels
