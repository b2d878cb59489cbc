// What a screen reader says of a widget that draws itself: what kind of thing it is, and how it stands.
#pragma once

#include <QAccessible>

class QString;
class QWidget;

namespace pastoso::appearance {

/// Once for a widget, before anybody asks what it is. Its name and its description are those that
/// QWidget knows.
void say_as(QWidget& widget, QAccessible::Role role);

/// How it stands now, in words; told to the screen reader where that is something else than before. The
/// widget has been given a role.
void say_value(QWidget& widget, const QString& value);

/// What was said last.
QString said_value(const QWidget& widget);

}  // namespace pastoso::appearance
