#include "appearance/said_value.hpp"

#include <QAccessibleWidget>
#include <QVariant>
#include <QWidget>

namespace pastoso::appearance {
namespace {

constexpr const char* kRole = "said_role";
constexpr const char* kValue = "said_value";

class SaidWidget : public QAccessibleWidget {
  public:
    SaidWidget(QWidget* widget, QAccessible::Role role) : QAccessibleWidget(widget, role) {}

    QString text(QAccessible::Text which) const override {
        return which == QAccessible::Value ? said_value(*widget()) : QAccessibleWidget::text(which);
    }
};

/// Null for widgets that Qt knows by itself.
QAccessibleInterface* make_said(const QString&, QObject* object) {
    auto* widget = qobject_cast<QWidget*>(object);
    if (widget == nullptr) return nullptr;
    const QVariant role = widget->property(kRole);
    return role.isValid() ? new SaidWidget(widget, static_cast<QAccessible::Role>(role.toInt()))
                          : nullptr;
}

}  // namespace

void say_as(QWidget& widget, QAccessible::Role role) {
    [[maybe_unused]] static const bool installed = [] {
        QAccessible::installFactory(make_said);
        return true;
    }();
    widget.setProperty(kRole, static_cast<int>(role));
}

void say_value(QWidget& widget, const QString& value) {
    if (said_value(widget) == value) return;
    widget.setProperty(kValue, value);
    QAccessibleValueChangeEvent changed(&widget, value);
    QAccessible::updateAccessibility(&changed);
}

QString said_value(const QWidget& widget) {
    return widget.property(kValue).toString();
}

}  // namespace pastoso::appearance
