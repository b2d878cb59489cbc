#include "project/stack_reader.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "document/layers.hpp"
#include "pigment/image.hpp"
#include "project/xml_elements.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace pastoso::project {
namespace {

using document::LayerLook;

constexpr double kFarthest_px = 1e6;
/// Ways to lay a picture over what is below: all of it, and only where something is.
constexpr const char *kOver = "svg:src-over", *kAtop = "svg:src-atop";
/// What programs write that know no resolution.
constexpr double kSaysNothing_dpi = 72.0;

/// The attributes of one element, with the place for errors.
struct Element {
    const XmlAttributes& attributes;
    const std::string& file;
    long line;

    [[noreturn]] void fail(const core::Message& message) const {
        throw core::located_error(file, line, message);
    }
    template <class... Arguments>
    [[noreturn]] void fail(core::Pattern<sizeof...(Arguments)> pattern,
                           const Arguments&... arguments) const {
        fail(core::message(pattern, arguments...));
    }

    std::string text(const char* key, const char* otherwise) const {
        const auto found = attributes.find(key);
        return found == attributes.end() ? otherwise : found->second;
    }

    double number(const char* key, double otherwise, double least, double most) const {
        const auto found = attributes.find(key);
        if (found == attributes.end()) return otherwise;
        const std::string& text = found->second;
        double value = 0.0;
        const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
            fail("expected a number for \"%1\".", key);
        if (value < least || value > most)
            fail("\"%1\" is %2, but must lie between %3 and %4.", key, value, least, most);
        return value;
    }

    int whole(const char* key, double otherwise, double least, double most) const {
        return static_cast<int>(std::lround(number(key, otherwise, least, most)));
    }
};

/// Cut before a letter of UTF-8, not within one.
std::string shortened(std::string name) {
    if (name.size() <= document::kMostLayerName) return name;
    std::size_t end = document::kMostLayerName;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U)
        --end;
    name.resize(end);
    return name;
}

LayerLook look_of(const Element& element, const char* otherwise) {
    LayerLook look;
    look.name = shortened(element.text("name", otherwise));
    look.visible = element.text("visibility", "visible") != "hidden";
    look.opacity = element.number("opacity", 1.0, 0.0, 1.0);
    return look;
}

/// A layer in a group that is none of its own in Pastoso.
void put_into(LayerLook& look, const LayerLook& group) {
    look.visible = look.visible && group.visible;
    look.opacity *= group.opacity;
}

class StackReader {
  public:
    explicit StackReader(const std::string& file) : file_(file) {}

    void begin(const std::string& name, const XmlAttributes& attributes, long line) {
        const Element element{attributes, file_, line};
        if (path_.empty()) {
            if (name != "image") element.fail("this is no list of layers; it would begin with <image>.");
            read_image(element);
        } else if (name == "stack") {
            begin_stack(element);
        } else if (name == "layer") {
            read_layer(element);
        } else {
            note(core::message("<%1> is left out.", name));
        }
        path_.push_back(name);
    }

    void end(const std::string& name) {
        path_.pop_back();
        if (name == "stack" && !stacks_.empty()) stacks_.pop_back();
    }

    RasterStack take() {
        std::reverse(stack_.pictures.begin(), stack_.pictures.end());
        return std::move(stack_);
    }

  private:
    void read_image(const Element& element) {
        if (!element.attributes.contains("w") || !element.attributes.contains("h"))
            element.fail("the size of the picture is missing.");
        stack_.width = element.whole("w", 0, 1, pigment::kMostPictureSide_px);
        stack_.height = element.whole("h", 0, 1, pigment::kMostPictureSide_px);
        const double x_dpi = element.number("xres", kSaysNothing_dpi, 1.0, 1e5);
        const double y_dpi = element.number("yres", x_dpi, 1.0, 1e5);
        if (x_dpi == kSaysNothing_dpi) return;
        stack_.px_per_mm_x = x_dpi / core::kInch_mm;
        stack_.px_per_mm_y = y_dpi / core::kInch_mm;
    }

    /// The outermost stack is the picture itself, those in it are groups, and what is in these is flat.
    void begin_stack(const Element& element) {
        stacks_.push_back(look_of(element, "Group"));
        check_way(element, stacks_.back().name);
        if (stacks_.size() == 2) stack_.groups.push_back(stacks_.back());
        if (stacks_.size() == 3)
            note(
                core::message("the groups within \"%1\" become part of it.", stack_.groups.back().name));
    }

    void read_layer(const Element& element) {
        if (stack_.pictures.size() == document::kMostLayers)
            element.fail("there are more than %1 layers.", document::kMostLayers);
        StackPicture picture{.source = element.text("src", ""), .look = look_of(element, "Layer")};
        if (picture.source.empty()) {
            note(core::message("\"%1\" holds no picture and is left out.", picture.look.name));
            return;
        }
        picture.look.clipped = element.text("composite-op", kOver) == kAtop;
        if (!picture.look.clipped) check_way(element, picture.look.name);
        for (std::size_t depth = 2; depth < stacks_.size(); ++depth)
            put_into(picture.look, stacks_[depth]);
        picture.x = element.whole("x", 0, -kFarthest_px, kFarthest_px);
        picture.y = element.whole("y", 0, -kFarthest_px, kFarthest_px);
        picture.group = stacks_.size() > 1 ? stack_.groups.size() : 0;
        stack_.pictures.push_back(std::move(picture));
    }

    void check_way(const Element& element, const std::string& name) {
        const std::string way = element.text("composite-op", kOver);
        if (way != kOver)
            note(core::message("\"%1\" was laid over the others by %2 and is laid over them as paint.",
                               name, shortened(way)));
    }

    void note(core::Message sentence) {
        constexpr std::size_t kMostNotes = 20;
        const auto& notes = stack_.notes;
        if (notes.size() < kMostNotes && std::find(notes.begin(), notes.end(), sentence) == notes.end())
            stack_.notes.push_back(std::move(sentence));
    }

    const std::string& file_;
    std::vector<std::string> path_;  ///< of the elements around the place
    std::vector<LayerLook> stacks_;  ///< of those around the place
    RasterStack stack_;
};

}  // namespace

RasterStack read_stack(std::string_view xml, const std::string& name) {
    PASTOSO_CHECK_OP(xml.size(), <=, kMostStackBytes);
    StackReader reader(name);
    read_xml(xml, name,
             {[&](const std::string& element, const XmlAttributes& attributes, long line) {
                  reader.begin(element, attributes, line);
              },
              [&](const std::string& element) { reader.end(element); }});
    return reader.take();
}

}  // namespace pastoso::project
