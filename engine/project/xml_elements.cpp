#include "project/xml_elements.hpp"

#include "core/error.hpp"

#include <exception>
#include <expat.h>
#include <memory>
#include <type_traits>

namespace pastoso::project {
namespace {

constexpr int kMostNested = 32;

struct FreeParser {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
};

/// Nothing may be thrown through expat: what is thrown is kept until it has returned.
struct Reading {
    XML_Parser parser;
    const XmlHandler& handler;
    const std::string& name;
    int depth = 0;
    std::exception_ptr thrown{};

    long line() const { return static_cast<long>(XML_GetCurrentLineNumber(parser)); }

    template <class Work>
    void guarded(const Work& work) {
        if (thrown) return;
        try {
            work();
        } catch (...) {
            thrown = std::current_exception();
            XML_StopParser(parser, XML_FALSE);
        }
    }
};

void begin_element(void* data, const XML_Char* element, const XML_Char** attributes) {
    Reading& reading = *static_cast<Reading*>(data);
    reading.guarded([&] {
        if (++reading.depth > kMostNested)
            throw core::located_error(reading.name, reading.line(), "the elements are nested too deep.");
        XmlAttributes values;
        for (; *attributes != nullptr; attributes += 2)
            values.emplace(attributes[0], attributes[1]);
        reading.handler.begin(element, values, reading.line());
    });
}

void end_element(void* data, const XML_Char* element) {
    Reading& reading = *static_cast<Reading*>(data);
    reading.guarded([&] {
        --reading.depth;
        reading.handler.end(element);
    });
}

void refuse_type(void* data, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    Reading& reading = *static_cast<Reading*>(data);
    reading.guarded([&] {
        throw core::located_error(reading.name, reading.line(), "a document type is not read here.");
    });
}

}  // namespace

void read_xml(std::string_view text, const std::string& name, const XmlHandler& handler) {
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, FreeParser> parser(
        XML_ParserCreate("UTF-8"));
    if (!parser) throw std::bad_alloc();
    Reading reading{parser.get(), handler, name};
    XML_SetUserData(parser.get(), &reading);
    XML_SetElementHandler(parser.get(), begin_element, end_element);
    XML_SetStartDoctypeDeclHandler(parser.get(), refuse_type);
    const XML_Status status =
        XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
    if (reading.thrown) std::rethrow_exception(reading.thrown);
    if (status == XML_STATUS_OK) return;
    throw core::located_error(name, reading.line(), "this is not valid XML (%1).",
                              XML_ErrorString(XML_GetErrorCode(parser.get())));
}

}  // namespace pastoso::project
