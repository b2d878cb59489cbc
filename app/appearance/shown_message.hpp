// What the engine tells, in the language of the window. Its sentences begin small, since many stand
// behind the name of a file.
#pragma once

#include "core/message.hpp"

#include <QString>

namespace pastoso::appearance {

/// As it stands within a sentence. What nobody has translated is English. May be asked for on any
/// thread.
QString shown_message(const core::Message& message);

/// With a capital at its beginning.
QString as_sentence(QString words);

/// As a sentence of its own.
QString shown_sentence(const core::Message& message);

}  // namespace pastoso::appearance
