#include "ui/window/exercises.h"

#include <numeric>
#include <utility>

#include "platform/file.h"
#include "text/catalogue.h"

namespace viewing {

void Exercises::go_to(const std::string& id, bool replays) {
    wanted_ = id;
    wants_replay_ = replays;
}

void Exercises::follow(Guide& guide, Replay& replay, Session& session) {
    session.report(desk.update(ImGui::GetTime()));
    if (!wanted_.empty() && desk.is_ready()) {
        std::vector<std::size_t> all(desk.entries().size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        if (std::optional<LessonRun> run = desk.sheet_at(wanted_, all)) {
            guide.begin(*std::move(run), session);
            const HandInItem* const item = desk.hand_in().find(wanted_);
            if (wants_replay_ && item) replay.begin(guide.run()->step(), item->replay);
        }
        wanted_.clear();
    }
    // While an exercise's initial state is loading, the current state does not count as an answer.
    if (guide.is_shown() && guide.is_sheet() && !replay.is_playing() && !session.is_loading()) {
        const bool is_at_rest = !ImGui::IsAnyItemActive() && !session.is_moving() && !guide.is_revealing();
        desk.follow(*guide.run(), session.params, is_at_rest, ImGui::GetTime());
        if (guide.run()->reached() != session.params) guide.run()->reached() = session.params;
    }
}

void Exercises::draw(Guide& guide, Session& session, FileDialog& dialog, const Pictures& pictures) {
    const ExercisePage::Wishes wishes = page.draw(desk, guide, session, pictures);
    typed_matrix.draw(pictures);
    if (wishes.save || wishes.open_answers) page.close();  // show the dialog over the views instead of over this page
    if (wishes.open_answers)
        dialog.show(FileDialog::Purpose::open_answers, "",
                    [this](const std::filesystem::path& file) { desk.open_hand_in(file); });
    if (wishes.save)
        dialog.show(FileDialog::Purpose::save_answers, hand_in_file_name(desk.student()),
                    [this, &session](const std::filesystem::path& file) {
                        session.write([file, text = hand_in_as_text(desk.hand_in())] { return write_file(file, text); },
                                      say("answers saved to {file}", "file"_a = file.string()));
                    });
}

}  // namespace viewing
