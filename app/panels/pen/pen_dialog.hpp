// Pens and mouse as the painter's hand wants them: a curve for each, what ends and buttons do, and a
// sheet to try it on. What is changed holds at once.
#pragma once

#include "dialogs/growing_dialog.hpp"
#include "panels/pen/pen_pad.hpp"
#include "tools/pen_settings.hpp"

#include <optional>
#include <vector>

class QLabel;
class QListWidget;
class QPushButton;
class QStackedLayout;

namespace pastoso::panels {

class CurveEditor;
class MousePart;

class PenDialog : public dialogs::GrowingDialog {
    Q_OBJECT
  public:
    PenDialog(tools::PenSettings settings, QWidget* parent);

    /// Lists the devices that are there, besides the mouse and those that are remembered.
    void show_devices(const std::vector<tools::PenDevice>& devices);

    const tools::PenSettings& settings() const { return settings_; }

    /// None: the mouse.
    std::optional<tools::PenDevice> chosen_device() const;

  Q_SIGNALS:
    void changed(const tools::PenSettings& settings);

  private:
    QWidget* make_devices();
    QWidget* make_curve_part();
    QWidget* make_buttons_part();
    QWidget* make_pad_part();
    void add_device(const tools::PenDevice& device);
    void choose_device(const std::optional<tools::PenDevice>& device);
    void show_chosen();
    void use_curve(const brush::DynamicsCurve& curve);
    void show_reading(const PenReading& reading);
    void change();

    tools::PenSettings settings_;
    std::vector<tools::PenDevice> devices_;  ///< in the rows of the list behind the mouse
    QListWidget* list_ = nullptr;
    QLabel* device_name_ = nullptr;
    QStackedLayout* parts_ = nullptr;
    QWidget* curve_part_ = nullptr;
    MousePart* mouse_part_ = nullptr;
    CurveEditor* editor_ = nullptr;
    QPushButton* reset_ = nullptr;
    PenPad* pad_ = nullptr;
    QLabel* readings_ = nullptr;
};

}  // namespace pastoso::panels
