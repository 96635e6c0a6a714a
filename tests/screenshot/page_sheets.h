// Pictures of pages side by side on sheets, large enough to be read: what is looked at by eye.
#pragma once

#include <QImage>
#include <QString>

#include <vector>

class QWidget;

namespace facetmill::test {

/// Lays pictures out in rows, each below its name, and writes FOLDER/NAME-01.png, -02, ... as they fill.
class PageSheets {
public:
    /// `shrink`: how many pixels of a picture become one.
    PageSheets(QString folder, QString name, double shrink);
    ~PageSheets() { write(); }
    PageSheets(const PageSheets&) = delete;
    PageSheets& operator=(const PageSheets&) = delete;

    void add(const QImage& picture, const QString& title);
    /// What a widget shows once its view has come to rest.
    void add(QWidget& widget, const QString& title);
    /// The sheet that was begun.
    void write();

private:
    struct Placed {
        QImage picture;
        QString title;
        QPoint at;
    };
    QString folder_, name_;
    double shrink_;
    std::vector<Placed> placed_;
    QPoint next_;
    int row_ = 0; ///< height of the row that is being filled
    int written_ = 0;
};

} // namespace facetmill::test
