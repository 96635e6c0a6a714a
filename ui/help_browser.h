// Shows the pages of the manual in the colours of the window, with pictures no wider than the page.
#pragma once

#include <QTextBrowser>

class QTimer;

namespace facetmill::ui {

class HelpBrowser : public QTextBrowser {
    Q_OBJECT
public:
    explicit HelpBrowser(QWidget* parent = nullptr);

    /// "rough.html#depth".
    void show_topic(const QString& topic);
    /// The page shown and the place on it that was asked for.
    QString topic() const { return topic_of(source()); }
    static QString topic_of(const QUrl& url);
    /// Marks these words wherever they stand on the page.
    void mark(const QStringList& words);

protected:
    QVariant loadResource(int type, const QUrl& name) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void load_again();

    QTimer* wait_ = nullptr; ///< until the size is the last one of a drag
    int width_ = 0;          ///< of the page that the pictures were made for
};

} // namespace facetmill::ui
