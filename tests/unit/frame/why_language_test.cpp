// Whatever a frame computes is the same in every language, and is said in the current one.
#include <gtest/gtest.h>

#include "state/person/language.h"
#include "topics/depth/numbers/cures.h"
#include "topics/depth/numbers/near_advice.h"
#include "topics/why/numbers/why.h"
#include "unit/frame/frame_test.h"

namespace viewing {
namespace {

using Sentences = std::vector<Message>;

/// Returns what a frame says in sentences: its problems, the explanations of many of its pixels, its cures for depth
/// fighting, and its advice about near.
Sentences sentences_of(const std::string& preset, const std::vector<std::string>& settings) {
    const auto [base, scene] = testing::preset_named(preset);
    const Result<Params> params = apply_settings(base, settings);
    EXPECT_TRUE(params) << params.error();
    const Viewport viewport{{160, 90}};
    const Derived derived = derive(*params, scene, viewport);
    const FramePlan frame = plan(*params, derived);
    const FragmentFinder finder(scene);
    const std::vector<Problem> problems = find_problems(*params, derived, scene, frame);
    EXPECT_GT(problems.size(), 1U) << preset;
    Sentences all;
    for (const Problem& problem : problems) all.push_back(problem.sentence);
    for (int y = 10; y < viewport.size_px.y; y += 20)
        for (int x = 10; x < viewport.size_px.x; x += 20) {
            const Why made = why({*params, derived, frame, finder, viewport, problems, {x, y}});
            all.push_back(why_as_text(made));
            for (const WhyLine& line : made.lines)
                if (!line.label.empty()) all.push_back(line.label);
        }
    for (const Cure& cure : cures(*params, derived, scene)) all.push_back(cure.explanation);
    if (const std::optional<NearAdvice> advice = near_advice(*params, derived, scene)) all.push_back(advice->sentence);
    return all;
}

TEST(Sentences, DoNotDependOnTheLanguage) {
    const std::pair<const char*, std::vector<std::string>> frames[] = {
        {"opening",
         {"reflection.reflect_light=false", "cull.enabled=true", "cull.face=\"front\"", "projection.near=0.001"}},
        {"room", {"shadow.stencil_once=false", "cull.enabled=true", "cull.face=\"front\""}},
        {"depth-fighting", {"cull.enabled=true", "cull.face=\"front\"", "projection.near=0.001"}},
        {"mirror-other-fovy", {"depth.test=false"}}};
    for (const auto& [preset, settings] : frames) {
        SCOPED_TRACE(preset);
        const Sentences english = sentences_of(preset, settings);
        const std::vector<std::string> in_english = testing::said(english);
        ASSERT_TRUE(speak(Language::ko));
        const Sentences korean = sentences_of(preset, settings);
        const std::vector<std::string> in_korean = testing::said(english);
        ASSERT_TRUE(speak(Language::en));
        EXPECT_TRUE(english == korean);
        EXPECT_EQ(in_english, testing::said(korean));
        for (std::size_t i = 0; i < in_english.size(); ++i) EXPECT_NE(in_english[i], in_korean[i]);
    }
}

}  // namespace
}  // namespace viewing
