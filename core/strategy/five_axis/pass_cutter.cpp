#include "core/strategy/five_axis/pass_cutter.h"

#include "core/strategy/five_axis/run_out.h"

#include <algorithm>
#include <chrono>

namespace facetmill {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

PassCutter::PassCutter(const FiveAxisField& field)
    : field_(field), record_(std::make_shared<FiveAxisRecord>()), kept_(field) {
    record_->context = field.context();
    record_->settings = field.settings();
    record_->pieces.push_back(
        {field.context(), field.view(), field.settings().lead_limits, field.settings().passes});
}

void PassCutter::add(std::vector<PlacedLine> pass, int drive, double v, const Progress& progress) {
    kept_.hand_over(pass);
    for (PlacedLine& placed : pass) {
        auto coming = std::make_unique<Pending>();
        coming->drive = drive;
        coming->v = v;
        coming->study = study(placed, progress);
        coming->placed = std::move(placed);
        if (pending_) cut(*pending_, coming->study.points, progress);
        pending_ = std::move(coming);
    }
}

void PassCutter::finish(const Progress& progress) {
    if (pending_) cut(*pending_, {}, progress);
    pending_.reset();
}

PostureStudy PassCutter::study(PlacedLine& line, const Progress& progress) {
    const auto start = Clock::now();
    PostureStudy made = study_postures(field_, line.places, progress);
    const double spent = seconds_since(start);
    const double cpu = std::max(made.stages.bottom + made.stages.top, 1e-12);
    done_.seconds.bottom += spent * made.stages.bottom / cpu;
    done_.seconds.top += spent * made.stages.top / cpu;
    kept_.check(line, made);
    return made;
}

void PassCutter::cut(Pending& line, std::span<const PassPoint> next, const Progress& progress) {
    const auto start = Clock::now();
    PlacedLine& placed = line.placed;
    placed.choices =
        choose_postures(field_, line.study, field_.settings().posture, last_pose(), next, progress);
    FiveAxisRecord::Line recorded{record_->points.size(), 0, line.drive, 0};
    for (std::size_t i = 0; i < placed.places.size(); ++i) {
        record_->points.push_back({placed.places[i], line.study.points[i].cm2_lead, placed.choices[i]});
        if (!placed.choices[i].free) {
            unfree_.add(line.study.spaces[i]);
        } else if (line.study.narrowed[i] != 0) {
            unfree_.add_narrowed();
            done_.uncut.push_back({placed.places[i].surface, placed.places[i].frame.normal});
        }
    }
    recorded.end = record_->points.size();
    record_->lines.push_back(recorded);
    add_run_outs(placed);
    JoinedPasses joined = join_postures(field_, placed, progress);
    for (Pass& p : joined.passes) {
        p.drive = line.drive;
        p.offset = line.v;
        done_.passes.push_back(std::move(p));
    }
    done_.uncut.insert(done_.uncut.end(), joined.uncut.begin(), joined.uncut.end());
    done_.cusp_max = std::max(done_.cusp_max, joined.cusp);
    done_.lead_min = std::min(done_.lead_min, joined.lead_min);
    done_.lead_max = std::max(done_.lead_max, joined.lead_max);
    done_.seconds.postures += seconds_since(start);
}

void PassCutter::add_run_outs(PlacedLine& line) const {
    const ChosenPosture &first = line.choices.front(), &last = line.choices.back();
    if (first.free && !line.cut_short[0])
        line.before = run_out(field_, line.line, line.places.front(), first.posture, line.travel, false);
    if (last.free && !line.cut_short[1])
        line.after = run_out(field_, line.line, line.places.back(), last.posture, line.travel, true);
}

std::optional<ToolPose> PassCutter::last_pose() const {
    if (done_.passes.empty()) return std::nullopt;
    const CutterLocation& end = done_.passes.back().cl.back();
    return ToolPose{end.tip, end.axis};
}

} // namespace facetmill
