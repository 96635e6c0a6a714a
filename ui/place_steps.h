// Changes of how the part lies, each one step of the history.
#pragma once

#include "core/setup/placement.h"
#include "ui/background_job.h"
#include "ui/document.h"
#include "ui/place_value.h"

#include <deque>
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
    /// the window. `then` where that was a change. Does nothing where the part or the setup has become
    /// another meanwhile; while the part does not stand yet, a word says so: what was picked is of where it
    /// was.
    void lay(const QString& what, Turn turn, std::function<void()> then = {});
    void lay(const QString& what, const Mat3& turn);
    /// The same by what is no place of the part; while it does not stand yet this, and what follows, is done
    /// as soon as it does, one after the other.
    void turn(const QString& what, Turn by);
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
    /// What still waits for the part is not done.
    void forget_waiting() { waiting_.clear(); }

signals:
    void settled();

private:
    /// The part stands as the project says, and nothing is worked out.
    bool stands() const { return part() && !busy(); }
    /// Now, or as soon as the part stands; in another setup not at all.
    void when_it_stands(std::function<void()> step);
    void go_on();
    bool scale(double factor);
    /// `size` (mm): of the part as it then stands; `factor`: it is so many times as large.
    bool change(const QString& what, const Placement& placement, const Vec3& size, double factor = 1);
    void tell(const Error& error);

    Document& document_;
    Viewport& viewport_;
    Messages& messages_;
    std::deque<std::function<void()>> waiting_;
    BackgroundJob job_; // last: it ends first
};

} // namespace facetmill::ui
