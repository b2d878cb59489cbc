// A page of what a tool is like: choices and numbers, each with what it means.
#pragma once

#include "brush/preset_fields.hpp"

#include <functional>
#include <vector>

#include <QWidget>

class QGridLayout;

namespace pastoso::panels {

struct PresetChoice;
struct PresetPage;
struct PresetRow;

class PresetPageView : public QWidget {
    Q_OBJECT
  public:
    explicit PresetPageView(const PresetPage& page, QWidget* parent = nullptr);

    /// Shows a tool, without a signal.
    void show_preset(const brush::Preset& preset);

    /// Whether tools of this kind have any of what stands on the page.
    bool has_some_of(brush::ToolKind kind) const;

  Q_SIGNALS:
    /// The tool that was shown, with one thing changed.
    void edited(const brush::Preset& preset);

  private:
    void add(const PresetChoice& choice);
    void add(const PresetPage& page, const PresetRow& row);
    QWidget* add_explanation(const QString& words);
    void edit(const brush::Preset& preset);

    struct Shown {
        std::function<bool(brush::ToolKind)> applies;
        std::function<void(bool)> set_visible;
        std::function<void(const brush::Preset&)> show;
    };
    brush::Preset preset_;
    QGridLayout* grid_;
    std::vector<Shown> shown_;
};

}  // namespace pastoso::panels
