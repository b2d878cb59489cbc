#include "panels/pen/brush_editor.hpp"

#include "appearance/shown_names.hpp"
#include "document/tool_sample.hpp"
#include "panels/parts/labels.hpp"
#include "panels/parts/section.hpp"
#include "panels/pen/curves_panel.hpp"
#include "panels/pen/preset_page.hpp"
#include "panels/pen/preset_rows.hpp"
#include "panels/pen/stroke_strip.hpp"

#include <algorithm>

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr QSize kFirstSize(640, 600);
constexpr int kContentsWidth = 148;

}  // namespace

BrushEditor::BrushEditor(const std::vector<QAction*>& own_actions, const core::Tell& tell,
                         QWidget* parent)
    : QDialog(parent), name_(heading(QString())) {
    setObjectName(QStringLiteral("brush_editor"));
    setWindowTitle(tr("Brush editor"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 12, 14, 12);
    column->setSpacing(10);
    column->addWidget(name_);
    column->addWidget(make_strips(tell));
    column->addWidget(make_actions(own_actions));
    column->addWidget(make_pages(), 1);
    resize(kFirstSize);
    contents_->setFocus();
}

// ---- what stands where

QWidget* BrushEditor::make_strips(const core::Tell& tell) {
    auto* strips = new QWidget;
    auto* column = new QVBoxLayout(strips);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    strip_ = new StrokeStrip(tell);
    strip_->setObjectName(QStringLiteral("stroke_in_hand"));
    strip_->setToolTip(tr("A stroke of the tool in hand, pressed hardest in its middle"));
    strip_->setAccessibleName(strip_->toolTip());
    kept_strip_ = new StrokeStrip(tell);
    kept_strip_->setObjectName(QStringLiteral("stroke_saved"));
    kept_strip_->setToolTip(tr("The same stroke of the tool as it is saved"));
    kept_strip_->setAccessibleName(kept_strip_->toolTip());
    kept_strip_->set_caption(tr("As saved"));
    kept_strip_->hide();
    column->addWidget(strip_);
    column->addWidget(kept_strip_);
    return strips;
}

QWidget* BrushEditor::make_actions(const std::vector<QAction*>& own_actions) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    compare_ = new QToolButton;
    compare_->setText(tr("Compare"));
    compare_->setCheckable(true);
    compare_->setObjectName(QStringLiteral("compare_brush"));
    compare_->setToolTip(tr("Shows below the stroke of the tool as it is saved"));
    revert_ = new QPushButton(tr("Revert"));
    revert_->setObjectName(QStringLiteral("revert_brush"));
    revert_->setToolTip(tr("Takes back all changes of the tool in hand"));
    revert_->setAutoDefault(false);
    layout->addWidget(compare_);
    layout->addStretch(1);
    layout->addWidget(revert_);
    layout->addWidget(button_row(own_actions));
    connect(compare_, &QToolButton::toggled, this, [this](bool compared) {
        kept_strip_->setVisible(compared);
        strip_->set_caption(compared ? tr("In hand") : QString());
    });
    connect(revert_, &QPushButton::clicked, this, [this] { edit(kept_); });
    return row;
}

QWidget* BrushEditor::make_pages() {
    contents_ = new QListWidget;
    contents_->setObjectName(QStringLiteral("brush_pages"));
    contents_->setAccessibleName(tr("Parts of the tool"));
    contents_->setFixedWidth(kContentsWidth);
    pages_ = new QStackedWidget;
    connect(contents_, &QListWidget::currentRowChanged, pages_, &QStackedWidget::setCurrentIndex);
    connect(contents_, &QListWidget::currentRowChanged, this, [this](int page) { open_page_ = page; });
    for (const PresetPage& page : preset_pages()) {
        auto* numbers = new PresetPageView(page);
        connect(numbers, &PresetPageView::edited, this, &BrushEditor::edit);
        connect(numbers, &PresetPageView::width_chosen, this, &BrushEditor::width_chosen);
        numbers_.push_back(numbers);
        add_page(translated(page.words), numbers);
    }
    curves_ = new CurvesPanel;
    connect(curves_, &CurvesPanel::edited, this, &BrushEditor::edit);
    auto* curves_page = new QWidget;
    auto* column = new QVBoxLayout(curves_page);
    column->setContentsMargins(4, 0, 10, 0);
    column->addWidget(curves_);
    column->addStretch(1);
    add_page(tr("Curves"), curves_page);
    contents_->setCurrentRow(0);
    auto* part = new QWidget;
    auto* row = new QHBoxLayout(part);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(12);
    row->addWidget(contents_);
    row->addWidget(pages_, 1);
    return part;
}

void BrushEditor::add_page(const QString& words, QWidget* page) {
    contents_->addItem(words);
    pages_->addWidget(scrolled(page));
}

void BrushEditor::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    Q_EMIT shown(true);
}

void BrushEditor::hideEvent(QHideEvent* event) {
    QDialog::hideEvent(event);
    Q_EMIT shown(false);
}

// ---- the tool

void BrushEditor::show_tool(const brush::Preset& in_hand, const brush::Preset& kept) {
    if (in_hand == tool_ && kept == kept_) return;
    tool_ = in_hand;
    kept_ = kept;
    show_all();
}

void BrushEditor::edit(const brush::Preset& preset) {
    tool_ = preset;
    show_all();
    Q_EMIT edited(preset);
}

void BrushEditor::show_all() {
    const bool changed = !(tool_ == kept_);
    const QString name = appearance::shown_name(tool_.name);
    name_->setText(changed ? tr("%1, changed").arg(name) : name);
    revert_->setEnabled(changed);
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        const bool has_some = numbers_[i]->has_some_of(tool_.kind);
        contents_->item(static_cast<int>(i))->setHidden(!has_some);
        numbers_[i]->show_preset(tool_, kept_);
    }
    show_page();
    curves_->show_preset(tool_, kept_);
    show_strips();
}

/// The page that the painter opened last, or the first where tools of this kind have nothing on it.
void BrushEditor::show_page() {
    const int wanted = open_page_;
    contents_->setCurrentRow(contents_->item(wanted)->isHidden() ? 0 : wanted);
    open_page_ = wanted;
}

int BrushEditor::open_page() const {
    return open_page_;
}

void BrushEditor::open_page(int page) {
    open_page_ = std::clamp(page, 0, contents_->count() - 1);
    show_page();
}

/// The same mark on one scale, so that widths compare as well: that of the saved tool, whose ground
/// stays while a number moves, unless one is dipped and the other is not.
void BrushEditor::show_strips() {
    const double mark_mm = std::max(document::mark_width_mm(tool_), document::mark_width_mm(kept_));
    const document::ToolMark mark = document::mark_of(kept_.dips == tool_.dips ? kept_ : tool_);
    strip_->show_tool(tool_, mark, mark_mm);
    kept_strip_->show_tool(kept_, mark, mark_mm);
}

}  // namespace pastoso::panels
