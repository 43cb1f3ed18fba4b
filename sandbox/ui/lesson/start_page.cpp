#include "ui/lesson/start_page.h"

#include <algorithm>
#include <utility>

#include "text/catalogue.h"
#include "text/words.h"
#include "ui/lesson/full_page.h"
#include "ui/lesson/lesson_text.h"
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

void Past::note(LessonRun& run) {
    const Lesson& lesson = run.lesson();
    if (lesson.sheet || lesson.lecture) return;
    LessonProgress& known = progress[lesson.id];
    last_lesson = lesson.id;
    for (const std::size_t step : known.done)  // another window may have added some steps
        if (step < lesson.steps.size()) run.set_done(step);
    known.step = run.index();
    for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
        const auto at = std::lower_bound(known.done.begin(), known.done.end(), step);
        if (run.is_done(step) && (at == known.done.end() || *at != step)) known.done.insert(at, step);
    }
}

void Past::note_opened(const Session& session) {
    const auto remember = [this](const std::string& file) {
        constexpr std::size_t most = 10;
        if (!recent.empty() && recent.front() == file) return;
        std::erase(recent, file);
        recent.insert(recent.begin(), file);
        recent.resize(std::min(recent.size(), most));
    };
    if (!session.opening().empty()) {
        opening_ = session.opening();
    } else if (!opening_.empty()) {
        // A preset is opened by its name, which is not a file path.
        if (!session.message.is_error && opening_.find('/') != std::string::npos) remember(opening_);
        opening_.clear();
    }
    const auto* const scene = std::get_if<std::string>(&session.params.scene);
    const bool is_mesh = scene && scene->starts_with('/') && scene->ends_with(".obj");
    if (session.loading_fraction()) return;
    if (is_mesh && *scene != opened_mesh_) remember(*scene);
    opened_mesh_ = is_mesh ? *scene : "";
}

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

namespace {

/// How many of the lesson's steps are done. Ignores recorded steps that the lesson no longer has.
std::ptrdiff_t done_in(const LessonFile& file, const LessonsProgress& progress) {
    const auto known = progress.find(file.id);
    if (known == progress.end()) return 0;
    return std::count_if(known->second.done.begin(), known->second.done.end(),
                         [&](std::size_t step) { return std::cmp_less(step, file.steps); });
}

/// Returns the positions in the list, counted from 1, of the lessons that this one builds on: "10, 14"; "" if there are
/// none.
std::string needed_places(const LessonFile& file, const std::vector<LessonFile>& all) {
    std::string places;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (std::find(file.needs.begin(), file.needs.end(), all[i].id) != file.needs.end())
            places += (places.empty() ? "" : ", ") + std::to_string(i + 1);
    return places;
}

Card card_of(const std::vector<LessonFile>& all, std::size_t place, const LessonsProgress& progress) {
    const LessonFile& file = all[place];
    const std::ptrdiff_t done = done_in(file, progress);
    const std::string needed = needed_places(file, all);
    const std::string steps = done > 0 ? say("{done} of {count} steps", "done"_a = done, "count"_a = file.steps)
                                       : say_count(file.steps, "one step", "{count} steps");
    std::string note = say("{steps} · {minutes} min", "steps"_a = steps, "minutes"_a = file.minutes);
    if (!needed.empty()) note += " · " + say("after {lessons}", "lessons"_a = needed);
    return {key_of(file.id, 0), std::to_string(place + 1) + " · " + file.title.shown(), note,
            done > 0 && done == file.steps, false};
}

/// A topic with its lessons, as indices into the list.
struct LessonGroup {
    std::string name;
    std::vector<std::size_t> places;
    std::vector<int> slides;
};

std::vector<LessonGroup> groups_of(const std::vector<LessonFile>& lessons) {
    std::vector<LessonGroup> groups;
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        if (groups.empty() || groups.back().name != lessons[i].group) groups.push_back({lessons[i].group, {}, {}});
        LessonGroup& group = groups.back();
        group.places.push_back(i);
        for (const int slide : lessons[i].slides)
            if (const auto at = std::lower_bound(group.slides.begin(), group.slides.end(), slide);
                at == group.slides.end() || *at != slide)
                group.slides.insert(at, slide);
    }
    return groups;
}

