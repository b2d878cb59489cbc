// A list of facts on a page, to be read and copied.
#pragma once

#include <utility>
#include <vector>

#include <QString>

class QWidget;

namespace pastoso::dialogs {

/// What, and how it is.
using Fact = std::pair<QString, QString>;

/// "Processor: 8 at once", a line for each.
QString words_of(const std::vector<Fact>& facts);

/// A line for each, and a button that copies them all.
QWidget* fact_list(const std::vector<Fact>& facts);

}  // namespace pastoso::dialogs
