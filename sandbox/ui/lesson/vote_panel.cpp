#include "ui/lesson/vote_panel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "text/catalogue.h"
#include "text/per_enum.h"
#include "ui/lesson/lesson_text.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

/// The character that a key types into the counts; 0: none.
char typed_sign(Key key) {
    constexpr Key letters[] = {Key::a, Key::b, Key::c, Key::d, Key::e, Key::f, Key::g, Key::h, Key::i};
    for (std::size_t i = 0; i < std::size(letters); ++i)
        if (key == letters[i]) return static_cast<char>('A' + i);
    if (key == Key::space || key == Key::comma) return ' ';
    if (const int digit = digit_of(key); digit >= 0) return static_cast<char>('0' + digit);
    return '\0';
}

/// One bar of the chart: a choice in one of the votes.
struct VoteBar {
    std::size_t choice = 0;
    VoteRound round = VoteRound::before_discussion;
    int votes = 0, percent = 0;

    std::string text() const { return fmt::format("{} % · {}", percent, votes); }
};

/// Returns the votes to draw, with the counts that are being typed.
PerEnum<VoteRound, VoteCounts, 2> shown_votes(const Ballot& ballot, const std::string& typed) {
    PerEnum<VoteRound, VoteCounts, 2> all{ballot.votes(VoteRound::before_discussion),
                                          ballot.votes(VoteRound::after_discussion)};
    if (const Result<VoteCounts> counts = typed_votes(typed, ballot.choices()))
        all[ballot.round()] = ballot.with(*counts);
    return all;
}

std::string round_text(VoteRound round, int votes, bool are_two) {
    if (round == VoteRound::after_discussion)
        return say_count(votes, "After the discussion: one vote", "After the discussion: {count} votes");
    return are_two ? say_count(votes, "Before the discussion: one vote", "Before the discussion: {count} votes")
                   : say_count(votes, "One vote", "{count} votes");
}

}  // namespace

int digit_of(Key key) {
    if (key == Key::zero) return 0;
    return key >= Key::one && key <= Key::nine ? static_cast<int>(key) - static_cast<int>(Key::one) + 1 : -1;
}

void VotePanel::close() {
    end_typing();
    is_shown_ = false;
}

void VotePanel::end_typing() {
    is_typing_ = false;
    typed_.clear();
    trouble_.clear();
}

void VotePanel::enter(Ballot& ballot) {
    const Result<VoteCounts> counts = typed_votes(typed_, ballot.choices());
    if (!counts) {
        trouble_ = counts.error();
        return;
    }
    ballot.take(*counts);
    end_typing();
}

bool VotePanel::type(const KeyPress& press, Ballot& ballot) {
    constexpr std::size_t longest = 60;
    if (press.key == Key::page_down || press.key == Key::page_up) {  // the lesson goes to another step
        enter(ballot);
        end_typing();
        return false;
    }
    if (press.key == Key::enter) {
        enter(ballot);
        return true;
    }
    if (press.key == Key::escape) {
        press.shift ? close() : end_typing();
        return !press.shift;
    }
    trouble_.clear();
    if (press.key == Key::backspace && !typed_.empty()) typed_.pop_back();
    if (const char sign = typed_sign(press.key); sign != '\0' && typed_.size() < longest) typed_ += sign;
    return press.key < Key::f1;  // also uses up letters that have no effect
}

bool VotePanel::take(const KeyPress& press, LessonRun& run) {
    Ballot& ballot = run.ballot();
    if (ballot.choices() == 0) return press.key == Key::v && !press.ctrl;
    if (press.ctrl) {
        if (press.key != Key::z || !is_shown_) return false;
        if (typed_.empty())
            ballot.undo();
        else
            typed_.clear();
        trouble_.clear();
        return true;
    }
    if (press.key == Key::v) {
        end_typing();
        if (run.is_revealed()) {  // voting is over
            is_shown_ = !is_shown_;
            return true;
        }
        ballot.begin(press.shift ? VoteRound::after_discussion : VoteRound::before_discussion);
        is_shown_ = is_typing_ = true;
        return true;
    }
    if (is_typing_) return type(press, ballot);
    if (press.key == Key::escape && is_shown_ && !press.shift) {
        close();
        return true;
    }
    const int digit = digit_of(press.key);
    if (digit <= 0 || run.is_revealed()) return false;
    ballot.count(digit - 1, press.shift ? -1 : 1);
    is_shown_ = is_shown_ || digit <= static_cast<int>(ballot.choices());
    return true;
}

