#include "viz/path_display.h"

#include "core/job/planner.h"
#include "core/strategy/five_axis/five_axis_record.h"
#include "viz/dasher.h"

#include <cmath>

namespace facetmill {

namespace {

constexpr std::size_t points_per_check = 1u << 16; // points: about 1 ms

void append(std::vector<float>& points, const Vec3& p) {
    points.insert(points.end(), {float(p.x()), float(p.y()), float(p.z())});
}
void append(Polylines& lines, const Vec3& p) {
    append(lines.points, p);
}

/// Ends the polyline that is being built; one of a single point is dropped unless `keep_single`.
void finish(Polylines& lines, bool keep_single) {
    const auto count = std::int32_t(lines.points.size() / 3);
    const std::int32_t length = count - lines.offsets.back();
    if (length == 1 && !keep_single) lines.points.resize(lines.points.size() - 3);
    if (length > (keep_single ? 0 : 1)) lines.offsets.push_back(count);
}

/// Every n-th point of each polyline and its last; every n-th polyline where they are short. Empty for few
/// points.
Polylines thinned(const Polylines& lines) {
    Polylines thin;
    const std::size_t points = lines.points.size() / 3, count = lines.offsets.size() - 1;
    if (points <= largest_path_without_preview) return thin;
    const std::size_t n = points / largest_path_without_preview + 1;
    const bool short_lines = points / count < 4 * n;
    for (std::size_t i = 0; i < count; i += short_lines ? n : 1) {
        const auto first = std::size_t(lines.offsets[i]), end = std::size_t(lines.offsets[i + 1]);
        for (std::size_t p = first; p < end;) {
            thin.points.insert(thin.points.end(), &lines.points[3 * p], &lines.points[3 * p] + 3);
            p = p + 1 == end ? end : std::min(p + (short_lines ? 1 : n), end - 1);
        }
        thin.offsets.push_back(std::int32_t(thin.points.size() / 3));
    }
    return thin;
}

/// Fills a display from its sources.
class Builder {
public:
    Builder(PathDisplay& display, const Progress& progress) : display_(display), progress_(progress) {}