bool large_button(const char* label, const char* about, bool is_on = false) {
    ImGui::PushFont(widgets::CurrentContext().fonts.caption);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(26.0F), px(12.0F)});
    const bool clicked = widgets::Button(label);
    if (is_on)
        ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), palette().accent,
                                            ImGui::GetStyle().FrameRounding, 0, px(2.5F));
    ImGui::PopStyleVar();
    ImGui::PopFont();
    widgets::Tooltip(label, about);
    return clicked;
}

/// A layout in which the cards of all groups fit into the window.
struct Grid {
    bool has_column = true;  ///< the names of the topics are at the left, not above
    std::size_t columns = 1;
    float names = 0.0F;  ///< the width of that column
    FlatCard card;
};

constexpr float grid_gap = 10.0F;

Grid grid_for(const std::vector<LessonGroup>& groups, const std::vector<Card>& cards, ImVec2 room) {
    Grid grid;
    const float gap = px(grid_gap), least_card = px(196.0F);
    grid.has_column = room.x >= px(760.0F);
    grid.names = grid.has_column ? px(132.0F) : 0.0F;
    std::size_t most = 1;
    for (const LessonGroup& group : groups) most = std::max(most, group.places.size());
    const float width = room.x - grid.names;
    grid.columns = std::clamp<std::size_t>(static_cast<std::size_t>((width + gap) / (least_card + gap)), 1, most);
    const auto columns = static_cast<float>(grid.columns);
    grid.card.width = std::floor((width - gap * (columns - 1.0F)) / columns);
    const auto rows = static_cast<float>(groups.size());
    const float spare = std::floor((room.y - gap * (rows - 1.0F)) / rows);
    grid.card.picture = grid.card.width >= px(250.0F) ? std::floor(0.42F * grid.card.width) : 0.0F;
    for (const Card& card : cards) grid.card.height = std::max(grid.card.height, least_height(card, grid.card));
    const float enough = std::max(px(96.0F), grid.card.picture);
    grid.card.height = std::ceil(std::max(grid.card.height, std::min(spare, enough)));
    return grid;
}

void draw_group_name(const LessonGroup& group, float width) {
    const widgets::Context& context = widgets::CurrentContext();
    if (!group.name.empty())
        paragraph(tr(group.name.c_str()), context.fonts.heading, width).draw(group.name.c_str(), palette().text);
    if (const std::string slides = slides_text(group.slides); !slides.empty())
        paragraph(say("slides {slides}", "slides"_a = slides), context.fonts.note, width)
            .draw("slides", palette().quiet);
}

}  // namespace

std::optional<std::size_t> StartPage::draw_beginnings(const Past& past) {
    std::optional<std::size_t> chosen;
    if (large_button("Start", marked("Opens the first lesson at its beginning."))) {
        gives_lecture_ = false;
        chosen = 0;
    }
    ImGui::SameLine(0.0F, px(12.0F));
    if (large_button("Give a lecture",
                     marked("Choose a lesson below; it opens on stage: full screen, large type, and keys for a "
                            "clicker."),
                     gives_lecture_))
        gives_lecture_ = !gives_lecture_;
    const auto last = std::find_if(lessons().begin(), lessons().end(),
                                   [&](const LessonFile& file) { return file.id == past.last_lesson; });
    const auto known = past.progress.find(past.last_lesson);
    if (last == lessons().end() || known == past.progress.end()) return chosen;
    const std::string where = say(
        "Continue: {lesson}, step {step}", "lesson"_a = last->title.shown(),
        "step"_a = std::min<std::size_t>(known->second.step + 1, static_cast<std::size_t>(std::max(last->steps, 1))));
    ImGui::SameLine(0.0F, px(12.0F));
    const float room = ImGui::GetContentRegionAvail().x - px(40.0F);
    ImGui::PushFont(widgets::CurrentContext().fonts.caption);
    const std::string shown = widgets::Shortened(where, room);
    ImGui::PopFont();
    if (large_button((shown + "###Go on").c_str(), where.c_str())) {
        continues_ = true;
        chosen = static_cast<std::size_t>(last - lessons().begin());
    }
    return chosen;
}

