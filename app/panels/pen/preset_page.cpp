#include "panels/pen/preset_page.hpp"

#include "appearance/icon.hpp"
#include "panels/parts/labels.hpp"
#include "panels/parts/section.hpp"
#include "panels/pen/preset_choices.hpp"
#include "panels/pen/preset_rows.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

namespace pastoso::panels {
namespace {

/// What a number of the tool in hand was kept with: one that goes with the width, at the width that the
/// tool is held with.
double kept_number(const brush::PresetField& field, const brush::Preset& kept,
                   const brush::Preset& in_hand) {
    if (is_width(field)) return field.get(kept);
    return field.get(brush::within_ranges(brush::resized(kept, in_hand.tip.width_mm)));
}

/// But for the rounding of what has gone with the width to and fro.
bool is_same(double number, double kept) {
    constexpr double kRounding = 1e-9;
    return std::abs(number - kept) <= kRounding * std::abs(kept);
}

}  // namespace

PresetPageView::PresetPageView(const PresetPage& page, QWidget* parent)
    : QWidget(parent), grid_(new QGridLayout(this)) {
    grid_->setContentsMargins(4, 0, 10, 0);
    grid_->setHorizontalSpacing(10);
    grid_->setVerticalSpacing(3);
    for (const PresetChoice& choice : preset_choices())
        if (choice.section == std::string_view(page.section)) add(choice);
    for (const PresetRow& row : page.rows)
        add(page, row);
    grid_->setRowStretch(grid_->rowCount(), 1);
}

void PresetPageView::add(const PresetChoice& choice) {
    auto* label = new QLabel(translated(choice.words));
    label->setObjectName(QStringLiteral("reading"));
    auto* box = new QComboBox;
    box->setObjectName(QLatin1String(choice.name));
    box->setAccessibleName(label->text());
    box->setToolTip(translated(choice.meaning));
    for (const char* option : choice.options)
        box->addItem(translated(option));
    keep_keys_for_canvas(box);
    const int row = grid_->rowCount();
    grid_->addWidget(label, row, 0);
    grid_->addWidget(box, row, 1, 1, 2);
    QToolButton* reset = add_reset(box->objectName(), label->text(), [this, &choice] {
        brush::Preset changed = preset_;
        choice.set(changed, choice.get(kept_));
        edit(changed);
    });
    QWidget* below = add_explanation(box->toolTip());
    connect(box, &QComboBox::activated, this, [this, &choice](int place) {
        brush::Preset changed = preset_;
        choice.set(changed, place);
        edit(changed);
    });
    shown_.push_back({[&choice](brush::ToolKind kind) {
                          return !choice.contact_only || kind == brush::ToolKind::Contact;
                      },
                      [label, box, reset, below](bool visible) {
                          for (QWidget* widget :
                               {static_cast<QWidget*>(label), static_cast<QWidget*>(box),
                                static_cast<QWidget*>(reset), below})
                              widget->setVisible(visible);
                      },
                      [this, box, reset, &choice] {
                          box->setCurrentIndex(choice.get(preset_));
                          reset->setEnabled(choice.get(preset_) != choice.get(kept_));
                      }});
}

void PresetPageView::add(const PresetPage& page, const PresetRow& row) {
    const brush::PresetField& field = field_of(page, row);
    const QString explanation = explanation_of(page, row);
    auto* value = new ValueRow(grid_, QStringLiteral("%1_%2").arg(page.section, row.key),
                               translated(row.words), explanation, range_of(page, row));
    QToolButton* reset =
        add_reset(QStringLiteral("%1_%2").arg(page.section, row.key), translated(row.words),
                  [this, &field] { change(field, kept_number(field, kept_, preset_)); });
    QWidget* below = add_explanation(explanation);
    connect(value, &ValueRow::chosen, this,
            [this, &row, &field](double shown) { change(field, shown / row.scale); });
    shown_.push_back({[&field](brush::ToolKind kind) { return brush::applies_to(field, kind); },
                      [value, reset, below](bool visible) {
                          value->setVisible(visible);
                          reset->setVisible(visible);
                          below->setVisible(visible);
                      },
                      [this, value, reset, &row, &field] {
                          value->show_value(row.scale * field.get(preset_));
                          reset->setEnabled(
                              !is_same(field.get(preset_), kept_number(field, kept_, preset_)));
                      }});
}

QWidget* PresetPageView::add_explanation(const QString& words) {
    constexpr int kGap = 8;
    QLabel* below = note(words);
    below->setContentsMargins(0, 0, 0, kGap);
    grid_->addWidget(below, grid_->rowCount(), 0, 1, 4);
    return below;
}

/// Beside the row that was added last.
QToolButton* PresetPageView::add_reset(const QString& name, const QString& words,
                                       const std::function<void()>& reset) {
    auto* button = new QToolButton;
    button->setObjectName(name + QStringLiteral("_reset"));
    button->setIcon(appearance::icon(QStringLiteral("reset_number")));
    button->setAutoRaise(true);
    button->setToolTip(tr("%1: as the tool is saved").arg(words));
    button->setAccessibleName(button->toolTip());
    keep_keys_for_canvas(button);
    grid_->addWidget(button, grid_->rowCount() - 1, 3);
    connect(button, &QToolButton::clicked, this, reset);
    return button;
}

void PresetPageView::change(const brush::PresetField& field, double value) {
    if (is_width(field))
        Q_EMIT width_chosen(value);
    else
        edit(brush::with_number(preset_, field, value));
}

void PresetPageView::edit(const brush::Preset& preset) {
    preset_ = preset;
    show_all();
    Q_EMIT edited(preset_);
}

void PresetPageView::show_preset(const brush::Preset& preset, const brush::Preset& kept) {
    preset_ = preset;
    kept_ = kept;
    show_all();
}

void PresetPageView::show_all() {
    for (const Shown& shown : shown_) {
        shown.set_visible(shown.applies(preset_.kind));
        shown.show();
    }
}

bool PresetPageView::has_some_of(brush::ToolKind kind) const {
    return std::any_of(shown_.begin(), shown_.end(),
                       [kind](const Shown& shown) { return shown.applies(kind); });
}

}  // namespace pastoso::panels
