// Shared by the tests of the hidden-surface views: a desk with a topic and a method selected, and a temporary folder.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "desk.h"

namespace viewing::test {

class HiddenViews : public ::testing::Test {
protected:
    explicit HiddenViews(const std::string& state = "interpenetrating", ImVec2 size = {1600, 640})
        : desk(size, state) {}

    void show(Topic topic, VisibilityMethod method, int step = -1) {
        params.visibility.method = method;
        params.visibility.step = step;
        ui.frame();  // changing the method selects its topic
        desk.params().view.lower_right = topic;
        desk.settle();
    }
    HiddenState& hidden() { return desk.workbench.views.hidden; }
    const HiddenResult& result() const { return *desk.answer()->camera; }
    bool says(std::string_view start) const {
        return std::ranges::any_of(desk.recorded(), [&](const RecordedItem& item) {
            return std::string_view(item.label).starts_with("lower/" + std::string(start));
        });
    }
    /// Returns the node that holds a fragment, found by searching all nodes; −1 if there is none.
    int node_that_holds(int fragment) const {
        const auto& nodes = result().tree->nodes;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (fragment >= nodes[i].first_fragment && fragment < nodes[i].first_fragment + nodes[i].fragment_count)
                return static_cast<int>(i);
        return -1;
    }
    std::map<std::string, std::pair<float, float>> node_places() const {
        std::map<std::string, std::pair<float, float>> places;
        for (const RecordedItem& item : desk.recorded())
            if (item.label.starts_with("lower/tree/") && std::isdigit(item.label.back()))
                places[item.label] = {item.min.x, item.min.y};
        return places;
    }

    Desk desk;
    widgets::test::Harness& ui = desk.ui;
    Params& params = desk.session.params;
};

/// A temporary folder that is the working directory during its lifetime.
struct TemporaryFolder {
    std::filesystem::path path;
    std::filesystem::path before = std::filesystem::current_path();
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "viewing-XXXXXX").string();
        path = mkdtemp(pattern.data());
        std::filesystem::current_path(path);
    }
    ~TemporaryFolder() {
        std::filesystem::current_path(before);
        std::filesystem::remove_all(path);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

}  // namespace viewing::test
