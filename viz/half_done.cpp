#include "viz/half_done.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/job/planner.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticPointLocator.h>

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Colours come up behind the tool over this share of the cuts.
constexpr double fade = 0.1;
/// Places along the path that samples are held against, per length of its box's diagonal.
constexpr double places_per_diagonal = 500;
constexpr std::size_t samples_per_block = 4096;

/// Where cuts come by, with the share of the cuts that is done there.
struct Places {
    vtkNew<vtkPoints> points;
    std::vector<float> shares;
};

void sample_cuts(const std::vector<Motion>& motions, Places& places, const Progress& progress) {
    Box3 box;
    double length = 0;
    for (std::size_t i = 1; i < motions.size(); ++i)
        if (motions[i].kind == MotionKind::cut) {
            box.add(motions[i].to.tip);
            length += (motions[i].to.tip - motions[i - 1].to.tip).norm();
        }
    const double step = box.diagonal() / places_per_diagonal;
    if (!(step > 0) || !(length > 0)) return;
    double gone = 0;
    for (std::size_t i = 1; i < motions.size(); ++i) {
        if (i % samples_per_block == 0) progress.check();
        if (motions[i].kind != MotionKind::cut) continue;
        const Vec3 &from = motions[i - 1].to.tip, &to = motions[i].to.tip;
        const double run = (to - from).norm();
        const int steps = std::max(1, int(std::ceil(run / step)));
        for (int k = 1; k <= steps; ++k) {
            const double t = double(k) / steps;
            const Vec3 at = from + t * (to - from);
            places.points->InsertNextPoint(at.x(), at.y(), at.z());
            places.shares.push_back(float((gone + t * run) / length));
        }
        gone += run;
    }
}

} // namespace

HalfDone half_done(const std::shared_ptr<const OperationResult>& operation, const DeviationSurface& surface,
                   double share, const Progress& progress) {
    const std::vector<Motion>& motions = operation->program.motions.motions;
    const auto cuts = std::count_if(motions.begin(), motions.end(),
                                    [](const Motion& m) { return m.kind == MotionKind::cut; });
    Places places;
    sample_cuts(motions, places, progress);
    if (cuts == 0 || places.shares.empty())
        throw Error(ErrorCode::empty_result, "operation '" + operation->name + "'", "cuts nothing",
                    "show one that does");
    HalfDone half;
    // Where the share of the length is reached.
    const auto reached = std::lower_bound(places.shares.begin(), places.shares.end(), float(share));
    const auto place =
        vtkIdType(std::min(std::size_t(reached - places.shares.begin()), places.shares.size() - 1));
    const Vec3 tip(places.points->GetPoint(place));
    std::size_t nearest = 0;
    double least = infinity;
    for (std::size_t i = 0; i < motions.size(); ++i)
        if (const double away = (motions[i].to.tip - tip).squaredNorm();
            motions[i].kind == MotionKind::cut && away < least) {
            least = away;
            nearest = i;
        }
    half.pose = motions[nearest].to;
    auto ahead = std::make_shared<ToolMotions>(operation->program.motions);
    ahead->motions.erase(ahead->motions.begin(), ahead->motions.begin() + std::ptrdiff_t(nearest));
    half.ahead.motions = std::move(ahead);

    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(places.points);
    vtkNew<vtkStaticPointLocator> locator;
    locator->SetDataSet(cloud);
    locator->BuildLocator();
    half.done.resize(surface.points.size());
    parallel_for(half.done.size(), samples_per_block, progress, [&](std::size_t i) {
        const auto& s = surface.points[i];
        const Vec3 p{double(s[0]), double(s[1]), double(s[2])};
        const double at = places.shares[std::size_t(locator->FindClosestPoint(p.data()))];
        const double t = std::clamp((share - at) / fade, 0.0, 1.0);
        half.done[i] = float(t * t * (3 - 2 * t));
    });
    return half;
}

} // namespace facetmill
