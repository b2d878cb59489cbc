// The window: puts its parts together.
#pragma once

#include "main/files/prepared_painting.hpp"
#include "main/panel_set.hpp"
#include "main/program/kept_preferences.hpp"
#include "main/studio.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <QMainWindow>

namespace pastoso::main {

struct WindowParts;

class MainWindow : public QMainWindow {
    Q_OBJECT
  public:
    /// Throws core::InputError when there can be no such canvas. What is painted is kept on the disk as
    /// it happens, to be recovered, unless `keeps_journal` says otherwise. What of the preferences holds
    /// for the whole program is in use already.
    explicit MainWindow(const document::CanvasSettings& canvas, bool keeps_journal = true,
                        const KeptPreferences& preferences = kept_preferences());
    ~MainWindow() override;

    /// What the parts share.
    Studio& studio() { return studio_; }
    /// The parts themselves (window_parts.hpp).
    WindowParts& parts() { return *parts_; }

    /// Puts up the recording's canvas and paints on it what was recorded.
    void replay(const document::Recording& recording);

    /// Begins to open what the program is started with: a painting, a picture, or a recording. Where it
    /// cannot be had, that stands in the window, whose canvas stays as it is.
    void open_file(const std::filesystem::path& file);

  protected:
    void closeEvent(QCloseEvent* event) override;

  private:
    std::optional<FirstCanvas> first_canvas_;  ///< until the window is laid out
    Studio studio_;
    const PanelSet panels_;
    std::unique_ptr<WindowParts> parts_;
};

}  // namespace pastoso::main
