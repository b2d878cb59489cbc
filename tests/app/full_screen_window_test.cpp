// The window on the whole screen.
#include "app/window_fixture.hpp"

#include <QAction>

namespace pastoso::tests {
namespace {

class FullScreenWindow : public WindowTest {};

TEST_F(FullScreenWindow, ComesAndGoesWithItsCommand) {
    QAction* full = action(commands::Command::FullScreen);
    const QSize before = window().size();
    full->trigger();
    wait_for([&] { return window().isFullScreen(); });
    EXPECT_TRUE(full->isChecked());
    full->trigger();
    wait_for([&] { return !window().isFullScreen() && window().size() == before; });
    EXPECT_FALSE(full->isChecked());
}

TEST_F(FullScreenWindow, TheCommandFollowsTheDesktop) {
    window().showFullScreen();
    wait_for([&] { return action(commands::Command::FullScreen)->isChecked(); });
    window().showNormal();
    wait_for([&] { return !action(commands::Command::FullScreen)->isChecked(); });
}

}  // namespace
}  // namespace pastoso::tests