void VotePanel::draw(const LessonRun& run, const Rect& room) const {
    if (!is_shown_) return;
    const Ballot& ballot = run.ballot();
    const PerEnum<VoteRound, VoteCounts, 2> votes = shown_votes(ballot, typed_);
    const bool has_second =
        ballot.round() == VoteRound::after_discussion || ballot.has_votes(VoteRound::after_discussion);
    const bool are_two = has_second && ballot.has_votes(VoteRound::before_discussion);
    std::vector<VoteRound> rounds;
    if (are_two || !has_second) rounds.push_back(VoteRound::before_discussion);
    if (has_second) rounds.push_back(VoteRound::after_discussion);

    ImFont* const font = widgets::CurrentContext().fonts.caption;
    const float size = font->FontSize, line = std::floor(size * 1.2F), margin = std::floor(size * 0.6F);
    const auto width_of = [&](const std::string& text) {
        return font->CalcTextSizeA(size, FLT_MAX, 0.0F, text.c_str()).x;
    };
    std::vector<VoteBar> bars;
    float number_room = width_of("100 % · 200");
    for (std::size_t choice = 0; choice < ballot.choices(); ++choice)
        for (const VoteRound round : rounds) {
            const VoteCounts& counts = votes[round];
            bars.push_back({choice, round, counts[choice], vote_shares(counts)[choice]});
            number_room = std::max(number_room, width_of(bars.back().text()));
        }

    const float width = std::min(std::max(room.width() * 0.46F, size * 22.0F), room.width());
    const float inner = width - 2.0F * margin;
    std::string hint = trouble_;
    if (is_typing_ && typed_.empty()) hint = tr("Type A 80 B 60, then Enter.");
    const Paragraph below = paragraph(hint, font, inner);
    const auto rows = static_cast<float>(bars.size());
    const float between = std::floor(size * 0.35F),
                between_all = between * (static_cast<float>(ballot.choices()) + 0.5F);
    const float typed_height = typed_.empty() ? 0.0F : line;
    const float height =
        2.0F * margin + line * (static_cast<float>(rounds.size()) + rows) + between_all + typed_height + below.height;
    ImDrawList* const draw = ImGui::GetForegroundDrawList();
    const ImVec2 max(room.max.x - px(8.0F), room.max.y - px(8.0F)), min(max.x - width, std::max(max.y - height, 0.0F));
    draw->AddRectFilled(min, max, palette().raised, px(6.0F));
    draw->AddRect(min, max, palette().border, px(6.0F), 0, px(1.5F));
    const auto write = [&](float x, float y, ImU32 color, const std::string& text) {
        draw->AddText(font, size, {std::floor(x), std::floor(y)}, color, text.c_str());
    };
    const auto color_of = [&](VoteRound round) {
        return are_two && round == VoteRound::before_discussion ? palette().quiet : palette().accent;
    };
    const float left = min.x + margin, right = max.x - margin;
    float y = min.y + margin;
    for (const VoteRound round : rounds) {
        const float side = std::floor(size * 0.7F), top = y + (size - side) * 0.5F;
        draw->AddRectFilled({left, top}, {left + side, top + side}, color_of(round));
        write(left + side + margin * 0.6F, y, palette().text, round_text(round, total_votes(votes[round]), has_second));
        y += line;
    }
    y += between;
    const float letter_room = std::floor(size * 1.1F);
    const float bar_left = left + letter_room, bar_room = right - number_room - margin * 0.6F - bar_left;
    for (const VoteBar& bar : bars) {
        if (bar.round == rounds.front()) {
            if (bar.choice > 0) y += between;
            write(left, y, palette().accent, std::string(1, static_cast<char>('A' + bar.choice)));
        }
        const float bar_width = std::max(bar_room * static_cast<float>(bar.percent) / 100.0F, px(2.0F));
        const bool is_right = run.is_revealed() && run.step().ask.choices[bar.choice].right;
        draw->AddRectFilled({bar_left, y}, {bar_left + bar_width, y + size}, color_of(bar.round));
        if (is_right)
            draw->AddRect({bar_left - px(2.0F), y - px(2.0F)}, {bar_left + bar_room + px(2.0F), y + size + px(2.0F)},
                          palette().plane, px(3.0F), 0, px(2.5F));
        const std::string text = bar.text();
        write(right - width_of(text), y, palette().text, text);
        y += line;
    }
    y += between * 0.5F;
    if (typed_height > 0.0F) {
        write(left, y, palette().text, typed_);
        const float caret = left + width_of(typed_) + px(2.0F);
        draw->AddRectFilled({caret, y}, {caret + px(2.0F), y + size}, palette().accent);
        y += line;
    }
    if (!hint.empty())
        draw->AddText(font, size, {left, y}, trouble_.empty() ? palette().quiet : palette().trouble,
                      below.lines.c_str());
}

}  // namespace viewing
