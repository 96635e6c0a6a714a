// Keeps what is not saved while the window lives, and offers what a window left that was killed.
#pragma once

#include "ui/background_job.h"
#include "ui/document.h"
#include "ui/kept_work.h"

#include <QTimer>
#include <QWidget>

#include <chrono>
#include <memory>

namespace facetmill::ui {

class Messages;
class ProjectFiles;

class Autosave : public QObject {
    Q_OBJECT
public:
    Autosave(Document& document, BackgroundJob& job, ProjectFiles& files, Messages& messages,
             QWidget* window);
    /// Nothing stays behind a window that ends in order.
    ~Autosave() override;

    /// So much work can be lost at most. A project is a few kilobytes, which
    /// can be written often without being noticed.
    void set_interval(std::chrono::milliseconds time) { timer_.setInterval(time); }
    /// Keeps what has changed since the last time, aside from the window. Happens by itself as a plan, or any
    /// other job of the window, begins, which waits until it is on the disk.
    void keep();
    /// What is kept is saved, or not wanted.
    void discard();
    /// Waits until that is done, and tells what came of it.
    void finish();
    /// Asks about everything that killed windows left, that of the project `first` first, until something is
    /// restored into this window. False: nothing was.
    bool offer(const QString& first = {});

private:
    enum class Answer { restore, later, discard };

    void follow();
    void failed(const QString& why);
    Answer ask(const KeptWork& work);
    bool restore(std::unique_ptr<KeptWork> work);

    Document& document_;
    ProjectFiles& files_;
    Messages& messages_;
    QWidget* window_;
    /// Where the shown project is kept: files that are touched aside alone, in the order of what was asked.
    struct Place {
        std::unique_ptr<KeptWork> work;
    };
    std::shared_ptr<Place> place_;       ///< null: it is kept nowhere
    std::unique_ptr<KeptWork> restored_; ///< what the project that is being opened is kept in
    QTimer timer_;
    bool due_ = false;  ///< the project has changed since it was kept
    bool told_ = false; ///< that it cannot be kept
};

} // namespace facetmill::ui
