// Changes of how the part lies, each one step of the history.
#pragma once

#include "core/setup/placement.h"
#include "ui/background_job.h"
#include "ui/document.h"
#include "ui/place_value.h"

#include <functional>
#include <optional>

namespace facetmill::ui {

class Messages;
class Viewport;

class PlaceSteps : public QObject {
    Q_OBJECT
public:
    PlaceSteps(Document& document, Viewport& viewport, Messages& messages, QObject* parent);

    /// The part as it stands, where the project says that it does; null while it is read anew.
    const PreparedPart* part() const;
    /// What turns a part; may throw Error, and nothing is turned where it finds nothing. Called in the thread
    /// of a job: it walks all facets.
    using Turn = std::function<std::optional<Mat3>(const Mesh&, const Progress&)>;
    /// Turned, the middle of its box over the same place and its lowest point on Z 0, worked out aside from
    /// the window. `then` where that was a change. Does nothing while the last one is still worked out, nor
    /// where the part or the setup has become another meanwhile.
    void lay(const QString& what, Turn turn, std::function<void()> then = {});
    void lay(const QString& what, const Mat3& turn);
    void mirror(int axis);
    void drop_to_zero();
    void centre();
    /// By principal axes; says why where it has none.
    void lay_by_principal_axes();
    /// About the middle of its box by radians, along an axis by mm, or by a factor. False: nothing changed.
    bool apply(PlaceChange what, int axis, double value);
    /// What `apply` would make of a place, without a change of the project.
    static std::pair<Mat3, Vec3> motion(const Box3& box, PlaceChange what, int axis, double value);
    bool busy() const { return job_.running(); }

signals:
    void settled();

private:
    bool scale(double factor);
    /// `height` (mm): of the part as it then stands; `factor`: it is so many times as large.
    bool change(const QString& what, const Placement& placement, double height, double factor = 1);
    void tell(const Error& error);

    Document& document_;
    Viewport& viewport_;
    Messages& messages_;
    BackgroundJob job_; // last: it ends first
};

} // namespace facetmill::ui
