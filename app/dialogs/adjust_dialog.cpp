#include "dialogs/adjust_dialog.hpp"

#include "appearance/screen_colours.hpp"
#include "document/actions/adjust_actions.hpp"

#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPixmap>
#include <QPushButton>

namespace pastoso::dialogs {
namespace {

using Way = ChosenAdjustment::Way;

constexpr double kMicrometres = 1000.0;  ///< in a millimetre
constexpr double kPercent = 100.0;
constexpr QSize kSwatch_px(130, 48);
constexpr int kWords_px = 340;

QLabel* wrapped(const QString& words) {
    auto* label = new QLabel(words);
    label->setWordWrap(true);
    label->setMinimumWidth(kWords_px);
    return label;
}

QLabel* add_swatch(const QString& name, const QString& words, QHBoxLayout* row) {
    auto* swatch = new QLabel;
    swatch->setObjectName(name);
    swatch->setAccessibleName(words);
    swatch->setToolTip(words);
    swatch->setFixedSize(kSwatch_px);
    row->addWidget(swatch);
    return swatch;
}

void show_colour(const pigment::Srgb8& rgb, QLabel* swatch) {
    QPixmap patch(kSwatch_px);
    patch.fill(appearance::shown(QColor(rgb[0], rgb[1], rgb[2])));
    swatch->setPixmap(patch);
}

}  // namespace

layers::Adjustment adjustment_of(const ChosenAdjustment& chosen) {
    if (chosen.way == Way::Glaze) return chosen.glaze;
    return chosen.exchange;
}

AdjustDialog::AdjustDialog(const ChosenAdjustment& proposal, bool previews, Foretell foretell,
                           QWidget* parent)
    : GrowingDialog(parent),
      chosen_(proposal),
      foretell_(std::move(foretell)),
      form_(new QFormLayout(this)),
      ways_(new QComboBox),
      meaning_(wrapped({})),
      problem_(wrapped(tr("The medium in hand leaves next to nothing when it dries."))),
      previews_(new QCheckBox(tr("&Preview"))),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
    setWindowTitle(tr("Adjust dry paint"));
    form_->setContentsMargins(18, 18, 18, 14);
    form_->setSpacing(9);
    form_->addRow(
        wrapped(tr("The dry paint of the layer that you paint on takes another colour, where "
                   "it is selected or all over. Wet paint stays as it is.")));
    ways_->setObjectName(QStringLiteral("way"));
    ways_->addItems({tr("As a glaze"), tr("As other pigments")});
    ways_->setCurrentIndex(static_cast<int>(proposal.way));
    form_->addRow(tr("Adjust"), ways_);
    meaning_->setObjectName(QStringLiteral("meaning"));
    form_->addRow(meaning_);
    thickness_ =
        add_number(QStringLiteral("thickness_um"), tr("Thickness"), tr(" µm"),
                   kMicrometres * document::kLeastGlaze_mm, kMicrometres * layers::kMostGlaze_mm,
                   kMicrometres * proposal.glaze.thickness_mm);
    share_ = add_number(QStringLiteral("share"), tr("Share"), tr(" %"), 0.0, kPercent,
                        kPercent * proposal.exchange.share);
    add_swatches();
    problem_->setObjectName(QStringLiteral("problem"));
    form_->addRow(problem_);
    previews_->setObjectName(QStringLiteral("preview"));
    previews_->setToolTip(tr("Show on the canvas what comes of it"));
    previews_->setChecked(previews);
    form_->addRow(previews_);
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("Adjust"));
    form_->addRow(buttons_);
    connect(ways_, &QComboBox::currentIndexChanged, this, [this] {
        read();
        show_way();
    });
    connect(previews_, &QCheckBox::toggled, this, &AdjustDialog::changed);
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    show_way();
    show_outcome();
}

QDoubleSpinBox* AdjustDialog::add_number(const QString& name, const QString& words, const QString& unit,
                                         double least, double most, double value) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setDecimals(0);
    box->setRange(least, most);
    box->setSuffix(unit);
    box->setValue(value);
    connect(box, &QDoubleSpinBox::valueChanged, this, &AdjustDialog::read);
    form_->addRow(words, box);
    return box;
}

void AdjustDialog::add_swatches() {
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    before_ = add_swatch(QStringLiteral("before"), tr("The mean colour as it is"), row);
    after_ = add_swatch(QStringLiteral("after"), tr("The mean colour after it is adjusted"), row);
    row->addStretch();
    form_->addRow(tr("Before, after"), row);
}

void AdjustDialog::read() {
    chosen_.way = static_cast<Way>(ways_->currentIndex());
    chosen_.glaze.thickness_mm = thickness_->value() / kMicrometres;
    chosen_.exchange.share = share_->value() / kPercent;
    show_outcome();
}

void AdjustDialog::show_way() {
    const bool glaze = chosen_.way == Way::Glaze;
    form_->setRowVisible(thickness_, glaze);
    form_->setRowVisible(share_, !glaze);
    meaning_->setText(
        glaze ? tr("A thin even coat of the paint in hand dries over it, and what lies below shows "
                   "through. It is as thick as this when it is dry.")
              : tr("So much of the dry paint is taken out and replaced by the paint in hand, which is "
                   "stirred in. It stays as thick as it is."));
}

bool AdjustDialog::previews() const {
    return previews_->isChecked();
}

void AdjustDialog::show_outcome() {
    const auto colours = foretell_(adjustment_of(chosen_));
    problem_->setVisible(!colours);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(colours.has_value());
    if (colours) {
        show_colour(colours->before, before_);
        show_colour(colours->after, after_);
    }
    Q_EMIT changed();
}

}  // namespace pastoso::dialogs
