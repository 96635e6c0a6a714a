// The window's status bar: what runs and how far it is, where the tool or the pointer is, and the unit.
#pragma once

#include "ui/background_job.h"
#include "ui/document.h"
#include "viz/scene.h"

#include <QElapsedTimer>

class QAction;
class QComboBox;
class QLabel;
class QProgressBar;
class QStatusBar;
class QToolButton;

namespace facetmill::ui {

class ElidedLabel;

/// "40 s left", "3 min left": rounded as roughly as it is known.
QString time_left_text(double seconds);
/// The bar grows with its words, and does not shrink again: others beside it would jump about.
void say_in_bar(QProgressBar& bar, const QString& format);

class StatusLine : public QObject {
    Q_OBJECT
public:
    StatusLine(const Document& document, QStatusBar* bar);
    /// Follows a job; `cancel` is the action of the button beside its progress.
    void follow(const BackgroundJob& job, QAction* cancel);

    /// Where the tool is, said in parts: those that come first go first where there is no room for all.
    /// Empty: there is none.
    void set_readout(const QStringList& parts);
    /// The point under the pointer goes before it; none: the pointer has left the part.
    void set_hovered(const std::optional<PartPick>& pick);
    void show_cancelling();
    /// The document has another unit, or no part.
    void refresh();

signals:
    void unit_chosen(facetmill::LengthUnit unit);

private:
    void show_time_left(double fraction);
    void show_readout();

    const Document& document_;
    QStatusBar* bar_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QLabel* activity_ = nullptr;
    ElidedLabel* readout_ = nullptr;
    QToolButton* cancel_button_ = nullptr;
    QComboBox* unit_box_ = nullptr;
    QStringList readout_parts_;
    QElapsedTimer since_; ///< the job began
};

} // namespace facetmill::ui
