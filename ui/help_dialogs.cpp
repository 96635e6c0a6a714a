#include "ui/help_dialogs.h"

#include "ui/icons.h"
#include "ui/language.h"
#include "ui/preferences_dialog.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QCoreApplication>
#include <QMessageBox>

namespace facetmill::ui {

void show_shortcuts(QWidget* window) {
    QString rows;
    const auto row = [&](const QString& key, const QString& what) {
        rows += QStringLiteral("<tr><td style=\"padding:2px 18px 2px 0; white-space:nowrap\"><b>%1</b></td>"
                               "<td style=\"padding:2px 0\">%2</td></tr>")
                    .arg(key, what);
    };
    for (const QString& line : navigation_words(settings::navigation().style))
        row(line.section(QStringLiteral(": "), 1), in_a_sentence(line.section(QStringLiteral(": "), 0, 0)));
    row(QObject::tr("Double click, F"), QObject::tr("fit"));
    row(QObject::tr("Click on a path"),
        QObject::tr("show the tool there; ← and → step along the path (Shift: by ten)"));
    row(QObject::tr("← →  ↑ ↓"),
        QObject::tr("with the configuration space in view: points along the pass, passes"));
    row(QObject::tr("While a boundary is painted"),
        QObject::tr("left drag: paint (Shift: erase); Ctrl + left drag: turn; Esc: end"));
    row(QObject::tr("In a chart or the unrolled path"),
        QObject::tr("click or drag: the tool there; wheel: zoom; right drag: move; Home: all"));
    row(QObject::tr("0 … 6"), QObject::tr("isometric, front, top, right, rear, bottom, left"));
    row(QObject::tr("Alt+1 … Alt+0"), QObject::tr("into the panels: project, parameters, report and so on"));
    row(QObject::tr("M"), QObject::tr("measure"));
    row(QObject::tr("F5, Ctrl+P"), QObject::tr("plan"));
    row(QObject::tr("F6"), QObject::tr("verify"));
    row(QObject::tr("F7 … F10"), QObject::tr("see what belongs to: prepare, plan, verify, simulate"));
    row(QObject::tr("Space"), QObject::tr("play, pause"));
    row(QObject::tr(",  ."), QObject::tr("one motion back, on (← and → too while playing back; Shift: ten)"));
    row(QObject::tr("Esc"), QObject::tr("cancel the running job"));
    row(QObject::tr("Ctrl+E"), QObject::tr("export programs and the report"));
    row(QObject::tr("Ctrl+Z, Ctrl+Shift+Z"), QObject::tr("undo, redo"));
    row(QObject::tr("Enter"), QObject::tr("edit the selected tool or the parameters of the selection"));
    row(QObject::tr("F2"), QObject::tr("rename what is selected in the tree"));
    row(QObject::tr("Ctrl+C, Ctrl+V"),
        QObject::tr("copy an operation in the tree, paste it here or in another project"));
    row(QObject::tr("F1"), QObject::tr("the manual, at the place of what has the keys"));
    row(QObject::tr("Del"), QObject::tr("remove the selected tool or operation"));
    auto* box = new QMessageBox(QMessageBox::NoIcon, QObject::tr("Keys and mouse"),
                                QStringLiteral("<table cellspacing=\"0\" width=\"700\">%1</table>").arg(rows),
                                QMessageBox::Close, window);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void show_about(QWidget* window) {
    auto* box =
        new QMessageBox(QMessageBox::NoIcon, QObject::tr("About Facetmill"),
                        QObject::tr("<h3>Facetmill %1</h3><p>Plans tool paths on triangle meshes.</p>"
                                    "<p>Built with Qt %2, VTK, Eigen, OpenMesh and oneTBB.<br>Licensed under "
                                    "the Apache License 2.0.</p>")
                            .arg(QCoreApplication::applicationVersion(), QLatin1String(qVersion())),
                        QMessageBox::Close, window);
    box->setIconPixmap(application_icon().pixmap(64, 64));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

} // namespace facetmill::ui
