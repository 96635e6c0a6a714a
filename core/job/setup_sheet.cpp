#include "core/job/setup_sheet.h"

#include "core/base/error.h"
#include "core/base/figures.h"
#include "core/job/posting.h"
#include "core/job/program_files.h"
#include "core/job/work_zero.h"
#include "core/mesh/mesh_report.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace facetmill {

namespace {

constexpr const char* style = R"(
:root { color-scheme: light; }
body { font: 14px/1.45 system-ui, "DejaVu Sans", Arial, sans-serif; color: #1d2733; background: #fff;
       max-width: 1040px; margin: 24px auto; padding: 0 20px; }
h1 { font-size: 24px; margin: 0 0 4px; overflow-wrap: anywhere; }
h2 { font-size: 16px; margin: 28px 0 8px; border-bottom: 1px solid #c9d2dc; padding-bottom: 3px; }
.quiet { color: #5b6875; }
.verdict { margin: 16px 0; padding: 10px 14px; border-left: 5px solid; font-weight: 600; overflow-wrap: anywhere; }
.good { border-color: #1a7f4b; background: #e8f5ee; color: #125c36; }
.bad { border-color: #b3261e; background: #fcebea; color: #8c1d18; }
.warning { margin: 4px 0; padding-left: 14px; border-left: 3px solid #b26a00; color: #7a4a00; overflow-wrap: anywhere; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; }
th { text-align: left; font-weight: 600; color: #5b6875; vertical-align: bottom; }
th, td { padding: 4px 12px 4px 0; border-bottom: 1px solid #e4e9ee; }
td { vertical-align: top; overflow-wrap: anywhere; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
td.file { white-space: nowrap; font-family: "DejaVu Sans Mono", monospace; font-size: 12px; }
tr.sum td { font-weight: 600; border-bottom: none; }
table.facts { width: auto; }
table.facts th { padding-right: 24px; font-weight: normal; white-space: nowrap; vertical-align: top; }
.pictures { display: grid; grid-template-columns: 1fr 1fr; gap: 14px; }
figure { margin: 0; break-inside: avoid; }
figure img { width: 100%; display: block; border: 1px solid #c9d2dc; }
figcaption { color: #5b6875; font-size: 12px; padding-top: 3px; }
tr, .verdict { break-inside: avoid; }
@media (max-width: 640px) { .pictures { grid-template-columns: 1fr; } }
@media print { body { margin: 0; max-width: none; font-size: 11px; } .scroll { overflow: visible; } }
)";

/// Text as HTML shows it; what cannot be shown is replaced as in messages.
std::string html(std::string_view text) {
    std::string out;
    for (const char c : printable(text, 4000)) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += c;
    }
    return out;
}

std::string base64(std::string_view bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t v = 0;
        for (std::size_t k = 0; k < 3; ++k)
            v = v << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += k <= n ? digits[v >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

std::string said_in(const SheetLanguage& language, const std::string& english) {
    return language.words && !english.empty() ? language.words(english) : english;
}

/// Lengths, angles and figures in the project's units.
class Sheet {
public:
    Sheet(const Project& project, const PlanResult& plan, const SheetLanguage& language)
        : project_(project), plan_(plan), language_(language) {}

    std::string say(const std::string& english) const { return said_in(language_, english); }

    std::string number(double mm, int digits = 5) const {
        return coordinate_text(mm / mm_per(project_.unit), digits);
    }
    std::string length(double mm, int digits = 5) const { return length_text(mm, project_.unit, digits); }
    std::string unit() const { return std::string(unit_name(project_.unit)); }
    std::string point(const Vec3& p) const {
        return number(p.x()) + ", " + number(p.y()) + ", " + number(p.z()) + " " + unit();
    }
    std::string size(const Box3& box) const {
        const Vec3 s = box.size();
        return number(s.x()) + " \u00d7 " + number(s.y()) + " \u00d7 " + number(s.z()) + " " + unit();
    }

    std::string text;

    void heading(const std::string& title) { text += "<h2>" + html(say(title)) + "</h2>\n"; }
    void begin_facts() { text += "<table class=\"facts\">\n"; }
    void fact(const std::string& name, const std::string& value) { fact_of(name, say(value)); }
    /// A value that is a name, or said already.
    void fact_of(const std::string& name, const std::string& value) {
        text += "<tr><th>" + html(say(name)) + "</th><td>" + html(value) + "</td></tr>\n";
    }
    void end_table() { text += "</table>\n"; }
    void warning(const std::string& line) { text += "<p class=\"warning\">" + html(say(line)) + "</p>\n"; }
    void quiet(const std::string& line) { text += "<p class=\"quiet\">" + html(say(line)) + "</p>\n"; }

    struct Column {
        char kind; ///< '#' holds numbers, '/' names of files, ' ' words
        std::string name;
    };
    void begin_table(std::initializer_list<Column> columns) {
        columns_.clear();
        text += "<div class=\"scroll\"><table>\n<tr>";
        for (const auto& [kind, name] : columns) {
            columns_ += kind;
            text +=
                std::string("<th") + (kind == '#' ? " class=\"n\"" : "") + ">" + html(say(name)) + "</th>";
        }
        text += "</tr>\n";
    }
    /// Numbers are said, words are as they are given.
    void row(const std::vector<std::string>& cells, bool sum = false) {
        text += sum ? "<tr class=\"sum\">" : "<tr>";
        for (std::size_t k = 0; k < cells.size(); ++k)
            text += std::string("<td")
                    + (columns_[k] == '#'   ? " class=\"n\""
                       : columns_[k] == '/' ? " class=\"file\""
                                            : "")
                    + ">" + html(columns_[k] == '#' ? say(cells[k]) : cells[k]) + "</td>";
        text += "</tr>\n";
    }
    void end_wide_table() { text += "</table></div>\n"; }

    /// The setup's name and how it holds the part, where there are several.
    void setup_title();
    void pictures(std::span<const SheetPicture> all);
    void part_and_stock();
    std::string fixture_text(const Fixture& fixture) const;
    void tools();
    void operations();
    void posted_programs();
    std::string axes_reached(const PostedProgram& program) const;
    void told_from_zero();
    void verification(std::span<const VerifyProgram> programs, const Verification& v);

private:
    const Project& project_;
    const PlanResult& plan_;
    const SheetLanguage& language_;
    std::string columns_;
};

void Sheet::setup_title() {
    if (setup_count(project_) == 1) return;
    text += "<h1 style=\"break-before: page; margin-top: 40px\">"
            + html(say("Setup " + std::to_string(chosen_setup(project_) + 1))) + " \u00b7 "
            + html(project_.name) + "</h1>\n";
    const auto& [turn, move] = project_.place;
    std::string held;
    const auto then = [&](const std::string& step) { held += (held.empty() ? "" : ", ") + say(step); };
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string axis(1, "XYZ"[k]), by = format_number(degrees(turn[k]), 6);
        if (turn[k] != 0)
            then(held.empty() ? "turned by " + by + "\u00b0 about " + axis
                              : "then by " + by + "\u00b0 about " + axis);
    }
    if (const Vec3 by(move[0], move[1], move[2]); by != Vec3::Zero())
        then(held.empty() ? "moved by " + point(by) : "then moved by " + point(by));
    if (held.empty())
        quiet("The part lies as in the project.");
    else
        text +=
            "<p class=\"quiet\">" + html(say("The part lies as in the project") + ", " + held) + ".</p>\n";
}

void Sheet::pictures(std::span<const SheetPicture> all) {
    if (all.empty()) return;
    text += "<div class=\"pictures\">\n";
    for (const SheetPicture& p : all)
        text += "<figure><img alt=\"" + html(p.caption) + "\" src=\"data:image/png;base64," + base64(p.png)
                + "\"><figcaption>" + html(p.caption) + "</figcaption></figure>\n";
    text += "</div>\n";
}

std::string Sheet::fixture_text(const Fixture& f) const {
    const auto triple = [&](const std::array<double, 3>& v) { return point(Vec3(v[0], v[1], v[2])); };
    const bool tab = f.kind == Fixture::Kind::tab;
    const std::string shape =
        tab ? fixture_parameters().find("shape")->info.words.at(std::size_t(f.shape)) : std::string();
    std::string said = say(tab                            ? shape + " tab, " + triple(f.size)
                           : f.kind == Fixture::Kind::box ? "box, " + triple(f.size)
                           : f.kind == Fixture::Kind::cylinder
                               ? "cylinder, diameter " + length(f.diameter) + ", height " + length(f.height)
                               : "mesh " + f.file);
    said += ", "
            + say(f.kind == Fixture::Kind::mesh ? "moved by " + triple(f.translate)
                                                : "the middle of its bottom at " + triple(f.translate));
    if (f.rotate != std::array<double, 3>{0, 0, 0}) {
        std::string turns;
        for (std::size_t k = 0; k < 3; ++k)
            turns += (k > 0 ? ", " : "") + format_number(degrees(f.rotate[k]), 6) + "°";
        said += ", " + say("turned by " + turns);
    }
    return said + "; " + say(tab ? std::string("it is left standing") : "tools keep " + length(f.clearance));
}

void Sheet::part_and_stock() {
    heading("Part, stock and machine");
    begin_facts();
    const Box3& part = plan_.part->box;
    fact_of("Part", project_.part.file);
    fact("Part's size", size(part));
    if (plan_.part->report.surfaces)
        fact("Facets for surfaces", "the surfaces of the file lie at most "
                                        + length(plan_.part->surface_deviation[0]) + " outside and "
                                        + length(plan_.part->surface_deviation[1])
                                        + " inside the facets that were planned on");
    fact("Part from", point(part.lo));
    fact("Part to", point(part.hi));
    const StockSolid& stock = plan_.stock;
    std::string kind = say(stock_kind_name(project_.stock.kind));
    if (project_.stock.kind == StockSpec::Kind::rest && !project_.before.empty())
        kind = say("what setup '" + project_.before.back().name + "' left");
    if (stock.kind == StockSolid::Kind::cylinder)
        kind +=
            ", "
            + say("diameter " + length(2 * stock.radius) + ", along " + std::string(1, "XYZ"[stock.axis]));
    if (!project_.stock_path().empty()) kind += ", " + project_.stock_path().filename().string();
    fact_of("Stock", kind);
    fact("Stock's size", size(stock.box));
    fact("Stock from", point(stock.box.lo));
    fact("Stock to", point(stock.box.hi));
    fact("Origin", "0, 0, 0 of the part's coordinates, in which the programs are written; it is "
                       + length(-stock.box.lo.x()) + ", " + length(-stock.box.lo.y()) + ", "
                       + length(-stock.box.lo.z()) + " (X, Y, Z) from the stock's lowest corner");
    for (const Fixture& f : project_.fixtures)
        fact_of("Fixture '" + f.name + "'", fixture_text(f));
    const Machine machine = project_machine(project_);
    fact("Machine", machine.label);
    end_table();
    for (const std::string& w : plan_.stock_warnings)
        warning(w);
    for (const std::string& w : plan_.part->report.warnings)
        warning(explain_warning(w));
    for (const auto& o : plan_.idle)
        warning("There is no program for '" + o->name + "', which has nothing to do: " + o->nothing_to_do);
}

void Sheet::tools() {
    heading("Tools");
    std::set<long> used;
    for (const auto& o : plan_.operations)
        used.insert(o->program.tool_number);
    begin_table({{'#', "T"},
                 {' ', "Name"},
                 {' ', "Shape"},
                 {'#', "Diameter, " + unit()},
                 {'#', "Corner radius"},
                 {'#', "Flutes"},
                 {' ', "Shank"},
                 {' ', "Holder"},
                 {'#', "Out of holder"}});
    for (const Tool& t : project_.tools) {
        if (!used.count(t.number)) continue;
        std::string shape = say(t.shape_name());
        if (t.bottom_angle != 0)
            shape += ", " + say("bottom " + format_number(degrees(t.bottom_angle), 4) + "\u00b0");
        if (t.taper_angle != 0)
            shape += ", " + say("taper " + format_number(degrees(t.taper_angle), 4) + "\u00b0");
        std::string holder;
        for (const HolderSection& h : t.holder)
            holder += (holder.empty() ? "" : ", ")
                      + ("\u00d8 " + number(h.diameter) + " \u00d7 " + number(h.length));
        row({std::to_string(t.number), t.name, shape, number(t.diameter), number(t.corner_radius),
             number(t.flute_length),
             say("\u00d8 " + number(t.shank_diameter) + " \u00d7 " + number(t.shank_length)),
             holder.empty() ? "\u2013" : say(holder), number(t.flute_length + t.shank_length)});
    }
    end_wide_table();
}

void Sheet::operations() {
    heading("Operations");
    begin_table({{'#', ""},
                 {' ', "Operation"},
                 {'#', "T"},
                 {'/', "Program"},
                 {'#', "Tolerance"},
                 {'#', "Passes"},
                 {'#', "Feed, " + unit() + "/min"},
                 {'#', "Spindle, rpm"},
                 {'#', "Cut, " + unit()},
                 {'#', "Rapid, " + unit()},
                 {'#', "Time"}});
    double cut = 0, rapid = 0, time = 0;
    std::size_t n = 0;
    long tool = -1;
    std::size_t changes = 0;
    for (std::size_t i = 0; i < plan_.operations.size(); ++i) {
        const OperationResult& o = *plan_.operations[i];
        const ClSection& p = o.program;
        if (tool != -1 && tool != p.tool_number) ++changes;
        tool = p.tool_number;
        cut += o.totals.cut_length;
        rapid += o.totals.rapid_length;
        time += o.totals.time_seconds;
        row({std::to_string(++n), o.name, std::to_string(p.tool_number),
             program_file_name(project_, plan_, i),
             number(operation_of(project_, plan_, i).common().tolerance),
             std::to_string(std::max(0, o.path.drive_planes)), number(p.feed_mm_per_min),
             format_number(p.spindle_rpm, 6), number(o.totals.cut_length), number(o.totals.rapid_length),
             duration_text(o.totals.time_seconds)});
    }
    row({"", say("Together"), "", "", "", "", "", "", number(cut), number(rapid), duration_text(time)}, true);
    end_wide_table();
    if (changes > 0)
        quiet(changes == 1 ? std::string("1 change of tools, not in the time.")
                           : std::to_string(changes) + " changes of tools, not in the time.");
    for (const auto& o : plan_.operations) {
        if (o->view == Mat3::Identity()) continue;
        const Vec3 axis = o->view.row(2);
        const std::string told = "the tool keeps the axis (" + format_number(axis.x(), 6) + ", "
                                 + format_number(axis.y(), 6) + ", " + format_number(axis.z(), 6) + "), "
                                 + format_number(degrees(std::acos(std::clamp(axis.z(), -1.0, 1.0))), 6)
                                 + "\u00b0 from upright.";
        text += "<p class=\"quiet\">" + html(o->name + ": " + say(told)) + "</p>\n";
    }
    for (const auto& o : plan_.operations)
        for (const std::string& w : o->warnings())
            warning(o->name + ": " + w);
}

/// Where part and stock are as the control tells places.
void Sheet::told_from_zero() {
    const Vec3 zero = work_zero(project_.programs, plan_.part->box, plan_.stock.box);
    if (zero == Vec3::Zero()) return;
    fact("Zero at", point(zero) + " of the part's coordinates");
    fact("Part in them", point(plan_.part->box.lo - zero) + " to " + point(plan_.part->box.hi - zero));
    fact("Stock in them", point(plan_.stock.box.lo - zero) + " to " + point(plan_.stock.box.hi - zero));
}

/// "X -20 … 30, ..., A 0° … 12.5°": how far a program takes each axis.
std::string Sheet::axes_reached(const PostedProgram& program) const {
    const Machine machine = project_machine(project_);
    std::string shown_axes;
    for (int k = 0; k < machine.joints(); ++k) {
        const std::size_t r = std::size_t(k - 3);
        const auto shown = [&](double value) {
            return k < 3 ? number(value) : format_number(degrees(value), 6) + "\u00b0";
        };
        shown_axes += (k > 0 ? ", " : "") + machine.axis_name(k) + " "
                      + shown(k < 3 ? program.reach.lo[k] : program.turns[r].lo) + " \u2026 "
                      + shown(k < 3 ? program.reach.hi[k] : program.turns[r].hi);
    }
    return shown_axes;
}

/// The programs for the control, as they are posted now.
void Sheet::posted_programs() {
    if (project_.programs.post.empty()) return;
    heading("Programs for the control");
    try {
        const Post post = project_post(project_, project_.programs.post);
        std::string wcs = project_.programs.wcs;
        if (wcs.empty()) wcs = post.default_wcs();
        const std::vector<PostedFile> files = post_plan(project_, plan_, {});
        begin_facts();
        fact("Control", post.label);
        fact("Work coordinates", (wcs.empty() ? "the control's" : wcs) + ", its zero in "
                                     + work_zero_text(project_.programs, project_.unit));
        told_from_zero();
        end_table();
        begin_table({{'/', "Program"},
                     {' ', "Told as"},
                     {' ', "Tools, gauge length"},
                     {'#', "Blocks"},
                     {' ', "Axes of the machine"},
                     {'#', "Time"}});
        for (const PostedFile& f : files) {
            std::string used;
            for (const long n : f.program.tools)
                for (const Tool& t : project_.tools)
                    if (t.number == n)
                        used +=
                            (used.empty() ? "T" : ", T") + std::to_string(n) + " " + length(gauge_length(t));
            const bool several = std::any_of(f.programs.begin(), f.programs.end(), [&](std::size_t i) {
                return plan_.operations[i]->program.multi_axis;
            });
            std::string told = f.program.tcp ? f.program.planes > 0 ? "tip (TCP, tilted planes)" : "tip (TCP)"
                               : several     ? "joints"
                                             : "three axes";
            told = say(told);
            if (f.program.arcs > 0) told += ", " + say(std::to_string(f.program.arcs) + " arcs");
            row({f.name, told, say(used), std::to_string(f.program.blocks), say(axes_reached(f.program)),
                 duration_text(f.program.seconds)});
            if (f.program.tcp)
                warning(f.name
                        + ": the feed is that of the tip; where an axis is slower, the control slows down.");
            if (f.program.rewinds > 0)
                warning(f.name + ": the tool goes up " + std::to_string(f.program.rewinds)
                        + " times so that rotary axes can turn.");
        }
        end_wide_table();
    } catch (const Error& e) {
        warning(std::string("There are none: ") + e.what());
    }
}

void Sheet::verification(std::span<const VerifyProgram> programs, const Verification& v) {
    heading("Verification by removal of material");
    begin_facts();
    const DeviationFigures& f = v.figures;
    const auto percent = [](double share) { return percent_text(share) + " of the surface"; };
    fact("Deepest gouge",
         length(std::max(f.gouge_max, v.border.gouge_max), 3) + ", allowed " + length(v.used.gouge_limit, 3));
    fact("Collisions", std::to_string(v.collisions.size()));
    if (v.used.tolerance > 0) {
        fact("Tolerance", length(v.used.tolerance));
        fact("Over the tolerance", percent(f.over_fraction));
        fact("Uncut (over twice the tolerance)", percent(f.uncut_fraction));
    }
    fact("What is left, 95 % below", length(f.excess_p95, 3));
    fact("What is left, 99 % below", length(f.excess_p99, 3));
    fact("What is left, largest", length(f.excess_max, 3));
    fact("Places looked at", std::to_string(f.samples));
    fact("Resolution", length(v.used.resolution, 3));
    end_table();
    const auto where = [&](const MotionPlace& at) {
        if (!at.known()) return std::string("nowhere");
        const VerifyProgram& program = programs[at.program];
        return program.name
               + (program.lines.empty() ? ", GOTO " + std::to_string(at.motion + 1)
                                        : ", line " + std::to_string(program.lines[at.motion]));
    };
    if (!v.gouges.empty() || !v.collisions.empty()) {
        constexpr std::size_t max_listed = 20;
        begin_table({{' ', "Found"}, {'#', "Depth, " + unit()}, {' ', "Where"}, {' ', "Place"}});
        for (const DeviationExtreme& e : v.gouges)
            row({say("Gouge"), number(-e.deviation, 4), say(where(e.by)), say(point(e.point))});
        for (std::size_t i = 0; i < std::min(max_listed, v.collisions.size()); ++i) {
            const Collision& c = v.collisions[i];
            const char* body = c.kind == Collision::Kind::shank    ? "Shank"
                               : c.kind == Collision::Kind::holder ? "Holder"
                               : c.kind == Collision::Kind::cutter ? "Cutter"
                                                                   : "Rapid";
            row({say(body) + say(touched_text(c)), number(c.depth, 4), say(where(c.at)),
                 say(point(c.place))});
        }
        end_wide_table();
        if (v.collisions.size() > max_listed)
            quiet(std::to_string(v.collisions.size() - max_listed) + " more collisions are in verify.json.");
    }
    for (const std::string& remark : v.remarks)
        quiet(remark);
}

/// Up to the verdict.
std::string sheet_head(const Project& project, std::size_t setups, std::size_t programs, double time,
                       const std::string& findings, bool passed, const SheetLanguage& language) {
    const auto say = [&](const std::string& english) { return html(said_in(language, english)); };
    const std::string title =
        project.path.empty() ? project.part_path().stem().string() : project.path.stem().string();
    std::string text = "<!DOCTYPE html>\n<html lang=\"" + html(language.code)
                       + "\">\n<head>\n<meta charset=\"utf-8\">\n"
                         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>"
                       + html(title) + " \u00b7 " + say("Setup sheet") + "</title>\n<style>" + style
                       + "</style>\n</head>\n<body>\n";
    const std::string several = std::to_string(setups) + " setups";
    text +=
        "<h1>" + html(title) + "</h1>\n<p class=\"quiet\">" + say("Setup sheet") + " \u00b7 "
        + (setups > 1 ? say(several) + " \u00b7 " : std::string())
        + say(programs == 1 ? std::to_string(programs) + " program" : std::to_string(programs) + " programs")
        + " \u00b7 " + say(duration_text(time)) + " \u00b7 "
        + say("lengths in " + std::string(unit_name(project.unit))) + "</p>\n";
    if (passed)
        text += "<p class=\"verdict good\">" + say("Verified: no gouge, no collision.") + "</p>\n";
    else
        text += "<p class=\"verdict bad\">" + say("Not verified, do not run: " + findings) + "</p>\n";
    return text;
}

double time_of(const PlanResult& plan) {
    double time = 0;
    for (const auto& o : plan.operations)
        time += o->totals.time_seconds;
    return time;
}

/// All that is said of one setup but its verdict.
void add_setup(Sheet& sheet, std::span<const SheetPicture> pictures) {
    sheet.setup_title();
    sheet.pictures(pictures);
    sheet.part_and_stock();
    sheet.tools();
    sheet.operations();
    sheet.posted_programs();
}

} // namespace

std::string setup_sheet(const Project& project, const PlanResult& plan,
                        std::span<const VerifyProgram> programs, const Verification& verification,
                        std::span<const SheetPicture> pictures, const SheetLanguage& language) {
    Sheet sheet(project, plan, language);
    sheet.text = sheet_head(project, 1, plan.operations.size(), time_of(plan),
                            findings_line(project, programs, verification), verification.passed(), language);
    add_setup(sheet, pictures);
    sheet.verification(programs, verification);
    sheet.text += "</body>\n</html>\n";
    return std::move(sheet.text);
}

std::string setup_sheet(std::span<const JudgedChain> chains,
                        const std::vector<std::vector<SheetPicture>>& pictures,
                        const SheetLanguage& language) {
    const SetupPlan& first = chains.front().setups.front();
    std::size_t programs = 0, setups = 0;
    double time = 0;
    for (const JudgedChain& chain : chains)
        for (const SetupPlan& setup : chain.setups) {
            ++setups;
            programs += setup.plan->operations.size();
            time += time_of(*setup.plan);
        }
    std::string text = sheet_head(first.project, setups, programs, time, findings_line(chains),
                                  verdict_of(chains) == Verdict::verified, language);
    std::size_t i = 0;
    for (const JudgedChain& chain : chains)
        for (const SetupPlan& setup : chain.setups) {
            Sheet sheet(setup.project, *setup.plan, language);
            add_setup(sheet, i < pictures.size() ? std::span(pictures[i]) : std::span<const SheetPicture>());
            text += sheet.text;
            ++i;
        }
    for (const JudgedChain& chain : chains) {
        Sheet sheet(chain.setups.front().project, *chain.setups.front().plan, language);
        sheet.verification(chain.programs.programs, *chain.result);
        if (chains.size() > 1)
            sheet.quiet("Of the stock that begins in setup '" + chain.setups.front().project.name + "'.");
        text += sheet.text;
    }
    return text + "</body>\n</html>\n";
}

} // namespace facetmill
