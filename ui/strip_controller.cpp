#include "ui/strip_controller.h"

#include "ui/camera_flight.h"
#include "ui/elided_label.h"
#include "ui/shown_paths.h"
#include "ui/strip_panel.h"
#include "ui/text.h"
#include "ui/viewport.h"
#include "ui/worded.h"
#include "viz/strip_display.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QTreeWidget>

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

namespace facetmill::ui {

namespace {

/// What the view shows around a strip: this share of its size, and at least this share of the part's.
constexpr double strip_room = 1.3, part_room = 0.15;

} // namespace

StripController::StripController(Document& document, Viewport& viewport, QWidget* window)
    : Controller(window), document_(document), viewport_(viewport), panel_(new StripPanel(window)),
      flight_(new CameraFlight(viewport)) {
    QTreeWidget* list = panel_->list();
    connect(list, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        if (column == StripPanel::name_column) switch_strip(*item);
    });
    connect(list, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        choose(item ? std::optional(StripPanel::strip_of(*item)) : std::nullopt, true);
    });
    connect(panel_->operation_box(), &QComboBox::currentIndexChanged, this, &StripController::refresh);
    connect(panel_->touch_box(), &QCheckBox::toggled, this, &StripController::take_tool);
    connect(panel_->place(), &QSlider::valueChanged, this, &StripController::take_tool);
    connect(&job_, &BackgroundJob::ended, this, [this](const JobEnd& end) {
        if (end.how == JobEnd::How::failed) emit failed(end.message);
        emit settled();
    });
    refresh();
}

StripController::~StripController() = default;

bool StripController::busy() const {
    return job_.running() || flight_->flying();
}

void StripController::paths_shown(const ShownPaths& paths) {
    results_ = paths.programs();
    ids_ = paths.ids();
    sources_.clear();
    {
        QComboBox* box = panel_->operation_box();
        const QSignalBlocker quiet(box);
        const QString was = box->currentText();
        box->clear();
        for (std::size_t i = 0; i < results_.size(); ++i) {
            if (!results_[i]->path.as<CleanupPath>()) continue;
            sources_.push_back(i);
            box->addItem(elided(text(results_[i]->name), 40));
        }
        box->setCurrentIndex(std::max(sources_.empty() ? -1 : 0, box->findText(was)));
        box->setVisible(sources_.size() > 1);
    }
    tool_left_ = false;
    refresh();
    if (!sources_.empty()) offer();
}

std::optional<std::size_t> StripController::source() const {
    const auto at = std::size_t(std::max(0, panel_->operation_box()->currentIndex()));
    if (at >= sources_.size()) return std::nullopt;
    return sources_[at];
}

const OperationResult* StripController::result() const {
    const auto at = source();
    return at ? results_[*at].get() : nullptr;
}

std::optional<std::string> StripController::switched_off() const {
    const auto at = source();
    const auto index = at ? document_.index_of(ids_[*at]) : std::nullopt;
    if (!index || !document_.operation(*index).has(switched_off_key)) return std::nullopt;
    return std::get<std::string>(document_.operation(*index).get(switched_off_key));
}

/// Why there is no strip to be listed.
QString StripController::empty_reason() const {
    for (std::size_t i = 0; i < document_.operation_count(); ++i) {
        const Operation& operation = document_.operation(i);
        if (!operation.has(switched_off_key)) continue;
        if (document_.state(i) == OperationState::failed)
            return with_lengths_in(sentence(document_.failure(i)), document_.unit());
        if (const auto planned = document_.result(i); planned && !planned->nothing_to_do.empty())
            return with_lengths_in(sentence(worded(planned->nothing_to_do)), document_.unit());
        return tr("Plan “%1” to see its strips here").arg(text(operation.common().name));
    }
    return tr("Strips of clean-up come here: add a clean-up operation and plan it");
}

/// Everything that the list, its states and the view show, as far as it changed.
void StripController::refresh() {
    const OperationResult* now = result();
    panel_->set_empty_text(now ? QString() : empty_reason());
    if (now != listed_ || listed_unit_ != document_.unit()) {
        // A plan made anew has the same strips under the same names, but for what was changed.
        const std::optional<std::size_t> was = chosen_;
        std::string name;
        if (was && listed_name_.size() > *was) name = listed_name_[*was];
        listed_ = now;
        listed_unit_ = document_.unit();
        listed_name_.clear();
        const std::vector<Strip> strips = now ? now->path.strips : std::vector<Strip>();
        for (const Strip& s : strips)
            listed_name_.push_back(s.name);
        panel_->fill(strips, listed_unit_, viewport_.scene().palette());
        std::optional<std::size_t> again;
        for (std::size_t i = 0; i < listed_name_.size(); ++i)
            if (!name.empty() && listed_name_[i] == name) again = i;
        chosen_.reset();
        choose(again, false);
    }
    show_states();
    show_strips();
    show_touch();
}

