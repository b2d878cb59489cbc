// Which page of the manual explains what one sees in the window.
#pragma once

#include <span>

#include <QString>

class QWidget;

namespace pastoso::help {

struct Topic {
    const char* widget;  ///< the name of its class, with its namespaces
    const char* page;    ///< as links in the manual name it: "paint", "paint#the-mixing-well"
};

/// Of all widgets that a page is about.
std::span<const Topic> topics();

/// Sets the page of a widget that is for something else than others of its class.
void set_topic(QWidget& widget, const char* page);

/// Of the innermost widget around this one that there is a topic of; empty: of none.
QString topic_of(const QWidget* widget);

}  // namespace pastoso::help
