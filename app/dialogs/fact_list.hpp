// A list of facts on a page, to be read and copied.
#pragma once

#include <utility>
#include <vector>

#include <QString>

class QWidget;

namespace pastoso::dialogs {

/// What, and how it is.
using Fact = std::pair<QString, QString>;

/// A line for each, and a button that copies them all.
QWidget* fact_list(const std::vector<Fact>& facts);

}  // namespace pastoso::dialogs