std::optional<std::size_t> StartPage::draw_groups(const Past& past, const Pictures& pictures) {
    std::vector<Card> cards;
    for (std::size_t i = 0; i < lessons().size(); ++i) cards.push_back(card_of(lessons(), i, past.progress));
    const std::vector<LessonGroup> groups = groups_of(lessons());
    if (cards.empty()) widgets::Note("There are no lessons: the folder assets/lessons was not found.");
    std::optional<std::size_t> chosen;
    const float left = ImGui::GetCursorPosX(), gap = px(grid_gap);
    const Grid grid = grid_for(groups, cards, ImGui::GetContentRegionAvail());
    for (const LessonGroup& group : groups) {
        float top = ImGui::GetCursorPosY();
        ImGui::SetCursorPosX(left);
        draw_group_name(group, grid.has_column ? grid.names - gap : ImGui::GetContentRegionAvail().x);
        if (!grid.has_column) top = ImGui::GetCursorPosY();
        for (std::size_t i = 0; i < group.places.size(); ++i) {
            const std::size_t place = group.places[i];
            const auto column = static_cast<float>(i % grid.columns), row = static_cast<float>(i / grid.columns);
            ImGui::SetCursorPos(
                {left + grid.names + column * (grid.card.width + gap), top + row * (grid.card.height + gap)});
            if (draw_flat_card(cards[place], ("card " + std::to_string(place + 1)).c_str(), grid.card,
                               texture_in(pictures, cards[place].key)))
                chosen = place;
        }
        const auto rows = static_cast<float>((group.places.size() + grid.columns - 1) / grid.columns);
        ImGui::SetCursorPos({left, top + rows * (grid.card.height + gap) - (&group == &groups.back() ? gap : 0.0F)});
    }
    ImGui::Dummy({0.0F, 0.0F});
    return chosen;
}

bool StartPage::draw(Guide& guide, PresenterMode& presenter, Session& session, const Past& past,
                     const Pictures& pictures) {
    if (!is_open_) return false;
    const Page page("start page");
    const widgets::Group group("start");
    page_heading(tr("Viewing: a lecture in interactive pictures"), "title");
    if (button_at_right("Explore freely")) is_open_ = false;
    const char* const about =
        gives_lecture_ ? marked("Choose a lesson: it opens on stage.")
                       : marked(
                             "Move the camera, the light or a plane, and see immediately how the picture and the "
                             "lecture's matrices change. Each lesson asks before it shows the answer.");
    paragraph(tr(about), widgets::CurrentContext().fonts.text, ImGui::GetContentRegionAvail().x - px(150.0F))
        .draw("about", gives_lecture_ ? palette().text : palette().quiet);
    if (button_at_right("Exercises")) {
        is_open_ = false;
        return true;
    }
    continues_ = false;
    ImGui::Dummy({0.0F, px(2.0F)});
    std::optional<std::size_t> chosen = draw_beginnings(past);
    for (std::size_t i = 0; i < std::min<std::size_t>(past.recent.size(), 3); ++i) {
        if (i > 0) ImGui::SameLine();
        const std::filesystem::path file(past.recent[i]);
        if (widgets::SmallButton(
                (printable(file.filename().string()) + "###recent " + std::to_string(i + 1)).c_str())) {
            session.open(past.recent[i]);
            is_open_ = false;
        }
        widgets::Tooltip("Recent files", printable(past.recent[i]).c_str());
    }
    ImGui::Dummy({0.0F, px(4.0F)});
    ImGui::BeginChild("cards");
    if (const std::optional<std::size_t> card = draw_groups(past, pictures)) {
        chosen = card;
        continues_ = !gives_lecture_;
    }
    ImGui::EndChild();
    if (!chosen || *chosen >= lessons().size()) return false;
    const LessonFile& file = lessons()[*chosen];
    const auto known = past.progress.find(file.id);
    const bool is_finished = continues_ && file.steps > 0 && done_in(file, past.progress) == file.steps;
    guide.open(file.path.string(), !continues_ || known == past.progress.end() ? 0 : known->second.step);
    if (gives_lecture_) presenter.begin();
    finished_ = is_finished ? file.id : "";
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
