// A page of what a tool is like: choices and numbers, each with what it means.
#pragma once

#include "brush/preset_fields.hpp"

#include <functional>
#include <vector>

#include <QWidget>

class QGridLayout;
class QToolButton;

namespace pastoso::panels {

struct PresetChoice;
struct PresetPage;
struct PresetRow;

class PresetPageView : public QWidget {
    Q_OBJECT
  public:
    explicit PresetPageView(const PresetPage& page, QWidget* parent = nullptr);

    /// Shows a tool, without a signal; `kept` is what each of its numbers can be reset to.
    void show_preset(const brush::Preset& preset, const brush::Preset& kept);

    /// Whether tools of this kind have any of what stands on the page.
    bool has_some_of(brush::ToolKind kind) const;

  Q_SIGNALS:
    /// The tool that was shown, with one thing changed.
    void edited(const brush::Preset& preset);
    /// How wide it is to be held; what else that changes is to be shown.
    void width_chosen(double width_mm);

  private:
    void add(const PresetChoice& choice);
    void add(const PresetPage& page, const PresetRow& row);
    QWidget* add_explanation(const QString& words);
    QToolButton* add_reset(const QString& name, const QString& words,
                           const std::function<void()>& reset);
    void change(const brush::PresetField& field, double value);
    void edit(const brush::Preset& preset);
    void show_all();

    struct Shown {
        std::function<bool(brush::ToolKind)> applies;
        std::function<void(bool)> set_visible;
        std::function<void()> show;
    };
    brush::Preset preset_, kept_;
    QGridLayout* grid_;
    std::vector<Shown> shown_;
};

}  // namespace pastoso::panels
