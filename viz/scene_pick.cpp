// Picking by lines of sight, on the core's own numbers (double), not on what was drawn.
#include "viz/scene_impl.h"

#include <cmath>

namespace facetmill {

namespace {

/// A point of a path near the pixel.
struct Candidate {
    double pixels = 0, depth = 0; ///< distance on the screen; distance from the eye's plane, mm
    std::size_t source = 0;
    bool is_contact = false;
    std::size_t pass = 0, index = 0; ///< pass and CC, or motion
};

} // namespace

std::optional<PartPick> Scene::pick_part(double x, double y) const {
    if (!impl_->part || impl_->pixel_size() <= 0) return std::nullopt;
    const Mesh& mesh = *impl_->part->mesh;
    const Vec3 direction = -Vec3(impl_->camera_frame().row(2).transpose());
    // Start before everything: in parallel projection the eye's own place means nothing.
    const double back =
        2 * impl_->part->box.diagonal() + (impl_->part->box.center() - impl_->point_at(x, y)).norm();
    const Vec3 origin = impl_->point_at(x, y) - back * direction;
    const SightHit hit = impl_->part->sights.first(mesh, origin, direction);
    if (!hit.found()) return std::nullopt;
    PartPick pick;
    pick.point = origin + hit.distance * direction;
    pick.normal = mesh.facet_normal(hit.facet);
    pick.facet = hit.facet;
    pick.back_side = pick.normal.dot(direction) > 0;
    return pick;
}

std::optional<PathPick> Scene::pick_path(double x, double y, double radius) const {
    const double mm = impl_->pixel_size();
    if (!impl_->path || mm <= 0) return std::nullopt;
    const Mat3 frame = impl_->camera_frame();
    const Vec3 at = impl_->point_at(x, y), right = frame.row(0).transpose(), up = frame.row(1).transpose(),
               toward = frame.row(2).transpose();
    std::vector<Candidate> near;
    const auto consider = [&](const Vec3& p, Candidate c) {
        const Vec3 d = p - at;
        const double dx = d.dot(right) / mm, dy = d.dot(up) / mm;
        const double pixels = std::sqrt(dx * dx + dy * dy);
        if (!(pixels <= radius)) return;
        c.pixels = pixels;
        c.depth = -d.dot(toward);
        near.push_back(c);
    };
    for (std::size_t s = 0; s < impl_->path->sources.size(); ++s) {
        const PathSource& source = impl_->path->sources[s];
        if (visible(Layer::cc) && source.contacts)
            for (std::size_t p = 0; p < source.contacts->passes.size(); ++p) {
                if (!source.shows(source.contacts->passes[p])) continue;
                const auto& cc = source.contacts->passes[p].cc;
                for (std::size_t i = 0; i < cc.size(); ++i)
                    consider(cc[i].point, {0, 0, s, true, p, i});
            }
        if (visible(Layer::cl) && source.motions)
            for (std::size_t i = 0; i < source.motions->motions.size(); ++i)
                if (motion_visible(source.motions->motions[i].kind) && source.shows_motion(i))
                    consider(source.motions->motions[i].to.tip, {0, 0, s, false, 0, i});
    }
    // Within two pixels counts as equally near; then the one before the others.
    std::sort(near.begin(), near.end(), [](const Candidate& a, const Candidate& b) {
        const double pa = std::floor(a.pixels / 2), pb = std::floor(b.pixels / 2);
        if (pa != pb) return pa < pb;
        if (a.depth != b.depth) return a.depth < b.depth;
        return a.pixels < b.pixels;
    });
    constexpr std::size_t tries = 8; // lines of sight cast: what else lies that near is hidden as well
    const bool occluded = impl_->part && visible(Layer::part) && impl_->part_style != PartStyle::wire;
    for (std::size_t i = 0; i < std::min(near.size(), tries); ++i) {
        const Candidate& c = near[i];
        const PathSource& source = impl_->path->sources[c.source];
        PathPick pick;
        pick.source = c.source;
        pick.is_contact = c.is_contact;
        if (c.is_contact) {
            const Pass& pass = source.contacts->passes[c.pass];
            pick.pass = Index(c.pass);
            pick.point = Index(c.index);
            pick.position = pass.cc[c.index].point;
            // A pass that was not lifted yet has contacts and no locations.
            pick.location =
                c.index < pass.cl.size() ? pass.cl[c.index] : CutterLocation{pick.position, Vec3(0, 0, 1)};
        } else {
            const Motion& motion = source.motions->motions[c.index];
            pick.motion = c.index;
            pick.pass = motion.pass;
            pick.point = motion.point;
            pick.position = motion.to.tip;
            pick.location = motion.to;
        }
        if (occluded) {
            const double back =
                2 * impl_->part->box.diagonal() + (impl_->part->box.center() - pick.position).norm();
            const SightHit hit =
                impl_->part->sights.first(*impl_->part->mesh, pick.position + back * toward, -toward);
            // A point on the surface is seen although the facets around it lie a little before it.
            const double slack = 2 * mm + 1e-3 * impl_->part->box.diagonal();
            if (hit.distance < back - slack) continue;
        }
        return pick;
    }
    return std::nullopt;
}

Vec2 Scene::Impl::display_of(const Vec3& point) const {
    const Eigen::Vector2i size = window_size();
    const double mm = pixel_size();
    if (mm <= 0) return Vec2::Zero();
    const Mat3 frame = camera_frame();
    const Vec3 d = point - point_at(size.x() / 2.0, size.y() / 2.0);
    return {size.x() / 2.0 + frame.row(0).dot(d) / mm, size.y() / 2.0 - frame.row(1).dot(d) / mm};
}

Vec2 Scene::display_of(const Vec3& point) const {
    return impl_->display_of(point);
}

} // namespace facetmill
