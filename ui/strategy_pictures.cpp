#include "ui/strategy_pictures.h"

#include "core/job/new_operation.h"
#include "core/job/preview_job.h"
#include "ui/operation_menu.h"
#include "ui/theme.h"

#include <QMenu>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

/// As wide and high as the drawings that they stand for, in pixels of a fine screen.
constexpr int picture_pixels = 240;
constexpr double picture_share = 130.0 / 240.0;
/// The part as so many patches along its longer side; so many passes can be told apart.
constexpr int patches = 56, told_apart = 16;

/// From above one corner, the eye looking down at about 40 degrees.
Vec2 seen(const Vec3& p) {
    constexpr double across = 0.82, back = 0.34, up = 0.72;
    return {across * (p.x() - 0.55 * p.y()), -back * (p.y() + 0.55 * p.x()) - up * p.z()};
}

class PictureFrame {
public:
    PictureFrame(const Box3& box, const QSize& size) {
        Vec2 lo = Vec2::Constant(infinity), hi = Vec2::Constant(-infinity);
        for (int k = 0; k < 8; ++k) {
            const Vec2 p = seen({k & 1 ? box.hi.x() : box.lo.x(), k & 2 ? box.hi.y() : box.lo.y(),
                                 k & 4 ? box.hi.z() : box.lo.z()});
            lo = lo.cwiseMin(p);
            hi = hi.cwiseMax(p);
        }
        constexpr double frame_margin = 4;
        const Vec2 extent = (hi - lo).cwiseMax(Vec2::Constant(1e-9));
        scale_ = std::min((size.width() - 2 * frame_margin) / extent.x(),
                          (size.height() - 2 * frame_margin) / extent.y());
        middle_ = 0.5 * (lo + hi);
        center_ = QPointF(0.5 * size.width(), 0.5 * size.height());
    }
    QPointF at(const Vec3& p) const {
        const Vec2 q = scale_ * (seen(p) - middle_);
        return center_ + QPointF(q.x(), q.y());
    }

private:
    double scale_ = 1;
    Vec2 middle_;
    QPointF center_;
};

void paint_ground(QPainter& painter, const PictureFrame& frame, const CoarseGround& ground,
                  const QColor& color, const Progress& progress) {
    const CoarseGrid& grid = ground.grid();
    const int by = std::max(1, (std::max(grid.columns, grid.rows) + patches - 1) / patches);
    const auto corner = [&](int x, int y) {
        const int cx = std::min(x, grid.columns - 1), cy = std::min(y, grid.rows - 1);
        const Vec2 p = grid.middle(cx, cy);
        const float h = ground.height()[grid.index(cx, cy)];
        return std::pair(Vec3(p.x(), p.y(), double(h)), is_there(h) && ground.on_part(grid.index(cx, cy)));
    };
    painter.setPen(Qt::NoPen);
    // What lies behind goes first.
    for (int y = (grid.rows - 1) / by * by; y >= 0; y -= by) {
        progress.check();
        for (int x = (grid.columns - 1) / by * by; x >= 0; x -= by) {
            const auto [a, has_a] = corner(x, y);
            const auto [b, has_b] = corner(x + by, y);
            const auto [c, has_c] = corner(x + by, y + by);
            const auto [d, has_d] = corner(x, y + by);
            if (!has_a || !has_b || !has_c || !has_d) continue;
            const Vec3 normal = (c - a).cross(d - b).normalized();
            const double light = std::max(0.0, normal.dot(Vec3(-0.35, -0.45, 0.82).normalized()));
            const QColor shade = color.darker(int(100 / std::clamp(0.45 + 0.62 * light, 0.3, 1.1)));
            painter.setBrush(shade);
            painter.drawPolygon(QPolygonF({frame.at(a), frame.at(b), frame.at(c), frame.at(d)}));
        }
    }
}

} // namespace

