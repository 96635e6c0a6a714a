#include "ui/boundary_menu.h"

#include "ui/boundary_list.h"
#include "ui/icons.h"

#include <QCoreApplication>
#include <QMenu>

namespace facetmill::ui {

namespace {

struct BoundaryEntry {
    Boundary::Kind kind;
    const char *name, *label;
};

constexpr BoundaryEntry boundary_entries[] = {
    {Boundary::Kind::facets, "boundary_facets", QT_TRANSLATE_NOOP("BoundaryMenu", "Painted facets")},
    {Boundary::Kind::slope, "boundary_slope", QT_TRANSLATE_NOOP("BoundaryMenu", "Range of slope")},
    {Boundary::Kind::curve, "boundary_curve", QT_TRANSLATE_NOOP("BoundaryMenu", "Closed curve")},
    {Boundary::Kind::silhouette, "boundary_silhouette",
     QT_TRANSLATE_NOOP("BoundaryMenu", "Silhouette of the part")},
    {Boundary::Kind::rest, "boundary_rest", QT_TRANSLATE_NOOP("BoundaryMenu", "What a tool leaves")},
    {Boundary::Kind::faces, "boundary_faces", QT_TRANSLATE_NOOP("BoundaryMenu", "Faces of the file")},
};

QString boundary_label(const char* text) {
    return QCoreApplication::translate("BoundaryMenu", text);
}

} // namespace

QMenu* boundary_menu(QWidget* parent, Document& document, const std::function<void(std::size_t)>& added) {
    auto* menu = new QMenu(boundary_label(QT_TRANSLATE_NOOP("BoundaryMenu", "Add boundary")), parent);
    menu->setIcon(icon(Icon::boundary));
    for (const BoundaryEntry& entry : boundary_entries) {
        QAction* a =
            menu->addAction(icon(Icon::boundary), boundary_label(entry.label), parent,
                            [&document, added, kind = entry.kind] { added(add_boundary(document, kind)); });
        a->setObjectName(QString::fromLatin1(entry.name));
    }
    return menu;
}

} // namespace facetmill::ui
