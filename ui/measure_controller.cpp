#include "ui/measure_controller.h"

#include "ui/messages.h"
#include "ui/point_picker.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/viewport.h"

#include <QEvent>
#include <QKeyEvent>
#include <QPainter>

#include <cmath>

namespace facetmill::ui {

/// Draws over the view, and lets every press through.
class MeasureOverlay : public QWidget {
public:
    explicit MeasureOverlay(Viewport& viewport) : QWidget(&viewport), viewport_(viewport) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setObjectName(QStringLiteral("measure_overlay"));
        viewport.installEventFilter(this);
        connect(&viewport, &Viewport::camera_changed, this, qOverload<>(&QWidget::update));
        hide();
    }
    void set(const std::vector<Vec3>& points, const QString& label) {
        points_ = points;
        label_ = label;
        setVisible(!points_.empty());
        setGeometry(viewport_.rect());
        update();
    }

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Resize) setGeometry(viewport_.rect());
        return false;
    }
    void paintEvent(QPaintEvent*) override {
        QPainter p(this);
        p.setRenderHint(QPainter::Antialiasing);
        const QColor line = palette().color(QPalette::Highlight), ground = palette().color(QPalette::Window);
        std::vector<QPointF> at;
        for (const Vec3& point : points_) {
            const Vec2 pixel = viewport_.scene().camera().display_of(point);
            at.push_back(QPointF(pixel.x(), pixel.y()) / viewport_.devicePixelRatioF());
        }
        if (at.size() == 2) {
            p.setPen(QPen(ground, 5));
            p.drawLine(at[0], at[1]);
            p.setPen(QPen(line, 2));
            p.drawLine(at[0], at[1]);
        }
        p.setPen(QPen(ground, 1.5));
        p.setBrush(line);
        for (const QPointF& place : at)
            p.drawEllipse(place, dot, dot);
        if (at.size() == 2) draw_label(p, (at[0] + at[1]) / 2);
    }

private:
    static constexpr double dot = 4.5, margin = 5;

    /// Beside the middle of the line, inside the view.
    void draw_label(QPainter& p, const QPointF& middle) const {
        QRectF box = QFontMetricsF(font()).boundingRect(label_).adjusted(-margin, -margin, margin, margin);
        box.moveCenter(middle - QPointF(0, box.height()));
        box.moveLeft(std::clamp(box.left(), 0.0, std::max(0.0, width() - box.width())));
        box.moveTop(std::clamp(box.top(), 0.0, std::max(0.0, height() - box.height())));
        p.setPen(palette().color(QPalette::Mid));
        p.setBrush(palette().color(QPalette::Window));
        p.drawRoundedRect(box, 3, 3);
        p.setPen(palette().color(QPalette::WindowText));
        p.drawText(box, int(Qt::AlignCenter), label_);
    }

    Viewport& viewport_;
    std::vector<Vec3> points_;
    QString label_;
};

QString measurement_text(const Measurement& m, LengthUnit unit) {
    const Vec3 by = m.to - m.from;
    const auto length = [&](double mm) { return shown_length(mm, unit); };
    return MeasureController::tr("Distance %1, X %2, Y %3, Z %4; faces at %5°")
        .arg(length(by.norm()), length(std::abs(by.x())), length(std::abs(by.y())), length(std::abs(by.z())),
             number_text(degrees(m.angle), 4));
}

MeasureController::MeasureController(Document& document, Viewport& viewport, Messages& messages,
                                     QObject* window)
    : Controller(window), document_(document), viewport_(viewport), messages_(messages),
      overlay_(new MeasureOverlay(viewport)) {
    connect(&viewport_, &Viewport::point_picked, this, [this](const std::optional<PartPick>& pick) {
        if (active_ && pick && document_.part_is_current()) take(*pick);
    });
}

MeasureController::~MeasureController() = default;

void MeasureController::set_active(bool on) {
    if (on == active_ || (on && !document_.part())) return;
    if (on) emit measuring_begun();
    active_ = on;
    viewport_.set_picking(on);
    clear();
    if (on)
        messages_.show(
            tr("Click two points of the part; corners nearby are taken exactly. Esc ends measuring."));
    else
        messages_.dismiss();
    emit switched();
}

void MeasureController::clear() {
    points_.clear();
    normals_.clear();
    overlay_->set({}, {});
}

void MeasureController::take(const PartPick& pick) {
    if (points_.size() == 2) clear();
    points_.push_back(snapped_point(viewport_, *document_.part()->mesh, pick));
    normals_.push_back(pick.back_side ? Vec3(-pick.normal) : pick.normal);
    show();
    if (const auto m = measured()) messages_.show(measurement_text(*m, document_.unit()) + QChar('.'));
}

void MeasureController::show() {
    const auto m = measured();
    overlay_->set(points_, m ? shown_length((m->to - m->from).norm(), document_.unit()) : QString());
}

std::optional<Measurement> MeasureController::measured() const {
    if (points_.size() < 2) return std::nullopt;
    return Measurement{points_[0], points_[1],
                       std::atan2(normals_[0].cross(normals_[1]).norm(), normals_[0].dot(normals_[1]))};
}

bool MeasureController::take_key(const QKeyEvent& event) {
    if (!active_ || event.key() != Qt::Key_Escape) return false;
    set_active(false);
    return true;
}

} // namespace facetmill::ui
