// Meshes that leave the workbench: the part as it lies, what all operations leave of the stock, and the
// surface of the verdict with its deviations.
#pragma once

#include "ui/background_job.h"
#include "ui/document.h"

#include <QWidget>

#include <cstdint>

namespace facetmill::ui {

class Messages;
class VerificationController;

class MeshExport : public QObject {
    Q_OBJECT
public:
    enum class What : std::uint8_t { part, stock, deviation };

    MeshExport(const Document& document, BackgroundJob& job, Messages& messages,
               VerificationController& verification, QWidget* window);

    /// There is one to write: a part that was read, a complete plan, a verdict on the project as it stands.
    bool has(What what) const;
    void with_dialog(What what);
    /// In the background, in the project's unit; says how it went. Nothing where there is none.
    void save(What what, const QString& path);

private:
    /// What is to be written, found in the background.
    struct Content;
    std::function<Content(const Progress&)> content(What what) const;

    const Document& document_;
    BackgroundJob& job_;
    Messages& messages_;
    VerificationController& verification_;
    QWidget* window_;
};

} // namespace facetmill::ui
