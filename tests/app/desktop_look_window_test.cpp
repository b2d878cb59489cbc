// What the desktop's settings portal says, on a bus of its own.
#include "app/window_fixture.hpp"
#include "main/program/desktop_look.hpp"

#include <chrono>
#include <future>
#include <optional>
#include <vector>

#include <QCoreApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVariant>
#include <QDBusVirtualObject>
#include <QProcess>

namespace pastoso::tests {
namespace {

class FakePortal : public QDBusVirtualObject {
  public:
    QString introspect(const QString&) const override { return {}; }
    bool handleMessage(const QDBusMessage& message, const QDBusConnection& bus) override {
        const QString key = message.arguments().value(1).toString();
        if (!values.contains(key))
            return bus.send(message.createErrorReply(
                QStringLiteral("org.freedesktop.portal.Error.NotFound"), QStringLiteral("not found")));
        const QVariant value = values[key];
        const QDBusVariant once(value), twice(QVariant::fromValue(once));
        return bus.send(message.createReply() << QVariant::fromValue(twice));
    }

    QVariantMap values;
};

class DesktopLookTest : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        daemon_.start(QStringLiteral("dbus-daemon"),
                      {QStringLiteral("--session"), QStringLiteral("--nofork"),
                       QStringLiteral("--nosyslog"), QStringLiteral("--print-address")});
        if (!daemon_.waitForStarted()) GTEST_SKIP() << "there is no dbus-daemon here";
        while (!daemon_.canReadLine())
            ASSERT_TRUE(daemon_.waitForReadyRead());
        const QString address = QString::fromLatin1(daemon_.readLine()).trimmed();
        service_ = QDBusConnection::connectToBus(address, QStringLiteral("portal"));
        client_ = QDBusConnection::connectToBus(address, QStringLiteral("asks"));
        ASSERT_TRUE(service_.registerService(QStringLiteral("org.freedesktop.portal.Desktop")));
        ASSERT_TRUE(
            service_.registerVirtualObject(QStringLiteral("/"), &portal_, QDBusConnection::SubPath));
    }
    void TearDown() override {
        QDBusConnection::disconnectFromBus(QStringLiteral("portal"));
        QDBusConnection::disconnectFromBus(QStringLiteral("asks"));
        daemon_.terminate();
        daemon_.waitForFinished();
        WindowTest::TearDown();
    }
    void tell(const QString& of, const QString& key, const QVariant& value) {
        service_.send(QDBusMessage::createSignal(QStringLiteral("/org/freedesktop/portal/desktop"),
                                                 QStringLiteral("org.freedesktop.portal.Settings"),
                                                 QStringLiteral("SettingChanged"))
                      << of << key << QVariant::fromValue(QDBusVariant(value)));
    }

    QProcess daemon_;
    FakePortal portal_;
    QDBusConnection service_{QString()}, client_{QString()};
};

TEST_F(DesktopLookTest, IsAskedAndHeardWhenItChanges) {
    portal_.values = {{QStringLiteral("contrast"), 1U}, {QStringLiteral("text-scaling-factor"), 1.25}};
    main::DesktopLook look(client_);
    std::vector<bool> contrasts;
    std::vector<double> scales;
    QObject::connect(&look, &main::DesktopLook::contrast_told, &look,
                     [&](bool high) { contrasts.push_back(high); });
    QObject::connect(&look, &main::DesktopLook::text_scale_told, &look,
                     [&](double scale) { scales.push_back(scale); });
    look.ask();
    wait_for([&] { return !contrasts.empty() && !scales.empty(); });
    EXPECT_EQ(contrasts, std::vector<bool>{true});
    EXPECT_EQ(scales, std::vector<double>{1.25});
    tell(QStringLiteral("org.freedesktop.appearance"), QStringLiteral("color-scheme"), 1U);
    tell(QStringLiteral("org.freedesktop.appearance"), QStringLiteral("contrast"), 0U);
    tell(QStringLiteral("org.gnome.desktop.interface"), QStringLiteral("text-scaling-factor"), 99.0);
    wait_for([&] { return contrasts.size() == 2 && scales.size() == 2; });
    EXPECT_FALSE(contrasts.back());
    EXPECT_EQ(scales.back(), 3.0) << "no more than the window has room for";
}

/// As that of Debian 12 answers.
TEST_F(DesktopLookTest, APortalThatKnowsNoContrastIsAskedForTheTheme) {
    portal_.values = {{QStringLiteral("gtk-theme"), QStringLiteral("HighContrastInverse")}};
    main::DesktopLook look(client_);
    std::vector<bool> told;
    QObject::connect(&look, &main::DesktopLook::contrast_told, &look,
                     [&](bool high) { told.push_back(high); });
    look.ask();
    wait_for([&] { return !told.empty(); });
    tell(QStringLiteral("org.gnome.desktop.interface"), QStringLiteral("gtk-theme"),
         QStringLiteral("Adwaita-dark"));
    wait_for([&] { return told.size() == 2; });
    tell(QStringLiteral("org.freedesktop.appearance"), QStringLiteral("contrast"), 1U);
    tell(QStringLiteral("org.gnome.desktop.interface"), QStringLiteral("gtk-theme"),
         QStringLiteral("Adwaita"));
    wait_for([&] { return told.size() == 4; });
    EXPECT_EQ(told, (std::vector<bool>{true, false, true, true})) << "either of them suffices";
}

TEST_F(DesktopLookTest, TheTextsSizeIsWaitedForAtTheStart) {
    // The portal answers on this thread.
    const auto asked = [this] {
        auto answer = std::async(std::launch::async, [this] {
            constexpr int kLong_ms = 20000;
            return main::wanted_text_scale(client_, kLong_ms);
        });
        wait_for([&] { return answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready; });
        return answer.get();
    };
    EXPECT_EQ(asked(), std::nullopt) << "the portal knows none";
    portal_.values = {{QStringLiteral("text-scaling-factor"), 1.5}};
    EXPECT_EQ(asked(), 1.5);
    EXPECT_EQ(main::wanted_text_scale(client_, 20), std::nullopt) << "it cannot answer meanwhile";
    EXPECT_EQ(main::wanted_text_scale(QDBusConnection(QStringLiteral("nowhere")), 20), std::nullopt);
}

TEST_F(DesktopLookTest, WithoutABusNothingIsTold) {
    main::DesktopLook look(QDBusConnection(QStringLiteral("nowhere")));
    int told = 0;
    QObject::connect(&look, &main::DesktopLook::contrast_told, &look, [&](bool) { ++told; });
    look.ask();
    QCoreApplication::processEvents();
    EXPECT_EQ(told, 0);
}

}  // namespace
}  // namespace pastoso::tests
