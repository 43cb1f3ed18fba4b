#include "ui/lesson/start_page.h"

#include <algorithm>
#include <utility>

#include "text/catalogue.h"
#include "text/words.h"
#include "ui/lesson/page.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

std::string key_of(const std::string& lesson, std::size_t step) {
    return lesson + "/" + std::to_string(step + 1);
}

std::string slides_text(const std::vector<int>& slides) {
    if (slides.empty()) return "";
    const bool is_range = slides.size() > 1 && slides.back() - slides.front() + 1 == std::ssize(slides);
    if (is_range) return std::to_string(slides.front()) + "–" + std::to_string(slides.back());
    return joined(slides);
}

}  // namespace

const std::vector<LessonFile>& StartPage::lessons() {
    if (!lessons_) lessons_ = viewing::lessons();
    return *lessons_;
}

std::vector<CardPicture> StartPage::wanted_pictures() {
    std::vector<CardPicture> wanted;
    if (is_open_)
        for (const LessonFile& file : lessons())
            wanted.push_back({key_of(file.id, 0), [path = file.path.string()]() -> Result<LoadedState> {
                                  const Result<Lesson> lesson = load_lesson(path);
                                  if (!lesson) return Error{lesson.error()};
                                  return lesson->picture.value_or(lesson->steps.front().start);
                              }});
    return wanted;
}

bool StartPage::draw(Guide& guide, Session& session, const LessonsProgress& progress,
                     const std::vector<std::string>& recent, const Pictures& pictures) {
    if (!is_open_) return false;
    const Page page("start page");
    const widgets::Group group("start");
    page_heading(tr("Viewing: a lecture in pictures that answer you"), "title");
    if (button_at_right("Explore freely")) is_open_ = false;
    widgets::Note(
        "Each lesson asks before it shows the answer. You can leave at any point and return to the same step.");
    if (button_at_right("Exercises")) {
        is_open_ = false;
        return true;
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(recent.size(), 3); ++i) {
        if (i > 0) ImGui::SameLine();
        const std::filesystem::path file(recent[i]);
        if (widgets::SmallButton(
                (printable(file.filename().string()) + "###recent " + std::to_string(i + 1)).c_str())) {
            session.open(recent[i]);
            is_open_ = false;
        }
        widgets::Tooltip("Recent files", printable(recent[i]).c_str());
    }
    ImGui::Dummy({0.0F, px(4.0F)});
    ImGui::BeginChild("cards");
    std::vector<Card> cards;
    for (const LessonFile& file : lessons()) {
        const auto known = progress.find(file.id);
        // Ignore recorded steps that no longer exist in the lesson.
        const auto done = known == progress.end()
                              ? 0
                              : std::count_if(known->second.done.begin(), known->second.done.end(),
                                              [&](std::size_t step) { return std::cmp_less(step, file.steps); });
        const std::string steps = done > 0 ? say("{done} of {count} steps", "done"_a = done, "count"_a = file.steps)
                                           : say_count(file.steps, "one step", "{count} steps");
        const std::string slides = slides_text(file.slides);
        cards.push_back({key_of(file.id, 0), std::to_string(cards.size() + 1) + " · " + file.title.shown(),
                         say("{steps} · {minutes} min · slides {slides}", "steps"_a = steps, "minutes"_a = file.minutes,
                             "slides"_a = slides),
                         done > 0 && done == file.steps, false});
    }
    if (cards.empty()) widgets::Note("There are no lessons: the folder assets/lessons was not found.");
    const int clicked = draw_cards(
        cards, [&](const std::string& key) { return texture_in(pictures, key); }, -1);
    ImGui::EndChild();
    if (clicked < 0) return false;
    const LessonFile& file = lessons()[static_cast<std::size_t>(clicked)];
    const auto known = progress.find(file.id);
    guide.open(file.path.string(), known == progress.end() ? 0 : known->second.step);
    is_open_ = false;
    return false;
}

std::vector<CardPicture> overview_pictures(const Guide& guide) {
    std::vector<CardPicture> wanted;
    if (!guide.run()) return wanted;
    const std::shared_ptr<const Lesson> lesson = guide.run()->shared_lesson();
    for (std::size_t i = 0; i < lesson->steps.size(); ++i)
        wanted.push_back(
            {key_of(lesson->id, i), [lesson, i]() -> Result<LoadedState> { return lesson->steps[i].start; }});
    return wanted;
}

void draw_overview(PresenterMode& presenter, Guide& guide, Session& session, const Pictures& pictures) {
    if (!presenter.shows_overview() || !guide.run()) return;
    const LessonRun& run = *guide.run();
    const Page page("overview");
    const widgets::Group group("overview");
    page_heading(run.lesson().title.shown(), "title");
    if (button_at_right("Close")) presenter.close_overview();
    ImGui::Dummy({0.0F, px(6.0F)});
    ImGui::BeginChild("cards");
    std::vector<Card> cards;
    for (std::size_t i = 0; i < run.lesson().steps.size(); ++i) {
        const LessonStep& step = run.lesson().steps[i];
        cards.push_back({key_of(run.lesson().id, i), std::to_string(i + 1) + " · " + step.ask.question.shown(), "",
                         run.is_done(i), i == run.index()});
    }
    const int clicked = draw_cards(
        cards, [&](const std::string& key) { return texture_in(pictures, key); }, presenter.overview_choice());
    ImGui::EndChild();
    if (clicked < 0) return;
    presenter.close_overview();
    guide.go_to(static_cast<std::size_t>(clicked), session);
}

}  // namespace viewing
