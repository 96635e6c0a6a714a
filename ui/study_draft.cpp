#include "ui/study_draft.h"

#include "core/base/parameter_json.h"
#include "core/job/asked_operations.h"
#include "core/setup/machine.h"
#include "core/setup/stock.h"
#include "core/study/study.h"
#include "core/tools/library_file.h"
#include "ui/operation_menu.h"
#include "ui/own_folders.h"
#include "ui/study_words.h"
#include "ui/text.h"
#include "ui/value_words.h"
#include "ui/worded.h"

#include <QObject>
#include <QRegularExpression>

#include <algorithm>

namespace facetmill::ui {

namespace {

constexpr double max_combinations = 1e15;
constexpr std::size_t max_ordered = 5; ///< operations that are put into every order

/// What the form offers of an operation beside tool and kind, where it has it.
constexpr const char* varied_keys[] = {"tolerance", "chord_tolerance", "stepover",   "depth",
                                       "direction", "pattern",         "lead_limit", "lead_limits"};

/// How many numbers a value of the parameter has.
std::size_t numbers_of(const ParameterInfo& info) {
    if (info.kind == ParameterKind::triple) return 3;
    return info.kind == ParameterKind::pair ? 2 : 1;
}

QStringList typed_pieces(const QString& typed, const QRegularExpression& between) {
    QStringList pieces;
    for (QString piece : typed.split(between, Qt::SkipEmptyParts)) {
        piece = piece.trimmed();
        while (piece.endsWith(QChar(',')))
            piece.chop(1);
        if (!piece.isEmpty()) pieces << piece;
    }
    return pieces;
}

/// A value of several numbers as the parameter reads it; one number stands for all three of a triple.
std::string typed_numbers(const QString& piece, std::size_t numbers, const std::string& where) {
    static const QRegularExpression blanks(QStringLiteral("\\s+"));
    QStringList typed = typed_pieces(piece, blanks);
    if (numbers == 3 && typed.size() == 1) typed << typed[0] << typed[0];
    std::string text;
    for (const QString& one : typed)
        text += (text.empty() ? "" : ", ") + utf8(with_decimal_point(one, where));
    return text;
}

/// The values that are typed, as files have them. Throws Error(wrong_type, out_of_range).
std::vector<Json> typed_values(const DraftVariation& v, LengthUnit unit) {
    static const QRegularExpression one_by_one(QStringLiteral("[;\\s]+")), semicolons(QStringLiteral(";"));
    std::vector<Json> values;
    const std::string where = utf8(v.what);
    const std::size_t numbers = numbers_of(*v.info);
    for (const QString& piece : typed_pieces(v.typed, numbers > 1 ? semicolons : one_by_one)) {
        const QString word = word_of(*v.info, piece);
        const bool is_word =
            std::find(v.info->words.begin(), v.info->words.end(), utf8(word)) != v.info->words.end();
        const std::string typed = is_word       ? utf8(word)
                                  : numbers > 1 ? typed_numbers(piece, numbers, where)
                                                : utf8(with_decimal_point(piece, where));
        const ParameterValue value = v.info->parse(typed, unit);
        v.info->check(value, unit);
        Json json = write_value(value, *v.info, where, unit);
        if (std::find(values.begin(), values.end(), json) == values.end()) values.push_back(std::move(json));
    }
    return values;
}

/// A place within brackets is a name where that has no signs of its own, else a number.
std::string bracketed(const std::string& name, std::size_t place) {
    const bool plain = !name.empty() && name.find_first_of("[].") == std::string::npos
                       && name.find_first_not_of("0123456789") != std::string::npos;
    return "[" + (plain ? name : std::to_string(place)) + "]";
}

Json tool_json(Tool tool, LengthUnit unit) {
    Json object = Json::object();
    write_parameters(object, "tool", ParameterView<Tool>(tool, tool_parameters()), unit);
    return object;
}

QString tool_label(const Tool& tool, LengthUnit unit) {
    const QString name = tool.name.empty() ? shown_length(tool.diameter, unit, 4) : text(tool.name);
    return QObject::tr("T%1 %2").arg(tool.number).arg(elided(name, 40));
}

/// The tools of the project, then those of the user's libraries under numbers of their own.
std::vector<DraftVariation::Choice> tool_choices(const Project& project) {
    std::vector<DraftVariation::Choice> choices;
    std::vector<Tool> all = project.tools;
    for (const Tool& tool : all)
        choices.push_back({tool_label(tool, project.unit), tool.number, {}, false});
    for (const KeptLibrary& kept : kept_libraries(own_library_folder()))
        for (const LibraryTool& kept_tool : kept.library.tools) {
            Tool tool = numbered_for(kept_tool, all);
            const bool known = std::any_of(all.begin(), all.end(), [&](Tool one) {
                one.number = tool.number;
                return tool_json(one, project.unit) == tool_json(tool, project.unit);
            });
            if (known) continue;
            all.push_back(tool);
            choices.push_back({QObject::tr("%1 (library)").arg(tool_label(tool, project.unit)), tool.number,
                               tool_json(tool, project.unit), false});
        }
    return choices;
}

/// Kinds that stand for an operation: of the same purpose, with as many axes.
std::vector<DraftVariation::Choice> kind_choices(const Operation& operation) {
    std::vector<DraftVariation::Choice> choices;
    for (const OperationKind& kind : operation_kinds()) {
        const auto other = kind.make();
        const bool alike =
            other->purpose() == operation.purpose() && other->keeps_axis() == operation.keeps_axis()
            && !other->turning() == !operation.turning() && !other->rework() == !operation.rework();
        if (alike || kind.kind == operation.kind())
            choices.push_back({operation_label(kind.kind), kind.kind, {}, kind.kind == operation.kind()});
    }
    return choices;
}

/// A value as it is typed: several numbers with blanks between them.
QString typed_value(const ParameterInfo& info, const ParameterValue& value, LengthUnit unit) {
    const std::string written = info.value_text(value, unit);
    return in_user_numbers(text(written).replace(QStringLiteral(", "), QStringLiteral(" ")));
}

void add_operation(StudyDraft& draft, const Project& project, const Operation& operation,
                   const std::string& path, const QString& named,
                   const std::vector<DraftVariation::Choice>& tools) {
    using Kind = DraftVariation::Kind;
    DraftVariation tool{.kind = Kind::choices,
                        .operation = named,
                        .what = worded(operation.parameter("tool").label),
                        .path = path + ".tool",
                        .choices = tools};
    for (DraftVariation::Choice& choice : tool.choices)
        choice.on = choice.tool.is_null() && choice.value.get<long>() == operation.common().tool;
    draft.vary.push_back(std::move(tool));
    DraftVariation kind{.kind = Kind::choices,
                        .operation = named,
                        .what = QObject::tr("Strategy"),
                        .path = path + ".kind",
                        .choices = kind_choices(operation)};
    if (kind.choices.size() > 1) draft.vary.push_back(std::move(kind));
    for (const char* key : varied_keys) {
        if (!operation.has(key)) continue;
        const ParameterInfo& info = operation.parameter(key);
        DraftVariation v{.kind = Kind::numbers,
                         .operation = named,
                         .what = worded(info.label),
                         .path = path + "." + key,
                         .info = &info};
        const ParameterValue value = operation.get(key);
        if (info.kind == ParameterKind::choice) {
            v.kind = Kind::choices;
            for (const std::string& word : info.words)
                v.choices.push_back({shown_word(info, word), word, {}, word == std::get<std::string>(value)});
        } else {
            const auto* word = std::get_if<std::string>(&value);
            v.typed =
                word && !word->empty() ? shown_word(info, *word) : typed_value(info, value, project.unit);
        }
        draft.vary.push_back(std::move(v));
    }
}

/// Machines of the program and the project's own, and how much larger than the part the stock is.
void add_machine_and_stock(StudyDraft& draft, const Project& project, const std::string& above,
                           const QString& named) {
    using Kind = DraftVariation::Kind;
    DraftVariation machine{
        .kind = Kind::choices, .operation = named, .what = QObject::tr("Machine"), .path = above + "machine"};
    if (is_machine_file(project.machine))
        machine.choices.push_back({text(project.machine), project.machine, {}, true});
    for (const Machine& one : machines())
        machine.choices.push_back({worded(one.label), one.name, {}, one.name == project.machine});
    draft.vary.push_back(std::move(machine));
    const std::vector<std::string>& keys = stock_keys(project.stock.kind);
    if (std::find(keys.begin(), keys.end(), "margin") == keys.end()) return;
    const ParameterInfo& info = stock_parameters().find("margin")->info;
    draft.vary.push_back({.kind = Kind::numbers,
                          .operation = named,
                          .what = QObject::tr("Stock: %1").arg(worded(info.label)),
                          .path = above + "stock.margin",
                          .info = &info,
                          .typed = typed_value(info, project.stock.margin, project.unit)});
}

/// A limit as files have it, and what is typed for it: a number in the window's unit of it, or "×1.1".
Json typed_limit(const DraftMeasure& m) {
    QString typed = m.most.trimmed();
    const std::string where = utf8(measure_label(m.measure));
    const bool times = typed.startsWith(QChar(0xd7)) || typed.startsWith(QChar('x'), Qt::CaseInsensitive);
    if (times) typed = typed.mid(1).trimmed();
    bool fine = false;
    const double v = with_decimal_point(typed, where).toDouble(&fine);
    if (!fine || !(v >= 0))
        throw Error(ErrorCode::wrong_type, where, "'" + utf8(typed) + "' is no limit",
                    "write a number, or ×1.1 for 1.1 times what the project comes to");
    if (times) return v == 1 ? Json("project") : Json{{"project_times", v}};
    return json_number(v * measure_typed(m.measure), where);
}

} // namespace

std::size_t DraftVariation::count(LengthUnit unit, QString* wrong) const {
    if (kind == Kind::orders) {
        if (!on) return 1;
        std::size_t orders = 1;
        for (std::size_t i = 2; i <= choices.size(); ++i)
            orders *= i;
        return orders;
    }
    if (kind == Kind::choices)
        return std::size_t(
            std::count_if(choices.begin(), choices.end(), [](const Choice& c) { return c.on; }));
    try {
        return typed_values(*this, unit).size();
    } catch (const Error& e) {
        if (wrong) *wrong = worded(e);
        return 0;
    }
}

double StudyDraft::combinations() const {
    double n = 1;
    for (const DraftVariation& v : vary)
        n = std::min(n * double(std::max<std::size_t>(v.count(unit), 1)), max_combinations);
    return n;
}

double StudyDraft::candidates() const {
    const double all = combinations();
    return samples > 0 ? std::min(all, double(samples)) : all;
}

QString StudyDraft::problem() const {
    bool varies = false;
    for (const DraftVariation& v : vary) {
        QString wrong;
        const std::size_t n = v.count(unit, &wrong);
        if (!wrong.isEmpty())
            return v.operation.isEmpty() ? wrong : QObject::tr("%1: %2").arg(v.operation, wrong);
        if (n == 0) return QObject::tr("%1, %2: choose at least one value.").arg(v.operation, v.what);
        varies = varies || n > 1;
    }
    if (!varies)
        return QObject::tr("Nothing may vary: choose at least two values of something, such as two tools.");
    const bool wanted = std::any_of(measures.begin(), measures.end(),
                                    [&](const DraftMeasure& m) { return m.wanted || m.measure == first; });
    if (!wanted) return QObject::tr("Nothing is wanted: choose a measure.");
    for (const DraftMeasure& m : measures)
        try {
            if (!m.most.trimmed().isEmpty()) (void)typed_limit(m);
        } catch (const Error& e) {
            return worded(e);
        }
    if (candidates() > double(Study::max_candidates))
        return QObject::tr("These are more than %1 combinations: let less vary, or try some of them.")
            .arg(count_text(Study::max_candidates));
    return {};
}

std::string StudyDraft::json(const std::string& project_file) const {
    Json file{{"study", 1}, {"project", project_file}};
    Json tools = Json::array(), varied = Json::array();
    std::vector<Json> numbers;
    for (const DraftVariation& v : vary) {
        if (v.count(unit) < 2) continue;
        const std::string name =
            utf8(v.operation.isEmpty() ? v.what : QObject::tr("%1: %2").arg(v.operation, v.what));
        if (v.kind == DraftVariation::Kind::orders) {
            varied.push_back({{"name", name}, {"path", v.path}, {"values", "orders"}});
            continue;
        }
        if (v.kind == DraftVariation::Kind::numbers) {
            varied.push_back({{"name", name}, {"path", v.path}, {"values", typed_values(v, unit)}});
            continue;
        }
        Json choices = Json::array();
        for (const DraftVariation::Choice& c : v.choices) {
            if (!c.on) continue;
            choices.push_back({{"label", utf8(c.label)}, {v.path, c.value}});
            if (c.tool.is_null() || std::find(numbers.begin(), numbers.end(), c.value) != numbers.end())
                continue;
            numbers.push_back(c.value);
            tools.push_back(c.tool);
        }
        varied.push_back({{"name", name}, {"choices", std::move(choices)}});
    }
    if (!tools.empty()) file["tools"] = std::move(tools);
    file["vary"] = std::move(varied);
    Json want = Json::array({std::string(measure_name(first))}), limits = Json::object();
    for (const DraftMeasure& m : measures) {
        const std::string name(measure_name(m.measure));
        if (m.wanted && m.measure != first) want.push_back(name);
        if (!m.most.trimmed().isEmpty()) limits[name] = typed_limit(m);
    }
    file["want"] = std::move(want);
    if (!limits.empty()) file["limits"] = std::move(limits);
    if (samples > 0) file["samples"] = samples;
    return pretty_json(file);
}

StudyDraft draft_for(const Project& project) {
    StudyDraft draft;
    draft.unit = project.unit;
    const std::vector<DraftVariation::Choice> tools = tool_choices(project);
    const std::size_t setups = setup_count(project);
    for (std::size_t s = 0; s < setups; ++s) {
        const Project view = view_of_setup(project, s);
        const std::string above = setups > 1 ? "setups" + bracketed(view.name, s) + "." : "";
        for (std::size_t i = 0; i < view.operations.size(); ++i) {
            const Operation& operation = *view.operations[i];
            if (operation.common().off) continue;
            const std::string& name = operation.common().name;
            const QString named =
                setups > 1 ? QObject::tr("%1: %2").arg(text(view.name), text(name)) : text(name);
            add_operation(draft, view, operation, above + "operations" + bracketed(name, i), named, tools);
        }
        add_machine_and_stock(draft, view, above,
                              setups > 1 ? QObject::tr("%1: machine and stock").arg(text(view.name))
                                         : QObject::tr("Machine and stock"));
    }
    if (setups == 1 && project.operations.size() > 1 && project.operations.size() <= max_ordered) {
        DraftVariation orders{.kind = DraftVariation::Kind::orders,
                              .what = QObject::tr("Order of operations"),
                              .path = "operations"};
        orders.choices.resize(project.operations.size());
        draft.vary.push_back(std::move(orders));
    }
    for (const Measure m : all_measures())
        draft.measures.push_back({m, m == Measure::machining_time || m == Measure::excess_max, {}});
    return draft;
}

} // namespace facetmill::ui
