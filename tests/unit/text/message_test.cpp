// Messages are compared without a language and said in the current one.
#include "text/message.h"

#include <gtest/gtest.h>

namespace viewing {
namespace {

class MessageTest : public ::testing::Test {
protected:
    ~MessageTest() override { speak_english(); }

    static void speak_other() {
        speak(std::vector<PoEntry>{{"Shadow of light {light}", "{light}번 빛의 그림자"},
                                   {"{pass} in mirror {mirrors}", "거울 {mirrors}: {pass}"},
                                   {"{light} on {plane}", "{plane}[/]: {light}"},
                                   {"{names}, and {last_name}", "{names}, {last_name}"},
                                   {"the light", "빛"},
                                   {"the plane", "평면"},
                                   {"post", "기둥"}});
    }
};

TEST_F(MessageTest, IsSaidInTheLanguageOfThatMoment) {
    const Message shadow = message("Shadow of light {light}", "light"_a = 2);
    EXPECT_EQ(say(shadow), "Shadow of light 2");
    speak_other();
    EXPECT_EQ(say(shadow), "2번 빛의 그림자");
    EXPECT_EQ(shadow, message("Shadow of light {light}", "light"_a = 2));
    EXPECT_EQ(say(message("untranslated {braces}", "braces"_a = "{}")), "untranslated {}");
}

TEST_F(MessageTest, TranslatesTheMessagesInIt) {
    const Message inside = message("{pass} in mirror {mirrors}", "mirrors"_a = "2, 3",
                                   "pass"_a = message("Shadow of light {light}", "light"_a = 1));
    EXPECT_EQ(say(inside), "Shadow of light 1 in mirror 2, 3");
    speak_other();
    EXPECT_EQ(say(inside), "거울 2, 3: 1번 빛의 그림자");
    EXPECT_EQ(say("{pass}.", "pass"_a = inside), "거울 2, 3: 1번 빛의 그림자.");
}

TEST_F(MessageTest, ListsObjectsByTheirTranslatedNames) {
    const Message objects = listed({object_message("post 3"), object_message("my {own} thing")});
    EXPECT_EQ(say(objects), "post 3, my {own} thing");
    EXPECT_TRUE(listed({}).empty());
    const Message told = message("near cuts into {objects} at z = {z}", "objects"_a = objects, "z"_a = "0.5");
    speak_other();
    EXPECT_EQ(say(objects), "기둥 3, my {own} thing");
    const std::vector<std::pair<std::string, std::string>> values = {{"objects", "기둥 3, my {own} thing"},
                                                                     {"z", "0.5"}};
    EXPECT_EQ(told.said_values(), values);
}

TEST_F(MessageTest, EnumeratesNamesAsInASentence) {
    const Message light = message("the light"), post = object_message("post 3"), plane = message("the plane");
    EXPECT_TRUE(enumerated({}).empty());
    EXPECT_EQ(say(enumerated({light})), "the light");
    EXPECT_EQ(say(enumerated({light, post})), "the light and post 3");
    EXPECT_EQ(say(enumerated({light, post, plane})), "the light, post 3, and the plane");
    speak_other();
    EXPECT_EQ(say(enumerated({light, post, plane})), "빛, 기둥 3, 평면");
}

TEST_F(MessageTest, IsJoinedFromWholeMessages) {
    const Message parts = listed({message("the light"), verbatim("the light"), ""}, " → ");
    EXPECT_EQ(say(parts), "the light → the light → ");
    EXPECT_FALSE(parts == listed({message("the light"), verbatim("the light"), ""}));
    speak_other();
    EXPECT_EQ(say(parts), "빛 → the light → ");
}

TEST_F(MessageTest, BecomesASentenceWhereItIsSaid) {
    const auto shines = [](const char* name) { return message("{light} shines", "light"_a = Message(name, {})); };
    EXPECT_EQ(say(ended(begun(shines("the light")))), "The light shines.");
    EXPECT_EQ(say(begun(shines("n·ℓ"))), "n·ℓ shines");
    EXPECT_EQ(say(ended("Done.")), "Done.");
    EXPECT_EQ(say(begun(Message())), "");
    EXPECT_FALSE(begun("so") == ended("so"));
    speak_other();
    EXPECT_EQ(say(ended(begun(shines("the light")))), "빛 shines.");
}

TEST_F(MessageTest, CountsAsSayCountDoes) {
    const auto nodes = [](std::int64_t count) {
        return message_count(count, "{count} node of {tree}", "{count} nodes of {tree}",
                             "tree"_a = message("the light"));
    };
    EXPECT_EQ(say(nodes(1)), "1 node of the light");
    EXPECT_EQ(say(nodes(1200)), "1,200 nodes of the light");
    EXPECT_EQ(say(message_count(1, "One node.", "{count} nodes.")), "One node.");
    EXPECT_FALSE(nodes(2) == nodes(3));
}

TEST_F(MessageTest, DiffersByTemplateAndByEachValue) {
    const auto shadow = [](int light) { return message("Shadow of light {light}", "light"_a = light); };
    const auto inside = [](const Message& pass) {
        return message("{pass} in mirror {mirrors}", "pass"_a = pass, "mirrors"_a = "2");
    };
    EXPECT_FALSE(shadow(1) == shadow(2));
    EXPECT_FALSE(inside(shadow(1)) == inside(shadow(2)));
    EXPECT_TRUE(inside(shadow(1)) == inside(shadow(1)));
    EXPECT_FALSE(object_message("box") == object_message("ball"));
    EXPECT_TRUE(message("Objects") == "Objects");
    EXPECT_FALSE(message("Objects") == "Decals");
    EXPECT_TRUE(Message().empty());
    EXPECT_EQ(say(Message()), "");
}

}  // namespace
}  // namespace viewing
