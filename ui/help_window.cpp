#include "ui/help_window.h"

#include "ui/help_browser.h"
#include "ui/help_pages.h"
#include "ui/icons.h"

#include <QAction>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QResizeEvent>
#include <QScreen>
#include <QSplitter>
#include <QStackedWidget>
#include <QStyle>
#include <QToolBar>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace facetmill::ui {

namespace {

constexpr int help_topic_role = Qt::UserRole;
constexpr int help_left_width = 230;
constexpr int max_help_results = 200, max_help_zoom = 12;
constexpr char help_first_page[] = "index.html";

QTreeWidgetItem* add_help_item(QTreeWidgetItem* above, QTreeWidget* tree, const HelpSection& section) {
    auto* item = above ? new QTreeWidgetItem(above) : new QTreeWidgetItem(tree);
    item->setText(0, section.title);
    item->setToolTip(0, section.title);
    item->setData(0, help_topic_role, section.topic);
    return item;
}

/// What titles ask for: with the mark that opens them, the frame and a scroll bar.
int width_of_titles(const QTreeWidget& tree) {
    int widest = 0;
    for (int i = 0; i < tree.topLevelItemCount(); ++i)
        widest = std::max(widest, tree.fontMetrics().horizontalAdvance(tree.topLevelItem(i)->text(0)));
    return widest + 3 * tree.indentation();
}

} // namespace

HelpWindow::HelpWindow(QWidget* parent) : QWidget(parent, Qt::Window) {
    setObjectName(QStringLiteral("help_window"));
    setWindowTitle(tr("Facetmill manual"));
    setWindowIcon(application_icon());
    setAttribute(Qt::WA_QuitOnClose, false);
    browser_ = new HelpBrowser(this);
    browser_->setObjectName(QStringLiteral("help_page"));
    browser_->setAccessibleName(tr("Page of the manual"));
    contents_ = new QTreeWidget(this);
    contents_->setObjectName(QStringLiteral("help_contents"));
    contents_->setAccessibleName(tr("Contents"));
    contents_->setHeaderHidden(true);
    results_ = new QListWidget(this);
    results_->setObjectName(QStringLiteral("help_results"));
    results_->setAccessibleName(tr("Places found"));
    results_->setWordWrap(true);
    left_ = new QStackedWidget(this);
    left_->addWidget(contents_);
    left_->addWidget(results_);
    halves_ = new QSplitter(this);
    halves_->addWidget(left_);
    halves_->addWidget(browser_);
    halves_->setStretchFactor(1, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(make_bar());
    column->addWidget(halves_, 1);
    fill_contents();
    connect(halves_, &QSplitter::splitterMoved, this, [this] { divided_ = true; });
    connect(contents_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
        if (item) browser_->show_topic(item->data(0, help_topic_role).toString());
    });
    connect(results_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (!item) return;
        browser_->show_topic(item->data(help_topic_role).toString());
        browser_->mark(search_->text().split(QChar(' '), Qt::SkipEmptyParts));
    });
    connect(browser_, &QTextBrowser::sourceChanged, this, &HelpWindow::choose_in_contents);
    const QSize screen = QGuiApplication::primaryScreen()->availableSize();
    resize(std::min(960, screen.width()), std::min(680, screen.height()));
}

/// Titles are read whole where the page, which has wide tables, keeps its room.
void HelpWindow::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (divided_) return;
    const int left = std::max(help_left_width, std::min(width_of_titles(*contents_), width() / 4));
    halves_->setSizes({left, std::max(1, width() - left)});
}

