// The search over everything: which entries match the typed words, in which order, which of them the window and the
// stage offer, and what choosing an entry does.
#include <algorithm>
#include <chrono>
#include <thread>

#include "exercise_desk.h"
#include "trials.h"
#include "ui/window/search_entries.h"

namespace viewing::test {
namespace {

// ---- matching entries --------------------------------------------------------------------------------------------

SearchEntry preset_entry(const std::string& title, const std::string& about = "") {
    std::string names = title;
    std::ranges::transform(names, names.begin(), [](unsigned char c) { return std::tolower(c); });
    return {EntryKind::preset, title, "", PresetChoice{title}, names, about};
}

std::vector<std::string> titles(const std::vector<SearchEntry>& entries) {
    std::vector<std::string> all;
    for (const SearchEntry& entry : entries) all.push_back(entry.title);
    return all;
}

TEST(Search, RequiresAllWordsAndPrefersStartsNamesAndShortTitles) {
    const SearchEntry entries[] = {preset_entry("Unlit"),          preset_entry("Parallel light"),
                                   preset_entry("Sun", "a light"), preset_entry("Light"),
                                   preset_entry("Twilight"),       preset_entry("Mirror")};
    EXPECT_EQ(titles(found(entries, "light")),
              (std::vector<std::string>{"Light", "Parallel light", "Twilight", "Sun"}));
    EXPECT_EQ(titles(found(entries, " LIGHT  par ")), std::vector<std::string>{"Parallel light"});
    EXPECT_TRUE(found(entries, "qqq").empty());
    EXPECT_TRUE(found(entries, "light qqq zzz").empty());
    EXPECT_EQ(found(entries, "", 4).size(), 4U);
}

/// The search over the assets, as in the free window.
class FoundEntries : public ::testing::Test {
protected:
    const std::vector<NamedFile> all_presets = presets();
    const std::vector<LessonFile> all_lessons = lessons();
    const ExerciseTitle exercise{"E16-shadow-matrix", {{"The shadow matrix", "그림자 행렬"}}};
    Params params;
    SearchLimits limits;

