// Links: every state round-trips through its own link exactly, and an invalid or hostile link is reported in a
// sentence.
#include <gtest/gtest.h>
#include <zlib.h>

#include "platform/sanitized.h"
#include "random_params.h"
#include "state/file/link.h"
#include "state/file/state_json.h"
#include "state/presets.h"
#include "trials.h"

namespace viewing {
namespace {

/// Returns "#1" and the deflated text in base64url, whatever the text is.
std::string link_of(const std::string& text) {
    static constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    uLongf size = compressBound(text.size());
    std::string bytes(size, '\0');
    EXPECT_EQ(compress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                       text.size()),
              Z_OK);
    bytes.resize(size);
    std::string link = "#1";
    for (std::size_t i = 0; i < size; i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8U | (i + k < size ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4 && i + k <= size; ++k) link += digits[bits >> (18 - 6 * k) & 63U];
    }
    return link;
}

std::string trouble_with(const std::string& link) {
    const Result<LoadedState> state = load_state(link);
    return state ? "nothing" : state.error();
}

void expect_back(const Params& params) {
    const std::string fragment = link_fragment(params);
    const Result<LoadedState> back = load_state(link_base() + fragment);
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(back->params, params);
    EXPECT_EQ(write_state(back->params), write_state(params));
    EXPECT_EQ(link_fragment(back->params), fragment);
}

TEST(Link, EveryPresetRoundTrips) {
    ASSERT_GT(presets().size(), 50U);
    for (const NamedFile& preset : presets()) {
        SCOPED_TRACE(preset.name);
        expect_back(load_state(preset.name)->params);
        EXPECT_LT(link_fragment(load_state(preset.name)->params).size(), 1000U);
    }
    EXPECT_LT(link_fragment(Params{}).size(), 30U);
}

TEST(Link, RandomStatesRoundTrip) {
    testing::RandomParams random(23);
    for (int i = 0; i < testing::trials(is_sanitized ? 100 : 300); ++i) {
        SCOPED_TRACE(i);
        expect_back(random.make());
    }
}

TEST(Link, NamesAPresetOrAStepOfALesson) {
    const Result<LoadedState> room = load_state("https://example.org/viewing-sandbox.html#preset=room");
    ASSERT_TRUE(room) << room.error();
    ASSERT_TRUE(room->preset);
    EXPECT_EQ(room->preset->name, "room");
    EXPECT_EQ(trouble_with("#lesson=depth-fighting&step=3"),
              "this link opens a lesson: use viewing-sandbox lesson depth-fighting --step 3");
    EXPECT_EQ(trouble_with("#step=3&lesson=mine"),
              "this link opens a lesson: use viewing-sandbox lesson mine --step 3");
    EXPECT_EQ(trouble_with("#lesson=mine"), "this link opens a lesson: use viewing-sandbox lesson mine --step 1");
    EXPECT_EQ(trouble_with("#preset=roon").substr(0, 27), "link: roon: no such preset ");
    for (const char* bad : {"#preset=", "#preset=-", "#preset=../room", "#preset=/etc/passwd", "#preset=a.json"})
        EXPECT_TRUE(trouble_with(bad).starts_with("link: ")) << bad << trouble_with(bad);
    for (const char* bad :
         {"#lesson=", "#lesson=a b", "#lesson=a&step=x", "#lesson=a&step=99999", "#lesson=a&step=0", "#lesson=a&step="})
        EXPECT_EQ(trouble_with(bad), "link: it does not name a lesson and a step") << bad;
}

TEST(Link, RefusesUnknownParts) {
    constexpr const char* known = "a state, preset=NAME, or lesson=ID and step=N";
    const std::string state = link_fragment(Params{});
    EXPECT_TRUE(load_state(state + "&"));
    EXPECT_EQ(trouble_with("#preset=room&colour=red"), std::string("link: colour=… is unknown; use ") + known);
    EXPECT_EQ(trouble_with(state + "&x=1"), std::string("link: x=… is unknown; use ") + known);
    EXPECT_EQ(trouble_with("#preset=room&hello"),
              std::string("link: hello after the # is neither a state nor KEY=VALUE; use ") + known);
    for (const std::string& twice : {std::string("#preset=room&preset=room"), state + "&" + state.substr(1)})
        EXPECT_EQ(trouble_with(twice),
                  std::string("link: a part appears twice after the #; use ") + known + ", each once");
    for (const std::string& bad : {std::string("#"), std::string("#step=2&&"), "#preset=room&" + state.substr(1),
                                   std::string("#preset=room&lesson=depth-fighting")})
        EXPECT_TRUE(trouble_with(bad).starts_with("link: ")) << bad << trouble_with(bad);
    EXPECT_EQ(trouble_with("#preset=room&step=2"), "link: step=N needs lesson=ID");
}

TEST(Link, DiffersFromAStateThatMentionsOne) {
    const Result<LoadedState> state =
        state_in_text("{\"about\": \"see viewing-sandbox.html#preset=room\"}", "standard input");
    ASSERT_TRUE(state) << state.error();
    EXPECT_FALSE(state->preset);
    EXPECT_EQ(state_in_text("#preset=room\n", "standard input")->preset->name, "room");
    EXPECT_EQ(state_in_text("{\"camera\": 1}", "standard input").error().substr(0, 22), "standard input: camera");
}

TEST(Link, DiffersFromFilesAndPresets) {
    for (const char* link :
         {"#1abc", "http://a#1", "https://a/b.html", "file:///tmp/v.html#1", "viewing-sandbox.html#1"})
        EXPECT_TRUE(is_link(link)) << link;
    for (const char* other : {"room", "mine.json", "a#1.json", "folder/b#c.png", "-", ""})
        EXPECT_FALSE(is_link(other)) << other;
}

TEST(Link, RefusesBrokenLinksWithASentence) {
    const std::string whole = link_fragment(load_state("room")->params);
    for (std::size_t length = 2; length < whole.size(); ++length)
        EXPECT_EQ(trouble_with(whole.substr(0, length)), "link: it is cut off or damaged") << length;
    for (std::size_t at = 2; at < whole.size(); ++at) {
        std::string changed = whole;
        changed[at] = changed[at] == 'A' ? 'B' : 'A';
        const Result<LoadedState> state = load_state(changed);
        if (state)  // the padding bits of the last character carry no data
            EXPECT_EQ(state->params, load_state("room")->params) << at;
        else
            EXPECT_TRUE(state.error().starts_with("link: ")) << at << ": " << state.error();
    }
    EXPECT_EQ(trouble_with(whole + "AAAA"), "link: unexpected data after the end of its state");
    EXPECT_EQ(trouble_with("#2" + whole.substr(2)), "link: its format has version 2, but this program reads version 1");
    EXPECT_EQ(trouble_with("https://example.org/"), "link: there is no # followed by a state");
    EXPECT_EQ(trouble_with("#hello"),
              "link: hello after the # is neither a state nor KEY=VALUE; use a state, preset=NAME, or lesson=ID and "
              "step=N");
    EXPECT_NE(trouble_with(link_of("{\"scene\": \"\xff\"}")).find("UTF-8"), std::string::npos);
    EXPECT_EQ(trouble_with(link_of("{\"camera\": {\"yav\": 1}}")),
              "link: camera.yav: no such field; did you mean camera.yaw?");
    EXPECT_TRUE(trouble_with(link_of("{} {}")).starts_with("link: line 1"));
}

/// A link of a few hundred kilobytes would unpack to 200 MiB. Nothing beyond the limit may be unpacked.
TEST(Link, DoesNotUnpackABomb) {
    const std::string bomb = link_of(std::string(200U << 20U, ' '));
    ASSERT_LT(bomb.size(), 400'000U);
    EXPECT_EQ(trouble_with(bomb), "link: its state is longer than 16 MiB");
}

TEST(Link, ReachesNoFilesByItself) {
    const Result<LoadedState> state = load_state(link_of("{\"scene\": \"/etc/room.json\"}"));
    ASSERT_TRUE(state) << state.error();
    EXPECT_FALSE(state->reach.is_everywhere);
    EXPECT_TRUE(state->base.empty());
}

}  // namespace
}  // namespace viewing
