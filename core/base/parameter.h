// One description per parameter. Name, label, unit, default, range, help text and the earliest stage to rerun
// stand once, beside the plain struct that holds the value (in core units). The form, `--set op.key=value`,
// the project file and the generated reference page read it from here.
//
//     struct Finish3Settings { double tolerance = 0.05; StepOver stepover; ... };
//     const ParameterTable<Finish3Settings>& finish3_parameters();   // built once, with pointers to members
#pragma once

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/base/vec.h"

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace facetmill {

/// Stages of a plan, in order; a changed parameter makes its stage and all later ones stale. What no stage
/// reads, as it helps the user alone, stands behind them: `advice`.
enum class Stage { mesh, cutter, contact, cspace, strategy, link, verify, output, advice };

enum class ParameterKind {
    number,         ///< double
    number_or_word, ///< double, or one of `words` ("auto", "adaptive")
    integer,        ///< long
    boolean,        ///< bool
    choice,         ///< one of `words`
    text,           ///< std::string
    pair,           ///< two numbers, low then high (limits) or in then out (tolerances)
    triple,         ///< three numbers
    names,          ///< std::string: names, separated by commas
    records,        ///< std::vector of a struct that has described parameters itself
};

struct ParameterRecords;

/// A value in core units. number_or_word holds either double or std::string.
using ParameterValue = std::variant<double, long, bool, std::string, std::array<double, 2>,
                                    std::array<double, 3>, ParameterRecords>;

/// A list of records: of each the values of its parameters, in the order of their descriptions.
struct ParameterRecords {
    std::vector<std::vector<ParameterValue>> all;
    bool operator==(const ParameterRecords& other) const;
};

/// A number, or a word in its place ("auto", "adaptive"). An empty word means the number counts.
struct NumberOrWord {
    double number = 0.0;
    std::string word;
    bool is(std::string_view w) const { return word == w; }
    bool is_number() const { return word.empty(); }
    bool operator==(const NumberOrWord&) const = default;
};

struct ParameterInfo {
    std::string key;   ///< in files and on the command line: snake_case
    std::string label; ///< in forms: "Step-over"
    std::string help;  ///< one or two sentences: what it does, when to change it
    ParameterKind kind = ParameterKind::number;
    Quantity quantity = Quantity::none;
    ParameterValue default_value = 0.0; ///< core units
    /// Range of every number of the value, in core units. `open_minimum`: the minimum itself is not allowed.
    double minimum = -infinity, maximum = infinity;
    bool open_minimum = false;
    bool ordered = false; ///< pair: first must be below second
    std::vector<std::string> words;
    Stage stage = Stage::strategy;
    bool advanced = false; ///< forms fold it away
    /// What to do where a file lacks the key, which has to be there then; empty: it may be missing.
    std::string required;
    /// names, records: what one and several of them are called ("kept posture", "kept postures").
    std::array<std::string, 2> nouns;
    std::vector<const ParameterInfo*> record; ///< records: the parameters of each
    bool written_empty = false;               ///< records: files have the key even where there are none
    bool default_unwritten = false;           ///< files do not have the key where the value is the default

    /// Throws Error(wrong_type or out_of_range) whose place is the key, in a record "holder[1].length"; NaN
    /// and infinity are always out of range. Numbers in the message are in the edge's unit `unit`.
    void check(const ParameterValue& value, LengthUnit unit = LengthUnit::mm) const;
    /// "> 0 mm", "0 to 45 °": the range in the edge's unit; empty when every number is allowed.
    std::string range_text(LengthUnit unit) const;
    /// The value as the edge writes it, with no unit: "0.05", "adaptive", "0, 45"; records as files have
    /// them.
    std::string value_text(const ParameterValue& value, LengthUnit unit) const;
    /// names, records: "3 kept postures", "none".
    std::string count_text(const ParameterValue& value) const;
    /// Is it one that a list holds?
    bool is_list() const { return kind == ParameterKind::names || kind == ParameterKind::records; }
    /// names, records: without any.
    ParameterValue empty_list() const;
    /// Reads what `value_text` writes; throws Error(wrong_type or out_of_range), for records also what
    /// read_parameters does (parameter_json.h).
    ParameterValue parse(std::string_view text, LengthUnit unit) const;
    /// Factor core = edge * factor.
    double scale(LengthUnit unit) const { return core_per_edge(quantity, unit); }
};

/// Type-erased view of "a struct with described parameters", so that forms and files need no templates.
class Parameterized {
public:
    virtual ~Parameterized() = default;
    virtual std::vector<const ParameterInfo*> parameters() const = 0;
    /// Throws Error(unknown_key) for a key that is not in `parameters()`.
    virtual ParameterValue get(std::string_view key) const = 0;
    /// Checks, then sets. Throws Error(unknown_key, wrong_type, out_of_range); nothing changes then.
    virtual void set(std::string_view key, const ParameterValue& value) = 0;

    /// Throws Error(unknown_key).
    const ParameterInfo& parameter(std::string_view key) const;
    bool has(std::string_view key) const;
};

[[noreturn]] void throw_unknown_key(std::string_view key, const std::vector<const ParameterInfo*>& known);

template <class Record>
struct RecordList;

template <class Struct>
class ParameterTable {
public:
    struct Entry {
        ParameterInfo info;
        std::function<ParameterValue(const Struct&)> get;
        std::function<void(Struct&, const ParameterValue&)> set;
    };

    /// Adds a member of a plain type (double, long, bool, std::string, NumberOrWord, std::array<double, 2 or
    /// 3>). The default is the member's value in a default-constructed struct.
    template <class Member>
    ParameterTable& add(Member Struct::*member, ParameterInfo info) {
        Entry e;
        e.get = [member](const Struct& s) { return to_value(s.*member); };
        e.set = [member](Struct& s, const ParameterValue& v) { from_value(s.*member, v); };
        return append(std::move(e), std::move(info));
    }
    /// Adds an enumeration as a choice; the words stand in the order of the enumerators, from 0.
    template <class Enum>
    ParameterTable& add_choice(Enum Struct::*member, ParameterInfo info) {
        info.kind = ParameterKind::choice;
        Entry e;
        const auto words = info.words;
        e.get = [member, words](const Struct& s) -> ParameterValue {
            return words.at(std::size_t(s.*member));
        };
        e.set = [member, words](Struct& s, const ParameterValue& v) {
            const auto& word = std::get<std::string>(v);
            s.*member = Enum(std::find(words.begin(), words.end(), word) - words.begin());
        };
        return append(std::move(e), std::move(info));
    }

    /// Adds a list of structs; its key and the description of a record are those of `list`.
    template <class Record>
    ParameterTable& add_records(std::vector<Record> Struct::*member, const RecordList<Record>& list,
                                ParameterInfo info) {
        info.kind = ParameterKind::records;
        info.key = list.key;
        info.record = list.table().infos();
        Entry e;
        e.get = [member, list](const Struct& s) -> ParameterValue { return list.values(s.*member); };
        e.set = [member, list](Struct& s, const ParameterValue& v) {
            s.*member = list.structs(std::get<ParameterRecords>(v));
        };
        return append(std::move(e), std::move(info));
    }

    /// Another stage than the entry was described with: for common parameters that an operation reads
    /// earlier. Throws Error(unknown_key).
    ParameterTable& set_stage(std::string_view key, Stage stage) {
        added(key).stage = stage;
        return *this;
    }
    /// Other words for what an operation reads in its own way. Throws Error(unknown_key).
    ParameterTable& set_help(std::string_view key, std::string help) {
        added(key).help = std::move(help);
        return *this;
    }

    const std::vector<Entry>& entries() const { return entries_; }
    std::vector<const ParameterInfo*> infos() const {
        std::vector<const ParameterInfo*> all;
        for (const Entry& e : entries_)
            all.push_back(&e.info);
        return all;
    }
    const Entry* find(std::string_view key) const {
        for (const Entry& e : entries_)
            if (e.info.key == key) return &e;
        return nullptr;
    }

private:
    ParameterTable& append(Entry e, ParameterInfo info) {
        info.default_value = e.get(Struct{});
        e.info = std::move(info);
        entries_.push_back(std::move(e));
        return *this;
    }
    ParameterInfo& added(std::string_view key) {
        for (Entry& e : entries_)
            if (e.info.key == key) return e.info;
        throw_unknown_key(key, infos());
    }

    static ParameterValue to_value(double v) { return v; }
    static ParameterValue to_value(long v) { return v; }
    static ParameterValue to_value(bool v) { return v; }
    static ParameterValue to_value(const std::string& v) { return v; }
    static ParameterValue to_value(const std::array<double, 2>& v) { return v; }
    static ParameterValue to_value(const std::array<double, 3>& v) { return v; }
    static ParameterValue to_value(const NumberOrWord& v) {
        return v.is_number() ? ParameterValue(v.number) : ParameterValue(v.word);
    }
    template <class T>
    static void from_value(T& member, const ParameterValue& v) {
        member = std::get<T>(v);
    }
    static void from_value(NumberOrWord& member, const ParameterValue& v) {
        if (const double* d = std::get_if<double>(&v)) {
            member = {*d, {}};
        } else {
            member = {0.0, std::get<std::string>(v)};
        }
    }

    std::vector<Entry> entries_;
};

/// Implements Parameterized over a struct and its table.
template <class Struct>
class ParameterView : public Parameterized {
public:
    ParameterView(Struct& values, const ParameterTable<Struct>& table) : values_(&values), table_(&table) {}

    std::vector<const ParameterInfo*> parameters() const override { return table_->infos(); }
    ParameterValue get(std::string_view key) const override { return entry(key).get(*values_); }
    void set(std::string_view key, const ParameterValue& value) override {
        const auto& e = entry(key);
        e.info.check(value);
        e.set(*values_, value);
    }

private:
    const typename ParameterTable<Struct>::Entry& entry(std::string_view key) const {
        const auto* e = table_->find(key);
        if (!e) throw_unknown_key(key, parameters());
        return *e;
    }
    Struct* values_;
    const ParameterTable<Struct>* table_;
};

/// A list of structs among described parameters: its key, and the table that describes one of them. Where the
/// list is known by its structs, this is the way to it.
///
///     inline constexpr RecordList<ManualPosture> manual_posture_list{"manual_postures",
///                                                                    manual_posture_parameters};
template <class Record>
struct RecordList {
    const char* key;
    const ParameterTable<Record>& (*table)();

    bool is_in(const Parameterized& values) const { return values.has(key); }
    /// None where it has no such list.
    std::vector<Record> of(const Parameterized& values) const {
        return is_in(values) ? structs(std::get<ParameterRecords>(values.get(key))) : std::vector<Record>();
    }
    /// Throws what Parameterized::set does.
    void set(Parameterized& owner, const std::vector<Record>& records) const {
        owner.set(key, values(records));
    }

    ParameterRecords values(const std::vector<Record>& records) const {
        ParameterRecords result;
        for (const Record& record : records) {
            auto& one = result.all.emplace_back();
            for (const auto& e : table().entries())
                one.push_back(e.get(record));
        }
        return result;
    }
    /// As they are: nothing is checked but the number of values.
    std::vector<Record> structs(const ParameterRecords& records) const {
        std::vector<Record> result;
        for (const auto& one : records.all) {
            Record& record = result.emplace_back();
            const auto& entries = table().entries();
            for (std::size_t i = 0; i < entries.size(); ++i)
                entries[i].set(record, one.at(i));
        }
        return result;
    }
};

/// The names in a list that is separated by commas, without the blanks around them.
std::vector<std::string> listed_names(const std::string& list);

/// The known name nearest to a mistyped one, or empty: for "did you mean".
std::string nearest_name(std::string_view mistyped, const std::vector<std::string>& known);

} // namespace facetmill
