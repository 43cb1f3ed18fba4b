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
