// The profile that the system has for a screen, asked of colord, which desktops tell it to.
#pragma once

#include <functional>

#include <QDBusConnection>
#include <QDBusMessage>
#include <QObject>
#include <QString>

namespace pastoso::main {

/// Waits for nothing: what is asked is told a little later. A bus or a service that is not there, and
/// anything else than a profile as an answer, are the same as no profile.
class ColordProfile : public QObject {
    Q_OBJECT
  public:
    explicit ColordProfile(const QDBusConnection& bus, QObject* parent = nullptr);

    /// Of a screen, by the name of its connector (QScreen::name()). It is asked again whenever the
    /// system's screens and profiles become others.
    void ask(const QString& connector);

  Q_SIGNALS:
    /// The file of the profile; empty where there is none.
    void found(const QString& file);

  private Q_SLOTS:
    void ask_again();

  private:
    using Then = std::function<void(const QDBusMessage& reply)>;

    void call(const QDBusMessage& message, const Then& then);
    void ask_property(const QString& path, const QString& interface, const QString& property,
                      const Then& then);

    QDBusConnection bus_;
    QString connector_;
    int question_ = 0;  ///< answers to earlier ones are no longer wanted
};

}  // namespace pastoso::main
