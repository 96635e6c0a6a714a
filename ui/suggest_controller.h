// Suggestions of a finishing operation (core/study/suggest.h) in the window: looked for in the background,
// shown with reasons in words, made by a click as one step of the history.
#pragma once

#include "core/study/suggest.h"
#include "ui/background_job.h"
#include "ui/controller.h"

#include <memory>

namespace facetmill::ui {

class SuggestDialog;

class SuggestController : public Controller {
    Q_OBJECT
public:
    SuggestController(Document& document, QWidget* window);
    ~SuggestController() override;

    /// Shows the page, and begins to look where nothing has been found for the project as it is.
    void open();
    SuggestDialog* dialog() { return dialog_; }
    void project_opened() override;
    void project_changed() override;
    bool busy() const override { return job_.running(); }

signals:
    /// An operation was made at this place.
    void added(std::size_t operation);

private:
    std::string asked() const;
    void look();
    void show();
    void show_stale();
    void add(std::size_t i);
    /// In place of finishing within the same boundaries, which is switched off (their names), and behind
    /// roughing where it needs one; returns its place.
    std::size_t put_in(const Suggestion& suggestion, QStringList& off);

    Document& document_;
    QWidget* window_ = nullptr;
    SuggestDialog* dialog_ = nullptr; ///< once it was opened
    std::shared_ptr<const Suggestions> found_;
    std::string looked_for_; ///< the project that they were found for
    std::string found_for_;  ///< the same, with those of them that were added
    bool as_found_ = false;  ///< nothing is said but what was found
    BackgroundJob job_;      // last: it ends first
};

} // namespace facetmill::ui
