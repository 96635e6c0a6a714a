// LinuxCNC's own interpreter (rs274 of Debian's linuxcnc-uspace) in front of posted programs. Not linked: a
// program beside the tests; where it is missing they say so.
#pragma once

#include "core/base/plane_geometry.h"
#include "core/output/post/post_writer.h"
#include "core/setup/kinematics.h"

#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <cmath>

namespace facetmill::test {

using Place = std::array<double, 6>;

struct Interpreted {
    int status = -1;
    QByteArray message;
    std::vector<Place> places; ///< X, Y, Z and A, B, C of every straight motion; points on arcs, too
    std::size_t arcs = 0;
};

/// The interpreter's own words for an arc: ends and centre in the plane, turns (positive is anticlockwise),
/// the end across it. Points of it, evenly.
inline void add_arc(const QList<QByteArray>& numbers, int normal, Interpreted& into) {
    constexpr int points = 64;
    const auto number = [&](int k) { return numbers[k].trimmed().toDouble(); };
    const std::size_t u = std::size_t(normal + 1) % 3, v = std::size_t(normal + 2) % 3,
                      w = std::size_t(normal);
    const Place from = into.places.back();
    const double cu = number(2), cv = number(3), turns = number(4);
    const double r0 = std::hypot(from[u] - cu, from[v] - cv), r1 = std::hypot(number(0) - cu, number(1) - cv);
    const double start = std::atan2(from[v] - cv, from[u] - cu);
    double by = std::remainder(std::atan2(number(1) - cv, number(0) - cu) - start, 2 * pi);
    if (turns > 0 && by <= 0) by += 2 * pi;
    if (turns < 0 && by >= 0) by -= 2 * pi;
    for (int k = 1; k <= points; ++k) {
        const double t = double(k) / points, r = (1 - t) * r0 + t * r1, a = start + t * by;
        Place at = from;
        at[u] = cu + r * std::cos(a);
        at[v] = cv + r * std::sin(a);
        at[w] = (1 - t) * from[w] + t * number(5);
        into.places.push_back(at);
    }
    ++into.arcs;
}

inline QString rs274_program() {
    return QStandardPaths::findExecutable("rs274");
}

/// Each run has a home of its own: runs that share one spoil each other's.
inline Interpreted interpret(const std::string& text, const ClProgram& program) {
    QTemporaryDir home;
    const auto write = [&](const QString& name, const QByteArray& bytes) {
        QFile file(home.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("cannot write");
    };
    write("p.ngc", QByteArray::fromStdString(text));
    write("p.var", "");
    QByteArray table;
    for (const auto& s : program.sections) // lengths are inches here, whatever the program has
        table +=
            QString("T%1 P%1 Z%2 D0.1\n").arg(s->tool_number).arg(s->gauge_length / 25.4, 0, 'f', 9).toUtf8();
    write("tool.tbl", table);
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("HOME", home.path());
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(home.path());
    process.setStandardInputFile(QProcess::nullDevice());
    QStringList arguments{"-g", "-t", "tool.tbl", "-v", "p.var"};
    // What switches kinematics is remapped by the machine's own file, as LinuxCNC's examples do it; here
    // nothing is behind it, so that places are seen as they are told.
    if (text.find("M428") != std::string::npos) {
        write("kins.ini", "[RS274NGC]\nSUBROUTINE_PATH = .\nREMAP = M428 modalgroup=10 ngc=m428\n"
                          "REMAP = M429 modalgroup=10 ngc=m429\n");
        for (const char* code : {"m428", "m429"})
            write(QString(code) + ".ngc", QByteArray("o<C> sub\no<C> endsub\nM2\n").replace("C", code));
        arguments << "-i"
                  << "kins.ini";
    }
    process.start(rs274_program(), arguments << "p.ngc");
    Interpreted result;
    if (!process.waitForFinished(60000) || process.exitStatus() != QProcess::NormalExit) return result;
    result.status = process.exitCode();
    result.message = process.readAllStandardError();
    int normal = 2;
    for (const QByteArray& line : process.readAllStandardOutput().split('\n')) {
        const auto open = line.indexOf('(');
        if (line.contains("SELECT_PLANE(")) normal = line.contains("XY") ? 2 : line.contains("XZ") ? 1 : 0;
        if (line.contains(" ARC_FEED(")) add_arc(line.mid(open + 1).chopped(1).split(','), normal, result);
        if (open < 0 || (!line.contains("STRAIGHT_TRAVERSE(") && !line.contains("STRAIGHT_FEED("))) continue;
        const QList<QByteArray> numbers = line.mid(open + 1).chopped(1).split(',');
        Place at{};
        for (int k = 0; k < 6 && k < numbers.size(); ++k)
            at[std::size_t(k)] = numbers[k].trimmed().toDouble();
        result.places.push_back(at);
    }
    return result;
}

/// The ways in which the machine can hold the place of every motion, in the words of the control, which leads
/// the tip of leaning tools (`tips`) or is told joints.
inline std::vector<std::vector<Place>> wanted_places(const ClProgram& program, const PostSetup& setup,
                                                     bool tips = false) {
    std::vector<std::vector<Place>> all;
    for (const auto& s : program.sections) {
        const Kinematics kinematics(setup.machine, s->gauge_length, setup.part_origin);
        for (const Motion& m : s->motions.motions) {
            const Kinematics::Solutions held = kinematics.inverse({m.to.tip, m.to.axis}, {});
            std::vector<Place> held_so;
            for (int k = 0; k < held.count; ++k) {
                const Joints& at = held.at[std::size_t(k)];
                const Vec3 joints = at.linear - setup.part_origin - Vec3(0, 0, s->gauge_length);
                const Vec3 words = (tips && s->multi_axis ? m.to.tip : joints) / mm_per(program.unit);
                Place place{words.x(), words.y(), words.z(), 0, 0, 0};
                for (std::size_t r = 0; r < setup.machine.rotary.size(); ++r)
                    place[3 + std::size_t(setup.machine.rotary[r].name[0] - 'A')] = degrees(at.rotary[r]);
                held_so.push_back(place);
            }
            all.push_back(held_so);
        }
    }
    return all;
}

/// The largest difference of two places; whole turns count for nothing, and angles are printed apart.
inline double difference(const Place& a, const Place& b) {
    double most = 0;
    for (std::size_t k = 0; k < 6; ++k)
        most =
            std::max(most, k < 3 ? std::abs(a[k] - b[k]) : std::abs(std::remainder(a[k] - b[k], 360)) - 1e-5);
    return most;
}

/// True when every place of the program is among those seen, in order, to half a digit of what is printed,
/// here and there.
inline bool all_places_seen(const ClProgram& program, const PostSetup& setup, const Post& post,
                            const Interpreted& seen) {
    const bool inch = program.unit == LengthUnit::inch;
    const double digit = std::pow(10, -(inch ? post.inch_decimals : post.mm_decimals)), canon = 1e-4;
    const double limit = 0.501 * (digit < 0.9 * canon ? digit + canon : digit);
    std::size_t at = 0;
    const bool tips = post.multi_axis == Post::MultiAxis::tcp;
    for (const std::vector<Place>& held_so : wanted_places(program, setup, tips)) {
        const auto there = [&](const Place& p) {
            return std::any_of(held_so.begin(), held_so.end(),
                               [&](const Place& w) { return difference(p, w) < limit; });
        };
        while (at < seen.places.size() && !there(seen.places[at]))
            ++at;
        if (at == seen.places.size()) return false;
    }
    return true;
}

} // namespace facetmill::test
