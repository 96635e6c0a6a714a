#include "ui/place_steps.h"

#include "core/job/usual_tools.h"
#include "core/setup/lying.h"
#include "ui/messages.h"
#include "ui/text.h"
#include "ui/tool_list.h"
#include "ui/viewport.h"

#include <Eigen/Geometry>

#include <memory>
#include <utility>

namespace facetmill::ui {

PlaceSteps::PlaceSteps(Document& document, Viewport& viewport, Messages& messages, QObject* parent)
    : QObject(parent), document_(document), viewport_(viewport), messages_(messages) {
    connect(&job_, &BackgroundJob::ended, this, &PlaceSteps::settled);
    // Queued: all others hear first of a part that was read anew.
    connect(&job_, &BackgroundJob::ended, this, &PlaceSteps::go_on, Qt::QueuedConnection);
    connect(&document_, &Document::part_changed, this, &PlaceSteps::go_on, Qt::QueuedConnection);
    connect(&document_, &Document::opened, this, &PlaceSteps::forget_waiting);
}

void PlaceSteps::when_it_stands(std::function<void()> step) {
    if (stands() && waiting_.empty()) return step();
    if (!document_.part()) return;
    waiting_.push_back([this, step = std::move(step), setup = chosen_setup(document_.project())] {
        if (chosen_setup(document_.project()) == setup) step();
    });
}

void PlaceSteps::go_on() {
    if (!stands() || waiting_.empty()) return;
    const std::function<void()> next = std::move(waiting_.front());
    waiting_.pop_front();
    next();
    // One that changed nothing has no end to go on from.
    if (!waiting_.empty()) QMetaObject::invokeMethod(this, &PlaceSteps::go_on, Qt::QueuedConnection);
}

const PreparedPart* PlaceSteps::part() const {
    return document_.part_is_current() ? document_.part().get() : nullptr;
}

void PlaceSteps::lay(const QString& what, Turn turn, std::function<void()> then) {
    const auto part = document_.part();
    if (!part) return;
    if (!stands())
        return messages_.information(tr("The part is still being turned. Do that again when it stands."));
    struct Laid {
        Placement placement;
        Vec3 size;
    };
    auto after = std::make_shared<std::optional<Laid>>();
    const std::size_t setup = chosen_setup(document_.project());
    job_.start(
        what,
        [after, part, turn = std::move(turn),
         before = placement_of(document_.project().placed_part())](const Progress& progress) {
            if (const auto by = turn(*part->mesh, progress))
                *after = Laid{laid(before, *part->mesh, *by, progress),
                              turned_box(*part->mesh, *by, progress).size()};
        },
        // Weak: the last one to hold a large part must not be the window.
        [this, what, after, setup, then = std::move(then),
         of = std::weak_ptr<const PreparedPart>(part)](const JobEnd& end) {
            const auto was = of.lock();
            if (end.how == JobEnd::How::cancelled || !was || this->part() != was.get()
                || chosen_setup(document_.project()) != setup)
                return;
            if (!end.done()) return messages_.warning(sentence(end.message));
            if (*after && change(what, (*after)->placement, (*after)->size) && then) then();
        });
}

void PlaceSteps::lay(const QString& what, const Mat3& turn) {
    lay(what, [turn](const Mesh&, const Progress&) { return turn; });
}

void PlaceSteps::turn(const QString& what, Turn by) {
    when_it_stands([this, what, by = std::move(by)] { lay(what, by); });
}

void PlaceSteps::mirror(int axis) {
    when_it_stands([this, axis] {
        const Box3& box = part()->box;
        change(tr("Mirror part in %1").arg(QChar(u'X' + char16_t(axis))),
               mirrored(placement_of(document_.project().placed_part()), axis, box.center()[axis]),
               box.size());
    });
}

void PlaceSteps::drop_to_zero() {
    when_it_stands([this] {
        const Box3& box = part()->box;
        change(tr("Drop part to Z 0"),
               moved(placement_of(document_.project().placed_part()), Vec3(0, 0, -box.lo.z())), box.size());
    });
}

void PlaceSteps::centre() {
    when_it_stands([this] {
        const Box3& box = part()->box;
        const Vec3 middle = box.center();
        change(tr("Centre part"),
               moved(placement_of(document_.project().placed_part()), Vec3(-middle.x(), -middle.y(), 0)),
               box.size());
    });
}

void PlaceSteps::lay_by_principal_axes() {
    turn(tr("Lay part by its principal axes"), turn_to_principal);
}

std::pair<Mat3, Vec3> PlaceSteps::motion(const Box3& box, PlaceChange what, int axis, double value) {
    if (what == PlaceChange::move) return {Mat3::Identity(), value * Vec3::Unit(axis)};
    const Mat3 turn = Eigen::AngleAxisd(value, Vec3::Unit(axis)).toRotationMatrix();
    return {turn, box.center() - turn * box.center()};
}

bool PlaceSteps::apply(PlaceChange what, int axis, double value) {
    if (!document_.part()) return false;
    if (!stands()) {
        when_it_stands([this, what, axis, value] { apply(what, axis, value); });
        return true;
    }
    const PreparedPart* p = part();
    if (what == PlaceChange::scale) return scale(value);
    const Placement now = placement_of(document_.project().placed_part());
    const QChar letter(u'X' + char16_t(axis));
    if (what == PlaceChange::move)
        return change(tr("Move part along %1").arg(letter), moved(now, value * Vec3::Unit(axis)),
                      p->box.size());
    const Box3& box = p->box;
    const Mat3 turn = motion(box, what, axis, value).first;
    return change(tr("Turn part about %1").arg(letter), turned(now, turn, box.center()),
                  turned_box(*p->mesh, turn).size());
}

bool PlaceSteps::scale(double factor) {
    const Box3 box = part()->box; // a change may replace the part
    const Placement now = placement_of(document_.project().placed_part());
    // A point p comes to factor * (p - t) + t; the middle and the lowest point are to stay.
    const Vec3 t(now.translate[0], now.translate[1], now.translate[2]);
    const Vec3 kept(box.center().x(), box.center().y(), box.lo.z());
    const Vec3 by = kept - (factor * (kept - t) + t);
    if (!change(tr("Scale part by %1").arg(number_text(factor, 6)), moved(now, by), factor * box.size(),
                factor))
        return false;
    const Vec3 size = factor * box.size();
    const double three[3] = {size.x(), size.y(), size.z()};
    messages_.warning(
        tr("The part is %1 now, no longer as large as its file says. Cutters, allowances and tolerances stay "
           "as they are.")
            .arg(size_text(three, document_.unit(), 5)));
    return true;
}

void PlaceSteps::tell(const Error& e) {
    messages_.warning(failure_text(e) + QChar('.'));
}

bool PlaceSteps::change(const QString& what, const Placement& placement, const Vec3& size, double factor) {
    if (factor == 1 && placement == placement_of(document_.project().placed_part())) {
        messages_.information(tr("The part lies so already."));
        return false;
    }
    viewport_.scene().marks().set_marker(std::nullopt);
    const Vec3 before = part()->box.size();
    try {
        document_.change(what, [&](Project& p) {
            lay_part(p, placement);
            p.part.scale *= factor;
            if (factor == 1)
                follow_part_size(p, before, size, spoken_tool_names());
            else
                follow_part_height(p, before.z(), size.z());
            // Numbers that no file can hold are refused.
            ParameterView<PartSpec> part(p.part, part_parameters());
            ParameterView<SetupPlace> place(p.place, place_parameters());
            part.set("scale", part.get("scale"));
            for (Parameterized* values :
                 {static_cast<Parameterized*>(&part), static_cast<Parameterized*>(&place)})
                for (const char* key : {"rotate", "translate"})
                    values->set(key, values->get(key));
        });
    } catch (const Error& e) {
        tell(e);
        return false;
    }
    return true;
}

} // namespace facetmill::ui
