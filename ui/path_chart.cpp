#include "ui/path_chart.h"

#include "core/job/planner.h"
#include "core/strategy/five_axis/five_axis_record.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QObject>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace facetmill::ui {

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double longest_in_seconds = 300; ///< beyond it the axis of time counts minutes

const char* kind_name(MotionKind kind) {
    constexpr const char* names[] = {"rapid", "approach", "cut", "link", "retract"};
    return names[std::size_t(kind)];
}

QString angle_text(double degrees, int digits = 1) {
    return in_user_numbers(QString::number(degrees, 'f', digits)).replace(QChar('-'), QChar(0x2212))
           + QChar(0x00B0);
}

/// A number of a table; nothing where there is none.
std::string number(double v) {
    return std::isfinite(v) ? format_number(v, 9) : std::string();
}

} // namespace

PathChart::PathChart(Chart chart, std::shared_ptr<const OperationResult> program, PathFiguresPtr figures,
                     LengthUnit unit)
    : chart_(chart), program_(std::move(program)), figures_(std::move(figures)), unit_(unit) {
    if (chart_ == Chart::stepover)
        build_stepover();
    else
        build_rotary();
}

void PathChart::build_stepover() {
    const OperationResult& result = *program_;
    const QString name = text(result.name), length_unit = text(unit_name(unit_));
    const double per = mm_per(unit_);
    std::map<int, Drive> drives;
    for (const Pass& pass : result.path.passes)
        drives.try_emplace(pass.drive, Drive{pass.offset, 0, pass.drive});
    // The first cut of each; a pass has thousands of motions, and belongs to one drive.
    const auto& motions = result.program.motions.motions;
    std::set<int> begun;
    Index last = Index(result.path.passes.size());
    for (std::size_t m = 0; m < motions.size(); ++m) {
        const Index pass = motions[m].pass;
        if (motions[m].kind != MotionKind::cut || pass == last || pass >= result.path.passes.size()) continue;
        last = pass;
        const int drive = result.path.passes[pass].drive;
        if (begun.insert(drive).second) drives[drive].motion = m;
    }
    for (const auto& [drive, values] : drives)
        drives_.push_back(values);
    std::sort(drives_.begin(), drives_.end(),
              [](const Drive& a, const Drive& b) { return a.offset < b.offset; });
    if (drives_.size() < 2) {
        drives_.clear();
        missing_ = tr("“%1” has one pass only: there is no step-over").arg(name);
        return;
    }
    content_.title = tr("%1: step-over along the part").arg(name);
    content_.x_label = tr("Place of the pass across the travel (%1)").arg(length_unit);
    content_.y_label = tr("Step-over (%1)").arg(length_unit);
    // From each pass to the next.
    PlotSeries steps{{}, {}, {}, no_number, no_number};
    for (std::size_t i = 0; i + 1 < drives_.size(); ++i) {
        const double step = (drives_[i + 1].offset - drives_[i].offset) / per;
        for (const std::size_t end : {i, i + 1}) {
            content_.x.push_back(drives_[end].offset / per);
            steps.y.push_back(step);
        }
    }
    content_.series.push_back(std::move(steps));
}

void PathChart::build_rotary() {
    const QString name = text(program_->name);
    if (!program_->program.multi_axis) {
        missing_ = tr("“%1” cuts with three axes: no rotary axis moves").arg(name);
        return;
    }
    if (!figures_) {
        missing_ = tr("Following the path on the machine…");
        return;
    }
    const PathFigures& figures = *figures_;
    const auto& rotary = figures.machine.rotary;
    if (rotary.empty()) {
        missing_ = tr("The machine “%1” has no rotary axis").arg(worded(figures.machine.label));
        return;
    }
    const bool over_time = chart_ == Chart::rotary_over_time;
    const bool minutes = !figures.elapsed.empty() && figures.elapsed.back() > longest_in_seconds;
    content_.title = tr("%1 on %2: rotary axes").arg(name, worded(figures.machine.label));
    content_.x_label = over_time ? tr("Time (%1)").arg(minutes ? tr("min") : tr("s"))
                                 : tr("Way of the tool tip (%1)").arg(text(unit_name(unit_)));
    content_.y_label = tr("Angle (°)");
    content_.marks_label = tr("turns back");
    const auto& along = over_time ? figures.elapsed : figures.length;
    const double scale = over_time ? (minutes ? 60.0 : 1.0) : mm_per(unit_);
    for (const double v : along)
        content_.x.push_back(v / scale);
    for (std::size_t r = 0; r < std::min<std::size_t>(rotary.size(), 2); ++r) {
        PlotSeries series{text(rotary[r].name), {}, figures.reversals[r], no_number, no_number};
        for (const double v : figures.rotary[r])
            series.y.push_back(degrees(v));
        const Travel& travel = rotary[r].travel;
        if (travel.lo > -infinity) series.low_limit = degrees(travel.lo);
        if (travel.hi < infinity) series.high_limit = degrees(travel.hi);
        if (travel.limited())
            series.name += tr(" (%1 to %2)")
                               .arg(travel.lo > -infinity ? angle_text(series.low_limit, 0) : tr("any"),
                                    travel.hi < infinity ? angle_text(series.high_limit, 0) : tr("any"));
        content_.series.push_back(std::move(series));
    }
}

