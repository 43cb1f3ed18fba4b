// After any user input, the state can still be read back, and no displayed number is NaN.
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <random>

#include "desk.h"

namespace viewing::test {
namespace {

bool has_nan(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (std::isnan(matrix[column][row])) return true;
    return false;
}

class Person {
public:
    Person(Desk& desk, unsigned seed) : desk_(desk), random_(seed) {}

    /// Performs one random action and returns its description.
    std::string act() {
        const std::vector<RecordedItem> items = desk_.recorded();
        const RecordedItem& item = items[pick(items.size())];
        const std::string label = item.label;
        move_to(item);
        switch (pick(8)) {
            case 0:
            case 1:
                press_and_release(0);
                return "click " + label;
            case 2:
            case 3:
                return "drag " + label + drag();
            case 4: {
                static constexpr const char* texts[] = {"0",   "-5",   "1e300", "1e-12", "90",
                                                        "nan", "−2,5", "abc",   "720",   "0.001"};
                const char* text = texts[pick(std::size(texts))];
                press_and_release(0);
                press_and_release(0);
                desk_.ui.frames(3);
                desk_.ui.type(text);
                desk_.ui.key(ImGuiKey_Enter);
                return "type " + std::string(text) + " into " + label;
            }
            case 5:
                press_and_release(ImGuiMouseButton_Right);
                return "right-click " + label;
            case 6:
                ImGui::GetIO().MouseWheel = pick(2) ? 3.0F : -3.0F;
                desk_.ui.frame();
                ImGui::GetIO().MouseWheel = 0.0F;
                return "wheel over " + label;
            default: {
                const auto key = static_cast<Key>(pick(static_cast<std::size_t>(Key::count)));
                const bool ctrl = pick(4) == 0;
                if (ctrl) desk_.hold(Key::ctrl);
                desk_.hold(key);
                desk_.ui.frames(static_cast<int>(pick(20)));
                desk_.let_go(key);
                if (ctrl) desk_.let_go(Key::ctrl);
                return (ctrl ? "Ctrl + key " : "key ") + std::to_string(static_cast<int>(key));
            }
        }
    }

private:
    std::size_t pick(std::size_t count) { return random_() % count; }
    void move_to(const RecordedItem& item) {
        const float share = static_cast<float>(pick(100)) / 100.0F;
        desk_.ui.frame(1.0F);
        desk_.ui.move_to({item.min.x + share * (item.max.x - item.min.x), (item.min.y + item.max.y) * 0.5F});
    }
    void press_and_release(int button) {
        desk_.ui.press(button);
        desk_.ui.release(button);
        desk_.ui.frame();
    }
    std::string drag() {
        const auto dx = static_cast<float>(pick(801)) - 400.0F, dy = static_cast<float>(pick(401)) - 200.0F;
        const ImVec2 from = ImGui::GetIO().MousePos;
        desk_.ui.press();
        for (int i = 1; i <= 4; ++i)
            desk_.ui.move_to({from.x + dx * static_cast<float>(i) / 4.0F, from.y + dy * static_cast<float>(i) / 4.0F});
        desk_.ui.release();
        return " by (" + std::to_string(dx) + ", " + std::to_string(dy) + ")";
    }

    Desk& desk_;
    std::mt19937 random_;
};

TEST(RandomActions, KeepTheStateReadable) {
    const auto start = std::filesystem::current_path();
    const auto folder = std::filesystem::temp_directory_path() / ("viewing-random-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::filesystem::current_path(folder);
    for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
        std::cout << "seed " << seed << "\n";
        Desk desk;
        desk.fold_out_all();
        Person person(desk, seed);
        for (int action = 0; action < 100; ++action) {
            const std::string done = person.act();
            desk.session.finish_loading();
            desk.ui.frame();
            SCOPED_TRACE("seed " + std::to_string(seed) + ", action " + std::to_string(action) + ": " + done);
            const Result<Params> read_back = parse_state(write_state(desk.params()), "state");
            ASSERT_TRUE(read_back) << read_back.error();
            ASSERT_EQ(*read_back, desk.params());
            for (const glm::dmat4& matrix :
                 {desk.derived.view_from_world, desk.derived.world_from_view, desk.derived.clip_from_view,
                  desk.derived.clip_from_world, desk.derived.planes[0].shadows[0].shadowed_world_from_world,
                  desk.derived.planes[0].mirrored_world_from_world})
                ASSERT_FALSE(has_nan(matrix));
            // An open dialog would receive everything that follows.
            if (action % 10 == 9) desk.press(Key::escape);
        }
    }
    std::filesystem::current_path(start);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace viewing::test
