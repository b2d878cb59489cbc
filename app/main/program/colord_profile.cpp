#include "main/program/colord_profile.hpp"

#include <QDBusArgument>
#include <QDBusObjectPath>
#include <QDBusPendingCallWatcher>
#include <QDBusVariant>

namespace pastoso::main {
namespace {

const QString kService = QStringLiteral("org.freedesktop.ColorManager");
const QString kPath = QStringLiteral("/org/freedesktop/ColorManager");
const QString kDevice = QStringLiteral("org.freedesktop.ColorManager.Device");
const QString kProfile = QStringLiteral("org.freedesktop.ColorManager.Profile");
const QString kProperties = QStringLiteral("org.freedesktop.DBus.Properties");

/// The value that an answer to Get holds.
QVariant value_of(const QDBusMessage& reply) {
    return reply.arguments().value(0).value<QDBusVariant>().variant();
}

/// The first of a device's profiles is the one that it is used with.
QString first_path(const QDBusMessage& reply) {
    const auto paths = qdbus_cast<QList<QDBusObjectPath>>(value_of(reply));
    return paths.isEmpty() ? QString() : paths.front().path();
}

}  // namespace

ColordProfile::ColordProfile(const QDBusConnection& bus, QObject* parent) : QObject(parent), bus_(bus) {
    // Of any sender: to ask who owns the service would wait for the bus.
    for (const char* change : {"DeviceAdded", "DeviceChanged", "DeviceRemoved", "ProfileChanged"})
        bus_.connect(QString(), kPath, kService, QLatin1String(change), this, SLOT(ask_again()));
}

void ColordProfile::ask(const QString& connector) {
    connector_ = connector;
    ask_again();
}

void ColordProfile::ask_again() {
    if (connector_.isEmpty()) return;
    ++question_;
    QDBusMessage find = QDBusMessage::createMethodCall(kService, kPath, kService,
                                                       QStringLiteral("FindDeviceByProperty"));
    find << QStringLiteral("XRANDR_name") << connector_;
    call(find, [this](const QDBusMessage& device) {
        const QString path = device.arguments().value(0).value<QDBusObjectPath>().path();
        ask_property(path, kDevice, QStringLiteral("Profiles"), [this](const QDBusMessage& profiles) {
            ask_property(first_path(profiles), kProfile, QStringLiteral("Filename"),
                         [this](const QDBusMessage& file) { Q_EMIT found(value_of(file).toString()); });
        });
    });
}

void ColordProfile::ask_property(const QString& path, const QString& interface, const QString& property,
                                 const Then& then) {
    if (path.isEmpty()) return Q_EMIT found({});
    QDBusMessage get =
        QDBusMessage::createMethodCall(kService, path, kProperties, QStringLiteral("Get"));
    get << interface << property;
    call(get, then);
}

void ColordProfile::call(const QDBusMessage& message, const Then& then) {
    if (!bus_.isConnected()) {
        QMetaObject::invokeMethod(
            this, [this] { Q_EMIT found({}); }, Qt::QueuedConnection);
        return;
    }
    auto* watcher = new QDBusPendingCallWatcher(bus_.asyncCall(message), this);
    connect(watcher, &QDBusPendingCallWatcher::finished, this,
            [this, watcher, then, question = question_] {
                watcher->deleteLater();
                if (question != question_) return;
                if (watcher->isError())
                    Q_EMIT found({});
                else
                    then(watcher->reply());
            });
}

}  // namespace pastoso::main
