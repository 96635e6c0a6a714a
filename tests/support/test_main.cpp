// Of test programs that need no window.
#include "tests/support/test_runner.h"

#include <QCoreApplication>

int main(int argc, char** argv) {
    QCoreApplication app(argc, argv);
    return facetmill::test::run_tests(argc, argv);
}
