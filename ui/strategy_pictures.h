// Pictures of operations on the user's own part for the menu of new operations: its surface with the passes
// that each kind would about make. Drawn in the background once the menu is opened; until then, and for kinds
// that cannot cut this part, the menu has its drawings (operation_menu.h).
#pragma once

#include "core/strategy/preview/pass_preview.h"
#include "ui/background_job.h"
#include "ui/controller.h"

#include <QIcon>
#include <QImage>

#include <memory>
#include <set>
#include <string>
#include <vector>

class QMenu;

namespace facetmill {
class PassPreviewer; // core/job/preview_job.h
}

namespace facetmill::ui {

/// A ground seen from above one corner, with lines laid over it; as wide as that many pixels.
QImage strategy_picture(const CoarseGround& ground, const PassPreview& preview, Palette palette, int width,
                        const Progress& progress);

class StrategyPictures : public Controller {
    Q_OBJECT
public:
    /// Every entry that says which kind it adds (QAction::data) gets a picture; the menus share their
    /// entries.
    StrategyPictures(Document& document, const std::vector<QMenu*>& menus, QWidget* window);
    ~StrategyPictures() override;

    void project_opened() override { forget(); }
    void part_changed() override { forget(); }
    void palette_changed(Palette palette) override;
    bool busy() const override { return job_.running(); }
    /// Kinds that have one now.
    const std::set<std::string>& drawn() const { return drawn_; }

private:
    void draw();
    void forget();
    void take(const std::string& kind, const QImage& picture);
    void set_icon(const std::string& kind, const QIcon& icon);

    Document& document_;
    std::vector<QMenu*> menus_;
    std::shared_ptr<PassPreviewer> previewer_; ///< of the job's thread
    Palette palette_ = Palette::light;
    std::string fingerprint_; ///< what the pictures are of; empty: there are none
    std::set<std::string> drawn_;
    BackgroundJob job_; // last: it ends first
};

} // namespace facetmill::ui
