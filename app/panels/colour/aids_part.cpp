#include "panels/colour/aids_part.hpp"

#include "appearance/terms.hpp"
#include "panels/parts/section.hpp"

#include <cmath>

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr int kTurnStep_deg = 15;

/// Its entries stand in the order of an enumeration.
QComboBox* choices(const char* name, const QString& words, const QStringList& entries) {
    auto* box = new QComboBox;
    box->setObjectName(QLatin1String(name));
    box->setAccessibleName(words);
    box->addItems(entries);
    let_shrink(box);
    keep_keys_for_canvas(box);
    return box;
}

}  // namespace

AidsPart::AidsPart(QWidget* parent)
    : Fold(QStringLiteral("colour_aids"), tr("Harmony and gamut mask"),
           tr("Marks for hues that go together, and a shape on the wheel to choose within"), parent) {
    harmony_ = choices("harmony", tr("Harmony"),
                       {tr("None"), tr("Complementary"), tr("Split complementary"), tr("Analogous"),
                        tr("Triad"), tr("Tetrad")});
    harmony_->setToolTip(tr("The hues that go with yours are marked on the ring: a click takes one"));
    shape_ = choices("mask_shape", tr("Gamut mask"),
                     {tr("None"), tr("Triad"), tr("Atmospheric triad"), tr("Split complementary"),
                      tr("Complementary"), tr("Circle")});
    shape_->setToolTip(
        tr("The colours of one lightness on a disc, and a shape that the wheel keeps to"));
    turn_ = new QSpinBox;
    turn_->setObjectName(QStringLiteral("mask_turn"));
    turn_->setAccessibleName(tr("Turn of the gamut mask"));
    turn_->setToolTip(tr("Turns the gamut mask"));
    turn_->setRange(0, 359);
    turn_->setWrapping(true);
    turn_->setSingleStep(kTurnStep_deg);
    turn_->setSuffix(QStringLiteral("\u00b0"));
    turn_->setKeyboardTracking(false);
    auto* grid = new QGridLayout;
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    const auto add_words = [grid](int row, const QString& words, appearance::Term term) {
        auto* label = new QLabel(words);
        appearance::explain(label, term);
        grid->addWidget(label, row, 0);
    };
    add_words(0, tr("Harmony"), appearance::Term::Harmony);
    grid->addWidget(harmony_, 0, 1, 1, 2);
    add_words(1, tr("Gamut mask"), appearance::Term::GamutMask);
    grid->addWidget(shape_, 1, 1);
    grid->addWidget(turn_, 1, 2);
    column()->addLayout(grid);
    turn_->setEnabled(false);
    connect(harmony_, &QComboBox::activated, this, &AidsPart::take);
    connect(shape_, &QComboBox::activated, this, &AidsPart::take);
    connect(turn_, &QSpinBox::valueChanged, this, &AidsPart::take);
}

void AidsPart::take() {
    const auto shape = static_cast<tools::MaskShape>(shape_->currentIndex());
    if (shape != aids_.mask.shape) aids_.mask.corners.clear();
    aids_.harmony = static_cast<tools::Harmony>(harmony_->currentIndex());
    aids_.mask.shape = shape;
    aids_.mask.turn_deg = turn_->value();
    turn_->setEnabled(aids_.mask.shape != tools::MaskShape::None);
    Q_EMIT changed(aids_);
}

void AidsPart::show_aids(const tools::ColourAids& aids) {
    aids_ = aids;
    const QSignalBlocker quiet(turn_);
    harmony_->setCurrentIndex(static_cast<int>(aids.harmony));
    shape_->setCurrentIndex(static_cast<int>(aids.mask.shape));
    turn_->setValue(static_cast<int>(std::lround(aids.mask.turn_deg)));
    turn_->setEnabled(aids.mask.shape != tools::MaskShape::None);
    if (!(aids == tools::ColourAids{})) open(true);
}

}  // namespace pastoso::panels
