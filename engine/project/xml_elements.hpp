// XML read element by element, by expat.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace pastoso::project {

using XmlAttributes = std::map<std::string, std::string>;

/// What is told of a text; what is thrown in here ends the reading.
struct XmlHandler {
    std::function<void(const std::string& element, const XmlAttributes& attributes, long line)> begin;
    std::function<void(const std::string& element)> end;
};

/// Reads a whole text of UTF-8. Throws InputError "NAME, line N: ..." when it is no well-formed XML, has
/// a document type (from which entities could unfold) or more than 32 elements within one another.
void read_xml(std::string_view text, const std::string& name, const XmlHandler& handler);

}  // namespace pastoso::project
