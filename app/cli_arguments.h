// The command line of the headless program: commands, their options, and what the user gave.
#pragma once

#include "core/base/units.h"

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace facetmill::cli {

struct OptionInfo {
    std::string name;  ///< "-o", "--units"
    std::string value; ///< placeholder of the value, "FILE"; empty: the option has none
    std::string help;
    bool required = false, repeated = false;
};

class Arguments;
class Session;

struct Command {
    std::string name;
    std::vector<std::string> operands; ///< placeholders; "[PART]", behind all others: may be left out
    std::string summary;               ///< one line
    std::string help;                  ///< more, for --help; may be empty
    std::vector<OptionInfo> options;
    std::function<void(const Arguments&, Session&)> run;
    bool draws = false; ///< done by the program that has VTK (cli_pictures.h)

    /// "facetmill-cli drop PART --cutter SHAPE ... -o FILE".
    std::string usage() const;
    std::string help_text() const;
};

/// What stands after the command. All errors are Error(usage).
class Arguments {
public:
    Arguments(const Command& command, const std::vector<std::string>& words);

    const std::string& operand(std::size_t i) const { return operands_[i]; }
    bool has_operand(std::size_t i) const { return i < operands_.size(); }
    bool has(std::string_view option) const;
    /// Its value; the fallback when it was not given.
    std::string value(std::string_view option, const std::string& fallback = {}) const;
    std::vector<std::string> values(std::string_view option) const;
    /// All options and their values in the order in which they were given.
    std::vector<std::pair<std::string, std::string>> given() const;
    /// A number; the fallback when the option was not given.
    double number(std::string_view option, double fallback) const;
    LengthUnit unit(std::string_view option, LengthUnit fallback) const;

private:
    struct Given {
        std::string option, value;
    };
    std::vector<std::string> operands_;
    std::vector<Given> given_;
};

} // namespace facetmill::cli
