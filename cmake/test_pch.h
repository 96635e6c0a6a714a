// Precompiled for every test program: QtTest and what it includes, which is half of all of QtCore.
#pragma once
#include "cmake/core_pch.h"
#include <QtTest/QTest>
#include <random>