/// Check marks and colours as the operation's settings stand now, planned with them or not.
void StripController::show_states() {
    const std::optional<std::string> off = switched_off();
    if (!listed_ || !off) {
        panel_->note()->hide();
        return;
    }
    std::vector<bool> cut;
    for (const std::string& name : listed_name_)
        cut.push_back(!is_switched_off(*off, name));
    panel_->show_states(cut, viewport_.scene().palette());
    const auto on = std::size_t(std::count(cut.begin(), cut.end(), true)), n = cut.size();
    QString note =
        on == n ? tr("%1 strips, all of them cut").arg(n) : tr("%1 of %2 strips cut").arg(on).arg(n);
    if (n == 1) note = on == 1 ? tr("1 strip, cut") : tr("1 strip, switched off");
    const auto index = document_.index_of(ids_[*source()]);
    if (index && document_.state(*index) == OperationState::stale)
        note += tr("; the path is out of date: plan again");
    panel_->note()->set_text(note);
    panel_->note()->show();
}

/// The check mark was changed by hand.
void StripController::switch_strip(const QTreeWidgetItem& item) {
    const std::optional<std::string> off = switched_off();
    const std::size_t i = StripPanel::strip_of(item);
    if (!off || i >= listed_name_.size()) return;
    const std::string name = listed_name_[i];
    const bool on = item.checkState(StripPanel::name_column) == Qt::Checked;
    if (on == !is_switched_off(*off, name)) return;
    const std::string list = with_switched(*off, name, on);
    const std::size_t index = *document_.index_of(ids_[*source()]);
    document_.change((on ? tr("Switch %1 on") : tr("Switch %1 off")).arg(text(name)),
                     [index, list](Project& p) { p.operations[index]->set(switched_off_key, list); });
}

void StripController::panel_seen(bool) {
    // Later: a dock says that it is hidden before what is in it is.
    QMetaObject::invokeMethod(
        this,
        [this] {
            show_strips();
            take_tool();
        },
        Qt::QueuedConnection);
}

/// In the view while the list is seen, in the states of the settings.
void StripController::show_strips() {
    const std::optional<std::string> off = switched_off();
    const bool wanted = listed_ && off && panel_->isVisible();
    if (!wanted) {
        job_.cancel();
        wanted_.clear();
        if (shown_) {
            shown_ = nullptr;
            viewport_.scene().strips().set(nullptr);
            viewport_.refresh();
            emit strips_shown(false);
        }
        return;
    }
    const LengthUnit unit = document_.unit();
    const std::string key =
        *off + '\n' + std::string(unit_name(unit)) + '\n' + std::to_string(std::uintptr_t(listed_));
    if (key == wanted_) return;
    wanted_ = key;
    auto display = std::make_shared<StripDisplayPtr>();
    job_.start(
        tr("Drawing the strips"),
        [display, unit, off = *off, result = results_[*source()]](const Progress& p) {
            std::vector<Strip> strips = result->path.strips;
            for (Strip& s : strips)
                s.enabled = !is_switched_off(off, s.name);
            *display = prepare_strip_display(strips, unit, p);
        },
        [this, display, key](const JobEnd& end) {
            if (!end.done() || key != wanted_) return;
            shown_ = *display;
            emit strips_shown(true);
            show_again();
        });
}

void StripController::show_again() {
    if (!shown_) return;
    viewport_.scene().strips().set(shown_);
    viewport_.scene().strips().choose(chosen_);
    viewport_.refresh();
}

void StripController::choose(std::optional<std::size_t> strip, bool fly) {
    if (strip && (!listed_ || *strip >= listed_->path.strips.size())) strip.reset();
    chosen_ = strip;
    QTreeWidget* list = panel_->list();
    {
        const QSignalBlocker quiet(list);
        QTreeWidgetItem* item = strip ? panel_->item_of(*strip) : nullptr;
        list->setCurrentItem(item);
        if (item) list->scrollToItem(item);
    }
    viewport_.scene().strips().choose(strip);
    QSlider* place = panel_->place();
    {
        const QSignalBlocker quiet(place);
        const auto touches = strip && listed_ ? listed_->path.as<CleanupPath>()->record->of(*strip)
                                              : std::span<const CleanupRecord::Touch>();
        place->setRange(0, std::max(0, int(touches.size()) - 1));
        place->setValue(int(touches.size() / 2));
        place->setPageStep(std::max(1, int(touches.size() / 20)));
        place->setEnabled(touches.size() > 1);
    }
    if (fly && strip && panel_->isVisible()) show_place();
    take_tool();
    viewport_.refresh();
}