QToolBar* HelpWindow::make_bar() {
    auto* bar = new QToolBar(this);
    bar->setIconSize(QSize(18, 18));
    const auto add = [&](const QString& text, const QString& tip, const char* name,
                         const QList<QKeySequence>& keys, auto&& act) {
        QAction* made = bar->addAction(text);
        made->setObjectName(QLatin1String(name));
        made->setShortcuts(keys);
        made->setToolTip(tip);
        connect(made, &QAction::triggered, this, act);
        return made;
    };
    QAction* back = add(tr("← Back"), tr("The page before (Alt+←)"), "help_back",
                        {QKeySequence(Qt::ALT | Qt::Key_Left)}, [this] { browser_->backward(); });
    QAction* on = add(tr("On →"), tr("The page after (Alt+→)"), "help_forward",
                      {QKeySequence(Qt::ALT | Qt::Key_Right)}, [this] { browser_->forward(); });
    connect(browser_, &QTextBrowser::backwardAvailable, back, &QAction::setEnabled);
    connect(browser_, &QTextBrowser::forwardAvailable, on, &QAction::setEnabled);
    back->setEnabled(false);
    on->setEnabled(false);
    add(tr("Contents"), tr("All chapters"), "help_home", {QKeySequence(Qt::ALT | Qt::Key_Home)}, [this] {
        search_->clear();
        show_topic({});
    });
    add(tr("A−"), tr("Smaller letters (Ctrl+−)"), "help_smaller", {QKeySequence(Qt::CTRL | Qt::Key_Minus)},
        [this] { zoom(-1); });
    add(tr("A+"), tr("Larger letters (Ctrl++)"), "help_larger",
        {QKeySequence(Qt::CTRL | Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Equal)}, [this] { zoom(1); });
    search_ = new QLineEdit(bar);
    search_->setObjectName(QStringLiteral("help_search"));
    search_->setPlaceholderText(tr("Search the manual (Ctrl+F)"));
    search_->setAccessibleName(tr("Search the manual"));
    search_->setClearButtonEnabled(true);
    search_->setMinimumWidth(120);
    bar->addWidget(search_);
    connect(search_, &QLineEdit::textChanged, this, &HelpWindow::search);
    connect(search_, &QLineEdit::returnPressed, this, [this] {
        if (results_->count() > 0) results_->setCurrentRow((results_->currentRow() + 1) % results_->count());
    });
    auto* find = new QAction(this);
    find->setShortcut(QKeySequence::Find);
    connect(find, &QAction::triggered, this, [this] {
        search_->setFocus(Qt::ShortcutFocusReason);
        search_->selectAll();
    });
    addAction(find);
    return bar;
}

void HelpWindow::fill_contents() {
    QTreeWidgetItem *page = nullptr, *reference = nullptr;
    for (const HelpSection& s : help_sections()) {
        if (s.level == 1) {
            const bool operation = s.topic.startsWith(QLatin1String("reference_"));
            page = add_help_item(operation ? reference : nullptr, contents_, s);
            if (s.topic == QLatin1String("reference.html")) reference = page;
        } else if (s.level == 2 && page) {
            add_help_item(page, contents_, s);
        }
    }
}

void HelpWindow::show_topic(const QString& topic) {
    const bool page = topic == QLatin1String(help_first_page) || has_help(topic);
    browser_->show_topic(page ? topic : QLatin1String(help_first_page));
}

void HelpWindow::choose_in_contents(const QUrl& shown) {
    // The page itself knows of it only after it has told.
    const QString topic = HelpBrowser::topic_of(shown), page = topic.section(QChar('#'), 0, 0);
    QTreeWidgetItem *exact = nullptr, *whole = nullptr;
    for (QTreeWidgetItemIterator it(contents_); *it; ++it) {
        const QString at = (*it)->data(0, help_topic_role).toString();
        if (at == topic) exact = *it;
        if (at == page) whole = *it;
    }
    // What leads here must not be led there once more.
    const QSignalBlocker quiet(contents_);
    contents_->setCurrentItem(exact ? exact : whole);
}

void HelpWindow::search(const QString& words) {
    results_->clear();
    const bool any = !words.trimmed().isEmpty();
    left_->setCurrentWidget(any ? static_cast<QWidget*>(results_) : contents_);
    if (!any) return browser_->mark({});
    QString page;
    for (const HelpSection* s : find_help(words)) {
        if (results_->count() == max_help_results) break;
        for (const HelpSection& p : help_sections())
            if (p.topic == s->page()) page = p.title;
        auto* item =
            new QListWidgetItem(s->level == 1 ? s->title : s->title + QStringLiteral(" – ") + page, results_);
        item->setData(help_topic_role, s->topic);
        item->setToolTip(s->text.left(300));
    }
    if (results_->count() > 0) return;
    auto* none = new QListWidgetItem(tr("Nothing has all these words."), results_);
    none->setFlags(Qt::NoItemFlags);
}

void HelpWindow::zoom(int steps) {
    const int wanted = std::clamp(zoomed_ + steps, -4, max_help_zoom);
    browser_->zoomIn(wanted - zoomed_);
    zoomed_ = wanted;
}

void HelpWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape) return QWidget::keyPressEvent(event);
    if (search_->text().isEmpty())
        close();
    else
        search_->clear();
}

} // namespace facetmill::ui
