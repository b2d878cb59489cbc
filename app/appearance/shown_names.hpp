// What ships by name, in the painter's language. Files and the engine know tools, paints and media by
// their English names; only what is shown is translated.
#pragma once

#include <span>
#include <string_view>

#include <QString>

namespace pastoso::appearance {

/// What the painter reads in place of a name, or of a sentence, from the files that ship. A name that
/// the painter gave stays as it is.
QString shown_name(std::string_view name);
QString shown_name(const QString& name);

/// The same with a capital, as it stands alone in a list.
QString shown_title(std::string_view name);

/// Every name that shown_name() can translate; a test compares them with the files.
std::span<const char* const> translated_names();

}  // namespace pastoso::appearance
