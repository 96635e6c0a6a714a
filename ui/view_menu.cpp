#include "ui/view_menu.h"

#include "core/mesh/facet_paint.h"
#include "ui/boundary_list.h"
#include "ui/controllers.h"
#include "ui/facet_tool.h"
#include "ui/icons.h"
#include "ui/layer_bar.h"
#include "ui/main_window.h"
#include "ui/place_controller.h"
#include "ui/project_tree.h"
#include "ui/text.h"
#include "ui/viewport.h"

#include <QMenu>

#include <algorithm>
#include <functional>

namespace facetmill::ui {

namespace {

/// Pixels about the pointer in which a path is taken for what was clicked.
constexpr double path_radius = 6;
constexpr ViewLayer path_layers[] = {ViewLayer::cc, ViewLayer::cuts, ViewLayer::links, ViewLayer::rapids};

} // namespace

ViewMenu::ViewMenu(MainWindow& window, QMenu& views) : QObject(&window), window_(window), views_(views) {}

QMenu* ViewMenu::make(const QPoint& global) {
    Viewport& view = window_.viewport();
    auto* menu = new QMenu(&window_);
    menu->setObjectName(QStringLiteral("clicked_menu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    const double scale = view.devicePixelRatioF();
    const QPointF p = QPointF(view.mapFromGlobal(global)) * scale;
    const bool on_path = view.scene().paths().pick(p.x(), p.y(), path_radius * scale).has_value();
    const auto on_part =
        window_.layers().shown(ViewLayer::part) ? view.scene().part().pick(p.x(), p.y()) : std::nullopt;
    if (on_part && window_.document().part_is_current()) add_part(*menu, *on_part);
    add_layers(*menu, on_part.has_value(), on_path);
    menu->addSeparator();
    menu->addActions(views_.actions());
    return menu;
}

void ViewMenu::add_part(QMenu& menu, const PartPick& pick) {
    PlaceController& place = window_.controllers().place();
    // The file may be read anew while the menu is open: what was clicked is a facet of this part.
    const auto on = [this, part = window_.document().part()](const std::function<void()>& act) {
        return [this, part, act] {
            if (window_.document().part() == part && window_.document().part_is_current()) act();
        };
    };
    menu.addAction(icon(Icon::lay_on_face), tr("Lay on this face"), this,
                   on([&place, pick] { place.lay_on(pick); }))
        ->setToolTip(tr("The face under the pointer comes down on the table"));
    menu.addAction(tr("Zero here"), this, on([&place, pick] { place.zero_at(pick); }))
        ->setToolTip(tr("Programs count from here; a corner or an edge nearby is taken exactly"));
    QAction* bound = menu.addAction(icon(Icon::boundary), tr("Boundary of this face"), this,
                                    on([this, pick] { bound_face(pick); }));
    bound->setToolTip(tr("All facets up to sharp edges, as a boundary for operations"));
    bound->setEnabled(!window_.job().running()); // it would end that
    menu.addSeparator();
}

void ViewMenu::add_layers(QMenu& menu, bool on_part, bool on_path) {
    LayerBar& layers = window_.layers();
    const auto show = [&layers](ViewLayer layer, bool on) {
        return [&layers, layer, on] { layers.set_shown(layer, on); };
    };
    if (on_path)
        menu.addAction(tr("Hide paths"), this, [&layers] {
            for (const ViewLayer layer : path_layers)
                layers.set_shown(layer, false);
        });
    else if (!layers.shown(ViewLayer::cuts) && window_.document().all_planned())
        menu.addAction(tr("Show paths"), this, show(ViewLayer::cuts, true));
    if (!window_.document().has_part()) return;
    if (on_part)
        menu.addAction(tr("Hide part"), this, show(ViewLayer::part, false));
    else if (!layers.shown(ViewLayer::part))
        menu.addAction(tr("Show part"), this, show(ViewLayer::part, true));
    menu.addAction(layers.shown(ViewLayer::stock) ? tr("Hide stock") : tr("Show stock"), this,
                   show(ViewLayer::stock, !layers.shown(ViewLayer::stock)));
}

/// Found beside the window where the file names no faces: of a large part it takes a moment.
void ViewMenu::bound_face(const PartPick& pick) {
    auto found = std::make_shared<std::vector<Index>>();
    const auto part = window_.document().part();
    if (part->faces) {
        Document& document = window_.document();
        if (!document.part_is_current()) return;
        document.undo_stack().beginMacro(tr("Boundary of a face"));
        const std::size_t at = add_boundary(document, Boundary::Kind::faces);
        set_boundary_faces(document, at, std::to_string(part->faces->at(pick.facet)),
                           tr("Boundary of a face"));
        document.undo_stack().endMacro();
        window_.tree().select({TreeNode::Kind::boundary, at});
        return;
    }
    window_.job().start(
        tr("Looking for the face"),
        [found, part, facet = Index(pick.facet)](const Progress& progress) {
            *found = FacetPainter(part->mesh, progress).flood(facet, PaintSettings().angle);
        },
        [this, found, part](const JobEnd& end) {
            Document& document = window_.document();
            if (!end.done() || document.part() != part || !document.part_is_current()) return;
            std::vector<char> marks(part->mesh->facets.size(), 0);
            for (const Index facet : *found)
                marks[facet] = 1;
            // One step of the history.
            document.undo_stack().beginMacro(tr("Boundary of a face"));
            const std::size_t at = add_boundary(document, Boundary::Kind::facets);
            set_boundary_facets(document, at, marks, tr("Boundary of a face"));
            document.undo_stack().endMacro();
            window_.tree().select({TreeNode::Kind::boundary, at});
        });
}

} // namespace facetmill::ui
