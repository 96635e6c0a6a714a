#include "app/manual/words.h"

#include "core/base/error.h"
#include "core/base/file.h"

#include <cctype>
#include <sstream>

namespace facetmill::manual {

namespace {

void replace_all(std::string& text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
}

/// What stands between two marks from `at` on, which moves behind them; XML's signs become letters.
bool take(const std::string& xml, const std::string& from, const std::string& to, std::size_t& at,
          std::string& found) {
    const auto begin = xml.find(from, at);
    if (begin == std::string::npos) return false;
    const auto end = xml.find(to, begin);
    if (end == std::string::npos) return false;
    found = xml.substr(begin + from.size(), end - begin - from.size());
    for (const auto& [sign, letter] :
         {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}})
        replace_all(found, sign, letter);
    at = end + to.size();
    return true;
}

/// Whether there is anything to translate beside `code`, numbers and signs.
bool has_words(const std::string& text) {
    bool code = false;
    int letters = 0;
    for (const char c : text) {
        if (c == '`') code = !code;
        letters = !code && std::isalpha(static_cast<unsigned char>(c)) ? letters + 1 : 0;
        if (letters == 4) return true;
    }
    return false;
}

} // namespace

Words::Words(const std::filesystem::path& resources, const std::string& language) : language_(language) {
    const auto text_of = [](const std::filesystem::path& file) {
        const InputFile in(file);
        return std::string(in.bytes());
    };
    read_window_words(text_of(resources / "languages" / ("facetmill_" + language + ".ts")));
    read_own_words(text_of(resources / "manual" / language / "words.txt"));
}

void Words::read_window_words(const std::string& file) {
    std::size_t at = 0, inner = 0;
    for (std::string message, source, said; take(file, "<message>", "</message>", at, message);) {
        // Signs were read once already; what stands within is plain.
        inner = 0;
        if (take(message, "<source>", "</source>", inner, source)
            && take(message, "<translation>", "</translation>", inner, said))
            take_window_text(source, said);
    }
}

/// Those of core come first in the file. Short texts with places would fit too much.
void Words::take_window_text(const std::string& english, const std::string& said) {
    constexpr std::size_t telling = 24;
    texts_.emplace(english, said);
    if (english.size() >= telling) add_template(english, said);
}

void Words::read_own_words(const std::string& file) {
    std::istringstream lines(file);
    for (std::string english, said; std::getline(lines, english);) {
        if (english.empty()) continue;
        if (!std::getline(lines, said) || said.empty())
            throw Error(ErrorCode::syntax, "words.txt", "nothing stands below \"" + english + "\"",
                        "translate it");
        texts_[english] = said;
        add_template(english, said);
    }
}

/// Where a text has places: what stands between them, by which it is known again.
void Words::add_template(const std::string& english, const std::string& said) {
    if (english.find("{1}") == std::string::npos) return;
    Template made{{}, said};
    std::size_t from = 0;
    for (int k = 1;; ++k) {
        const std::string place = "{" + std::to_string(k) + "}";
        const auto to = english.find(place, from);
        made.between.push_back(english.substr(from, to == std::string::npos ? std::string::npos : to - from));
        if (to == std::string::npos) break;
        from = to + place.size();
    }
    templates_.push_back(std::move(made));
}

bool Words::find(const std::string& english, std::string& said) const {
    if (const auto known = texts_.find(english); known != texts_.end()) {
        said = known->second;
        return true;
    }
    for (const Template& t : templates_) {
        const std::string &head = t.between.front(), &tail = t.between.back();
        if (english.size() < head.size() + tail.size() || !english.starts_with(head)
            || !english.ends_with(tail))
            continue;
        std::vector<std::string> places;
        std::size_t at = head.size();
        for (std::size_t k = 1; k < t.between.size() && at != std::string::npos; ++k) {
            const bool last = k + 1 == t.between.size();
            const auto to = last ? english.size() - tail.size() : english.find(t.between[k], at);
            if (to == std::string::npos || to < at) {
                at = std::string::npos;
                break;
            }
            places.push_back(english.substr(at, to - at));
            at = to + t.between[k].size();
        }
        std::string whole = t.said;
        bool fits = at != std::string::npos;
        for (std::size_t k = 0; fits && k < places.size(); ++k) {
            std::string word = places[k];
            fits = find(places[k], word) || !has_words(word); // else a sentence would fit as well
            replace_all(whole, "{" + std::to_string(k + 1) + "}", word);
        }
        if (!fits) continue;
        said = whole;
        return true;
    }
    return false;
}

std::string Words::of(const std::string& english) const {
    std::string said = english;
    if (language_ == "en" || find(english, said)) return said;
    if (has_words(english)) missing_.insert(english);
    return said;
}

std::string Words::measure(std::string said) const {
    const std::string half = of("0.5");
    const auto digit = [&](std::size_t at) {
        return at < said.size() && std::isdigit(static_cast<unsigned char>(said[at]));
    };
    for (std::size_t i = 1; i < said.size(); ++i)
        if (said[i] == '.' && digit(i - 1) && digit(i + 1)) said[i] = half[1];
    replace_all(said, "rpm", of("rpm"));
    return said;
}

} // namespace facetmill::manual
