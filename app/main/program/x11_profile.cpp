#include "main/program/x11_profile.hpp"

#include <cstdlib>
#include <memory>
#include <string_view>
#include <xcb/xcb.h>

#include <QGuiApplication>

namespace pastoso::main {
namespace {

template <class Reply>
using Answer = std::unique_ptr<Reply, decltype(&std::free)>;

xcb_atom_t profile_atom(xcb_connection_t* display) {
    constexpr std::string_view kName = "_ICC_PROFILE";
    const auto asked = xcb_intern_atom(display, 1, static_cast<uint16_t>(kName.size()), kName.data());
    const Answer<xcb_intern_atom_reply_t> answer(xcb_intern_atom_reply(display, asked, nullptr),
                                                 std::free);
    return answer == nullptr ? static_cast<xcb_atom_t>(XCB_ATOM_NONE) : answer->atom;
}

}  // namespace

std::string x11_profile() {
    constexpr uint32_t kMostWords = 1U << 22;
    const auto* x11 = qGuiApp->nativeInterface<QNativeInterface::QX11Application>();
    if (x11 == nullptr) return {};
    xcb_connection_t* display = x11->connection();
    const xcb_atom_t atom = profile_atom(display);
    if (atom == XCB_ATOM_NONE) return {};
    const xcb_window_t root = xcb_setup_roots_iterator(xcb_get_setup(display)).data->root;
    const auto asked = xcb_get_property(display, 0, root, atom, XCB_ATOM_ANY, 0, kMostWords);
    const Answer<xcb_get_property_reply_t> answer(xcb_get_property_reply(display, asked, nullptr),
                                                  std::free);
    if (answer == nullptr || answer->format != 8) return {};
    return {static_cast<const char*>(xcb_get_property_value(answer.get())),
            static_cast<std::size_t>(xcb_get_property_value_length(answer.get()))};
}

}  // namespace pastoso::main