    std::vector<SearchEntry> look(const std::string& query, std::size_t most = 12) const {
        return found(search_entries({all_presets, all_lessons, std::span(&exercise, 1)}, limits, params), query, most);
    }
    /// The first setting found; "" if there is none.
    std::string setting(const std::string& query) const {
        for (const SearchEntry& entry : look(query))
            if (const auto* field = std::get_if<FieldChoice>(&entry.choice)) return field->setting;
        return "";
    }
    bool has(const std::string& query, EntryKind kind, const std::string& title) const {
        return std::ranges::any_of(look(query), [&](const SearchEntry& entry) {
            return entry.kind == kind && entry.title.find(title) != std::string::npos;
        });
    }
};

TEST_F(FoundEntries, ANameWithAValueIsASetting) {
    const std::pair<const char*, const char*> cases[] = {
        {"near 0.0001", "projection.near=0.0001"},    {"fovy 40", "projection.fovy=40"},
        {"fovy = 40°", "projection.fovy=40"},         {"yaw −30", "camera.yaw=-30"},
        {"depth test off", "depth.test=false"},       {"depth function always", "depth.func=always"},
        {"shadow offset lift", "shadow.offset=lift"}, {"light.position 1, 2, 3, 1", "light.position=[1,2,3,1]"}};
    for (const auto& [query, expected] : cases) {
        EXPECT_EQ(setting(query), expected) << query;
        const std::string settings[] = {expected};
        EXPECT_TRUE(apply_settings(params, settings)) << expected;
    }
    EXPECT_EQ(setting("depth.test"), "depth.test=false") << "a switch without a value is toggled";
    EXPECT_EQ(setting("projection.near"), "") << "a number must be typed";
    EXPECT_EQ(setting("projection.near 1 2"), "");
}

TEST_F(FoundEntries, WordsOfATroubleLeadToThePresetThatShowsIt) {
    const std::pair<const char*, const char*> cases[] = {{"dark twice", "Shadow blended twice"},
                                                         {"shadow is missing", "Normal flipped, shadow lost"},
                                                         {"z-fighting shadow", "Shadow fights with the floor"},
                                                         {"mirror covers objects", "Mirror drawn over the objects"}};
    for (const auto& [query, title] : cases) EXPECT_TRUE(has(query, EntryKind::trouble, title)) << query;
    EXPECT_FALSE(look("light below the plane").empty());
    EXPECT_TRUE(std::ranges::any_of(look("light below the plane"),
                                    [](const SearchEntry& entry) { return entry.kind == EntryKind::trouble; }));
}

TEST_F(FoundEntries, ASlidesNumberFindsWhatIsForIt) {
    for (const char* query : {"s19", "slide 19"}) {
        const std::vector<SearchEntry> all = look(query, 100);
        int presets = 0, steps = 0;
        for (const SearchEntry& entry : all) {
            if (const auto* preset = std::get_if<PresetChoice>(&entry.choice)) {
                ++presets;
                const auto file = std::find_if(all_presets.begin(), all_presets.end(),
                                               [&](const NamedFile& one) { return one.name == preset->name; });
                ASSERT_NE(file, all_presets.end());
                EXPECT_EQ(std::count(file->slides.begin(), file->slides.end(), 19), 1) << preset->name;
            }
            steps += entry.kind == EntryKind::step;
        }
        EXPECT_EQ(presets, std::count_if(all_presets.begin(), all_presets.end(), [](const NamedFile& one) {
                      return std::find(one.slides.begin(), one.slides.end(), 19) != one.slides.end();
                  }));
        EXPECT_GT(presets, 1);
        EXPECT_GT(steps, 3);
        EXPECT_EQ(all.front().kind, EntryKind::preset);
    }
    EXPECT_TRUE(look("s99").empty());
}

TEST_F(FoundEntries, EveryKindIsFoundByItsName) {
    EXPECT_TRUE(has("why this", EntryKind::view, "Why this pixel?"));
    EXPECT_TRUE(has("histogram", EntryKind::view, "Depth histogram"));
    EXPECT_TRUE(has("undo", EntryKind::command, "Undo"));
    EXPECT_TRUE(has("walking down", EntryKind::preset, "Walking while looking down"));
    EXPECT_TRUE(has("whose fault", EntryKind::lesson, "Depth fighting: whose fault is it?"));
    EXPECT_TRUE(has("e16", EntryKind::exercise, "The shadow matrix"));
    for (const NamedFile& preset : all_presets) {
        const std::vector<SearchEntry> first = look(preset.name, 3);
        EXPECT_TRUE(std::ranges::any_of(first, [&](const SearchEntry& entry) {
            const auto* choice = std::get_if<PresetChoice>(&entry.choice);
            return choice && choice->name == preset.name;
        })) << preset.name;
    }
    for (const LessonFile& lesson : all_lessons) {
        ASSERT_EQ(std::ssize(lesson.listed_steps), lesson.steps) << lesson.id;
        for (std::size_t step = 0; step < lesson.listed_steps.size(); ++step) {
            const std::vector<SearchEntry> first = look(lesson.listed_steps[step].question.in_english(), 3);
            EXPECT_TRUE(std::ranges::any_of(first,
                                            [&](const SearchEntry& entry) {
                                                const auto* choice = std::get_if<LessonPlace>(&entry.choice);
                                                return choice && choice->id == lesson.id && choice->step == step;
                                            }))
                << lesson.id << " " << step;
        }
    }
}

TEST_F(FoundEntries, KoreanAndEnglishNamesBothLeadThere) {
    ASSERT_TRUE(speak(Language::ko));
    for (const char* query : {"Shadow blended twice", tr("Shadow blended twice")})
        EXPECT_TRUE(has(query, EntryKind::trouble, tr("Shadow blended twice"))) << query;
    for (const char* query : {"depth histogram", tr("Depth histogram")})
        EXPECT_TRUE(has(query, EntryKind::view, tr("Depth histogram"))) << query;
    EXPECT_EQ(setting(std::string(tr("depth test")) + " 끄기"), "depth.test=false");
    EXPECT_TRUE(has("그림자 행렬", EntryKind::exercise, "그림자 행렬"));
    ASSERT_TRUE(speak(Language::en));
}

TEST_F(FoundEntries, NothingIsOfferedThatTheStepForbids) {
    limits.movable = std::vector<std::string>{"projection.near", "light"};
    limits.covered = {"control:light.position", "view:histogram"};
    EXPECT_EQ(setting("near 0.1"), "projection.near=0.1");
    for (const char* query : {"fovy 40", "light.position 1 2 3 1", "depth test off", "camera.yaw 3"})
        EXPECT_EQ(setting(query), "") << query;
    EXPECT_FALSE(has("depth histogram", EntryKind::view, ""));
    EXPECT_TRUE(has("depth precision", EntryKind::view, ""));
    limits.may_choose_view = false;
    EXPECT_FALSE(has("depth precision", EntryKind::view, ""));
}

// ---- in the window -----------------------------------------------------------------------------------------------

class SearchTest : public ::testing::Test {
protected:
    ExerciseSheetDesk desk{{1600, 900}};
    widgets::test::Harness& ui = desk.ui;
    Params& params = desk.session.params;

