#include "core/output/apt_sections.h"

#include <algorithm>
#include <cmath>

namespace facetmill::detail {

namespace {

bool same_cutter(const AptCutter& a, const AptCutter& b) {
    return a.d == b.d && a.r == b.r && a.e == b.e && a.f == b.f && a.alpha == b.alpha && a.beta == b.beta
           && a.h == b.h;
}

} // namespace

/// A tool that was not named is the one that is named later.
bool AptSections::next_is_another_tool() const {
    return (next_.cutter && tool_.cutter && !same_cutter(*next_.cutter, section_.cutter))
           || (next_.number && tool_.number && *next_.number != section_.tool_number);
}

const CutterLocation* AptSections::position() const {
    if (next_is_another_tool()) return nullptr;
    const auto& motions = section_.motions.motions;
    return motions.empty() ? nullptr : &motions.back().to;
}

void AptSections::take_head(long line) {
    const bool another_tool = next_is_another_tool();
    const bool has_motions = !section_.motions.motions.empty();
    if (has_motions && (another_tool || next_.operation)) begin_section(another_tool, line);
    if (another_tool) {
        tool_ = {};
        section_.tool_name.clear();
    }
    if (next_.operation) section_.operation_name = *next_.operation;
    if (next_.tool_name) section_.tool_name = *next_.tool_name;
    if (next_.cutter) section_.cutter = *next_.cutter;
    if (next_.number) section_.tool_number = *next_.number;
    tool_.cutter = tool_.cutter || next_.cutter;
    tool_.number = tool_.number || next_.number;
    next_ = {};
}

void AptSections::begin_section(bool another_tool, long line) {
    from_.reset();
    if (!another_tool) from_ = section_.motions.motions.back().to;
    close_section(line);
    feeds_.clear();
    section_spindle_.reset();
    section_coolant_.reset();
}

void AptSections::move(const Vec3& tip, const Vec3& axis, bool rapid, long line) {
    take_head(line);
    auto& motions = section_.motions.motions;
    const CutterLocation to{tip, axis};
    if (motions.empty() && from_ && !(rapid && from_->tip == tip && from_->axis == axis))
        motions.push_back({.kind = MotionKind::rapid, .to = *from_});
    // The first motion of a tool comes from nobody knows where, whatever the file calls it (see ToolMotions).
    const bool cuts = !rapid && !motions.empty();
    if (cuts) note_cut();
    motions.push_back({.kind = cuts ? MotionKind::cut : MotionKind::rapid, .to = to});
    section_.multi_axis = section_.multi_axis || axis != Vec3::UnitZ();
}

/// What holds for the next motion, which cuts.
void AptSections::note_cut() {
    cuts_ = true;
    if (feed_ && (feeds_.empty() || feeds_.back().feed != *feed_))
        feeds_.push_back({section_.motions.motions.size(), *feed_});
    if (spindle_) {
        if (!section_spindle_) section_spindle_ = spindle_->value;
        if (*section_spindle_ != spindle_->value) tell_("change of SPINDL", spindle_->line);
    }
    const Coolant coolant = coolant_ ? coolant_->value : Coolant::off;
    if (!section_coolant_) section_coolant_ = coolant;
    if (*section_coolant_ != coolant) tell_("change of COOLNT", coolant_->line);
}

std::optional<double> AptSections::minute_feed(const AptFeed& feed) const {
    if (!feed.per_turn) return feed.value;
    if (section_spindle_) return feed.value * *section_spindle_;
    return std::nullopt;
}

void AptSections::close_section(long line) {
    ClSection& s = section_;
    s.spindle_rpm = section_spindle_.value_or(ClSection().spindle_rpm);
    s.coolant = section_coolant_.value_or(Coolant::off);
    s.feed_mm_per_min = ClSection().feed_mm_per_min;
    const auto& motions = s.motions.motions;
    const bool known = std::all_of(feeds_.begin(), feeds_.end(),
                                   [&](const FeedChange& f) { return minute_feed(f.feed).has_value(); });
    if (!known) {
        tell_("feed per turn without SPINDL", line);
    } else if (!feeds_.empty()) {
        s.feed_mm_per_min = *minute_feed(feeds_.front().feed);
        if (feeds_.size() > 1) s.motion_feeds.assign(motions.size(), s.feed_mm_per_min);
        for (std::size_t k = 1; k < feeds_.size(); ++k)
            std::fill(s.motion_feeds.begin() + std::ptrdiff_t(feeds_[k].motion), s.motion_feeds.end(),
                      *minute_feed(feeds_[k].feed));
    }
    s.motions.clearance_z = -infinity;
    for (const Motion& m : motions)
        s.motions.clearance_z = std::max(s.motions.clearance_z, m.to.tip.z());
    sections_.push_back(std::make_shared<const ClSection>(std::move(s)));
    tools_.push_back(tool_);
    // Tool and names go on until something else is said.
    const ClSection& before = *sections_.back();
    section_ = {};
    section_.operation_name = before.operation_name;
    section_.tool_number = before.tool_number;
    section_.tool_name = before.tool_name;
    section_.cutter = before.cutter;
}

void AptSections::finish(AptReadResult& result, long line) {
    if (next_is_another_tool()) {
        tell_("a tool that makes no motion", line);
    } else {
        next_.operation.reset();
        take_head(line);
    }
    // What stands behind the last cut is better than nothing.
    if (feeds_.empty() && feed_) feeds_.push_back({0, *feed_});
    if (!section_spindle_ && spindle_) section_spindle_ = spindle_->value;
    close_section(line);
    result.program.sections = std::move(sections_);
    result.tools = std::move(tools_);
}

} // namespace facetmill::detail
