// What pages say in a language: the words of the window (resources/languages) and those of the manual alone
// (resources/manual/LANGUAGE/words.txt).
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace facetmill::manual {

class Words {
public:
    /// English, which needs none.
    Words() = default;
    /// `language`: "de", a folder of `resources`/manual.
    Words(const std::filesystem::path& resources, const std::string& language);

    /// What an English text is in the language; the text itself where it is not known.
    std::string of(const std::string& english) const;
    /// Numbers and units of a short text in the language's way: "0,5 tr/min". Its decimal mark is that of
    /// what it calls "0.5".
    std::string measure(std::string said) const;
    /// "en" or as it was asked for.
    const std::string& language() const { return language_; }
    /// Texts with words that were asked for and are not known.
    const std::set<std::string>& missing() const { return missing_; }

private:
    void read_window_words(const std::string& file);
    void take_window_text(const std::string& english, const std::string& said);
    void read_own_words(const std::string& file);
    void add_template(const std::string& english, const std::string& said);
    bool find(const std::string& english, std::string& said) const;

    std::string language_ = "en";
    std::map<std::string, std::string> texts_;
    /// Texts with places, "{1} to {2}": what stands between these.
    struct Template {
        std::vector<std::string> between;
        std::string said;
    };
    std::vector<Template> templates_;
    mutable std::set<std::string> missing_;
};

} // namespace facetmill::manual
