// The scan room in the 3D view: curves of holes, what is chosen in the survey, and a side of what was tried.
#pragma once

#include "core/job/placed_mesh.h"
#include "ui/scan_study.h"

#include <QObject>

namespace facetmill::ui {

class CameraFlight;
class Viewport;

/// What is to be seen.
struct ScanSight {
    ScannedMeshPtr scan;            ///< null: nothing
    std::vector<RepairStep> recipe; ///< says which holes it fills
    ScanTrialPtr trial;             ///< null: the part is seen as it is
    bool after = true;              ///< which side of it
    MeshPlace place;
};

class ScanView : public QObject {
    Q_OBJECT
public:
    ScanView(Viewport& viewport, QObject* parent);

    void show(const ScanSight& sight);
    /// Flies to a part of a line of the survey, a hole or a piece, and marks it; others are left alone.
    void go_to(std::size_t line, std::size_t part);
    bool flying() const;

private:
    void show_holes();
    std::vector<Vec3> in_view(const std::vector<Vec3>& points) const;

    Viewport& viewport_;
    CameraFlight* flight_ = nullptr;
    ScanSight sight_;
};

} // namespace facetmill::ui