QImage strategy_picture(const CoarseGround& ground, const PassPreview& preview, Palette palette, int width,
                        const Progress& progress) {
    QImage picture(width, int(std::lround(width * picture_share)), QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    const CoarseGrid& grid = ground.grid();
    Box3 box;
    const Vec2 low = grid.middle(0, 0), high = grid.middle(grid.columns - 1, grid.rows - 1);
    box.add(Vec3(low.x(), low.y(), ground.bottom()));
    box.add(Vec3(high.x(), high.y(), ground.top()));
    for (const auto& line : preview.lines)
        for (const Vec3& p : line)
            box.add(p);
    const PictureFrame frame(box, picture.size());
    const Colors& colors = colors_of(palette);
    QPainter painter(&picture);
    // Neighbouring patches meet without a seam.
    painter.setRenderHint(QPainter::Antialiasing, false);
    paint_ground(painter, frame, ground, to_qt(colors.part), progress);
    painter.setRenderHint(QPainter::Antialiasing, true);
    painter.setPen(QPen(to_qt(colors.preview), std::max(1.0, width / 110.0)));
    const std::size_t every = std::max<std::size_t>(
        1, (preview.passes / std::max<std::size_t>(preview.drawn_every, 1)) / told_apart);
    for (std::size_t i = 0; i < preview.lines.size(); i += every) {
        progress.check();
        QPainterPath path(frame.at(preview.lines[i].front()));
        for (const Vec3& p : preview.lines[i])
            path.lineTo(frame.at(p));
        painter.drawPath(path);
    }
    return picture;
}

StrategyPictures::StrategyPictures(Document& document, const std::vector<QMenu*>& menus, QWidget* window)
    : Controller(window), document_(document), menus_(menus), previewer_(std::make_shared<PassPreviewer>()) {
    for (QMenu* menu : menus_)
        connect(menu, &QMenu::aboutToShow, this, &StrategyPictures::draw);
    connect(&job_, &BackgroundJob::ended, this, &StrategyPictures::settled);
}

StrategyPictures::~StrategyPictures() = default;

void StrategyPictures::palette_changed(Palette palette) {
    palette_ = palette;
    forget();
}

void StrategyPictures::forget() {
    job_.cancel();
    fingerprint_.clear();
    for (const std::string& kind : drawn_)
        set_icon(kind, operation_picture(kind));
    drawn_.clear();
}

void StrategyPictures::draw() {
    if (!document_.part_is_current() || !document_.has_stock()) return;
    // What a new operation begins with depends on the tools and the operations that there are.
    const std::string fingerprint = project_to_json(document_.project());
    if (fingerprint == fingerprint_) return;
    fingerprint_ = fingerprint;
    job_.start(tr("Drawing operations"), [this, fingerprint, palette = palette_, previewer = previewer_,
                                          project = document_.project(),
                                          part = document_.part()](const Progress& progress) {
        const auto& kinds = operation_kinds();
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            const Progress own =
                progress.part(double(k) / double(kinds.size()), double(k + 1) / double(kinds.size()));
            try {
                Project with = project;
                NewOperation made = new_operation(kinds[k].kind, with);
                if (made.tool) with.tools.push_back(*made.tool);
                with.operations.push_back(std::move(made.operation));
                const PassPreview preview =
                    previewer->preview(with, with.operations.size() - 1, *part, own.part(0, 0.9));
                const auto ground = previewer->ground(*part, own);
                const QImage picture =
                    strategy_picture(*ground, preview, palette, picture_pixels, own.part(0.9, 1));
                QMetaObject::invokeMethod(
                    this,
                    [this, fingerprint, kind = kinds[k].kind, picture] {
                        if (fingerprint == fingerprint_) take(kind, picture);
                    },
                    Qt::QueuedConnection);
            } catch (const Error&) {
                // It keeps its drawing: it cannot cut this part, or has nothing to do there.
            }
        }
    });
}

void StrategyPictures::take(const std::string& kind, const QImage& picture) {
    drawn_.insert(kind);
    set_icon(kind, QIcon(QPixmap::fromImage(picture)));
}

void StrategyPictures::set_icon(const std::string& kind, const QIcon& icon) {
    // Menus share the entries.
    for (QAction* entry : menus_.front()->actions())
        if (entry->data().toString().toStdString() == kind) entry->setIcon(icon);
}

} // namespace facetmill::ui
