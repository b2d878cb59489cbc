#include "tools/key_settings.hpp"

#include "tools/memory_file.hpp"

#include <utility>

namespace pastoso::tools {
namespace {

using files::Json;
using files::JsonPlace;

constexpr int kVersion = 1;

void read_own(const JsonPlace& place, const KeyChecks& checks, KeySettings& settings) {
    std::map<std::string, std::string> holders;
    for (std::size_t i = 0; i < place.size(); ++i) {
        const JsonPlace entry = place.element(i), keys = entry.entry("keys");
        entry.allow_only({"command", "keys"});
        const std::string command = entry.entry("command").text();
        const auto [own, is_new] = settings.own.try_emplace(command);
        if (!is_new) entry.fail("\"%1\" stands here twice.", command);
        for (std::size_t k = 0; k < keys.size(); ++k) {
            const JsonPlace key = keys.element(k);
            const std::string text = key.text();
            key.guard([&] { checks.key(text); });
            const auto [holder, is_free] = holders.try_emplace(text, command);
            if (!is_free) key.fail("\"%1\" is the key of %2 already.", text, holder->second);
            own->second.push_back(text);
        }
    }
}

}  // namespace

KeySettings read_key_settings(const std::filesystem::path& file, const KeyChecks& checks) {
    KeySettings settings;
    read_memory(file, kVersion, [&](const JsonPlace& root) {
        root.allow_only({"version", "set", "own"});
        const JsonPlace set = root.entry("set");
        settings.set = set.text();
        set.guard([&] { checks.set(settings.set); });
        read_own(root.entry("own"), checks, settings);
    });
    return settings;
}

void write_key_settings(const KeySettings& settings, const std::filesystem::path& file) {
    Json own = Json::array();
    for (const auto& [command, keys] : settings.own)
        own.push_back({{"command", command}, {"keys", keys}});
    write_memory({{"version", kVersion}, {"set", settings.set}, {"own", std::move(own)}}, file);
}

}  // namespace pastoso::tools
