#include "ui/place_controller.h"

#include "core/job/work_zero.h"
#include "core/mesh/flat_face.h"
#include "core/mesh/refine.h"
#include "core/mesh/round_face.h"
#include "ui/messages.h"
#include "ui/point_picker.h"
#include "ui/text.h"
#include "ui/viewport.h"
#include "ui/worded.h"

#include <QKeyEvent>
#include <QTimer>
#include <QTreeWidget>

#include <algorithm>
#include <utility>

namespace facetmill::ui {

namespace {

/// Length of the axes at the work zero, as a share of the part's size.
constexpr double zero_axis_share = 0.15;
/// How round a hole is, is told no finer (mm).
constexpr double told_uneven = 1e-4;
/// A block that is smaller by this share is worth a word.
constexpr double worth_squaring = 0.1;

/// The share of the block about a part, once turned, that squaring it up saves.
double smaller_by_squaring(Mesh part, const Mat3& turn, const Progress& progress) {
    const auto area = [&](const Mat3& by) {
        const Vec3 size = turned_box(part, by, progress).size();
        return size.x() * size.y();
    };
    for (Vec3& v : part.vertices)
        v = turn * v;
    const double as_laid = area(Mat3::Identity());
    return as_laid > 0 ? 1 - area(turn_to_square(part, progress)) / as_laid : 0;
}

} // namespace

PlaceController::PlaceController(Document& document, Viewport& viewport, Messages& messages, QWidget* window)
    : Controller(window), document_(document), viewport_(viewport), messages_(messages),
      panel_(new PlacePanel(window)), flight_(new CameraFlight(viewport)), visit_(viewport, *flight_),
      steps_(new PlaceSteps(document, viewport, messages, this)), gizmo_(new PlaceGizmo(viewport, this)) {
    connect(panel_, &PlacePanel::order_changed, this, &PlaceController::find_faces);
    connect(panel_, &PlacePanel::face_chosen, this, &PlaceController::show_chosen);
    connect(panel_, &PlacePanel::lay_wanted, this, &PlaceController::lay_chosen);
    connect(panel_, &PlacePanel::pick_wanted, this, &PlaceController::pick);
    connect(panel_, &PlacePanel::turn_wanted, this, [this](int axis, int quarters) {
        steps_->turn(tr("Turn part about %1").arg(QChar(u'X' + char16_t(axis))),
                     [turn = quarter_turn(axis, quarters)](const Mesh&, const Progress&) { return turn; });
    });
    connect(panel_, &PlacePanel::square_wanted, this,
            [this] { steps_->turn(tr("Square up part"), turn_to_square); });
    connect(panel_, &PlacePanel::principal_wanted, steps_, &PlaceSteps::lay_by_principal_axes);
    connect(panel_, &PlacePanel::mirror_wanted, steps_, &PlaceSteps::mirror);
    connect(panel_, &PlacePanel::drop_wanted, steps_, &PlaceSteps::drop_to_zero);
    connect(panel_, &PlacePanel::centre_wanted, steps_, &PlaceSteps::centre);
    connect(panel_->value_row(), &PlaceValueRow::wanted, steps_, &PlaceSteps::apply);
    connect(gizmo_, &PlaceGizmo::dragged, this, [this](PlaceChange what, int axis, double value) {
        if (!mesh()) return;
        const auto [turn, move] = PlaceSteps::motion(document_.part()->box, what, axis, value);
        viewport_.scene().part().set_pose(turn, move);
        panel_->value_row()->show_value(what, axis, value);
        viewport_.refresh();
    });
    connect(gizmo_, &PlaceGizmo::dropped, this, [this](PlaceChange what, int axis, double value) {
        // As it is drawn it stays until it has been read anew.
        if (value != 0 && steps_->apply(what, axis, value)) return;
        viewport_.scene().part().set_pose(Mat3::Identity(), Vec3::Zero());
        viewport_.refresh();
    });
    connect(panel_, &PlacePanel::zero_wanted, this, [this](bool on_part, const std::array<double, 3>& place) {
        change_zero([&](ProgramSpec& spec) {
            spec.zero_from = on_part ? ProgramSpec::ZeroFrom::part : ProgramSpec::ZeroFrom::stock;
            spec.zero_place = place;
            spec.zero = {0, 0, 0};
        });
    });
    connect(panel_, &PlacePanel::zero_origin_wanted, this, [this] {
        change_zero([](ProgramSpec& spec) {
            spec.zero_from = ProgramSpec::ZeroFrom::origin;
            spec.zero = {0, 0, 0};
        });
    });
    connect(&viewport_, &Viewport::point_picked, this,
            [this](const std::optional<PartPick>& pick, Qt::KeyboardModifiers) { take(pick); });
    for (BackgroundJob* job : {&job_, &hole_job_})
        connect(job, &BackgroundJob::ended, this, &PlaceController::settled);
    connect(steps_, &PlaceSteps::settled, this, &PlaceController::settled);
}

PlaceController::~PlaceController() = default;

bool PlaceController::busy() const {
    return job_.running() || hole_job_.running() || steps_->busy() || flight_->flying();
}

void PlaceController::project_opened() {
    leave();
    box_ = Box3();
    refresh();
}

void PlaceController::part_changed() {
    refresh();
    if (!document_.part_is_current()) return;
    const Box3 now = document_.part()->box;
    const bool other = !box_.empty() && (now.lo != box_.lo || now.hi != box_.hi);
    box_ = now;
    if (!other) return;
    flight_->stop(); // to a face that is elsewhere now
    // After all have heard of the part: the stock goes with it.
    QTimer::singleShot(0, this, [this] { viewport_.fit(); });
}

void PlaceController::panel_seen(bool seen) {
    // Later: a dock says that it is hidden before what is in it is. Behind another one's tab it is hidden,
    // too, and its rings would lie over what that one is about.
    QMetaObject::invokeMethod(
        this,
        [this, seen] {
            seen_ = seen && panel_->isVisible();
            if (!seen_) leave();
            refresh();
        },
        Qt::QueuedConnection);
}

void PlaceController::refresh() {
    const bool there = document_.has_part() && document_.part();
    const Box3 box = there ? document_.part()->box : Box3();
    panel_->show_box(box, document_.unit(), document_.project().part.scale);
    if (!mesh()) leave();
    gizmo_->set_box(mesh() ? box : Box3(), document_.unit());
    viewport_.set_gizmo(seen_ ? gizmo_ : nullptr);
    show_zero();
    find_faces();
}

/// In the panel, and in the view where it is elsewhere than in the part's origin or the panel is seen.
void PlaceController::show_zero() {
    const Project& project = document_.project();
    const ProgramSpec& spec = project.programs;
    ShownZero shown;
    shown.on_origin = spec.zero_from == ProgramSpec::ZeroFrom::origin;
    shown.on_part = spec.zero_from == ProgramSpec::ZeroFrom::part;
    shown.place = spec.zero_place;
    std::optional<ZeroMark> mark;
    if (mesh()) {
        try {
            const Vec3 zero = work_zero(project, *document_.part());
            const std::string name = work_zero_name(project);
            shown.text = tr("%1 in %2").arg(worded(name), worded(work_zero_text(spec, project.unit)));
            if (seen_ || zero != Vec3::Zero())
                mark = ZeroMark{zero, zero_axis_share * document_.part()->box.diagonal(), name};
        } catch (const Error& e) {
            shown.text = failure_text(e) + QChar('.');
        }
    }
    panel_->show_zero(shown);
    viewport_.scene().zero().set(mark);
    viewport_.refresh();
}

void PlaceController::change_zero(const std::function<void(ProgramSpec&)>& edit) {
    ProgramSpec after = document_.project().programs;
    edit(after);
    if (after == document_.project().programs) return show_zero();
    document_.change(tr("Set work zero"), [&](Project& p) { p.programs = after; });
}

void PlaceController::zero_at(const PartPick& pick) {
    if (!mesh()) return;
    const Vec3 at = snapped_point(viewport_, *mesh(), pick);
    leave();
    change_zero([&](ProgramSpec& spec) {
        spec.zero_from = ProgramSpec::ZeroFrom::origin;
        spec.zero = {at.x(), at.y(), at.z()};
    });
}

/// Looked for beside the window: of a large part it takes a while.
void PlaceController::take_hole(const PartPick& pick) {
    auto found = std::make_shared<RoundFace>();
    const std::string key = Document::part_key(document_.project());
    leave();
    hole_job_.start(
        tr("Looking for a hole"),
        [found, pick, part = document_.part()](const Progress& progress) {
            *found = round_face(*part->mesh, Index(pick.facet), pick.point, progress);
        },
        [this, found, key](const JobEnd& end) {
            if (end.how == JobEnd::How::cancelled || !mesh()
                || key != Document::part_key(document_.project()))
                return;
            if (!end.done()) return messages_.warning(sentence(end.message));
            const Vec3& at = found->center;
            change_zero([&](ProgramSpec& spec) {
                spec.zero_from = ProgramSpec::ZeroFrom::origin;
                spec.zero = {at.x(), at.y(), at.z()};
            });
            const LengthUnit unit = document_.unit();
            messages_.information(tr("The zero is on the axis of a %1 of Ø %2, which is round to %3.")
                                      .arg(found->hole ? tr("hole") : tr("boss"),
                                           shown_length(2 * found->radius, unit, 6),
                                           shown_length(std::max(found->uneven, told_uneven), unit, 2)));
        });
}

void PlaceController::find_faces() {
    if (!seen_ || !mesh()) {
        if (!listed_.empty()) {
            job_.cancel();
            listed_.clear();
            faces_.clear();
            panel_->fill({}, document_.unit(), {});
            show_chosen();
        }
        return;
    }
    const LyingOrder order = panel_->order();
    const std::string key = Document::part_key(document_.project())
                            + (order == LyingOrder::best ? "|best" : "|largest")
                            + std::string(unit_name(document_.unit()));
    if (key == listed_) return;
    listed_ = key;
    faces_.clear();
    panel_->fill({}, document_.unit(), tr("Looking for faces to lie on…"));
    show_chosen();
    auto found = std::make_shared<std::vector<LyingFace>>();
    job_.start(
        tr("Looking for faces to lie on"),
        [found, order, part = document_.part()](const Progress& progress) {
            *found = lying_faces(*part->mesh, order, progress);
        },
        [this, found, key](const JobEnd& end) {
            if (key != listed_ || end.how == JobEnd::How::cancelled) return;
            faces_ = *found;
            panel_->fill(faces_, document_.unit(),
                         end.done() ? tr("Click: shown in the view. Double click: laid on it.")
                                    : sentence(end.message));
        });
}

void PlaceController::show_chosen() {
    const auto i = panel_->chosen();
    const bool shown = i && *i < faces_.size();
    viewport_.scene().support().set(shown ? faces_[*i].outline : std::vector<Vec3>());
    if (shown) {
        Box3 box;
        for (const Vec3& p : faces_[*i].outline)
            box.add(p);
        const SceneCamera& camera = viewport_.scene().camera();
        visit_.to(camera.place_to_see(box.center(), faces_[*i].down, camera.place().height));
    }
    viewport_.refresh();
}

void PlaceController::lay_chosen() {
    const auto i = panel_->chosen();
    if (!i || *i >= faces_.size()) return;
    visit_.back();
    auto smaller = std::make_shared<double>(0);
    steps_->lay(
        tr("Lay part on face"),
        [smaller, turn = turn_to_lie(faces_[*i].down)](const Mesh& part, const Progress& progress) {
            *smaller = smaller_by_squaring(part, turn, progress);
            return turn;
        },
        [this, smaller] {
            if (*smaller < worth_squaring) return;
            square_said_ = tr("The part lies across its stock: squared up, the block about it is %1 % "
                              "smaller.")
                               .arg(number_text(100 * *smaller, 2));
            said_of_ = placement_of(document_.project().placed_part());
            messages_.information(square_said_);
            messages_.offer(
                {tr("Square up"), [this] { steps_->turn(tr("Square up part"), turn_to_square); }});
        });
}

void PlaceController::project_changed() {
    // Laid another way, by whatever, the part is no longer what was said of it.
    const bool moved = placement_of(document_.project().placed_part()) != said_of_;
    if (moved && !square_said_.isEmpty() && messages_.bar().message() == square_said_) messages_.dismiss();
    refresh();
}

void PlaceController::pick(PlacePick what) {
    if (what != PlacePick::none && !mesh()) what = PlacePick::none;
    panel_->show_picking(what);
    points_.clear();
    if (what == picking_) return;
    const PlacePick was = std::exchange(picking_, PlacePick::none);
    if (what == PlacePick::none) {
        if (was == PlacePick::none) return;
        viewport_.set_picking(false);
        messages_.dismiss();
        return;
    }
    emit picking_begun();
    picking_ = what;
    viewport_.set_picking(true);
    const QString wanted =
        what == PlacePick::hole
            ? tr("Click into a round hole, on a boss, or beside a hole on its flat face. Esc "
                 "leaves it.")
        : what == PlacePick::zero ? tr("Click a point of the part for the work zero; a corner nearby is "
                                       "taken exactly. Esc leaves it.")
        : what == PlacePick::face ? tr("Click the flat face that the part is to lie on. Esc leaves it.")
        : what == PlacePick::points
            ? tr("Click three points of the part, one after the other, that are to be "
                 "down; a corner nearby is taken exactly. Esc leaves it.")
            : tr("Click on the part beside the edge that is to run along X. Esc leaves it.");
    messages_.information(wanted);
}

bool PlaceController::take_key(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Escape) return false;
    if (gizmo_->dragging()) {
        gizmo_->cancel();
        return true;
    }
    if (picking_ == PlacePick::none) return false;
    leave();
    return true;
}

