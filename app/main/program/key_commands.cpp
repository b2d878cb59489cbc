#include "main/program/key_commands.hpp"

#include "commands/command_names.hpp"
#include "core/error.hpp"
#include "core/user_data.hpp"
#include "dialogs/command_palette.hpp"
#include "dialogs/keys_dialog.hpp"
#include "main/program/findable.hpp"
#include "tools/key_settings.hpp"

#include <algorithm>
#include <utility>

#include <QMainWindow>

namespace pastoso::main {
namespace {

using commands::Command;
using commands::KeyBindings;

std::optional<commands::KeySet> set_named(const std::string& name) {
    for (const commands::KeySetText& set : commands::key_sets())
        if (set.name == name) return set.set;
    return std::nullopt;
}

QKeySequence key_of(const std::string& text) {
    return QKeySequence::fromString(QString::fromStdString(text), QKeySequence::PortableText);
}

void check_set(const std::string& name) {
    if (!set_named(name))
        throw core::InputError("\"%1\" is not one of pastoso, krita and photoshop.", name);
}

void check_key(const std::string& text) {
    const QKeySequence key = key_of(text);
    const bool known = key.count() == 1 && key[0].key() != Qt::Key_unknown;
    if (!known) throw core::InputError("\"%1\" is not a key such as Ctrl+Shift+Z.", text);
    if (commands::is_reserved(key))
        throw core::InputError("\"%1\" is needed on the canvas itself.", text);
}

tools::KeySettings settings_of(const KeyBindings& bindings) {
    tools::KeySettings settings;
    for (const commands::KeySetText& set : commands::key_sets())
        if (set.set == bindings.set()) settings.set = set.name;
    for (const auto& [command, keys] : bindings.own()) {
        auto& texts = settings.own[std::string(commands::name_of(command))];
        for (const QKeySequence& key : keys)
            texts.push_back(key.toString(QKeySequence::PortableText).toStdString());
    }
    return settings;
}

KeyBindings bindings_of(const tools::KeySettings& settings) {
    std::map<Command, KeyBindings::Keys> own;
    for (const auto& [name, texts] : settings.own) {
        const auto command = commands::command_named(name);
        if (!command) continue;
        KeyBindings::Keys& keys = own[*command];
        for (const std::string& text : texts)
            keys.append(key_of(text));
    }
    return KeyBindings(set_named(settings.set).value_or(commands::KeySet::Pastoso), std::move(own));
}

}  // namespace

KeyCommands::KeyCommands(Studio& studio, const PanelSet& panels)
    : studio_(studio),
      palette_(new dialogs::CommandPalette(studio.commands(), &studio.window())),
      file_(studio, core::user_config_path("keys.json")) {
    palette_->offer_also([this, panels] { return findable(studio_.commands(), panels); });
    studio_.commands().on(Command::FindCommand, [this](bool) { palette_->open_over(studio_.canvas()); });
    studio_.commands().on(Command::EditKeys, [this](bool) { edit(); });
}

void KeyCommands::recall() {
    file_.recall([this](const auto& file) {
        const tools::KeySettings settings =
            tools::read_key_settings(file, {.set = check_set, .key = check_key});
        studio_.commands().use_keys(bindings_of(settings));
        unknown_ = settings.own;
        std::erase_if(unknown_, [](const auto& own) { return commands::command_named(own.first); });
    });
}

void KeyCommands::edit() {
    dialogs::KeysDialog dialog(studio_.commands().keys(), &studio_.window());
    connect(&dialog, &dialogs::KeysDialog::changed, this, &KeyCommands::use);
    dialog.exec();
}

void KeyCommands::use(const KeyBindings& bindings) {
    studio_.commands().use_keys(bindings);
    remember();
}

/// But for keys that the painter has given to a command since.
void KeyCommands::add_unknown(tools::KeySettings& settings) const {
    const auto is_taken = [this](const std::string& key) {
        return studio_.commands().keys().holder(key_of(key)).has_value();
    };
    for (auto [name, keys] : unknown_) {
        std::erase_if(keys, is_taken);
        settings.own[name] = std::move(keys);
    }
}

void KeyCommands::remember() {
    tools::KeySettings settings = settings_of(studio_.commands().keys());
    add_unknown(settings);
    file_.remember([&settings](const auto& file) { tools::write_key_settings(settings, file); });
}

}  // namespace pastoso::main