    /// The box of everything, and how long the rapids are.
    void measure();
    /// Dashes of a fixed length on the part, longer where there would be too many of them.
    double dash() const { return std::max(display_.box.diagonal() / 60.0, rapid_length_ / 200'000.0); }
    void add_contacts(const PathSource& source);
    /// Contact points left to clean-up, and those of kept postures.
    void add_marks(const PathSource& source);
    void add_motions(const PathSource& source, double dash);
    void set_spacing();

private:
    void tick() {
        if (++points_ % points_per_check == 0) progress_.check();
    }
    void measure(const ToolMotions& motions);

    PathDisplay& display_;
    const Progress& progress_;
    std::size_t points_ = 0, contact_steps_ = 0;
    double rapid_length_ = 0, contact_length_ = 0;
};

void Builder::measure() {
    for (const PathSource& s : display_.sources) {
        if (s.contacts) {
            for (const Pass& pass : s.contacts->passes)
                for (const CutterContact& c : pass.cc) {
                    tick();
                    if (c.point.allFinite()) display_.box.add(c.point);
                }
            for (const CutterContact& c : s.contacts->cleanup)
                if (c.point.allFinite()) display_.box.add(c.point);
        }
        if (s.motions) measure(*s.motions);
    }
    if (display_.box.empty()) return;
    if (points_ > std::size_t(std::numeric_limits<std::int32_t>::max()) / 8)
        throw Error(ErrorCode::too_large, "path", "has more points than can be drawn",
                    "use a larger tolerance");
    display_.center = display_.box.center();
}

void Builder::measure(const ToolMotions& path) {
    const auto& motions = path.motions;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        tick();
        if (!motions[i].to.tip.allFinite()) continue;
        display_.box.add(motions[i].to.tip);
        if (i > 0 && motions[i].kind == MotionKind::rapid && motions[i - 1].to.tip.allFinite())
            rapid_length_ += (motions[i].to.tip - motions[i - 1].to.tip).norm();
    }
}

void Builder::add_contacts(const PathSource& s) {
    if (!s.contacts) return;
    for (const Pass& pass : s.contacts->passes) {
        if (!s.shows(pass)) continue;
        const CutterContact* before = nullptr;
        for (const CutterContact& c : pass.cc) {
            tick();
            if (!c.point.allFinite()) continue;
            append(display_.contacts, c.point - display_.center);
            if (before) {
                contact_length_ += (c.point - before->point).norm();
                ++contact_steps_;
            }
            before = &c;
        }
        finish(display_.contacts, true);
    }
}

void Builder::add_marks(const PathSource& s) {
    if (!s.contacts || s.hidden || s.layer >= 0) return;
    for (const CutterContact& c : s.contacts->cleanup) {
        tick();
        if (c.point.allFinite()) append(display_.left_points, c.point - display_.center);
    }
    if (const auto record = s.contacts->five_axis())
        for (const FiveAxisRecord::Point& p : record->points) {
            tick();
            if (p.place.kept) append(display_.kept_points, p.place.surface - display_.center);
        }
}

void Builder::add_motions(const PathSource& s, double dash) {
    if (!s.motions) return;
    const Vec3& center = display_.center;
    const auto& motions = s.motions->motions;
    Dasher rapid(display_.motions[std::size_t(MotionKind::rapid)], center, dash);
    bool open = false; // a polyline of the kind of motion i - 1 is being built
    for (std::size_t i = 1; i < motions.size(); ++i) {
        tick();
        const Motion &from = motions[i - 1], &to = motions[i];
        Polylines& line = display_.motions[std::size_t(to.kind)];
        if (open && to.kind != from.kind) {
            finish(display_.motions[std::size_t(from.kind)], false);
            open = false;
        }
        if (!s.shows_motion(i) || !from.to.tip.allFinite() || !to.to.tip.allFinite()) {
            if (open) finish(line, false);
            open = false;
            continue;
        }
        if (to.kind == MotionKind::rapid) {
            if (from.kind != MotionKind::rapid) rapid.restart();
            rapid.add(from.to.tip, to.to.tip);
            continue;
        }
        if (!open) append(line, from.to.tip - center);
        open = true;
        append(line, to.to.tip - center);
    }
    if (open) finish(display_.motions[std::size_t(motions.back().kind)], false);
}

void Builder::set_spacing() {
    if (contact_steps_ == 0) return;
    const Vec3 size = display_.box.size();
    const double area = std::max({size.x() * size.y(), size.y() * size.z(), size.z() * size.x()});
    const double along = contact_length_ / double(contact_steps_),
                 across = area / std::max(contact_length_, 1e-300);
    display_.contact_spacing = std::min(along, across);
}

} // namespace

PathSource path_source(const std::shared_ptr<const OperationResult>& operation, int layer) {
    if (!operation) return {};
    PathSource source{
        {operation, &operation->path}, {operation, &operation->program.motions}, layer, {}, false};
    if (layer < 0) return source;
    // What does not cut belongs to the next motion that does.
    const auto& passes = operation->path.passes;
    const auto& motions = operation->program.motions.motions;
    std::vector<int> layers(motions.size(), -1);
    int next = passes.empty() ? -1 : passes.back().layer;
    for (std::size_t m = motions.size(); m-- > 0;) {
        if (motions[m].pass < passes.size()) next = passes[motions[m].pass].layer;
        layers[m] = next;
    }
    source.motion_layers = std::make_shared<const std::vector<int>>(std::move(layers));
    return source;
}

PathDisplayPtr prepare_path_display(std::vector<PathSource> sources, const Progress& progress) {
    auto display = std::make_shared<PathDisplay>();
    display->sources = std::move(sources);
    Builder builder(*display, progress);
    builder.measure();
    if (display->box.empty()) return display;
    const double dash = builder.dash();
    for (const PathSource& s : display->sources) {
        builder.add_contacts(s);
        builder.add_marks(s);
        builder.add_motions(s, dash);
    }
    builder.set_spacing();
    progress.check();
    display->contacts_preview = thinned(display->contacts);
    for (std::size_t k = 0; k < motion_kinds; ++k)
        display->motions_preview[k] = thinned(display->motions[k]);
    return display;
}

} // namespace facetmill