void PlaceController::take(const std::optional<PartPick>& pick) {
    if (picking_ == PlacePick::none) return;
    if (!pick || !mesh()) {
        messages_.information(tr("That is beside the part: click on it, or press Esc."));
        return;
    }
    try {
        if (picking_ == PlacePick::face)
            lay_on(*pick);
        else if (picking_ == PlacePick::points)
            take_point(*pick);
        else if (picking_ == PlacePick::zero)
            zero_at(*pick);
        else if (picking_ == PlacePick::hole)
            take_hole(*pick);
        else
            take_edge(*pick);
    } catch (const Error& e) {
        points_.clear();
        messages_.warning(failure_text(e) + QChar('.'));
    }
}

void PlaceController::lay_on(const PartPick& pick) {
    if (!mesh()) return;
    // What is seen of a sheet from behind is laid down as it is seen.
    const Vec3 down = pick.back_side ? Vec3(-pick.normal) : pick.normal;
    auto above = std::make_shared<double>(0);
    leave();
    steps_->lay(
        tr("Lay part on face"),
        [above, down, facet = pick.facet](const Mesh& part, const Progress&) {
            double lowest = -infinity;
            for (const Facet& f : part.facets)
                for (const Index v : f)
                    lowest = std::max(lowest, down.dot(part.vertices[v]));
            *above = lowest - down.dot(part.corner(facet, 0));
            return turn_to_lie(down);
        },
        [this, above, size = document_.part()->box.diagonal()] {
            // A face in a hollow, or between feet.
            if (*above > 1e-3 * size)
                messages_.information(tr("The face is level now and %1 above the table: something else of "
                                         "the part reaches lower.")
                                          .arg(shown_length(*above, document_.unit(), 4)));
        });
}

void PlaceController::take_point(const PartPick& pick) {
    points_.push_back(snapped_point(viewport_, *mesh(), pick));
    viewport_.scene().marks().set_marker(Marker{points_.back(), pick.normal});
    viewport_.refresh();
    if (points_.size() < 3) {
        messages_.information(tr("%1 of 3 points. Click the next one; Esc leaves it.").arg(points_.size()));
        return;
    }
    const std::vector<Vec3> points = std::exchange(points_, {});
    const Mat3 turn =
        turn_to_lie(down_through(points[0], points[1], points[2], document_.part()->box.center()));
    leave();
    steps_->lay(tr("Lay part on three points"), turn);
}

void PlaceController::take_edge(const PartPick& pick) {
    leave();
    steps_->lay(tr("Align edge with X"), [pick](const Mesh& part, const Progress&) -> std::optional<Mat3> {
        const auto outline = border_loops(part_of(part, flat_face(part, Index(pick.facet))).mesh);
        const auto side = nearest_side(outline, pick.point);
        if (!side) return std::nullopt;
        const std::vector<Vec3>& loop = outline[side->loop];
        return turn_along_x(loop[(side->corner + 1) % loop.size()] - loop[side->corner]);
    });
}

} // namespace facetmill::ui