double PathChart::x_of(const ChartPlace& place) const {
    if (chart_ == Chart::stepover) {
        const auto& passes = program_->path.passes;
        const Index pass = program_->program.motions.motions[place.motion].pass;
        return pass < passes.size() ? passes[pass].offset / mm_per(unit_) : no_number;
    }
    if (place.motion >= content_.x.size()) return no_number;
    const double to = content_.x[place.motion], from = place.motion > 0 ? content_.x[place.motion - 1] : to;
    return from + place.share * (to - from);
}

QStringList PathChart::readout(const ChartPlace& place) const {
    if (chart_ == Chart::stepover) return stepover_readout(place);
    const PathFigures& figures = *figures_;
    const std::size_t m = place.motion, before = m > 0 ? m - 1 : m;
    const auto between = [&](const std::vector<double>& v) {
        return v[before] + place.share * (v[m] - v[before]);
    };
    const QString at = QStringLiteral("GOTO %1").arg(count_text(m + 1)),
                  length = shown_length(between(figures.length), unit_, 5),
                  time = duration_text(between(figures.elapsed));
    QStringList angles;
    for (std::size_t r = 0; r < 2 && !figures.rotary[r].empty(); ++r)
        if (const double v = between(figures.rotary[r]); std::isfinite(v))
            angles << QStringLiteral("%1 %2").arg(text(figures.machine.rotary[r].name),
                                                  angle_text(degrees(v)));
    const auto line = [](const QStringList& parts) { return parts.join(QStringLiteral("   ")); };
    return {line(QStringList{at, length, time} + angles), line(QStringList{at, length} + angles),
            line(QStringList{at} + angles)};
}

QStringList PathChart::stepover_readout(const ChartPlace& place) const {
    const int drive = program_->path.passes[program_->program.motions.motions[place.motion].pass].drive;
    const auto at =
        std::find_if(drives_.begin(), drives_.end(), [&](const Drive& d) { return d.drive == drive; });
    const QString pass = tr("Pass %1 of %2").arg(drive + 1).arg(drives_.size());
    QString line = pass;
    if (at != drives_.begin() && at != drives_.end())
        line += tr("   %1 to the one before").arg(shown_length(at->offset - (at - 1)->offset, unit_, 4));
    if (at != drives_.end() && at + 1 != drives_.end())
        line += tr("   %1 to the next").arg(shown_length((at + 1)->offset - at->offset, unit_, 4));
    return {line, pass};
}

std::optional<std::size_t> PathChart::motion_at(double x) const {
    if (chart_ == Chart::stepover) {
        const double v = x * mm_per(unit_);
        const auto nearest =
            std::min_element(drives_.begin(), drives_.end(), [&](const Drive& a, const Drive& b) {
                return std::abs(a.offset - v) < std::abs(b.offset - v);
            });
        return nearest == drives_.end() ? std::nullopt : std::optional(nearest->motion);
    }
    const auto& along = content_.x;
    if (along.empty()) return std::nullopt;
    const auto after = std::lower_bound(along.begin(), along.end(), x);
    auto motion = std::size_t(std::min(after, along.end() - 1) - along.begin());
    if (motion > 0 && x - along[motion - 1] < along[motion] - x) --motion;
    return motion;
}

std::optional<std::size_t> PathChart::pass_from(const ChartPlace& place, int by) const {
    if (drives_.empty()) return std::nullopt;
    const double v = x_of(place) * mm_per(unit_);
    const auto at = std::lower_bound(drives_.begin(), drives_.end(), v - 1e-9,
                                     [](const Drive& d, double value) { return d.offset < value; });
    const auto next =
        std::clamp<std::ptrdiff_t>(at - drives_.begin() + by, 0, std::ptrdiff_t(drives_.size()) - 1);
    return drives_[std::size_t(next)].motion;
}

std::string PathChart::table() const {
    if (chart_ == Chart::stepover) return stepover_table();
    const PathFigures& figures = *figures_;
    const auto& motions = program_->program.motions.motions;
    const std::size_t axes = figures.rotary[1].empty() ? 1 : 2;
    std::string lines = "goto,kind,way_" + std::string(unit_name(unit_)) + ",time_s";
    for (std::size_t r = 0; r < axes; ++r)
        lines +=
            "," + figures.machine.rotary[r].name + "_deg," + figures.machine.rotary[r].name + "_turns_back";
    lines += "\n";
    std::array<std::size_t, 2> next{};
    for (std::size_t m = 0; m < motions.size(); ++m) {
        lines += std::to_string(m + 1) + "," + kind_name(motions[m].kind) + ","
                 + number(figures.length[m] / mm_per(unit_)) + "," + number(figures.elapsed[m]);
        for (std::size_t r = 0; r < axes; ++r) {
            const auto& turns = figures.reversals[r];
            const bool here = next[r] < turns.size() && turns[next[r]] == m;
            next[r] += here;
            lines += "," + number(degrees(figures.rotary[r][m])) + (here ? ",1" : ",0");
        }
        lines += "\n";
    }
    return lines;
}

std::string PathChart::stepover_table() const {
    const std::string unit(unit_name(unit_));
    const double per = mm_per(unit_);
    std::string lines = "pass,place_" + unit + ",stepover_to_next_" + unit + "\n";
    for (std::size_t i = 0; i < drives_.size(); ++i)
        lines += std::to_string(drives_[i].drive + 1) + "," + number(drives_[i].offset / per) + ","
                 + (i + 1 < drives_.size() ? number((drives_[i + 1].offset - drives_[i].offset) / per)
                                           : std::string())
                 + "\n";
    return lines;
}

} // namespace facetmill::ui