    void search(const char* query) {
        desk.press_with(Key::ctrl, Key::p);
        ui.frames(3);
        ui.type(query);
        ui.frames(2);
    }
    void enter() {
        ui.key(ImGuiKey_Enter);
        desk.settle();
    }
    /// Searches for `query` and chooses the first entry whose text contains `text`.
    void choose(const char* query, const std::string& text) {
        search(query);
        for (int row = 1; row <= 12; ++row)
            if (const std::string label = "search/row " + std::to_string(row);
                ui.has(label) && ui.text_of(label).find(text) != std::string::npos) {
                for (int i = 1; i < row; ++i) ui.key(ImGuiKey_DownArrow);
                return enter();
            }
        std::string rows;
        for (const RecordedItem& item : desk.recorded())
            if (item.label.starts_with("search/")) rows += item.label + ": " + item.text + "\n";
        FAIL() << query << ": no row with " << text << " among\n" << rows;
    }
    void begin(const char* id, std::size_t step, bool presents) {
        Result<Lesson> lesson = load_lesson(id);
        ASSERT_TRUE(lesson);
        desk.workbench.guide.begin(*std::move(lesson), step, desk.session);
        if (presents) desk.workbench.presenter.begin();
        desk.settle();
        desk.apply_looks();
        ui.frames(3);
    }
};

TEST_F(SearchTest, EnterSetsTheFieldAndUndoTakesItBack) {
    const double before = params.projection.near;
    search("near 0.0001");
    EXPECT_EQ(ui.text_of("search/row 1").substr(0, 6), "z-near");
    enter();
    EXPECT_EQ(params.projection.near, 0.0001);
    EXPECT_FALSE(ui.has("search/text"));
    desk.undo();
    EXPECT_EQ(params.projection.near, before);
}

TEST_F(SearchTest, ASettingWithoutAValueWaitsForIt) {
    search("projection.fovy");
    ui.key(ImGuiKey_Enter);
    ui.frames(3);
    ASSERT_TRUE(ui.has("search/text"));
    ui.type("41.5");
    ui.frames(2);
    enter();
    EXPECT_EQ(params.projection.fovy, 41.5) << "what was typed continues the setting's name";
}

TEST_F(SearchTest, AValueOutOfRangeIsASentenceAndChangesNothing) {
    const Params before = params;
    choose("fovy 400", "fovy");
    EXPECT_EQ(params, before);
    EXPECT_TRUE(desk.session.message.is_error);
    EXPECT_NE(desk.session.message.text.find("179"), std::string::npos);
}

TEST_F(SearchTest, EscapeChangesNothing) {
    const Params before = params;
    search("near 0.0001");
    desk.press(Key::escape);
    ui.frames(2);
    EXPECT_FALSE(ui.has("search/text"));
    EXPECT_EQ(params, before);
}

TEST_F(SearchTest, PresetsViewsAndCommandsDoWhatTheirControlsDo) {
    choose("dark twice", "Shadow blended twice");
    EXPECT_EQ(desk.session.preset()->name, "shadow-double-blend");
    choose("histogram", "Depth histogram");
    EXPECT_TRUE(is_shown(params, Topic::histogram));
    choose("why this pixel", "Why this pixel?");
    EXPECT_TRUE(is_shown(params, Topic::why));
    choose("undo", "Undo");
    EXPECT_FALSE(is_shown(params, Topic::why));
    choose("navigation mode", "Next navigation mode");
    EXPECT_EQ(params.camera.navigation, Navigation::walk);
    choose("fold controls", "Fold the controls");
    EXPECT_TRUE(desk.layout().panel.empty());
    choose("lessons", "Lessons");
    EXPECT_TRUE(desk.workbench.start_page.is_open());
    choose("exercises", "Exercises");
    EXPECT_FALSE(desk.workbench.start_page.is_open());
    EXPECT_TRUE(desk.workbench.exercises.page.is_open());
}

TEST_F(SearchTest, StepsAndExercisesOpen) {
    const LessonFile lesson = lessons().at(10);
    choose(lesson.listed_steps.at(2).question.in_english().substr(0, 60).c_str(),
           lesson.listed_steps.at(2).question.in_english());
    for (int i = 0; i < 2000 && !desk.workbench.guide.run(); ++i) {
        ui.frame();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));  // the file is read in the background
    }
    ASSERT_NE(desk.workbench.guide.run(), nullptr);
    EXPECT_EQ(desk.workbench.guide.run()->lesson().id, lesson.id);
    EXPECT_EQ(desk.workbench.guide.run()->index(), 2U);
    const Exercise& exercise = desk.workbench.exercises.desk.entries().at(3).exercise;
    choose(exercise.short_id().c_str(), exercise.title.in_english());
    ASSERT_TRUE(desk.workbench.guide.is_sheet());
    EXPECT_EQ(desk.workbench.guide.run()->index(), 3U);
}