/// The view goes to the chosen strip.
void StripController::show_place() {
    const Strip& strip = listed_->path.strips[*chosen_];
    Box3 box;
    Vec3 normal = Vec3::Zero();
    for (const auto& [a, b, c] : strip.band) {
        for (const Vec3* p : {&a, &b, &c})
            box.add(*p);
        normal += (b - a).cross(c - a);
    }
    if (box.empty()) return;
    normal = normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3::UnitZ();
    const double across = document_.part() ? document_.part()->box.diagonal() : box.diagonal();
    flight_->fly_to(viewport_.scene().camera().place_to_see(
        box.center(), normal, std::max(strip_room * box.diagonal(), part_room * across)));
}

bool StripController::take_path_pick(const ShownPaths& paths, const PathPick& pick) {
    if (!listed_ || !panel_->isVisible() || !panel_->touch_box()->isChecked()) return false;
    const CutterContact* contact = paths.contact_of(pick);
    return contact && this->pick(contact->point);
}

bool StripController::pick(const Vec3& place) {
    if (!listed_ || !panel_->isVisible() || !document_.part()) return false;
    std::vector<const Strip*> strips;
    for (const Strip& strip : listed_->path.strips)
        strips.push_back(&strip);
    const auto nearest = strip_at(place, strips, document_.part()->box.diagonal());
    if (!nearest) return false;
    choose(nearest, false);
    const auto touches = listed_->path.as<CleanupPath>()->record->of(*nearest);
    const auto at = std::min_element(touches.begin(), touches.end(), [&](const auto& a, const auto& b) {
        return (a.center - place).squaredNorm() < (b.center - place).squaredNorm();
    });
    if (at != touches.end()) panel_->place()->setValue(int(at - touches.begin()));
    return true;
}

void StripController::take_tool() {
    tool_left_ = false;
    show_touch();
}

void StripController::leave_tool() {
    tool_left_ = true;
    touch_shown_ = false;
}

void StripController::palette_changed(Palette) {
    show_states();
}

/// The previous tool at the chosen place, in the view and in words.
void StripController::show_touch() {
    QString words;
    const CleanupRecord::Touch* touch = nullptr;
    if (listed_ && chosen_) {
        const CleanupRecord& record = *listed_->path.as<CleanupPath>()->record;
        const auto touches = record.of(*chosen_);
        const Strip& strip = listed_->path.strips[*chosen_];
        if (!touches.empty()) {
            touch = &touches[std::min(std::size_t(panel_->place()->value()), touches.size() - 1)];
            const LengthUnit unit = document_.unit();
            const auto place = [&](const Vec3& v) {
                const int digits = unit == LengthUnit::inch ? 4 : 3;
                const auto number = [&](double mm) {
                    return in_user_numbers(QString::number(mm / mm_per(unit), 'f', digits));
                };
                return QChar('(') + number_list({number(v.x()), number(v.y()), number(v.z())}) + QChar(')');
            };
            words = tr("Tool %1 touches at %2 and %3 %4; it stays %5 above the bottom.")
                        .arg(record.previous.number)
                        .arg(place(touch->touch[0]), place(touch->touch[1]), text(unit_name(unit)),
                             shown_length(touch->gap, unit, 4));
        } else if (strip.kind == StripKind::sharp) {
            words = tr("Tool %1 fits into it: its normals turn faster than the limit.")
                        .arg(record.previous.number);
        } else {
            words = tr("Tool %1 does not touch at two places along it.").arg(record.previous.number);
        }
    } else if (listed_) {
        words = tr("Click on a strip, here or in the view.");
    }
    panel_->readout()->setText(kept_together(words));
    const bool wanted = touch && panel_->isVisible() && panel_->touch_box()->isChecked() && !tool_left_;
    if (wanted) {
        touch_shown_ = true;
        emit touch_wanted(listed_->path.as<CleanupPath>()->record->previous, *touch);
    } else if (std::exchange(touch_shown_, false)) {
        emit touch_gone();
    }
}

} // namespace facetmill::ui
