// What can be read on a page, and what of it is not in the window's language.
#pragma once

#include <QHash>
#include <QSet>
#include <QString>
#include <QStringList>
#include <QWidget>

namespace facetmill::test {

/// All that a window's visible widgets say: labels, buttons, fields, tabs, heads, lines of lists and trees,
/// reports, tool tips. What is painted is not among it.
QStringList shown_texts(const QWidget& window);

/// A number that nobody reads: "0.00000608", "1.2e-16".
bool has_silly_figure(const QString& shown);

/// Knows English texts where another language is spoken, by that language's file.
class EnglishTexts {
public:
    /// "de".
    explicit EnglishTexts(const QString& language);
    bool known() const { return !plain_.isEmpty(); }
    /// Why a text is not in the language: the English text that it is, or a decimal point; empty where it may
    /// be.
    QString in(const QString& shown) const;

private:
    struct Template {
        QStringList between; ///< what stands before, between and behind the places
        QString longest;     ///< of these
    };
    bool is_of(const QString& shown, const Template& one) const;
    QHash<QString, bool> plain_, translated_;
    QList<Template> templates_;
};

/// What scenes write from now on, as long as it lives; to be made after a language was chosen.
class PaintedTexts {
public:
    PaintedTexts();
    ~PaintedTexts();
    PaintedTexts(const PaintedTexts&) = delete;
    PaintedTexts& operator=(const PaintedTexts&) = delete;
    /// Those that are not in the language, with why.
    QStringList not_in(const EnglishTexts& english) const;
    bool any() const { return !texts_.isEmpty(); }

private:
    QSet<QString> texts_; ///< as they are seen
};

} // namespace facetmill::test