TEST_F(SearchTest, OnStageItIsLargeAndSettingsStayWithinTheStep) {
    begin("depth-fighting", 0, true);
    const LessonStep& step = desk.workbench.guide.run()->step();
    ASSERT_FALSE(desk.workbench.guide.run()->is_revealed());
    const Params before = params;
    search("roll 30");
    for (int row = 1; row <= 12; ++row)
        if (const std::string label = "search/row " + std::to_string(row); ui.has(label)) {
            EXPECT_EQ(ui.text_of(label).find("camera.roll"), std::string::npos) << "the step does not offer it";
        }
    EXPECT_GE(ui.find("search/text").max.y - ui.find("search/text").min.y, 900.0F / 30.0F);
    desk.press(Key::escape);
    ui.frames(2);
    EXPECT_EQ(params, before);
    EXPECT_TRUE(desk.workbench.presenter.is_on());
    EXPECT_EQ(&desk.workbench.guide.run()->step(), &step);
    choose("freeze", "Freeze the picture");
    EXPECT_TRUE(desk.workbench.presenter.is_frozen());
    choose("depth bits few", "");
    EXPECT_TRUE(desk.workbench.presenter.is_on()) << "the stage stays on";
}

/// In all steps, the search cannot change a field that the step's panel cannot change.
TEST_F(SearchTest, NoStepOffersCoveredSettings) {
    for (const char* id : {"lens", "depth-fighting", "mirror-matrix"}) {
        const Result<Lesson> lesson = load_lesson(id);
        ASSERT_TRUE(lesson);
        for (std::size_t step = 0; step < lesson->steps.size(); ++step) {
            if (!testing::takes(step)) continue;
            begin(id, step, step % 2 == 0);
            desk.press_with(Key::ctrl, Key::p);
            ui.frames(2);
            for (const SearchEntry& entry : desk.workbench.searched())
                if (const auto* field = std::get_if<FieldChoice>(&entry.choice)) {
                    for (const std::string& covered : lesson->steps[step].cover)
                        EXPECT_NE("control:" + std::string(field->path), covered) << id << " " << step;
                }
            EXPECT_FALSE(desk.workbench.searched().empty());
            desk.press(Key::escape);
        }
    }
}

}  // namespace
}  // namespace viewing::test
