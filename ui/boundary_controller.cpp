#include "ui/boundary_controller.h"

#include "core/base/usual_value.h"
#include "core/job/bounds.h"
#include "ui/boundary_list.h"
#include "ui/messages.h"
#include "ui/text.h"
#include "ui/viewport.h"

#include <QKeyEvent>

#include <algorithm>
#include <utility>

namespace facetmill::ui {

namespace {

/// Of the brush to begin with, as a share of the part's size.
constexpr double first_radius_share = 0.03;

/// They have the same facets and the same curve.
bool same_region(const Boundary& a, const Boundary& b) {
    return a.kind == b.kind && a.invert == b.invert && a.facets == b.facets && a.of_facets == b.of_facets
           && a.faces == b.faces && a.slope == b.slope && a.curve == b.curve && a.offset == b.offset
           && a.tool == b.tool && a.more_than == b.more_than;
}

/// Of the part's size, as a share: facets that are divided to be drawn within a boundary are no longer there.
constexpr double longest_share = 0.01;

std::vector<Vec3> corners_of(const Boundary& boundary) {
    std::vector<Vec3> corners;
    for (const CurveCorner& c : boundary.curve)
        corners.emplace_back(c.at[0], c.at[1], c.at[2]);
    return corners;
}

std::vector<char> facets_or_none(const Boundary& boundary, const PreparedPart& part) {
    try {
        return boundary_facets(with_facets_of_faces(boundary, part), *part.mesh);
    } catch (const Error&) {
        return {}; // the form says why
    }
}

std::optional<AptCutter> cutter_or_none(const Project& project, const Boundary& boundary) {
    try {
        return project.cutter_of(boundary);
    } catch (const Error&) {
        return std::nullopt; // the form says why
    }
}

} // namespace

BoundaryController::BoundaryController(Document& document, Viewport& viewport, BoundaryBox& box,
                                       Messages& messages, QObject* window)
    : Controller(window), document_(document), viewport_(viewport), box_(box), messages_(messages),
      facets_(viewport, this), curve_(viewport, this) {
    connect(&box_, &BoundaryBox::activated, this, [this](bool on) {
        if (on)
            begin();
        else
            end();
    });
    connect(&box_, &BoundaryBox::settings_changed, this, [this] {
        facets_.settings() = box_.settings();
        viewport_.update();
    });
    connect(&box_, &BoundaryBox::change_wanted, this, &BoundaryController::change);
    connect(&facets_, &FacetTool::painted, this, [this](const std::vector<Index>& facets, bool in) {
        viewport_.scene().boundaries().paint(facets, in != inverted_);
        viewport_.refresh_painted();
    });
    connect(&facets_, &FacetTool::stroke_ended, this, &BoundaryController::store_stroke);
    connect(&curve_, &CurveTool::changed, this, &BoundaryController::curve_changed);
    connect(&curve_, &CurveTool::ended, this, &BoundaryController::store_curve);
    connect(&curve_, &CurveTool::refused, this, [this] {
        messages_.information(tr("A closed curve has three corners or more: click on the part."));
    });
    connect(&facets_, &FacetTool::settled, this, [this] { emit settled(); });
    connect(&job_, &BackgroundJob::ended, this, [this] { emit settled(); });
}

BoundaryController::~BoundaryController() = default;

const Boundary* BoundaryController::chosen() const {
    if (!node_ || node_->kind != TreeNode::Kind::boundary || !document_.part_is_current()
        || node_->index >= document_.project().boundaries.size())
        return nullptr;
    return &document_.project().boundaries[node_->index];
}

void BoundaryController::begin() {
    const Boundary* boundary = chosen();
    if (!boundary) return box_.set_active(false);
    emit painting_begun();
    if (boundary->kind == Boundary::Kind::curve) {
        curve_.begin(corners_of(*boundary));
        viewport_.set_tool(&curve_);
        return;
    }
    inverted_ = boundary->invert;
    const MeshPtr& part = document_.part()->mesh;
    if (!painter_ || painter_->mesh() != part) painter_ = std::make_shared<FacetPainter>(part, Progress());
    facets_.settings() = box_.settings();
    Boundary painted = *boundary;
    painted.invert = false;
    std::vector<char> marks = facets_or_none(painted, *document_.part());
    if (marks.empty()) { // what does not fit is painted anew
        marks.resize(part->facet_count(), 0);
        viewport_.scene().boundaries().set(BoundaryRole::within,
                                           std::vector<char>(marks.size(), boundary->invert));
    }
    facets_.begin(painter_, std::move(marks));
    viewport_.set_tool(&facets_);
}

void BoundaryController::end() {
    facets_.end();
    if (!viewport_.tool()) return;
    viewport_.set_tool(nullptr);
    messages_.dismiss();
    show();
}

void BoundaryController::leave() {
    box_.set_active(false);
}

void BoundaryController::project_opened() {
    leave();
    node_.reset();
    painter_ = nullptr;
    sized_ = false;
    show();
}

void BoundaryController::part_changed() {
    if (painter_ && (!document_.part() || painter_->mesh() != document_.part()->mesh)) {
        leave();
        painter_ = nullptr;
    }
    show();
}

void BoundaryController::project_changed() {
    const Boundary* boundary = chosen();
    const bool of_kind =
        boundary && (boundary->kind == Boundary::Kind::facets || boundary->kind == Boundary::Kind::curve);
    if (!of_kind) leave();
    if (box_.active() && !storing_) begin(); // undone, redone, or changed as a whole
    show();
}

void BoundaryController::node_chosen(const std::optional<TreeNode>& node) {
    if (node != node_) leave();
    node_ = node;
    const Boundary* boundary = chosen();
    if (boundary && !std::exchange(sized_, true)) {
        const double per = mm_per(document_.unit()), size = document_.part()->box.diagonal() / per;
        box_.set_radius(round_to_digit(first_radius_share * size) * per);
    }
    show();
}

void BoundaryController::show() {
    const Boundary *within = chosen(), *avoided = nullptr;
    const auto named = [&](const std::string& name) -> const Boundary* {
        for (const Boundary& b : document_.project().boundaries)
            if (b.name == name) return &b;
        return nullptr;
    };
    if (node_ && node_->kind == TreeNode::Kind::operation && document_.part_is_current()
        && node_->index < document_.operation_count()) {
        const OperationCommon& common = document_.operation(node_->index).common();
        within = named(common.boundary);
        avoided = named(common.avoid);
    }
    SceneBoundaries& scene = viewport_.scene().boundaries();
    if (const bool alone = chosen() != nullptr; alone != scene.foremost()) {
        scene.set_foremost(alone);
        viewport_.refresh();
    }
    show_role(BoundaryRole::within, within);
    show_role(BoundaryRole::avoided, avoided);
    if (std::any_of(wanted_.begin(), wanted_.end(), [](bool w) { return w; })) start_job();
}

void BoundaryController::show_role(BoundaryRole role, const Boundary* boundary) {
    Shown& shown = shown_[std::size_t(role)];
    const PartDisplayPtr part = viewport_.scene().part().display();
    if (!part || !document_.part() || part->mesh != document_.part()->mesh) boundary = nullptr;
    const auto cutter = boundary ? cutter_or_none(document_.project(), *boundary) : std::nullopt;
    const bool same = boundary ? shown.boundary && shown.part == part && shown.cutter == cutter
                                     && same_region(*shown.boundary, *boundary)
                               : !shown.boundary;
    if (same) return;
    wanted_[std::size_t(role)] = false;
    shown.boundary = boundary ? std::optional(*boundary) : std::nullopt;
    shown.part = part;
    shown.cutter = cutter;
    SceneBoundaries& scene = viewport_.scene().boundaries();
    show_curve(role, boundary);
    if (!boundary)
        scene.set(role, {});
    else if (!is_looked_at_along_z(boundary->kind))
        scene.set(role, facets_or_none(*boundary, *document_.part()));
    else
        wanted_[std::size_t(role)] = true;
    viewport_.refresh();
}

void BoundaryController::show_curve(BoundaryRole role, const Boundary* boundary) {
    const bool curve = boundary && boundary->kind == Boundary::Kind::curve;
    viewport_.scene().boundaries().set_curve(role, curve ? corners_of(*boundary) : std::vector<Vec3>(), true);
}

void BoundaryController::start_job() {
    struct Outcome {
        std::array<std::vector<char>, 2> marks;
        std::array<PartDisplayPtr, 2> areas;
        std::array<QString, 2> failures;
    };
    auto outcome = std::make_shared<Outcome>();
    const auto wanted = wanted_;
    const auto shown = shown_;
    job_.start(
        tr("Finding what lies in a boundary"),
        [outcome, wanted, shown](const Progress& progress) {
            for (std::size_t i = 0; i < wanted.size(); ++i) {
                if (!wanted[i]) continue;
                try {
                    const MeshPtr& part = shown[i].part->mesh;
                    const BoundaryRegion region(*shown[i].boundary, part, progress.part(0, 0.6),
                                                shown[i].cutter);
                    const double longest = longest_share * shown[i].part->box.diagonal();
                    outcome->marks[i] = region.facets();
                    outcome->areas[i] = prepare_part_display(
                        region.surface(0, longest, progress.part(0.6, 0.9)), progress.part(0.9, 1));
                } catch (const Error& e) {
                    outcome->marks[i].clear();
                    outcome->failures[i] = failure_text(e);
                }
            }
        },
        [this, outcome, wanted, shown](const JobEnd& end) {
            if (!end.done()) return;
            for (std::size_t i = 0; i < wanted.size(); ++i) {
                const bool fits = wanted[i] && wanted_[i] && shown_[i].part == shown[i].part
                                  && shown_[i].cutter == shown[i].cutter
                                  && same_region(*shown_[i].boundary, *shown[i].boundary);
                if (!fits) continue;
                wanted_[i] = false;
                viewport_.scene().boundaries().set(BoundaryRole(i), std::move(outcome->marks[i]),
                                                   std::move(outcome->areas[i]));
                if (!outcome->failures[i].isEmpty() && chosen()) messages_.warning(outcome->failures[i]);
            }
            viewport_.refresh();
        });
}

void BoundaryController::change(BoundaryBox::Change change) {
    const Boundary* boundary = chosen();
    if (!boundary || boundary->kind != Boundary::Kind::facets) return;
    const Mesh& part = *document_.part()->mesh;
    Boundary painted = *boundary;
    painted.invert = false;
    std::vector<char> marks = facets_or_none(painted, *document_.part());
    marks.resize(part.facet_count(), 0);
    QString what;
    switch (change) {
    case BoundaryBox::Change::invert:
        what = tr("Invert painted facets");
        for (char& m : marks)
            m = !m;
        break;
    case BoundaryBox::Change::clear:
        what = tr("Clear painted facets");
        std::fill(marks.begin(), marks.end(), 0);
        break;
    case BoundaryBox::Change::grow:
    case BoundaryBox::Change::shrink: {
        const bool grow = change == BoundaryBox::Change::grow;
        what = grow ? tr("Grow painted facets") : tr("Shrink painted facets");
        for (const Index f : ring_round(part, marks, grow, box_.distance(), {}))
            marks[f] = grow;
        break;
    }
    }
    tell_kept(set_boundary_facets(document_, node_->index, marks, what));
}

void BoundaryController::store_stroke() {
    if (!chosen()) return;
    // The view shows it already.
    const std::vector<char>& marks = facets_.marks();
    viewport_.keep_picture();
    std::optional<Boundary>& shown = shown_[std::size_t(BoundaryRole::within)].boundary;
    if (shown) {
        std::vector<Index> numbers;
        for (std::size_t f = 0; f < marks.size(); ++f)
            if (marks[f]) numbers.push_back(Index(f));
        shown->facets = facet_ranges_text(numbers);
        shown->of_facets = long(marks.size());
    }
    storing_ = true;
    tell_kept(set_boundary_facets(document_, node_->index, marks, tr("Paint facets")));
    storing_ = false;
}

void BoundaryController::tell_kept(bool kept) {
    if (!kept) return;
    emit said(
        MessageBar::Kind::information,
        tr("The part's chord tolerance is fixed from now on: with another one the painted facets would be "
           "others. A boundary of faces stays without that."),
        true);
}

void BoundaryController::curve_changed() {
    viewport_.scene().boundaries().set_curve(BoundaryRole::within, curve_.corners(), !curve_.drawing());
    viewport_.refresh();
}

void BoundaryController::store_curve() {
    if (!chosen()) return;
    messages_.dismiss();
    std::vector<CurveCorner> curve;
    for (const Vec3& c : curve_.corners())
        curve.push_back({{c.x(), c.y(), c.z()}});
    set_boundary_curve(document_, node_->index, curve, tr("Draw curve"));
}

bool BoundaryController::take_key(const QKeyEvent& event) {
    if (!box_.active()) return false;
    if (event.key() == Qt::Key_Escape) {
        if (curve_.drawing()) {
            // What was drawn before stays.
            const Boundary* boundary = chosen();
            curve_.begin(boundary ? corners_of(*boundary) : std::vector<Vec3>());
            curve_changed();
        }
        leave();
        return true;
    }
    if (!curve_.drawing()) return false;
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
        curve_.close();
    else if (event.key() == Qt::Key_Backspace)
        curve_.take_back();
    else
        return false;
    return true;
}

} // namespace facetmill::ui
