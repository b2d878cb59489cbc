// No exception leaves an event: it is told, and the next event has its turn.
#include "main/program/application.hpp"

#include "app/window_fixture.hpp"
#include "core/error.hpp"

#include <filesystem>
#include <functional>
#include <new>
#include <string>
#include <vector>

#include <QCoreApplication>
#include <QDialog>
#include <QTimer>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Events : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        auto* application = qobject_cast<main::Application*>(QCoreApplication::instance());
        ASSERT_NE(application, nullptr);
        QObject::connect(application, &main::Application::failed, &receiver_,
                         [this](const QString& sentence) { told_.push_back(sentence.toStdString()); });
    }

    void post(const std::function<void()>& work) {
        QMetaObject::invokeMethod(&receiver_, work, Qt::QueuedConnection);
    }

    QObject receiver_;
    std::vector<std::string> told_;
};

TEST_F(Events, WhateverASlotThrowsIsToldAndTheNextEventComes) {
    int handled = 0;
    post([] { throw core::InputError("a.png: is no picture."); });
    post([] { (void)std::filesystem::file_size("/nowhere/at all"); });
    post([] { throw std::bad_alloc(); });
    post([] { throw 7; });
    post([&] { ++handled; });
    QCoreApplication::processEvents();
    EXPECT_EQ(handled, 1);
    EXPECT_THAT(told_, ElementsAre("a.png: is no picture.", HasSubstr("/nowhere/at all"),
                                   HasSubstr("memory ran out"), HasSubstr("unknown kind")));
    QCoreApplication::processEvents();
    EXPECT_THAT(told(), HasSubstr("within the program")) << "and the painter reads it";
}

TEST_F(Events, ADialogStaysWhereASlotBehindItThrows) {
    QDialog dialog(&window());
    bool was_open = false;
    QTimer::singleShot(0, &receiver_, [] { throw core::InputError("refused."); });
    QTimer::singleShot(0, &receiver_, [&] {
        was_open = dialog.isVisible();
        dialog.accept();
    });
    EXPECT_EQ(dialog.exec(), QDialog::Accepted);
    EXPECT_TRUE(was_open);
    EXPECT_THAT(told_, ElementsAre("refused."));
}

}  // namespace
}  // namespace pastoso::tests
