#include "main/liquids/tank_mode.hpp"

#include "glass/glass_chooser.hpp"
#include "liquid_files/tank_json.hpp"
#include "main/liquids/tank_surface_file.hpp"
#include "main/queued_refresh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QAction>
#include <QCoreApplication>
#include <QFileDialog>
#include <QMainWindow>
#include <glm/common.hpp>

namespace pastoso::main {
namespace {

using commands::Command;

constexpr double kTurn_deg = 15.0, kStronger_m_s = 0.5;
constexpr const char* kFalling = "falling-liquid";
constexpr const char* kTwoLiquids = "two-liquids";

constexpr std::pair<Command, const char*> kButtonWords[] = {
    {Command::TankRestart, QT_TR_NOOP("Start again")},
    {Command::TankOpenScene, QT_TR_NOOP("Open")},
    {Command::TankBall, QT_TR_NOOP("Ball")},
    {Command::TankDrain, QT_TR_NOOP("Drain")},
    {Command::TankWind, QT_TR_NOOP("Wind")},
    {Command::TankVelocity, QT_TR_NOOP("Velocities")},
    {Command::TankExportAll, QT_TR_NOOP("Export all moments...")},
    {Command::TankRender, QT_TR_NOOP("Render a picture...")},
    {Command::TankRecordPictures, QT_TR_NOOP("Pictures")},
    {Command::TankRecordSurfaces, QT_TR_NOOP("Surfaces")},
};

Command command_of(Recorded what) {
    return what == Recorded::Pictures ? Command::TankRecordPictures : Command::TankRecordSurfaces;
}

}  // namespace

TankMode::TankMode(Studio& studio, PictureLayers& pictures, CanvasPlace& place)
    : GlassMode(studio, pictures, place, {commands::Mode::Tank, Command::GlassTank, Command::TankRender},
                words()) {
    connect_commands();
    connect_wind();
}

GlassWords TankMode::words() {
    return {
        .name = tr("Glass tank"),
        .picture = {.name = QStringLiteral("tank_picture"),
                    .title = tr("Picture of the tank"),
                    .hint = tr("The tank as it is seen in the window, traced along the light's ways "
                               "through glass and liquid. Choose a size and press Render."),
                    .file = QStringLiteral("tank.png"),
                    .size = {960, 720},
                    .has_milk_body = false},
        .export_title = tr("Export the liquid's surface"),
        .export_file = QStringLiteral("liquid_0001.obj"),
        .exported = tr("The liquid's surface is in %1."),
    };
}

void TankMode::connect_commands() {
    for (const auto& [command, words] : kButtonWords)
        action(command)->setIconText(QCoreApplication::translate("pastoso::main", words));
    on_here(Command::TankFalling, [this](bool) { choose(QString::fromLatin1(kFalling)); });
    on_here(Command::TankTwoLiquids, [this](bool) { choose(QString::fromLatin1(kTwoLiquids)); });
    on_here(Command::TankOpenScene, [this](bool) { ask_open(); });
    on_here(Command::TankRestart, [this](bool) { session_->start_again(scene_); });
    on_here(Command::TankBall, [this](bool) { drop_ball(0.5F * glm::vec2(scene_.size_m())); });
    on_here(Command::TankDrain, [this](bool open) { session_->open_drains(open); });
    on_here(Command::TankVelocity, [this](bool shown) { page_->view().show_velocity(shown); });
    on_here(Command::TankExportAll, [this](bool) { ask_export_all(); });
    for (const Recorded what : kRecorded)
        on_here(command_of(what),
                [this, what](bool on) { on ? ask_record(what) : recorder_->stop(what); });
}

void TankMode::connect_wind() {
    const commands::CommandRegistry& commands = studio().commands();
    commands.on(Command::TankWind, [this](bool on) {
        session::TankWind wind = wind_;
        wind.on = on;
        use_wind(wind);
    });
    commands.on(Command::TankWindLeft, [this](bool) { turn_wind(kTurn_deg); });
    commands.on(Command::TankWindRight, [this](bool) { turn_wind(-kTurn_deg); });
    commands.on(Command::TankWindStronger, [this](bool) { blow_harder(kStronger_m_s); });
    commands.on(Command::TankWindWeaker, [this](bool) { blow_harder(-kStronger_m_s); });
}

void TankMode::make_page() {
    page_ = new glass::TankPage({.glass = page_actions(),
                                 .restart = action(Command::TankRestart),
                                 .open = action(Command::TankOpenScene),
                                 .ball = action(Command::TankBall),
                                 .drain = action(Command::TankDrain),
                                 .wind = action(Command::TankWind),
                                 .left = action(Command::TankWindLeft),
                                 .right = action(Command::TankWindRight),
                                 .stronger = action(Command::TankWindStronger),
                                 .weaker = action(Command::TankWindWeaker),
                                 .velocity = action(Command::TankVelocity),
                                 .export_mesh = action(Command::LiquidExportMesh),
                                 .export_all = action(Command::TankExportAll),
                                 .render = action(Command::TankRender),
                                 .record_pictures = action(Command::TankRecordPictures),
                                 .record_surfaces = action(Command::TankRecordSurfaces)});
    add_page({Command::TankWindLeft, Command::TankWindRight, Command::TankWindStronger,
              Command::TankWindWeaker});
    glass::TankPanel& panel = page_->panel();
    connect(&panel.chooser(), &glass::GlassChooser::chosen, this, &TankMode::choose);
    connect(&panel, &glass::TankPanel::wind_changed, this, &TankMode::use_wind);
    connect(&panel, &glass::TankPanel::numbers_changed, this, [this](const tank::TankScene& numbers) {
        for (const tank::TankNumber& number : tank::tank_numbers())
            scene_.*number.value = numbers.*number.value;
        session_->set_numbers(numbers);
    });
    connect(&panel, &glass::TankPanel::ball_changed, this,
            [this](const glass::TankBall& ball) { page_->view().set_ball_radius(ball.radius_m); });
    connect(&page_->view(), &glass::TankView::ball_wanted, this, &TankMode::drop_ball);
}

// ---- coming and going

void TankMode::make_ready() {
    if (page_ == nullptr) make_page();
    if (key_.isEmpty()) {
        key_ = QString::fromLatin1(kFalling);
        scene_ = liquid_files::read_tank(kFalling);
    }
    if (session_ == nullptr) begin_session();
    page_->panel().chooser().show_choice(key_);
}

void TankMode::begin_session() {
    session_ = std::make_unique<session::TankSession>(
        scene_, false, queued_refresh(this, [this] { show_published(); }));
    recorder_ = std::make_unique<TankRecorder>(*session_, page_->view());
    connect(recorder_.get(), &TankRecorder::progressed, this, &TankMode::show_recorded);
    connect(recorder_.get(), &TankRecorder::ended, this, [this](Recorded what, const QString& told) {
        action(command_of(what))->setChecked(false);
        show_recorded();
        studio().report_refusal(told);
    });
}

void TankMode::put_away() {
    GlassMode::put_away();
    for (const Recorded what : kRecorded)
        recorder_->stop(what);
}

void TankMode::choose(const QString& key) {
    if (key == glass::GlassChooser::tea_key()) {
        Q_EMIT tea_wanted();
        return;
    }
    if (key.isEmpty()) return ask_open();
    if (page_ != nullptr) page_->panel().chooser().show_choice(key_);
    studio().attempt(tr("Open a tank"), [&] { open_scene(key); });
}

void TankMode::open_scene(const QString& path_or_name) {
    scene_ = liquid_files::read_tank(path_or_name.toStdString());
    key_ = path_or_name;
    if (session_ != nullptr) session_->new_tank(scene_);
    enter();
    page_->panel().chooser().show_choice(key_);
    page_->view().setFocus();
}

void TankMode::ask_open() {
    const QString path = QFileDialog::getOpenFileName(&studio().window(), tr("Open a tank"), {},
                                                      tr("Scenes of a tank (*.json);;All files (*)"));
    if (!path.isEmpty()) choose(path);
}

// ---- what is published

void TankMode::show_published() {
    const bool refused = tell_refusals();
    const auto [status, snapshot] = session_->published();
    if (snapshot) {
        page_->view().show_moment(snapshot);
        recorder_->look(snapshot);
        // What was refused is not to be read as if it held.
        if (refused || status.glass != shown_glass_) show_tank(status);
    }
    page_->show_status(status);
    show_running(status);
}

void TankMode::show_tank(const session::TankStatus& status) {
    shown_glass_ = status.glass;
    page_->panel().show_scene(scene_);
    page_->view().set_ball_radius(page_->panel().ball().radius_m);
    wind_ = status.wind;
    page_->panel().show_wind(wind_);
    page_->view().show_wind(wind_);
    action(Command::TankWind)->setChecked(wind_.on);
    action(Command::TankDrain)->setChecked(status.drains_open);
}

// ---- what is done to the liquid

void TankMode::drop_ball(const glm::vec2& at_m) {
    const glass::TankBall& ball = page_->panel().ball();
    const glm::vec3 size_m = scene_.size_m();
    const glm::vec3 margin_m = glm::min(glm::vec3(1.02F * ball.radius_m), 0.5F * size_m);
    const glm::vec3 centre_m = glm::clamp(glm::vec3(at_m, size_m.z), margin_m, size_m - margin_m);
    session_->add_sphere({centre_m, ball.radius_m}, ball.milk);
}

void TankMode::use_wind(const session::TankWind& wind) {
    wind_ = wind;
    session_->set_wind(wind);
    page_->panel().show_wind(wind);
    page_->view().show_wind(wind);
    action(Command::TankWind)->setChecked(wind.on);
}

void TankMode::turn_wind(double by_deg) {
    session::TankWind wind = wind_;
    wind.direction_deg = std::remainder(wind.direction_deg + by_deg, 360.0);
    use_wind(wind);
}

void TankMode::blow_harder(double by_m_s) {
    session::TankWind wind = wind_;
    wind.speed_m_s = std::clamp(wind.speed_m_s + by_m_s, 0.0, tank::kMostSpeed_m_s);
    use_wind(wind);
}

// ---- pictures

session::LiquidPictureOrder TankMode::picture_order() const {
    session::LiquidPictureOrder order;
    if (const auto snapshot = session_->snapshot())
        order.scene = [snapshot, camera = page_->view().camera().traced()](core::ThreadPool& pool,
                                                                           trace::MilkBody) {
            return session::traced_tank(*snapshot, camera, pool);
        };
    return order;
}

void TankMode::ask_record(Recorded what) {
    const QString folder = QFileDialog::getExistingDirectory(
        &studio().window(), what == Recorded::Pictures ? tr("A folder for pictures of every step")
                                                       : tr("A folder for surfaces of every step"));
    if (folder.isEmpty())
        action(command_of(what))->setChecked(false);
    else
        record(what, folder);
}

void TankMode::record(Recorded what, const QString& folder) {
    action(command_of(what))->setChecked(true);
    recorder_->start(what, folder);
}

void TankMode::show_recorded() {
    QStringList parts;
    if (recorder_->records(Recorded::Pictures))
        parts << tr("%n picture(s) written", nullptr, recorder_->written(Recorded::Pictures));
    if (recorder_->records(Recorded::Surfaces))
        parts << tr("%n surface(s) written", nullptr, recorder_->written(Recorded::Surfaces));
    page_->panel().show_recorded(parts.join(QLatin1Char('\n')));
}

// ---- surfaces

GlassMode::MeshWriter TankMode::mesh_writer() const {
    const auto snapshot = session_->snapshot();
    if (snapshot == nullptr) return {};
    return [snapshot](const std::filesystem::path& file, const BackgroundExport::Stops& stops) {
        core::ThreadPool pool;
        return write_tank_surface(*snapshot->place, snapshot->seen, file, pool, stops);
    };
}

void TankMode::ask_export_all() {
    const QString folder =
        QFileDialog::getExistingDirectory(&studio().window(), tr("A folder for all moments"));
    if (!folder.isEmpty()) export_all(folder);
}

void TankMode::export_all(const QString& folder) {
    const session::TankSession::Kept kept = session_->kept();
    if (kept.place == nullptr) return;
    const std::vector<int> steps = kept.frames.steps();
    const QString told = tr("All surfaces are in %1.").arg(folder);
    background().start([kept, steps, told, folder](const BackgroundExport::Stops& stops) {
        core::ThreadPool pool;
        int number = 0;
        for (const int step : steps) {
            const QString name = QStringLiteral("/liquid_%1.obj").arg(++number, 4, 10, QLatin1Char('0'));
            const std::filesystem::path file = (folder + name).toStdString();
            if (write_tank_surface(*kept.place, kept.frames.at(step), file, pool, stops) ==
                files::ExportStatus::Stopped)
                return QString();
        }
        return told;
    });
}

}  // namespace pastoso::main
