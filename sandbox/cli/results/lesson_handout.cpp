#include "cli/results/lesson_handout.h"

#include <algorithm>
#include <string_view>

#include "app/picture.h"
#include "cli/output.h"
#include "cli/state_arguments.h"
#include "grading/lesson_numbers.h"
#include "image/png.h"
#include "lesson/filled_text.h"
#include "lesson/notes.h"
#include "text/catalogue.h"
#include "text/html.h"
#include "text/subscripts.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr glm::ivec2 step_picture_px{1600, 800};

constexpr const char* handout_style = R"(
@page { size: A4; margin: 18mm }
body { font: 12pt/1.4 Inter, "NanumBarunGothic", "Noto Sans KR", "Malgun Gothic", "Apple SD Gothic Neo", "DejaVu Sans", sans-serif;
       color: #15181d; max-width: 174mm; margin: auto; word-break: keep-all; overflow-wrap: break-word }
section { break-after: page }
section:last-child { break-after: auto }
h1 { font-size: 12pt; font-weight: 600; color: #5a6470; margin: 0 0 4mm }
img { width: 100%; border: 0.3mm solid #c5ccd4; border-radius: 1mm }
p { margin: 4mm 0 0 }
.question { font-weight: 600 }
.person { display: flex; gap: 6mm; margin: 0 0 4mm; color: #5a6470 }
.person span { flex: 1; border-bottom: 0.3mm solid #8a94a0 }
ol { list-style: upper-alpha; margin: 2mm 0 0; padding-left: 8mm }
ol.items { list-style: disc }
.blank { margin-top: 6mm; border-bottom: 0.3mm solid #8a94a0; height: 9mm }
.answer { margin-top: 6mm; padding: 3mm 4mm; background: #eef2f6; border-left: 1mm solid #2f7de1 }
)";

/// Returns a line for the student's number, name and class, and the date.
std::string person_line() {
    std::string line = "<p class=\"person\">";
    for (const char* what : {marked("Student number"), marked("Name"), marked("Class"), marked("Date")})
        line += std::string("<span>") + tr(what) + "</span>";
    return line + "</p>\n";
}

/// Escapes a sentence, and makes the spaces in its formulas non-breaking.
std::string prose(const std::string& sentence) {
    std::string page;
    for (std::string_view rest = sentence; !rest.empty();) {
        const std::string_view unbroken = unbroken_start(rest);
        for (const TextPart& part : subscript_parts(unbroken)) {
            if (part.is_lowered) page += "<sub>";
            for (const char c : escaped(part.text)) c == ' ' ? page += "&nbsp;" : page += c;
            if (part.is_lowered) page += "</sub>";
        }
        if (unbroken.size() < rest.size()) page += ' ';
        rest.remove_prefix(std::min(rest.size(), unbroken.size() + 1));
    }
    return page;
}

std::string paragraph(const char* name, const std::string& text) {
    return text.empty() ? "" : "<p class=\"" + std::string(name) + "\">" + prose(text) + "</p>\n";
}

/// Returns a list of the choices or items or, if the question has neither, a line to write the answer on.
std::string answers(const Ask& ask) {
    std::string list;
    for (const LessonChoice& choice : ask.choices) list += "<li>" + prose(choice.say.shown()) + "</li>\n";
    for (const LessonText& item : ask.items) list += "<li>" + prose(item.shown()) + "</li>\n";
    if (list.empty()) return "<div class=\"blank\"></div>\n";
    return std::string(ask.items.empty() ? "<ol>\n" : "<ol class=\"items\">\n") + list + "</ol>\n";
}

std::string answer_of(const LessonStep& step) {
    const Scene scene = scene_of(step.start);
    LessonNumbers numbers(step.start.params, step.start.params, scene, nullptr);
    return "<div class=\"answer\"><strong>" + prose(answer_in_words(step.ask, numbers.surroundings())) +
           "</strong><br>" +
           prose(filled_or_same(step.reveal.say, with_constants(step.ask, numbers.surroundings())).shown()) +
           "</div>\n";
}

std::string step_picture(Headless& headless, const Lesson& lesson, std::size_t index) {
    LoadedState state = lesson.steps[index].start;
    state.params.ui = {.theme = Theme::light, .language = spoken_language()};  // for printing
    PictureRequest request;
    request.size_px = step_picture_px;
    request.lesson = std::make_shared<const LessonPicture>(LessonPicture{lesson, index, false, true, false});
    const Image image = headless.drawn(draw_picture(headless.renderer(), state, scene_of(state), request));
    return "<img alt=\"\" src=\"data:image/png;base64," + base64(encode_png(image)) + "\">\n";
}

}  // namespace

std::string handout(Headless& headless, const Lesson& lesson, bool with_answers) {
    const std::string title = escaped(lesson.title.shown());
    std::string page = "<!DOCTYPE html>\n<html lang=\"" + std::string(name_of(spoken_language())) +
                       "\">\n<meta charset=\"utf-8\">\n<title>" + title + "</title>\n<style>" + handout_style +
                       "</style>\n";
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const LessonStep& step = lesson.steps[i];
        page += "<section>\n<h1>" + title + " · " + std::to_string(i + 1) + " / " + std::to_string(lesson.steps.size());
        if (lesson.lecture) page += " · " + escaped(lesson.lecture->parts[lesson.lecture->part_of(i)].title.shown());
        page += "</h1>\n";
        if (i == 0) page += person_line();
        page += step_picture(headless, lesson, i);
        page += paragraph("say", step.say.shown());
        if (step.only_shows())
            page += paragraph("say", step.ask.question.shown());
        else
            page += paragraph("question", step.ask.question.shown()) + answers(step.ask) +
                    (with_answers ? answer_of(step) : "");
        page += "</section>\n";
    }
    return page + "</html>\n";
}

void write_handout(const Lesson& lesson, const std::string& output, bool with_answers, const std::string& device,
                   Language language) {
    Headless headless(device);
    value_or_end(speak(language));
    Outputs outputs;
    outputs.add(output, handout(headless, lesson, with_answers));
    outputs.write();
}

}  // namespace viewing
