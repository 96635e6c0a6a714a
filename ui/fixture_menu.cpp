#include "ui/fixture_menu.h"

#include "ui/fixture_list.h"
#include "ui/icons.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QCoreApplication>
#include <QMenu>

namespace facetmill::ui {

namespace {

struct FixtureEntry {
    NewFixture what;
    const char *name, *label;
};

constexpr FixtureEntry fixture_entries[] = {
    {NewFixture::vice, "fixture_vice", QT_TRANSLATE_NOOP("FixtureMenu", "Vice: two jaws")},
    {NewFixture::clamp, "fixture_clamp", QT_TRANSLATE_NOOP("FixtureMenu", "Clamp over the edge")},
    {NewFixture::plate, "fixture_plate", QT_TRANSLATE_NOOP("FixtureMenu", "Plate below")},
    {NewFixture::box, "fixture_box", QT_TRANSLATE_NOOP("FixtureMenu", "Box")},
    {NewFixture::cylinder, "fixture_cylinder", QT_TRANSLATE_NOOP("FixtureMenu", "Cylinder")},
    {NewFixture::tabs, "fixture_tabs", QT_TRANSLATE_NOOP("FixtureMenu", "Tabs round the part")},
};

QString fixture_label(const char* text) {
    return QCoreApplication::translate("FixtureMenu", text);
}

} // namespace

QMenu* fixture_menu(QWidget* parent, Document& document, const std::function<void(std::size_t)>& added,
                    const std::function<void(std::size_t)>& wants_mesh,
                    const std::function<void(const QString&)>& refused) {
    auto* menu = new QMenu(fixture_label(QT_TRANSLATE_NOOP("FixtureMenu", "Add fixture")), parent);
    menu->setIcon(icon(Icon::fixture));
    for (const FixtureEntry& entry : fixture_entries) {
        QAction* a = menu->addAction(icon(Icon::fixture), fixture_label(entry.label), parent,
                                     [&document, added, refused, what = entry.what] {
                                         try {
                                             added(add_fixture(document, what));
                                         } catch (const Error& e) {
                                             refused(sentence(worded(e)));
                                         }
                                     });
        a->setObjectName(QString::fromLatin1(entry.name));
    }
    QAction* mesh =
        menu->addAction(icon(Icon::fixture), fixture_label(QT_TRANSLATE_NOOP("FixtureMenu", "Mesh…")), parent,
                        [&document, added, wants_mesh] {
                            const std::size_t at = document.project().fixtures.size();
                            wants_mesh(at);
                            if (document.project().fixtures.size() > at) added(at);
                        });
    mesh->setObjectName(QStringLiteral("fixture_mesh"));
    return menu;
}

} // namespace facetmill::ui
