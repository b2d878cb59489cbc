#include "architecture/include_rules.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

namespace pastoso::tests {
namespace {

using Folders = std::set<std::string, std::less<>>;
using Rules = std::map<std::string, Folders, std::less<>>;

/// The folders of the project that each engine folder may use besides its own.
const Rules& engine_rules() {
    static const Rules rules = {
        {"core", {}},
        {"grid", {"core"}},
        {"packing", {"core", "grid"}},
        {"pigment", {"core"}},
        {"film", {"core", "grid", "pigment"}},
        {"liquid", {"core", "grid"}},
        {"tank", {"core", "grid", "liquid"}},
        {"brush", {"core", "grid", "pigment", "film"}},
        {"layers", {"core", "grid", "pigment", "film"}},
        {"shade", {"core", "grid", "pigment", "film"}},
        {"trace", {"core", "grid", "pigment", "liquid"}},
        {"gpu", {"core", "grid", "pigment", "film", "shade"}},
        {"document", {"core", "grid", "packing", "pigment", "film", "brush", "layers", "shade"}},
        {"io",
         {"core", "grid", "packing", "pigment", "film", "brush", "layers", "shade", "document",
          "liquid", "tank", "trace"}},
        {"project",
         {"core", "grid", "packing", "pigment", "film", "brush", "layers", "shade", "document", "io"}},
        {"journal",
         {"core", "grid", "packing", "pigment", "film", "brush", "layers", "shade", "document", "io",
          "project"}},
    };
    return rules;
}

/// The same for the folders of the window, which may use the whole engine besides.
const Rules& app_rules() {
    static const Rules rules = {
        {"arguments", {}},
        {"cli", {"arguments"}},
        {"appearance", {}},
        {"crash", {}},
        {"graphics", {}},
        {"session", {}},
        {"commands", {"appearance", "session"}},
        {"tools", {"session"}},
        {"view", {"appearance", "graphics", "session", "commands", "tools"}},
        {"panels", {"appearance", "session", "commands", "tools"}},
        {"dialogs", {"appearance", "session", "commands", "tools"}},
        {"start", {"appearance", "session", "commands", "tools", "dialogs"}},
        {"glass", {"appearance", "graphics", "session", "commands", "tools", "panels"}},
        {"main",
         {"arguments", "appearance", "crash", "graphics", "session", "commands", "tools", "view",
          "panels", "dialogs", "start", "glass"}},
    };
    return rules;
}

struct Place {
    std::string part;    ///< "engine" or "app"
    std::string folder;  ///< within the part
};

std::optional<Place> place_of(std::string_view path) {
    static const std::regex kPlace("(engine|app)/([^/]+)/.+");
    std::cmatch match;
    if (!std::regex_match(path.begin(), path.end(), match, kPlace)) return std::nullopt;
    return Place{match[1], match[2]};
}

struct Include {
    int line;
    bool quoted;  ///< "name", not <name>
    std::string name;
};

std::vector<Include> includes_of(std::string_view text) {
    static const std::regex kInclude("\\s*#\\s*include\\s*([\"<])([^\">]+)[\">].*");
    std::vector<Include> includes;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::smatch match;
        if (std::regex_match(line, match, kInclude))
            includes.push_back({number, match[1] == "\"", match[2]});
    }
    return includes;
}

/// Qt's headers: <QWidget>, <QtCore/qglobal.h>, <qpa/...>, <private/q...>, quoted or not.
bool is_qt(const std::string& name) {
    static const std::regex kQt("(Q[A-Zt].*|qpa/.*|private/q.*|q[a-z0-9_]+\\.h)");
    return std::regex_match(name, kQt);
}

/// Why the place may not include the name; empty when it may.
std::string objection(const Place& place, const Include& include) {
    const bool in_engine = place.part == "engine";
    if (is_qt(include.name)) {
        return in_engine || place.folder == "cli" ? "Qt belongs to the window alone" : "";
    }
    if (include.name.starts_with("OpenImageIO/")) {
        return in_engine && place.folder == "io" ? "" : "OpenImageIO belongs to engine/io alone";
    }
    if (include.name.starts_with("lcms2")) {
        return in_engine && place.folder == "io" ? "" : "LittleCMS belongs to engine/io alone";
    }
    if (include.name.starts_with("embree3/")) {
        return in_engine && place.folder == "trace" ? "" : "Embree belongs to engine/trace alone";
    }
    if (include.name == "zip.h") {
        return in_engine && place.folder == "project" ? "" : "libzip belongs to engine/project alone";
    }
    if (include.name == "zstd.h") {
        return in_engine && place.folder == "packing" ? "" : "zstd belongs to engine/packing alone";
    }
    if (!include.quoted || include.name.ends_with(".moc")) return "";

    const std::size_t slash = include.name.find('/');
    if (slash == std::string::npos) return "the project's headers are named with their folder";
    const std::string used = include.name.substr(0, slash);
    if (used == place.folder) return "";
    if (!in_engine && engine_rules().contains(used)) return "";
    const Rules& rules = in_engine ? engine_rules() : app_rules();
    return rules.at(place.folder).contains(used) ? "" : place.folder + " may not use " + used;
}

}  // namespace

std::vector<std::string> include_violations(std::string_view path, std::string_view text) {
    const std::optional<Place> place = place_of(path);
    if (!place) return {std::string(path) + ": lies in no folder of engine or app"};
    const Rules& rules = place->part == "engine" ? engine_rules() : app_rules();
    if (!rules.contains(place->folder)) {
        return {std::string(path) + ": the folder has no entry in the table of include rules"};
    }
    std::vector<std::string> violations;
    for (const Include& include : includes_of(text)) {
        const std::string reason = objection(*place, include);
        if (reason.empty()) continue;
        violations.push_back(std::string(path) + ":" + std::to_string(include.line) + ": includes " +
                             include.name + ", but " + reason);
    }
    return violations;
}

}  // namespace pastoso::tests
