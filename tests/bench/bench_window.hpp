// What the benchmarks of the real window share: a window as a painter starts it, in folders of its own.
#pragma once

#include "appearance/theme.hpp"
#include "core/memory.hpp"
#include "graphics/opengl_support.hpp"
#include "main/main_window.hpp"

#include <optional>

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

namespace pastoso::bench {

inline void use_own_folders(const QTemporaryDir& home) {
    for (const char* variable : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"})
        qputenv(variable, home.path().toLocal8Bit());
}

/// Before there is an application.
inline void prepare() {
    core::keep_freed_memory();  // as the program does
    graphics::ask_for_opengl();
}

inline constexpr QSize kWindow(1280, 800);

/// Shown.
class Window {
  public:
    explicit Window(const document::CanvasSettings& canvas, const QSize& size = kWindow) {
        appearance::apply_theme(*qobject_cast<QApplication*>(QCoreApplication::instance()),
                                appearance::Theme::Dark);
        use_own_folders(home_);
        window_.emplace(canvas);
        window_->resize(size);
        window_->show();
        shown_ = QTest::qWaitForWindowExposed(&*window_);
    }

    bool shown() const { return shown_; }
    main::MainWindow& operator*() { return *window_; }
    main::Studio& studio() { return window_->studio(); }

  private:
    QTemporaryDir home_;
    std::optional<main::MainWindow> window_;
    bool shown_ = false;
};

}  // namespace pastoso::bench
