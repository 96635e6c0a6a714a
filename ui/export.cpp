#include "ui/export.h"

#include "core/base/file.h"
#include "ui/text.h"

#include <QObject>
#include <QSaveFile>

namespace facetmill::ui {

QString write_picture(const QString& path, const QImage& picture) {
    QSaveFile file(path);
    if (!picture.isNull() && file.open(QIODevice::WriteOnly) && picture.save(&file, "PNG") && file.commit())
        return {};
    return QObject::tr("%1: the picture cannot be written (%2)").arg(path, file.errorString());
}

QString write_table(const QString& path, std::string_view lines) {
    try {
        OutputFile file(path_of(path));
        file.write(lines);
        file.commit();
    } catch (const Error& e) {
        return text(e.what());
    }
    return {};
}

} // namespace facetmill::ui
