// How the painter has set the desktop to be read, asked of its settings portal
// (org.freedesktop.portal.Settings).
#pragma once

#include <optional>

#include <QDBusConnection>
#include <QDBusMessage>
#include <QObject>
#include <QString>
#include <QVariant>

namespace pastoso::main {

/// Waits for nothing: what is asked is told a little later, and again whenever it becomes another. Where
/// there is no portal nothing is told.
class DesktopLook : public QObject {
    Q_OBJECT
  public:
    explicit DesktopLook(const QDBusConnection& bus, QObject* parent = nullptr);

    void ask();

  Q_SIGNALS:
    /// Whether more contrast than usual is wanted: org.freedesktop.appearance, contrast; or, of older
    /// desktops that tell of none, org.gnome.desktop.interface, gtk-theme: HighContrast...
    void contrast_told(bool high);
    /// How much larger than usual text is wanted, 0.5 to 3 (org.gnome.desktop.interface,
    /// text-scaling-factor).
    void text_scale_told(double scale);

  private Q_SLOTS:
    void hear(const QDBusMessage& change);

  private:
    void take(const QString& of, const QString& key, const QVariant& value);
    void tell_contrast();
    void ask(const QString& of, const QString& key);

    QDBusConnection bus_;
    bool high_contrast_ = false, high_theme_ = false;
};

/// How much larger than usual text is wanted, as text_scale_told() tells it; none where no portal tells it
/// within `most_ms`.
std::optional<double> wanted_text_scale(QDBusConnection bus, int most_ms);

/// Where it is Qt that has text follow the desktop, nobody else needs to: X11 tells Qt, Wayland does not.
bool qt_scales_text();

/// The bus of the painter's desktop; one that is not connected where there is none, which none is
/// started for.
QDBusConnection desktop_bus();

}  // namespace pastoso::main
