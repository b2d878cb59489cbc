#include "panels/pen/preset_page.hpp"

#include "panels/parts/labels.hpp"
#include "panels/parts/section.hpp"
#include "panels/pen/preset_choices.hpp"
#include "panels/pen/preset_rows.hpp"

#include <algorithm>
#include <string_view>

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>

namespace pastoso::panels {
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
    QWidget* below = add_explanation(box->toolTip());
    connect(box, &QComboBox::activated, this, [this, &choice](int place) {
        brush::Preset changed = preset_;
        choice.set(changed, place);
        edit(changed);
    });
    shown_.push_back(
        {[&choice](brush::ToolKind kind) {
             return !choice.contact_only || kind == brush::ToolKind::Contact;
         },
         [label, box, below](bool visible) {
             for (QWidget* widget : {static_cast<QWidget*>(label), static_cast<QWidget*>(box), below})
                 widget->setVisible(visible);
         },
         [box, &choice](const brush::Preset& preset) { box->setCurrentIndex(choice.get(preset)); }});
}

void PresetPageView::add(const PresetPage& page, const PresetRow& row) {
    const brush::PresetField& field = field_of(page, row);
    const QString explanation = explanation_of(page, row);
    auto* value = new ValueRow(grid_, QStringLiteral("%1_%2").arg(page.section, row.key),
                               translated(row.words), explanation, range_of(page, row));
    QWidget* below = add_explanation(explanation);
    connect(value, &ValueRow::chosen, this, [this, &row, &field](double shown) {
        edit(brush::with_number(preset_, field, shown / row.scale));
    });
    shown_.push_back({[&field](brush::ToolKind kind) { return brush::applies_to(field, kind); },
                      [value, below](bool visible) {
                          value->setVisible(visible);
                          below->setVisible(visible);
                      },
                      [value, &row, &field](const brush::Preset& preset) {
                          value->show_value(row.scale * field.get(preset));
                      }});
}

QWidget* PresetPageView::add_explanation(const QString& words) {
    constexpr int kGap = 8;
    QLabel* below = note(words);
    below->setContentsMargins(0, 0, 0, kGap);
    grid_->addWidget(below, grid_->rowCount(), 0, 1, 3);
    return below;
}

void PresetPageView::edit(const brush::Preset& preset) {
    show_preset(preset);
    Q_EMIT edited(preset_);
}

void PresetPageView::show_preset(const brush::Preset& preset) {
    preset_ = preset;
    for (const Shown& shown : shown_) {
        shown.set_visible(shown.applies(preset.kind));
        shown.show(preset);
    }
}

bool PresetPageView::has_some_of(brush::ToolKind kind) const {
    return std::any_of(shown_.begin(), shown_.end(),
                       [kind](const Shown& shown) { return shown.applies(kind); });
}

}  // namespace pastoso::panels
