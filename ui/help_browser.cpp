#include "ui/help_browser.h"

#include "ui/help_pages.h"

#include <QDesktopServices>
#include <QEvent>
#include <QScrollBar>
#include <QTextDocument>
#include <QTimer>

namespace facetmill::ui {

namespace {

constexpr char help_scheme[] = "manual:/";
constexpr int help_drawing_width = 240; ///< points
constexpr int help_wait_ms = 120;

QString help_name_in(const QUrl& url) {
    QString path = url.path();
    while (path.startsWith(QChar('/')))
        path.remove(0, 1);
    return path;
}

} // namespace

HelpBrowser::HelpBrowser(QWidget* parent) : QTextBrowser(parent) {
    setOpenLinks(false); // links to elsewhere are for the desktop's browser
    document()->setDocumentMargin(12);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // else the width would depend on the page
    wait_ = new QTimer(this);
    wait_->setSingleShot(true);
    wait_->setInterval(help_wait_ms);
    connect(wait_, &QTimer::timeout, this, [this] {
        if (width_ != viewport()->width()) load_again();
    });
    connect(this, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
        const QUrl to = source().resolved(link);
        if (to.scheme() == source().scheme())
            setSource(to);
        else
            QDesktopServices::openUrl(to);
    });
}

void HelpBrowser::show_topic(const QString& topic) {
    mark({});
    setSource(QUrl(QLatin1String(help_scheme) + topic));
}

QString HelpBrowser::topic_of(const QUrl& url) {
    const QString anchor = url.fragment();
    return help_name_in(url) + (anchor.isEmpty() ? QString() : QChar('#') + anchor);
}

void HelpBrowser::mark(const QStringList& words) {
    QList<QTextEdit::ExtraSelection> marks;
    constexpr qsizetype max_marks = 500;
    for (const QString& word : words)
        for (QTextCursor at = document()->find(word); !at.isNull() && marks.size() < max_marks;
             at = document()->find(word, at)) {
            QTextEdit::ExtraSelection mark;
            mark.cursor = at;
            mark.format.setBackground(palette().highlight());
            mark.format.setForeground(palette().highlightedText());
            marks << mark;
        }
    setExtraSelections(marks);
}

QVariant HelpBrowser::loadResource(int type, const QUrl& name) {
    const QString file = help_name_in(source().resolved(name));
    if (type == QTextDocument::StyleSheetResource) return help_style(palette());
    if (type == QTextDocument::HtmlResource) {
        width_ = viewport()->width();
        return help_file(file);
    }
    if (type != QTextDocument::ImageResource) return {};
    const int room = std::max(100, width_ - 2 * int(document()->documentMargin()) - 4);
    if (file.endsWith(QLatin1String(".svg")))
        return help_drawing(file.section(QChar('/'), -1).chopped(4), palette(),
                            std::min(help_drawing_width, room), devicePixelRatioF());
    QImage picture = QImage::fromData(help_file(file));
    const int wide = int(room * devicePixelRatioF());
    if (picture.width() > wide) picture = picture.scaledToWidth(wide, Qt::SmoothTransformation);
    picture.setDevicePixelRatio(devicePixelRatioF());
    return picture;
}

void HelpBrowser::load_again() {
    if (source().isEmpty()) return;
    const double place = verticalScrollBar()->maximum() > 0
                             ? double(verticalScrollBar()->value()) / verticalScrollBar()->maximum()
                             : 0;
    reload();
    verticalScrollBar()->setValue(int(place * verticalScrollBar()->maximum() + 0.5));
}

void HelpBrowser::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    if (width_ != viewport()->width()) wait_->start();
}

void HelpBrowser::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) QTimer::singleShot(0, this, &HelpBrowser::load_again);
}

} // namespace facetmill::ui
