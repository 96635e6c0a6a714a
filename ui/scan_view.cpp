#include "ui/scan_view.h"

#include "ui/camera_flight.h"
#include "ui/scan_words.h"
#include "ui/viewport.h"

#include <algorithm>

namespace facetmill::ui {

namespace {

/// Curves that the view draws.
constexpr std::size_t drawn_holes = 5000;
/// Height of the view around a hole or a piece, as a share of its size.
constexpr double view_of_part = 4;

std::vector<ClosedCurve> box_curves(const Box3& box) {
    const auto corner = [&](int i) {
        return Vec3(i & 1 ? box.hi.x() : box.lo.x(), i & 2 ? box.hi.y() : box.lo.y(),
                    i & 4 ? box.hi.z() : box.lo.z());
    };
    return {{corner(0), corner(1), corner(3), corner(2)},
            {corner(4), corner(5), corner(7), corner(6)},
            {corner(0), corner(4)},
            {corner(1), corner(5)},
            {corner(2), corner(6)},
            {corner(3), corner(7)}};
}

std::vector<Vec3> hole_curve(const ScannedMesh& scan, const Hole& hole) {
    std::vector<Vec3> points;
    for (const Index v : hole.loop)
        points.push_back(scan.mesh->vertices[v]);
    return points;
}

} // namespace

ScanView::ScanView(Viewport& viewport, QObject* parent)
    : QObject(parent), viewport_(viewport), flight_(new CameraFlight(viewport)) {}

bool ScanView::flying() const {
    return flight_->flying();
}

void ScanView::show(const ScanSight& sight) {
    const bool nothing = !sight_.scan && !sight.scan;
    if (sight.scan != sight_.scan) viewport_.scene().repair().set_chosen({});
    sight_ = sight;
    if (nothing) return;
    SceneRepair& scene = viewport_.scene().repair();
    const RepairDisplayPtr display = sight_.trial ? sight_.trial->display : nullptr;
    const bool other = display != scene.display();
    scene.set(display);
    scene.set_after(sight_.after);
    show_holes();
    if (other) viewport_.content_changed();
    viewport_.refresh();
}

std::vector<Vec3> ScanView::in_view(const std::vector<Vec3>& points) const {
    auto mesh = std::make_shared<Mesh>();
    mesh->vertices = points;
    return placed(mesh, sight_.place, {})->vertices;
}

void ScanView::show_holes() {
    std::vector<ClosedCurve> left, filled;
    if (sight_.scan) {
        const bool after = sight_.trial && sight_.after;
        const ScannedMesh& scan = after ? *sight_.trial->after : *sight_.scan;
        const auto& holes = scan.survey.holes.holes;
        const auto fates = after ? std::vector<HoleFate>(holes.size(), HoleFate::left)
                                 : hole_fates(*scan.mesh, scan.survey, sight_.recipe);
        for (std::size_t h = 0; h < std::min(holes.size(), drawn_holes); ++h)
            if (fates[h] != HoleFate::goes)
                (fates[h] == HoleFate::filled ? filled : left).push_back(in_view(hole_curve(scan, holes[h])));
    }
    viewport_.scene().repair().set_holes(left, filled);
}

void ScanView::go_to(std::size_t line, std::size_t part) {
    if (!sight_.scan) return;
    const ScannedMesh& scan = *sight_.scan;
    std::vector<ClosedCurve> curves;
    Vec3 from = Vec3::Zero();
    if (line == holes_line && part < scan.survey.holes.holes.size()) {
        curves.push_back(in_view(hole_curve(scan, scan.survey.holes.holes[part])));
        // A patch faces the way that its border is run around.
        const ClosedCurve& c = curves.front();
        for (std::size_t i = 1; i + 1 < c.size(); ++i)
            from += (c[i] - c[0]).cross(c[i + 1] - c[0]);
    } else if (line == pieces_line && part < scan.pieces.size()) {
        for (const ClosedCurve& curve : box_curves(scan.survey.shells.all[scan.pieces[part]].box))
            curves.push_back(in_view(curve));
    } else {
        return;
    }
    viewport_.scene().repair().set_chosen(curves);
    Box3 box;
    for (const ClosedCurve& curve : curves)
        for (const Vec3& p : curve)
            box.add(p);
    const SceneCamera& camera = viewport_.scene().camera();
    if (!(from.norm() > 0)) from = camera.toward_eye();
    flight_->fly_to(
        camera.place_to_see(box.center(), from.normalized(), std::max(view_of_part * box.diagonal(), 1e-3)));
    viewport_.refresh();
}

} // namespace facetmill::ui
