#include "panels/paint/medium_panel.hpp"

#include "appearance/shown_names.hpp"
#include "panels/paint/medium_box.hpp"
#include "panels/paint/medium_rows.hpp"
#include "panels/parts/feel_row.hpp"
#include "panels/parts/fold.hpp"
#include "panels/parts/labels.hpp"
#include "panels/parts/section.hpp"
#include "panels/parts/value_row.hpp"
#include "tools/medium_feel.hpp"
#include "tools/medium_numbers.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr int kRest_ms = 250;

/// A slider in painters' words.
struct FeelWords {
    tools::Feel feel;
    const char* name;  ///< of its widget
    const char* from;
    const char* to;
    const char* hint;
};

constexpr FeelWords kFeels[] = {
    {tools::Feel::StiffToRunny, "stiff_to_runny", QT_TR_NOOP("stiff"), QT_TR_NOOP("runny"),
     QT_TR_NOOP(
         "From paint that stands in peaks to paint that runs like ink: viscosity and yield stress")},
    {tools::Feel::ShortToLong, "short_to_long", QT_TR_NOOP("short"), QT_TR_NOOP("long"),
     QT_TR_NOOP(
         "From paint that breaks off sharply to paint that flows out at its edges and in long runs: "
         "the angle at which it spreads, the front and tail of drips, and the flow index")},
    {tools::Feel::OpaqueToTransparent, "opaque_to_transparent", QT_TR_NOOP("opaque"),
     QT_TR_NOOP("transparent"),
     QT_TR_NOOP("From paint that hides what lies below to a glaze: how much pigment is in it")}};

ValueRange shown_range(const MediumRow& number) {
    const film::MediumNumber& limits = tools::number_of(number.member);
    return {number.scale * limits.least, number.scale * limits.most, number.decimals,
            translated(number.unit), number.logarithmic};
}

}  // namespace

MediumPanel::MediumPanel(QWidget* parent)
    : QWidget(parent),
      media_(new MediumBox),
      description_(new QLabel),
      reset_(new QPushButton(tr("As it comes"))),
      fold_(new Fold(QStringLiteral("medium_numbers"), tr("Numbers"), tr("Each number of the paint"))) {
    setObjectName(QStringLiteral("medium_panel"));
    for (const MediumSection& section : medium_sections())
        fold_->column()->addWidget(numbers(section));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(medium_section());
    column->addWidget(feel_section());
    column->addWidget(fold_);
    column->addStretch();
    resting_.setSingleShot(true);
    resting_.setInterval(kRest_ms);
    connect(&resting_, &QTimer::timeout, this, [this] { Q_EMIT medium_changed(medium_); });
    show_medium(film::bundled_media().front());
}

QWidget* MediumPanel::medium_section() {
    auto* widget = new QWidget;
    auto* column = section(widget, tr("Kind of paint"));
    media_->setObjectName(QStringLiteral("kind_of_paint"));
    media_->setAccessibleName(tr("Kind of paint"));
    media_->setToolTip(tr("The brush is cleaned, and dipped in paint of this kind"));
    description_->setObjectName(QStringLiteral("reading"));
    description_->setWordWrap(true);
    reset_->setObjectName(QStringLiteral("medium_reset"));
    reset_->setToolTip(tr("Takes back what was changed below"));
    keep_keys_for_canvas(reset_);
    column->addWidget(media_);
    column->addWidget(description_);
    column->addWidget(reset_);
    connect(media_, &MediumBox::medium_chosen, this, &MediumPanel::choose);
    connect(reset_, &QPushButton::clicked, this,
            [this] { choose(QString::fromStdString(medium_.name)); });
    return widget;
}

void MediumPanel::choose(const QString& name) {
    resting_.stop();
    Q_EMIT medium_chosen(name);
}

QWidget* MediumPanel::numbers(const MediumSection& part) {
    auto* widget = new QWidget;
    auto* grid_widget = new QWidget;
    auto* grid = new QGridLayout(grid_widget);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    for (const MediumRow& number : part.rows) {
        auto* row = new ValueRow(grid, QLatin1String(number.name), translated(number.words),
                                 translated(number.hint), shown_range(number));
        connect(row, &ValueRow::chosen, this, [this, &number](double value) {
            change(tools::with_number(medium_, number.member, value / number.scale));
        });
        shown_.push_back({&number, row});
    }
    section(widget, translated(part.heading))->addWidget(grid_widget);
    return widget;
}

QWidget* MediumPanel::feel_section() {
    auto* widget = new QWidget;
    auto* grid_widget = new QWidget;
    auto* grid = new QGridLayout(grid_widget);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    for (const FeelWords& feel : kFeels) {
        auto* row = new FeelRow(grid, QLatin1String(feel.name), translated(feel.from),
                                translated(feel.to), translated(feel.hint));
        connect(row, &FeelRow::chosen, this,
                [this, &feel](double place) { change(tools::with_place(medium_, feel.feel, place)); });
        feels_.push_back(row);
    }
    section(widget, tr("What it is like"))->addWidget(grid_widget);
    return widget;
}

void MediumPanel::open_numbers(bool open) {
    fold_->open(open);
}

bool MediumPanel::numbers_open() const {
    return fold_->is_open();
}

/// Poured when it rests.
void MediumPanel::change(const film::Medium& medium) {
    show_numbers(medium);
    resting_.start();
}

void MediumPanel::finish() {
    if (!resting_.isActive()) return;
    resting_.stop();
    Q_EMIT medium_changed(medium_);
}

void MediumPanel::show_medium(const film::Medium& medium) {
    if (resting_.isActive() && medium == in_hand_) return;
    resting_.stop();
    in_hand_ = medium;
    show_numbers(medium);
}

void MediumPanel::show_numbers(const film::Medium& medium) {
    medium_ = medium;
    media_->show_medium(QString::fromStdString(medium.name));
    description_->setText(appearance::shown_name(medium.description));
    reset_->setEnabled(medium != film::find_medium(medium.name));
    for (std::size_t i = 0; i < feels_.size(); ++i)
        feels_[i]->show_place(tools::place_of(medium, kFeels[i].feel));
    for (const Shown& shown : shown_)
        shown.row->show_value(shown.number->scale * medium.*shown.number->member);
}

}  // namespace pastoso::panels
