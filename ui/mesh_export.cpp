#include "ui/mesh_export.h"

#include "core/base/file.h"
#include "core/job/mesh_export.h"
#include "core/job/verification.h"
#include "core/mesh/mesh_writer.h"
#include "core/verify/stock_surface.h"
#include "ui/export.h"
#include "ui/messages.h"
#include "ui/text.h"
#include "ui/verification_controller.h"
#include "ui/worded.h"
#include "viz/deviation_colors.h"

#include <QFileInfo>

#include <functional>

namespace facetmill::ui {

struct MeshExport::Content {
    MeshPtr mesh;
    std::vector<float> values; ///< mm; empty: it has none
    std::vector<VertexColor> colors;
};

MeshExport::MeshExport(const Document& document, BackgroundJob& job, Messages& messages,
                       VerificationController& verification, QWidget* window)
    : QObject(window), document_(document), job_(job), messages_(messages), verification_(verification),
      window_(window) {}

bool MeshExport::has(What what) const {
    switch (what) {
    case What::part:
        return document_.part() != nullptr;
    case What::stock:
        return !document_.program() && document_.complete_plan() != nullptr;
    case What::deviation:
        return verification_.model().current();
    }
    return false;
}

void MeshExport::with_dialog(What what) {
    const QString titles[] = {tr("Export the part as a mesh"), tr("Export the stock as a mesh"),
                              tr("Export the deviation as a mesh")};
    const QString names[] = {tr("part"), tr("stock"), tr("deviation")};
    const auto which = std::size_t(what);
    export_file(window_, titles[which],
                what == What::deviation ? ExportFormat::deviation : ExportFormat::mesh,
                QFileInfo(document_.name()).completeBaseName() + QChar(' ') + names[which],
                [this, what](const QString& path) { save(what, path); });
}

std::function<MeshExport::Content(const Progress&)> MeshExport::content(What what) const {
    if (what == What::part)
        return [part = document_.part()](const Progress&) { return Content{part->mesh, {}, {}}; };
    if (what == What::stock)
        return [project = document_.project(), plan = document_.complete_plan()](const Progress& p) {
            const VerifySettings settings = verify_settings(project, plan.get());
            const auto left =
                stock_after(plan->stock, verify_programs(project, plan), settings, p.part(0, 0.7));
            return Content{std::make_shared<Mesh>(stock_mesh(*left, p.part(0.7, 1))), {}, {}};
        };
    return
        [outcome = verification_.model().outcome_shared(), unit = document_.project().unit](const Progress&) {
            const DeviationSurface& surface = *outcome->verification->surface;
            return Content{std::make_shared<Mesh>(deviation_mesh(surface)), surface.deviation,
                           deviation_vertex_colors(surface.deviation, surface.flags,
                                                   default_scale(*outcome->verification, unit))};
        };
}

void MeshExport::save(What what, const QString& path) {
    if (!has(what)) return;
    const std::filesystem::path target = path_of(path);
    try {
        keep_files(document_, target);
        static_cast<void>(mesh_file_kind(target)); // said before a long job
    } catch (const Error& e) {
        messages_.fail(worded(e));
        return;
    }
    const LengthUnit unit = document_.project().unit;
    job_.start(
        tr("Writing a mesh"),
        [make = content(what), target, unit,
         name = utf8(QFileInfo(path).completeBaseName())](const Progress& p) {
            const Content out = make(p.part(0, 0.8));
            save_mesh(*out.mesh, target,
                      {.unit = unit, .name = name, .values = out.values, .colors = out.colors},
                      p.part(0.8, 1));
        },
        [this, path](const JobEnd& end) {
            if (!end.done()) return;
            messages_.succeeded();
            messages_.information(tr("Wrote %1.").arg(path));
        });
}

} // namespace facetmill::ui
