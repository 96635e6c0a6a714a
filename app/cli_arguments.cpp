#include "app/cli_arguments.h"

#include "core/base/error.h"
#include "core/base/parameter.h"

#include <algorithm>

namespace facetmill::cli {

namespace {

[[noreturn]] void usage_error(const std::string& where, const std::string& what, const std::string& remedy) {
    throw Error(ErrorCode::usage, where, what, remedy);
}

const OptionInfo& find_option(const Command& command, const std::string& name) {
    std::vector<std::string> known;
    for (const auto& o : command.options) {
        if (o.name == name) return o;
        known.push_back(o.name);
    }
    const std::string near = nearest_name(name, known);
    usage_error(command.name, "unknown option '" + printable(name) + "'",
                near.empty() ? "see facetmill-cli " + command.name + " --help"
                             : "did you mean '" + near + "'?");
}

} // namespace

std::string Command::usage() const {
    std::string text = "facetmill-cli " + name;
    for (const auto& o : operands)
        text += " " + o;
    for (const auto& o : options) {
        const std::string shown = o.name + (o.value.empty() ? "" : " " + o.value);
        text += o.required ? " " + shown : " [" + shown + "]" + (o.repeated ? "..." : "");
    }
    return text;
}

std::string Command::help_text() const {
    std::string text = "usage: " + usage() + "\n\n" + summary + "\n";
    if (!help.empty()) text += "\n" + help + "\n";
    if (!options.empty()) text += "\noptions:\n";
    for (const auto& o : options) {
        std::string left = "  " + o.name + (o.value.empty() ? "" : " " + o.value);
        left.resize(std::max<std::size_t>(left.size() + 2, 26), ' ');
        text += left + o.help + "\n";
    }
    return text;
}

Arguments::Arguments(const Command& command, const std::vector<std::string>& words) {
    bool only_operands = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (only_operands || word.size() < 2 || word[0] != '-') {
            operands_.push_back(word);
            continue;
        }
        if (word == "--") {
            only_operands = true;
            continue;
        }
        const std::size_t equal = word.starts_with("--") ? word.find('=') : std::string::npos;
        const std::string name = word.substr(0, equal);
        const OptionInfo& option = find_option(command, name);
        if (!option.repeated && has(name))
            usage_error(command.name, name + " is given twice", "give it once");
        std::string value;
        if (option.value.empty()) {
            if (equal != std::string::npos)
                usage_error(command.name, name + " takes no value", "leave it out");
        } else if (equal != std::string::npos) {
            value = word.substr(equal + 1);
        } else {
            if (i + 1 == words.size())
                usage_error(command.name, name + " has no value", "write " + name + " " + option.value);
            value = words[++i];
        }
        if (!option.value.empty() && value.empty())
            usage_error(command.name, name + " has an empty value", "write " + name + " " + option.value);
        given_.push_back({name, value});
    }
    if (operands_.size() > command.operands.size())
        usage_error(command.name, "unexpected '" + printable(operands_[command.operands.size()]) + "'",
                    "see facetmill-cli " + command.name + " --help");
    if (operands_.size() < command.operands.size() && !command.operands[operands_.size()].starts_with('['))
        usage_error(command.name, command.operands[operands_.size()] + " is missing",
                    "write " + command.usage());
    for (const std::string& o : operands_)
        if (o.empty()) usage_error(command.name, "an operand is empty", "write " + command.usage());
    for (const auto& o : command.options)
        if (o.required && !has(o.name))
            usage_error(command.name, o.name + " is missing", "write " + o.name + " " + o.value);
}

bool Arguments::has(std::string_view option) const {
    return std::any_of(given_.begin(), given_.end(), [&](const Given& g) { return g.option == option; });
}

std::string Arguments::value(std::string_view option, const std::string& fallback) const {
    for (const Given& g : given_)
        if (g.option == option) return g.value;
    return fallback;
}

std::vector<std::string> Arguments::values(std::string_view option) const {
    std::vector<std::string> all;
    for (const Given& g : given_)
        if (g.option == option) all.push_back(g.value);
    return all;
}

std::vector<std::pair<std::string, std::string>> Arguments::given() const {
    std::vector<std::pair<std::string, std::string>> all;
    for (const Given& g : given_)
        all.emplace_back(g.option, g.value);
    return all;
}

double Arguments::number(std::string_view option, double fallback) const {
    if (!has(option)) return fallback;
    double v = 0;
    const std::string text = value(option);
    if (!parse_number(text, v))
        usage_error(std::string(option), "'" + printable(text) + "' is not a number",
                    "write a decimal number");
    return v;
}

LengthUnit Arguments::unit(std::string_view option, LengthUnit fallback) const {
    if (!has(option)) return fallback;
    try {
        return parse_mesh_unit(value(option), std::string(option));
    } catch (const Error& e) {
        usage_error(e.where(), e.message(), e.remedy());
    }
}

} // namespace facetmill::cli
