// Recording and playing flights in the window. Read session/flight_recorder.h and session/replay.h first.
#include "platform/file.h"
#include "text/catalogue.h"
#include "ui/parts/look.h"
#include "ui/window/workbench.h"

namespace viewing {

void Workbench::follow_flights(Session& session, double dt_s) {
    if (recorder.is_full()) end_recording(session);
    if (std::shared_ptr<const Flight> opened = session.take_flight()) replay.begin(std::move(opened));
    replay.update(session, dt_s);
}

void Workbench::toggle_recording(Session& session) {
    if (recorder.is_recording()) return end_recording(session);
    recorder.begin();
    session.message = {tr("recording a flight: F9 stops it and writes the file"), false};
}

void Workbench::end_recording(Session& session) {
    const bool was_full = recorder.is_full();
    const std::optional<Flight> flight = recorder.end();
    if (!flight) return;
    const std::filesystem::path file = new_flight_file();
    const std::string seconds = fmt::format("{:.1f}", flight->seconds);
    session.write(
        [file, flight] { return write_file(file, write_flight(*flight)); },
        was_full ? say("maximum flight length reached: {seconds} s written to {file}", "seconds"_a = seconds,
                       "file"_a = file.string())
                 : say("flight of {seconds} s written to {file}", "seconds"_a = seconds, "file"_a = file.string()));
}

std::string Workbench::recording_sign() const {
    if (!recorder.is_recording()) return "";
    const auto seconds = static_cast<int>(recorder.seconds());
    return say("● REC {clock}", "clock"_a = fmt::format("{:02}:{:02}", seconds / 60, seconds % 60));
}

void Workbench::draw_recording_sign(const Layout& layout) const {
    if (!layout.status_bar.empty() || !recorder.is_recording()) return;
    ImGui::GetForegroundDrawList()->AddText({px(10.0F), px(8.0F)}, widgets.palette.trouble, recording_sign().c_str());
}

}  // namespace viewing
