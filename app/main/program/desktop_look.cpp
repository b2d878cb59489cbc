#include "main/program/desktop_look.hpp"

#include <algorithm>

#include <QDBusPendingCallWatcher>
#include <QDBusVariant>
#include <QFileInfo>
#include <QGuiApplication>

namespace pastoso::main {
namespace {

const QString kService = QStringLiteral("org.freedesktop.portal.Desktop");
const QString kPath = QStringLiteral("/org/freedesktop/portal/desktop");
const QString kSettings = QStringLiteral("org.freedesktop.portal.Settings");
const QString kAppearance = QStringLiteral("org.freedesktop.appearance");
const QString kContrast = QStringLiteral("contrast");
const QString kInterface = QStringLiteral("org.gnome.desktop.interface");
const QString kTheme = QStringLiteral("gtk-theme");
const QLatin1String kHighTheme("HighContrast");
const QString kTextScale = QStringLiteral("text-scaling-factor");

constexpr uint kHighContrast = 1;
constexpr double kLeastScale = 0.5, kMostScale = 3.0;

/// Read answers with a variant in a variant.
QVariant bared(QVariant value) {
    while (value.metaType() == QMetaType::fromType<QDBusVariant>())
        value = value.value<QDBusVariant>().variant();
    return value;
}

QDBusMessage reading(const QString& of, const QString& key) {
    QDBusMessage read =
        QDBusMessage::createMethodCall(kService, kPath, kSettings, QStringLiteral("Read"));
    return read << of << key;
}

std::optional<double> text_scale(const QVariant& told) {
    bool is_number = false;
    const double scale = told.toDouble(&is_number);
    return is_number ? std::optional(std::clamp(scale, kLeastScale, kMostScale)) : std::nullopt;
}

}  // namespace

DesktopLook::DesktopLook(const QDBusConnection& bus, QObject* parent) : QObject(parent), bus_(bus) {
    bus_.connect(QString(), kPath, kSettings, QStringLiteral("SettingChanged"), this,
                 SLOT(hear(QDBusMessage)));
}

void DesktopLook::ask() {
    ask(kAppearance, kContrast);
    ask(kInterface, kTheme);
    ask(kInterface, kTextScale);
}

void DesktopLook::ask(const QString& of, const QString& key) {
    if (!bus_.isConnected()) return;
    auto* watcher = new QDBusPendingCallWatcher(bus_.asyncCall(reading(of, key)), this);
    connect(watcher, &QDBusPendingCallWatcher::finished, this, [this, watcher, of, key] {
        watcher->deleteLater();
        if (!watcher->isError()) take(of, key, watcher->reply().arguments().value(0));
    });
}

void DesktopLook::hear(const QDBusMessage& change) {
    const QList<QVariant> told = change.arguments();
    take(told.value(0).toString(), told.value(1).toString(), told.value(2));
}

void DesktopLook::take(const QString& of, const QString& key, const QVariant& value) {
    const QVariant bare = bared(value);
    if (of == kAppearance && key == kContrast) {
        high_contrast_ = bare.toUInt() == kHighContrast;
        tell_contrast();
    } else if (of == kInterface && key == kTheme) {
        high_theme_ = bare.toString().startsWith(kHighTheme);
        tell_contrast();
    } else if (of == kInterface && key == kTextScale) {
        if (const std::optional<double> scale = text_scale(bare)) Q_EMIT text_scale_told(*scale);
    }
}

void DesktopLook::tell_contrast() {
    Q_EMIT contrast_told(high_contrast_ || high_theme_);
}

std::optional<double> wanted_text_scale(QDBusConnection bus, int most_ms) {
    if (!bus.isConnected()) return std::nullopt;
    const QDBusMessage reply = bus.call(reading(kInterface, kTextScale), QDBus::Block, most_ms);
    if (reply.type() != QDBusMessage::ReplyMessage) return std::nullopt;
    return text_scale(bared(reply.arguments().value(0)));
}

bool qt_scales_text() {
    return !QGuiApplication::platformName().startsWith(QLatin1String("wayland"));
}

QDBusConnection desktop_bus() {
    const bool is_there =
        qEnvironmentVariableIsSet("DBUS_SESSION_BUS_ADDRESS") ||
        QFileInfo::exists(qEnvironmentVariable("XDG_RUNTIME_DIR") + QStringLiteral("/bus"));
    return is_there ? QDBusConnection::sessionBus() : QDBusConnection(QStringLiteral("none"));
}

}  // namespace pastoso::main
