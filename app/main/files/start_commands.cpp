#include "main/files/start_commands.hpp"

#include "commands/recent_paintings.hpp"
#include "journal/recovery.hpp"
#include "main/canvas/message_place.hpp"
#include "main/files/project_files.hpp"
#include "start/examples_section.hpp"
#include "start/new_canvas_section.hpp"
#include "start/recent_section.hpp"
#include "start/start_page.hpp"
#include "start/unfinished_section.hpp"

#include <QAction>
#include <QMainWindow>

namespace pastoso::main {

using commands::Command;

StartCommands::StartCommands(Studio& studio, ProjectFiles& files, const MessagePlace& messages)
    : studio_(studio), files_(files), messages_(messages) {
    studio_.commands().on(Command::StartPage, [this](bool) { show_page(); });
    studio_.commands().on(Command::ClosePainting,
                          [this](bool) { files_.ask_to_close([this] { show_page(); }); });
    studio_.commands().on(Command::CanvasOnly, [this](bool) { dismiss(); });
    for (const Command liquid : {Command::MilkTea, Command::GlassTank})
        studio_.commands().on(liquid, [this](bool) { dismiss(); });
    connect(&studio_, &Studio::session_begun, this, &StartCommands::dismiss);
    connect(&studio_.on_canvas().paint, &interactions::Paint::stroke_begun, this,
            &StartCommands::dismiss);
    connect(&studio_.canvas(), &view::CanvasView::escaped, this, &StartCommands::dismiss);
    connect(&messages_, &MessagePlace::free_canvas_changed, this, &StartCommands::place);
}

void StartCommands::show_page() {
    page().open(messages_.free_canvas(), studio_.session().canvas(), files_.begun(),
                studio_.live_px_per_mm(), commands::known_paintings(),
                journal::unfinished_paintings(journal::journals_path()));
}

void StartCommands::welcome() {
    if (shown_at_start_)
        show_page();
    else
        files_.offer_recovery();
}

start::StartPage& StartCommands::page() {
    if (page_ == nullptr) {
        page_ = new start::StartPage(studio_.canvas().parentWidget());
        page_->set_shown_at_start(shown_at_start_);
        connect_choices(*page_);
    }
    return *page_;
}

void StartCommands::connect_choices(start::StartPage& page) {
    using start::NewCanvasSection, start::RecentSection, start::UnfinishedSection;
    connect(&page, &start::StartPage::dismissed, this, &StartCommands::dismiss);
    connect(page.new_canvas(), &NewCanvasSection::wanted, &files_, &ProjectFiles::ask_to_put_up);
    connect(page.new_canvas(), &NewCanvasSection::more_wanted, &files_, &ProjectFiles::ask_new_canvas);
    connect(page.recent(), &RecentSection::wanted, &files_, [this](const std::filesystem::path& path) {
        files_.ask_to_open(QString::fromStdString(path.string()));
    });
    connect(page.recent(), &RecentSection::open_wanted, &files_, &ProjectFiles::ask_open_painting);
    connect(page.recent(), &RecentSection::removal_wanted, this,
            [&page](const std::filesystem::path& path) {
                commands::forget_painting(path);
                page.show_recent(commands::known_paintings());
            });
    connect(page.unfinished(), &UnfinishedSection::wanted, &files_, &ProjectFiles::ask_to_recover);
    connect(page.unfinished(), &UnfinishedSection::all_wanted, this, [this, &page] {
        files_.offer_recovery();
        if (page.isVisible())
            page.show_unfinished(journal::unfinished_paintings(journal::journals_path()));
    });
    connect(page.examples(), &start::ExamplesSection::wanted, &files_,
            [this](const start::ExamplePainting& example) { files_.ask_to_watch(example.strokes); });
}

/// The canvas takes the keys, as if the page had never been there.
void StartCommands::dismiss() {
    if (!page_is_shown()) return;
    page_->hide();
    studio_.canvas().setFocus();
    Q_EMIT dismissed();
}

bool StartCommands::page_is_shown() const {
    return page_ != nullptr && !page_->isHidden();
}

void StartCommands::set_shown_at_start(bool shown) {
    shown_at_start_ = shown;
    if (page_ != nullptr) page_->set_shown_at_start(shown);
}

bool StartCommands::shown_at_start() const {
    return page_ != nullptr ? page_->shown_at_start() : shown_at_start_;
}

/// The page stays over the canvas wherever the panels leave it.
void StartCommands::place() {
    if (page_is_shown()) page_->lie_on(messages_.free_canvas());
}

}  // namespace pastoso::main
