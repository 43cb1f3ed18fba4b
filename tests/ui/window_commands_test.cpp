// The list of commands: no key means two things at one place, and every command can be reached.
#include "ui/window/window_commands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "text/manual.h"

namespace viewing::test {
namespace {

constexpr viewing::Place places[] = {viewing::Place::window, viewing::Place::lesson, viewing::Place::stage,
                                     viewing::Place::lesson_on_stage};

TEST(CommandsTest, AKeyHasOneCommandAtAPlace) {
    const std::span<const WindowCommand> all = window_commands();
    for (const viewing::Place place : places)
        for (const WindowCommand& command : all) {
            if (!command.key || !command.is_in(place)) continue;
            const auto rivals = std::count_if(all.begin(), all.end(), [&](const WindowCommand& other) {
                return other.key && other.is_in(place) && *other.key == *command.key;
            });
            EXPECT_EQ(rivals, 1) << key_text(command.key) << " at place " << static_cast<int>(place);
        }
}

TEST(CommandsTest, EveryCommandHasAKeyOrAName) {
    for (const WindowCommand& command : window_commands()) {
        EXPECT_TRUE(command.key || *command.name);
        EXPECT_EQ(key_text(command.key).empty(), !command.key.has_value());
        EXPECT_FALSE(key_text(command.key).ends_with("+")) << command.name << ": the key has no name";
    }
}

TEST(CommandsTest, KeysAreNamedWithTheirModifiers) {
    EXPECT_EQ(key_text(KeyPress{Key::z, true, true}), "Ctrl+Shift+Z");
    EXPECT_EQ(key_text(KeyPress{Key::page_up}), "Page up");
    EXPECT_EQ(key_text(std::nullopt), "");
}

TEST(CommandsTest, ShiftIsIgnoredUnlessACommandHasIt) {
    const auto name = [](const KeyPress& press, viewing::Place place) {
        const WindowCommand* const command = command_of(press, place);
        return std::string(command ? command->name : "none");
    };
    EXPECT_EQ(name({Key::z, true, false}, viewing::Place::window), "Undo");
    EXPECT_EQ(name({Key::z, true, true}, viewing::Place::window), "Redo");
    EXPECT_EQ(name({Key::g, false, true}, viewing::Place::window), "The whole scene");
    EXPECT_EQ(name({Key::escape, false, true}, viewing::Place::lesson_on_stage), "Leave the stage");
    EXPECT_EQ(name({Key::g, true, false}, viewing::Place::window), "none");
}

TEST(CommandsTest, AKeyMeansWhatItsPlaceIsFor) {
    const auto name = [](Key key, viewing::Place place) {
        const WindowCommand* const command = command_of({key}, place);
        return std::string(command ? command->name : "none");
    };
    EXPECT_EQ(name(Key::l, viewing::Place::window), "Level: no roll");
    EXPECT_EQ(name(Key::l, viewing::Place::stage), "Pointer, then spotlight");
    EXPECT_EQ(name(Key::home, viewing::Place::stage), "Starting view");
    EXPECT_EQ(name(Key::home, viewing::Place::lesson), "Restore the step's state");
    EXPECT_EQ(name(Key::x, viewing::Place::lesson), "none") << "it shows the state before, while it is held";
    EXPECT_EQ(name(Key::f1, viewing::Place::stage), "none") << "no help before an audience";
}

TEST(CommandsTest, TheManualNamesEveryKeyOfTheStage) {
    std::vector<std::string> keys;
    for (const ManualBlock& block : manual_topic("lessons")) {
        if (block.part != ManualPart::row) continue;
        const std::string cell = std::regex_replace(block.cells.front(), std::regex(" or "), "\n");
        const std::regex key("([^\n]+?)(, |\n|$)");
        for (std::sregex_iterator at(cell.begin(), cell.end(), key), end; at != end; ++at) keys.push_back((*at)[1]);
    }
    int count = 0;
    for (const WindowCommand& command : window_commands()) {
        if (command.is_in(viewing::Place::window) || command.is_in(viewing::Place::lesson)) continue;
        const auto is_named = [&](const std::string& key) { return key == key_text(command.key); };
        EXPECT_TRUE(std::any_of(keys.begin(), keys.end(), is_named)) << key_text(command.key);
        ++count;
    }
    EXPECT_GT(count, 10);
}

TEST(CommandsTest, TheFileMenuHasItsCommands) {
    const auto names_in = [](FilePart part) {
        std::vector<std::string> names;
        for (const WindowCommand& command : window_commands())
            if (command.file_part == part) names.emplace_back(command.name);
        return names;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(names_in(FilePart::files), (Names{"Open…", "Save…", "Save as step…"}));
    EXPECT_EQ(names_in(FilePart::copies), (Names{"Copy state", "Copy link"}));
    EXPECT_EQ(names_in(FilePart::pastes), (Names{"Paste state"}));
    EXPECT_EQ(names_in(FilePart::others), (Names{"Snapshot", "Record a flight", "Reset all"}));
}

}  // namespace
}  // namespace viewing::test
