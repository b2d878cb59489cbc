// A window in which selections are drawn, clicked and looked at.
#pragma once

#include "app/canvas_mouse.hpp"
#include "app/window_fixture.hpp"

#include <string>
#include <vector>

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QTest>

namespace pastoso::tests {

/// The mouse hits whole pixels, some eight a millimetre, and cells are a quarter of one.
constexpr double kSide_mm = 0.4;

class SelectionFixture : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        give(commands::Command::Pause);
        studio().easel().take_brush("Flat bristle 20", 4.0);
        cell_mm_ = session().snapshot()->film.cell_mm;
    }

    void give(commands::Command command) {
        ASSERT_TRUE(action(command)->isEnabled()) << action(command)->text().toStdString();
        action(command)->trigger();
        settle();
    }
    /// All readings may give way to a long sentence.
    std::string reading() {
        const auto* label = window().findChild<QLabel*>(QStringLiteral("selection"));
        return label->isHidden() ? std::string() : label->text().toStdString();
    }

    void send(QEvent::Type type, const glm::dvec2& place_mm, Qt::KeyboardModifiers keys) {
        send_mouse(canvas(), type, place_mm, keys);
    }
    void drag(const std::vector<glm::dvec2>& path_mm, Qt::KeyboardModifiers keys = {}) {
        send(QEvent::MouseButtonPress, path_mm.front(), keys);
        for (const glm::dvec2& place_mm : path_mm)
            send(QEvent::MouseMove, place_mm, keys);
        send(QEvent::MouseButtonRelease, path_mm.back(), keys);
        settle();
    }
    void key(Qt::Key key) { QTest::keyClick(&canvas(), key); }

    document::Selection selection() {
        session().wait_until_applied();
        return session().snapshot()->selection;
    }
    bool selected(double x_mm, double y_mm) {
        const document::Selection mask = selection();
        return mask == nullptr ||
               mask->at(static_cast<int>(x_mm / cell_mm_), static_cast<int>(y_mm / cell_mm_)) != 0;
    }
    double selected_mm2() {
        const document::Selection mask = selection();
        if (mask == nullptr) return 0.0;
        return static_cast<double>(grid::chosen_cells(*mask)) * cell_mm_ * cell_mm_;
    }
    std::int64_t events_posted() {
        session().wait_until_applied();
        return static_cast<std::int64_t>(session().recording().events.size());
    }

  private:
    double cell_mm_ = 0.0;
};

}  // namespace pastoso::tests
